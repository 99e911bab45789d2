#include "harness/run/truth.hpp"

#include "harness/run/radiance_store.hpp"

namespace alcove {
namespace {

constexpr const char* kRayTraced = "reference_ray_traced";
constexpr const char* kPathTraced = "reference_path_traced";

class RayTracedTruth final : public TruthSource {
  public:
    explicit RayTracedTruth(RoundStage& stage)
        : m_stage(stage),
          m_store(get_cache_folder(), stage.units().methods.find(kRayTraced).content_hash,
                  {stage.plan().audit_share, stage.plan().audit_seed}) {
        m_settings.target = stage.target();
        m_settings.rays_per_half = stage.plan().reference_rays_per_half;
    }

    Truth get(const FrameView& view) override {
        m_stage.set_frame(view);
        // Noise that stood still on the screen would cancel in differences over time.
        m_settings.seed = static_cast<std::uint32_t>(view.index);
        Truth truth;
        truth.halves = m_store.get(m_stage.scene(), view, m_settings, truth.was_cached);
        truth.mean = compute_mean(*truth.halves);
        return truth;
    }

    [[nodiscard]] std::size_t audited() const override { return m_store.audited(); }

  private:
    RoundStage& m_stage;
    ReferenceStore m_store;
    TraceSettings m_settings;
};

/// The reference's own parameters, into which the target was mapped; rays are the plan's.
PathSettings make_path_settings(const RoundStage& stage) {
    const CellRecord& reference = stage.round().reference;
    const ResolvedParameters parameters =
        read_parameters(stage.units().methods.find(reference.method), reference);
    const auto get = [&parameters](const char* name) { return to_text(parameters.get(name)); };
    PathSettings settings;
    settings.radius_m = to_number(parameters.get("radius"));
    settings.falloff = parse_falloff(get("falloff"));
    settings.normals = parse_normals(get("normals"));
    settings.reach = parse_reach(get("reach")) == Reach::full ? PathReach::full : PathReach::near;
    settings.bounces = static_cast<int>(to_number(parameters.get("bounces")));
    settings.rays_per_half = stage.plan().reference_rays_per_half;
    return settings;
}

class PathTracedTruth final : public TruthSource {
  public:
    explicit PathTracedTruth(RoundStage& stage)
        : m_stage(stage),
          m_store(get_cache_folder(), stage.units().methods.find(kPathTraced).content_hash,
                  {stage.plan().audit_share, stage.plan().audit_seed}),
          m_settings(make_path_settings(stage)) {}

    Truth get(const FrameView& view) override {
        m_stage.set_frame(view);
        // As of rays: noise that stood still would cancel in differences over time.
        m_settings.seed = static_cast<std::uint32_t>(view.index);
        Truth truth;
        const ReferencePair radiance =
            m_store.get(m_stage.scene(), view, m_settings, truth.was_cached);
        truth.halves = {tone_map(radiance.a), tone_map(radiance.b), radiance.ray_count};
        truth.mean = compute_mean(*truth.halves);
        return truth;
    }

    [[nodiscard]] std::size_t audited() const override { return m_store.audited(); }

  private:
    RoundStage& m_stage;
    RadianceStore m_store;
    PathSettings m_settings;
};

/// Every frame stands alone: the method starts anew and, if it has a history, converges.
class MethodTruth final : public TruthSource {
  public:
    explicit MethodTruth(RoundStage& stage)
        : m_stage(stage),
          m_cell(stage.context(), stage.units().methods.find(stage.round().reference.method),
                 stage.round().reference, stage.size()) {
        stage.add_gbuffers(RoundStage::list_keys(m_cell));
    }

    Truth get(const FrameView& view) override {
        m_stage.warm_up(m_cell, view);
        CellTimes times;
        const MethodOutput output = m_cell.render(m_stage.make_measured_inputs(m_cell),
                                                  PassTiming::none, m_stage.timer(), times);
        Truth truth;
        truth.mean = m_stage.read_measured(m_cell, output);
        m_stage.set_frame(view);
        return truth;
    }

  private:
    RoundStage& m_stage;
    MethodCell m_cell;
};

} // namespace

std::unique_ptr<TruthSource> make_truth_source(RoundStage& stage) {
    const std::string& method = stage.round().reference.method;
    if (method == kRayTraced && !stage.measures_pictures()) {
        return std::make_unique<RayTracedTruth>(stage);
    }
    if (method == kPathTraced && stage.measures_pictures()) {
        return std::make_unique<PathTracedTruth>(stage);
    }
    return std::make_unique<MethodTruth>(stage);
}

} // namespace alcove
