#include "methods/crytek_ssao/crytek_ssao.hpp"

#include "methods/common/unit_parts.hpp"
#include "methods/crytek_ssao/crytek_ssao_description.hpp"

namespace alcove {
namespace {

constexpr int kPictureSamples = 4; ///< the most that every device offers

/// Radius and weighting are parameters; the rest is as for all estimators with uniform steps.
TargetMapping map_target(const Target& target) {
    Target but_weighting = target;
    but_weighting.weighting = Weighting::cosine;
    TargetMapping mapping = map_linear_cosine_target(but_weighting);
    mapping.overrides.push_back(
        {"weighting", std::string(to_text(target.weighting)), Provenance::target});
    return mapping;
}

} // namespace

MethodUnit crytek_ssao_unit() {
    MethodUnit unit;
    unit.name = "crytek_ssao";
    unit.title = "Crytek SSAO";
    unit.citation = "Mittring. Finding next gen: CryEngine 2. 2007";
    unit.parameters = make_crytek_table();
    unit.presets = make_crytek_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = map_target;
    unit.count_samples = [](const ResolvedParameters& resolved) {
        const auto params = make_crytek_table().bind<CrytekSsaoParams>(resolved);
        return count_estimator_samples("crytek_ssao", params.samples,
                                       params.resolution == EstimatorResolution::half);
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        const auto params = make_crytek_table().bind<CrytekSsaoParams>(resolved);
        EstimatorRecipe recipe =
            make_estimator_recipe("crytek_ssao", params, make_crytek_kernel(params));
        recipe.requests.samples = params.msaa == CrytekMsaa::off ? 1 : kPictureSamples;
        recipe.requests.samples_take_nearest = params.msaa == CrytekMsaa::nearest_depth;
        return make_estimator_method(context.functions(), make_crytek_table(), resolved, recipe);
    };
    return unit;
}

} // namespace alcove
