#include "scenes/cathedral/guests.hpp"

#include "core/base/assert.hpp"
#include "scenes/cathedral/kit.hpp"
#include "scenes/common/bunny_mesh.hpp"
#include "scenes/common/skeleton_figure.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

namespace alcove::cathedral {
namespace {

constexpr double kStep_s = 1.0 / 30.0; ///< of the walkthrough
constexpr double kThickness = 0.025;   ///< of the long bones, metres

/// Along the aisle (z = 0) to the east, from the start of one of the walkthrough's runs on. Then
/// the skeleton rests until its next walk, where that starts: it jumps when the camera cuts.
struct AisleWalk {
    int first_frame = 0;
    int end_frame = 0; ///< a cut
    double from_x = 0.0;
    double to_x = 0.0;
};
/// Ahead of the camera, which follows from x = -13.6 to 6 on frames 0 to 699; then away from the
/// camera that stands at x = -7.5 on frames 2550 to 2849.
constexpr std::array<AisleWalk, 2> kWalks{{{0, 700, -9.5, 7.5}, {2550, 2850, -3.0, 7.5}}};

struct AislePlace {
    double x = 0.0;
    double cycles = 0.0;
};

AislePlace find_place(double time_s) {
    const double frame = time_s / kStep_s;
    // A frame's time may miss it by a bit.
    const auto walk = std::find_if(kWalks.begin(), kWalks.end() - 1, [frame](const AisleWalk& w) {
        return frame < w.end_frame - 1e-6;
    });
    const double share =
        std::clamp((frame - walk->first_frame) / (walk->end_frame - walk->first_frame), 0.0, 1.0);
    const double way = share * (walk->to_x - walk->from_x);
    // In its first moment both feet stand.
    return {walk->from_x + way, 0.06 + way / get_skeleton_body().cycle};
}

void add_object(AnimatedSceneContent& content, std::string name, std::size_t mesh,
                ObjectMotion motion) {
    AnimatedObject object;
    object.object = {std::move(name), mesh, motion};
    object.node = content.objects.size();
    content.objects.push_back(std::move(object));
}

} // namespace

AnimatedSceneContent add_guests(RigidSceneContent building) {
    ALCOVE_ASSERT(building.walkthrough.tracks.empty(), "a building at rest");
    AnimatedSceneContent content;
    content.meshes = std::move(building.meshes);
    content.lights = std::move(building.lights);
    content.walkthrough = std::move(building.walkthrough);
    content.ao_radius_m = building.ao_radius_m;
    for (Object& object : building.objects) {
        add_object(content, std::move(object.name), object.mesh, ObjectMotion::still);
    }
    std::vector<glm::dmat4> places = std::move(building.transforms);
    if (!find_bunny_obstacle()) {
        // Half its size, beside the axis; it looks down the nave.
        glm::dmat4 place =
            glm::translate(glm::dmat4(1.0), glm::dvec3(13.2, kChoirFloor - 0.004, -1.2));
        place = glm::rotate(place, -1.9, glm::dvec3(0.0, 1.0, 0.0));
        place = glm::scale(place, glm::dvec3(0.8));
        content.meshes.push_back(read_bunny("cathedral"));
        add_object(content, "bunny", content.meshes.size() - 1, ObjectMotion::still);
        places.push_back(place);
    }
    SkeletonMeshes skeleton = make_skeleton(kThickness, 1.0);
    const std::size_t first_mesh = content.meshes.size();
    for (Mesh& mesh : skeleton.meshes) {
        content.meshes.push_back(std::move(mesh));
    }
    for (std::size_t limb = 0; limb < kLimbs; ++limb) {
        const std::size_t mesh = first_mesh + skeleton.of_limb[limb];
        add_object(content, "skeleton " + content.meshes[mesh].name + "#" + std::to_string(limb),
                   mesh, ObjectMotion::rigid);
    }
    content.nodes = [places = std::move(places)](double time_s) {
        const AislePlace place = find_place(time_s);
        const WalkPose pose =
            pose_walk(get_skeleton_body(), place.cycles,
                      glm::translate(glm::dmat4(1.0), glm::dvec3(place.x, 0.0, 0.0)));
        std::vector<glm::dmat4> nodes = places;
        nodes.insert(nodes.end(), pose.begin(), pose.end());
        return nodes;
    };
    return content;
}

} // namespace alcove::cathedral
