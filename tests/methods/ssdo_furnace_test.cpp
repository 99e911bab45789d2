// The white furnace in every shipped scene: light of 1 from all around, and no other. What is
// reflected never exceeds what came in, and the bounce brings no more than one-bounce path tracing
// of the same reach.
#include "methods/common/path_tracer.hpp"
#include "methods/common/sample_sets.hpp"
#include "methods/ssdo/ssdo.hpp"
#include "scenes/registry.hpp"
#include "tests/methods/light_shots.hpp"

#include <cmath>
#include <map>

namespace alcove {
namespace {

constexpr ImageSize kSize{192, 144};
constexpr int kFrame = 28;

/// Bounds of the mean over surfaces of direct light and bounce against path tracing's, where it is
/// more than 1.02: a hundredth above what was measured. Light from blocked directions is there
/// without a bounce already (1.015 to 1.051): a sample asks where its end lies, not what lies on
/// the way, and passes blockers that are thinner than the radius.
const std::map<std::string, double> kExceptions{{"city", 1.057},
                                                {"closed_room", 1.036},
                                                {"foliage_and_vehicle", 1.067},
                                                {"molecule", 1.043},
                                                {"pebbles", 1.041}};

/// Relative standard error of one set of 16 samples in the open: the spread of a tile's sets. The
/// blur takes the mean of all of them, but of fewer beside an edge.
double compute_open_error() {
    const std::vector<glm::vec4> points = make_sample_sets(4, 16);
    std::vector<double> sets(16, 0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        sets[i / 16] += 2.0 * points[i].z / 16.0;
    }
    double squares = 0.0;
    for (const double set : sets) {
        squares += (set - 1.0) * (set - 1.0) / 16.0;
    }
    return std::sqrt(squares);
}

double average_over_surfaces(const Image& radiance, const LightShot& shot) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < shot.eye_depth.values().size(); ++i) {
        if (std::isfinite(shot.eye_depth.values()[i])) {
            sum += radiance.values()[3 * i + 1];
            ++count;
        }
    }
    return sum / static_cast<double>(count);
}

class SsdoFurnaceTest : public LightShotTest, public testing::WithParamInterface<std::string> {};

TEST_P(SsdoFurnaceTest, GivesNoMoreThanItHolds) {
    const std::unique_ptr<Scene> scene =
        open_lit_scene(GetParam(), "", "environment=uniform,sun=0,shadows=true");
    const int frame =
        std::min(kFrame, static_cast<int>(scene->get_walkthrough().cameras.size()) - 1);
    const LightShot direct = shoot(ssdo_unit(), "bounce=false", *scene, kSize, frame);
    const double most = 1.0 + 3.0 * compute_open_error();
    for (std::size_t i = 0; i < direct.radiance.values().size(); ++i) {
        if (std::isfinite(direct.eye_depth.values()[i / 3])) {
            ASSERT_LE(direct.radiance.values()[i], direct.albedo.values()[i] * most + 0x1p-10) << i;
        }
    }
    const FrameView view = make_frame_view(scene->get_walkthrough(), frame, kSize, true);
    PathSettings settings;
    settings.radius_m = scene->get_ao_radius_m();
    settings.rays_per_half = 16;
    PathTracer tracer;
    tracer.update(pose_geometry(*scene, view.time_s));
    const Image truth =
        compute_mean(tracer.trace(view.camera, kSize, scene->get_lights(), settings).indirect);
    const LightShot both = shoot(ssdo_unit(), "", *scene, kSize, frame);
    const double traced = average_over_surfaces(truth, both);
    const double ratio = average_over_surfaces(both.radiance, both) / traced;
    std::printf("%s: direct %.3f, with a bounce %.3f of one-bounce path tracing\n",
                GetParam().c_str(), average_over_surfaces(direct.radiance, direct) / traced, ratio);
    const auto exception = kExceptions.find(GetParam());
    EXPECT_LE(ratio, exception == kExceptions.end() ? 1.02 : exception->second);
}

std::vector<std::string> list_scenes() {
    std::vector<std::string> names;
    const Registry<SceneUnit> scenes = scenes_registry();
    for (const SceneUnit& unit : scenes.units()) {
        names.push_back(unit.name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Shipped, SsdoFurnaceTest, testing::ValuesIn(list_scenes()),
                         [](const auto& entry) { return entry.param; });

} // namespace
} // namespace alcove
