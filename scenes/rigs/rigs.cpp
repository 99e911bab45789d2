#include "scenes/rigs/rigs.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/object_tracks.hpp"
#include "scenes/common/walkthrough_file.hpp"
#include "scenes/hard_cases/bars.hpp"
#include "scenes/hard_cases/foreground.hpp"
#include "scenes/hard_cases/groove.hpp"
#include "scenes/hard_cases/plane.hpp"

#include <array>
#include <memory>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

enum class Rig { plane, corner, tilt, silhouettes, foreground_pole, grazed_corner };
constexpr std::array<const char*, 6> kRigs{"plane",       "corner",          "tilt",
                                           "silhouettes", "foreground_pole", "grazed_corner"};

struct RigsParameters {
    Rig rig = Rig::corner;
    double tilt_degrees = 60.0;
    double distance_m = 5.0;
};

ParameterTable make_table() {
    using P = RigsParameters;
    return describe_parameters(
        "rigs", {choice(&P::rig, "rig", {kRigs.begin(), kRigs.end()})
                     .meaning("a plane that faces the camera, floor and wall that meet, a plane "
                              "that leans away, bars before the sky, a pole before a far wall, the "
                              "corner seen along its floor")
                     .source("ours; \"Know your SSAO artifacts\""),
                 real(&P::tilt_degrees, "tilt")
                     .range(0.0, 85.0)
                     .unit("degrees")
                     .meaning("how far the plane of rig=tilt leans away from the camera")
                     .alive_with("rig=tilt")
                     .source("ours"),
                 real(&P::distance_m, "distance")
                     .range(2.5, 30.0)
                     .log_scale()
                     .unit("m")
                     .meaning("from the walkthrough's start to the planes of rig=plane and "
                              "rig=tilt, along the view axis")
                     .alive_with("rig=tilt")
                     .source("ours")});
}

std::unique_ptr<Scene> make_case(const RigsParameters& parameters) {
    PlaneSettings plane;
    // 1 km is too much for a tracer in float: rays from far out on the slope hit the plane itself.
    plane.half_m = 40.0;
    plane.distance_m = parameters.distance_m;
    switch (parameters.rig) {
    case Rig::plane:
        return make_plane_case(plane);
    case Rig::corner:
    case Rig::grazed_corner:
        return make_groove_case(GrooveAxis::horizontal);
    case Rig::tilt:
        plane.tilt_degrees = parameters.tilt_degrees;
        return make_plane_case(plane);
    case Rig::silhouettes:
        return make_bars_case(0.5);
    case Rig::foreground_pole:
        return make_foreground_case(2.0);
    }
    ALCOVE_ASSERT(false, "a rig of the list");
    return nullptr;
}

/// A hard case, which has one camera, under a light and with a walkthrough.
class RigScene final : public Scene {
  public:
    RigScene(std::unique_ptr<Scene> hard_case, Walkthrough walkthrough)
        : m_case(std::move(hard_case)), m_walkthrough(std::move(walkthrough)) {
        place_walkthrough(m_walkthrough, glm::dvec3(0.0));
        m_lights.directional.push_back(
            {glm::normalize(glm::dvec3(0.4, 1.0, 0.9)), glm::vec3(0.6f)});
        m_lights.ambient = glm::vec3(0.6f);
    }

    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_case->get_meshes(); }
    [[nodiscard]] std::span<const Object> get_objects() const override {
        return m_case->get_objects();
    }
    [[nodiscard]] const Lights& get_lights() const override { return m_lights; }
    [[nodiscard]] const Walkthrough& get_walkthrough() const override { return m_walkthrough; }
    [[nodiscard]] double get_ao_radius_m() const override { return m_case->get_ao_radius_m(); }
    [[nodiscard]] Pose compute_pose(double time_s) const override {
        return m_case->compute_pose(time_s);
    }

  private:
    std::unique_ptr<Scene> m_case;
    Walkthrough m_walkthrough;
    Lights m_lights;
};

std::unique_ptr<Scene> open_rigs(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<RigsParameters>(resolved);
    const std::string name = kRigs.at(static_cast<std::size_t>(parameters.rig));
    return std::make_unique<RigScene>(
        make_case(parameters),
        get_embedded_walkthrough("scenes/rigs/walkthrough_" + name + ".json"));
}

} // namespace

SceneUnit rigs_unit() {
    SceneUnit unit;
    unit.name = "rigs";
    unit.title = "Test rigs for artefacts";
    unit.stresses = "one artefact each: a plane that darkens itself, bands beside a corner, what "
                    "changes with tilt, black silhouettes, darkening by a far foreground";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_rigs;
    return unit;
}

} // namespace alcove
