#include "scenes/closed_room/closed_room.hpp"

#include "scenes/closed_room/props.hpp"
#include "scenes/common/scene_kit.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/split_mix.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

struct ClosedRoomParameters {
    int props = 14;
    int seed = 1;
};

// Inside, metres.
constexpr double kHalfX = 3.0;
constexpr double kHalfZ = 2.5;
constexpr double kHeight = 2.6;
constexpr double kWall = 0.2; ///< thickness

ParameterTable make_parameter_table() {
    using P = ClosedRoomParameters;
    return describe_parameters(
        "closed_room", {integer(&P::props, "props")
                            .range(0, 21)
                            .unit("1")
                            .meaning("pieces of furniture: the table, then others along the walls")
                            .source("ours"),
                        integer(&P::seed, "seed")
                            .range(0, 65535)
                            .unit("1")
                            .meaning("chooses what stands where")
                            .source("ours")});
}

/// One solid: a box and, turned inside out, the box of the air in it.
Mesh make_shell() {
    MeshBuilder builder;
    add_box(builder, {-kHalfX - kWall, -kWall, -kHalfZ - kWall},
            {kHalfX + kWall, kHeight + kWall, kHalfZ + kWall});
    MeshBuilder air;
    add_box(air, {-kHalfX, 0.0, -kHalfZ}, {kHalfX, kHeight, kHalfZ});
    const auto first = static_cast<std::uint32_t>(builder.points().size());
    for (const glm::dvec3& point : air.points()) {
        builder.add_point(point);
    }
    for (const auto& [a, b, c] : air.triangles()) {
        builder.add_triangle(first + a, first + c, first + b);
    }
    return builder.finish("room", {0.72f, 0.7f, 0.66f}, 0.0);
}

/// Where a prop may stand, with its back to a wall, in the order in which they are filled.
struct Slot {
    glm::dvec3 position{0.0};
    double radians = 0.0;
};

std::vector<Slot> list_slots(SplitMix& random) {
    constexpr double kPi = std::numbers::pi;
    constexpr double kBack = 0.34; ///< from the wall to a prop's middle
    std::vector<Slot> slots;
    for (int i = 0; i < 6; ++i) {
        const double x = -2.2 + 0.88 * i;
        slots.push_back({{x, 0.0, -kHalfZ + kBack}, 0.0});
        slots.push_back({{x, 0.0, kHalfZ - kBack}, kPi});
    }
    for (const double z : {-1.3, -0.45, 0.45, 1.3}) {
        slots.push_back({{-kHalfX + kBack, 0.0, z}, 0.5 * kPi});
        slots.push_back({{kHalfX - kBack, 0.0, z}, -0.5 * kPi});
    }
    for (std::size_t i = slots.size(); i > 1; --i) {
        std::swap(slots[i - 1],
                  slots[static_cast<std::size_t>(random.draw_index(static_cast<int>(i)))]);
    }
    return slots;
}

std::unique_ptr<Scene> open_closed_room(const ResolvedParameters& resolved) {
    const auto parameters = make_parameter_table().bind<ClosedRoomParameters>(resolved);
    SplitMix random(static_cast<std::uint64_t>(parameters.seed) * 2 + 1);
    SceneKit kit;
    kit.add(make_shell());
    if (parameters.props > 0) {
        kit.add(closed_room::make_table());
    }
    std::vector<std::size_t> meshes;
    if (parameters.props > 1) {
        for (Mesh& mesh : closed_room::make_props()) {
            meshes.push_back(kit.add_mesh(std::move(mesh)));
        }
    }
    const std::vector<Slot> slots = list_slots(random);
    const int first = random.draw_index(static_cast<int>(slots.size()));
    for (int i = 0; i + 1 < parameters.props; ++i) {
        // In turn, so that there are as many of each kind.
        const std::size_t mesh = meshes[static_cast<std::size_t>(first + i) % meshes.size()];
        const Slot& slot = slots.at(static_cast<std::size_t>(i));
        kit.place(mesh, make_place(slot.position, slot.radians));
    }
    RigidSceneContent content = kit.take();
    // Through the walls: without shadow, so that it reaches the room.
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.35, 1.0, 0.5)), glm::vec3(0.75f, 0.72f, 0.66f)});
    content.lights.ambient = glm::vec3(0.55f);
    content.walkthrough = get_embedded_walkthrough("scenes/closed_room/walkthrough.json");
    content.ao_radius_m = 0.6;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit closed_room_unit() {
    SceneUnit unit;
    unit.name = "closed_room";
    unit.title = "Closed room with furniture";
    unit.stresses = "no sky anywhere: whatever counts distant surfaces makes it black; corners of "
                    "three planes, the insides of a vase and shelves, no background pixel";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_parameter_table();
    unit.open = open_closed_room;
    return unit;
}

} // namespace alcove
