#include "scenes/lifted_box/lifted_box.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace alcove {
namespace {

enum class Motion { lift, slide };
enum class Speed { slow, medium, fast };

struct LiftedBoxParameters {
    Motion motion = Motion::lift;
    Speed speed = Speed::medium;
};

/// The scene's AO radius r, in metres. Ways and speeds are told in it: what matters to a history is
/// how much of the occlusion changes within a frame.
constexpr double kRadius = 0.5;
constexpr int kBegin = 58;  ///< frame at which the box starts on its way: in the middle burst
constexpr int kReturn = 98; ///< frame at which it starts back, if it has arrived by kLastArrival
constexpr int kLastArrival = 90;
/// The box stands this deep in the floor, metres: in contact, without two faces in one plane; less
/// than the way of one frame, so that it is free of the floor after the first one.
constexpr double kSink = 0.004;

struct MotionInfo {
    glm::dvec3 direction;
    double way; ///< in r
    const char* begins;
};

const MotionInfo& describe(Motion motion) {
    static const std::array<MotionInfo, 2> kMotions{
        {{{0.0, 1.0, 0.0}, 1.6, "box lifts"}, {{1.0, 0.0, 0.0}, 4.0, "box slides"}}};
    return kMotions[static_cast<std::size_t>(motion)];
}

/// In r a frame.
double get_step(Speed speed) {
    constexpr std::array<double, 3> kSteps{0.02, 0.2, 1.5};
    return kSteps[static_cast<std::size_t>(speed)];
}

ParameterTable make_table() {
    using P = LiftedBoxParameters;
    return describe_parameters(
        "lifted_box",
        {choice(&P::motion, "motion", {"lift", "slide"})
             .meaning("what the box does: rise by 1.6 r, or slide over the floor by 4 r; r is the "
                      "AO radius")
             .source("ours"),
         choice(&P::speed, "speed", {"slow", "medium", "fast"})
             .meaning("how far it gets in a frame: 0.02 r, 0.2 r or 1.5 r")
             .source("ours")});
}

/// Adds keys from `from` to `to` at `step_m` metres a frame; the last frame of the way may be
/// shorter than a step. Returns the frame of the arrival, which may lie beyond the walkthrough.
int add_way(std::vector<TrackKey>& keys, int begin, const glm::dvec3& from, const glm::dvec3& to,
            double step_m) {
    const double way = glm::distance(from, to);
    // 1e-9: 0.8 / 0.01 is 80 steps, whichever way its last bit falls.
    const int steps = static_cast<int>(std::floor(way / step_m + 1e-9));
    ALCOVE_ASSERT(steps > 0, "a way of a frame or more");
    keys.push_back({begin, from, 0.0});
    if (steps * step_m > way * (1.0 - 1e-9)) {
        keys.push_back({begin + steps, to, 0.0});
        return begin + steps;
    }
    keys.push_back({begin + steps, from + (to - from) * (steps * step_m / way), 0.0});
    keys.push_back({begin + steps + 1, to, 0.0});
    return begin + steps + 1;
}

/// Ends a track on the walkthrough's last frame, at the place it has reached by then.
void cut_off(std::vector<TrackKey>& keys, int last_frame) {
    while (keys.size() > 1 && keys[keys.size() - 2].frame >= last_frame) {
        keys.pop_back();
    }
    TrackKey& end = keys.back();
    const TrackKey& before = keys[keys.size() - 2];
    if (end.frame > last_frame) {
        const double share =
            static_cast<double>(last_frame - before.frame) / (end.frame - before.frame);
        end = {last_frame, before.translation + share * (end.translation - before.translation),
               0.0};
    }
}

void add_motion(Walkthrough& walkthrough, const LiftedBoxParameters& parameters) {
    const MotionInfo& motion = describe(parameters.motion);
    const double step_m = get_step(parameters.speed) * kRadius;
    const glm::dvec3 rest(0.0);
    const glm::dvec3 away = motion.direction * (motion.way * kRadius);
    const int last_frame = static_cast<int>(walkthrough.cameras.size()) - 1;
    ObjectTrack track;
    track.object = "box";
    walkthrough.events.push_back({kBegin, motion.begins});
    const int arrival = add_way(track.keys, kBegin, rest, away, step_m);
    if (arrival <= last_frame) {
        walkthrough.events.push_back({arrival, "box rests"});
    }
    if (arrival <= kLastArrival) {
        walkthrough.events.push_back({kReturn, "box comes back"});
        const int back = add_way(track.keys, kReturn, away, rest, step_m);
        ALCOVE_ASSERT(back <= last_frame, "the box is back before the end");
        walkthrough.events.push_back({back, "box is back"});
    }
    cut_off(track.keys, last_frame);
    walkthrough.tracks.push_back(std::move(track));
}

std::unique_ptr<Scene> open_lifted_box(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<LiftedBoxParameters>(resolved);
    RigidSceneContent content;
    content.meshes.push_back(
        make_box_mesh("floor", glm::vec3(0.6f), {-4.0, -0.25, -4.0}, {4.0, 0.0, 4.0}));
    content.meshes.push_back(
        make_box_mesh("box", {0.75f, 0.55f, 0.35f}, {-0.5, -kSink, -0.5}, {0.5, 1.0, 0.5}));
    MeshBuilder pillar;
    add_lathe(pillar, {{0.3, -0.05}, {0.3, 0.7}}, 48);
    content.meshes.push_back(pillar.finish("pillar", {0.45f, 0.6f, 0.7f}, 30.0));
    content.objects = {{"floor", 0}, {"box", 1}, {"pillar", 2}};
    const auto place = [](double x, double z) {
        return glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0.0, z));
    };
    // The pillar stands 0.15 m from the resting box: each occludes the other until the box leaves.
    content.transforms = {glm::dmat4(1.0), place(-1.0, 0.0), place(-1.95, 0.1)};
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.5, 1.0, 0.3)), glm::vec3(1.0f)});
    content.lights.ambient = glm::vec3(0.5f);
    content.walkthrough = get_embedded_walkthrough("scenes/lifted_box/walkthrough.json");
    add_motion(content.walkthrough, parameters);
    content.ao_radius_m = kRadius;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit lifted_box_unit() {
    SceneUnit unit;
    unit.name = "lifted_box";
    unit.title = "Box that leaves the floor";
    unit.stresses = "histories: a contact shadow that must fade where the box has been, at three "
                    "speeds told in AO radii, under a still camera";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_lifted_box;
    return unit;
}

} // namespace alcove
