#include "scenes/common/knight.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/grid.hpp"

#include <glm/matrix.hpp>

namespace alcove {
namespace {

WalkerBody make_body() {
    WalkerBody body;
    body.hip = 0.94;
    body.thigh_length = 0.45;
    body.shin_length = 0.44;
    body.ankle = 0.09;
    body.shoulder = 0.49;
    body.neck = 0.56;
    body.upper_arm_length = 0.3;
    body.half_hips = 0.1;
    body.cycle = 1.0;
    body.half_shoulders = 0.235;
    body.arms = {{{0.1, 0.1, 1.25, 0.06}, {0.05, 0.25, 0.55, 0.1}}}; // shield, sword
    return body;
}

/// What moves the torso away from its place at rest, in the walker's frame.
glm::dmat4 measure_torso(double cycles) {
    const WalkerBody& body = get_knight_body();
    return pose_walk(body, cycles, glm::dmat4(1.0))[kTorso] * glm::inverse(pose_rest(body)[kTorso]);
}

} // namespace

const WalkerBody& get_knight_body() {
    static const WalkerBody kBody = make_body();
    return kBody;
}

std::size_t KnightTroop::add_look(AnimatedSceneContent& content, const KnightLook& look) {
    const auto add_mesh = [&content](Mesh mesh) {
        content.meshes.push_back(std::move(mesh));
        content.deformers.resize(content.meshes.size());
        return content.meshes.size() - 1;
    };
    const std::string suffix = "_" + std::to_string(m_looks.size());
    Look made;
    SkinnedMesh body = make_knight_body(m_detail, look.surcoat);
    body.mesh.name += suffix;
    made.body = add_mesh(std::move(body.mesh));
    content.deformers[made.body].influences = std::move(body.influences);
    for (KnightPlate& plate : make_knight_plates(m_detail, look.surcoat)) {
        plate.mesh.name += suffix;
        made.plates.emplace_back(add_mesh(std::move(plate.mesh)), plate.limb);
    }
    const double hip_m = pose_rest(get_knight_body())[kTorso][3].y;
    made.cloak = std::make_shared<const Cloak>(m_detail, look.seed, hip_m);
    made.cloth = add_mesh(made.cloak->make_mesh("cloak" + suffix, look.cloak));
    m_looks.push_back(std::move(made));
    return m_looks.size() - 1;
}

void KnightTroop::add_knight(AnimatedSceneContent& content, std::size_t look,
                             const CircleWalk& walk, const std::string& name,
                             std::size_t first_node) {
    ALCOVE_ASSERT(look < m_looks.size(), "a look that was added");
    const Look& made = m_looks[look];
    Skin skin;
    const WalkPose rest = pose_rest(get_knight_body());
    for (std::size_t limb = 0; limb < kLimbs; ++limb) {
        skin.joints.push_back(first_node + 1 + limb);
        skin.inverse_bind.push_back(glm::inverse(rest[limb]));
    }
    content.skins.push_back(std::move(skin));
    AnimatedObject body;
    body.object = {name + " body", made.body, ObjectMotion::deforming};
    body.node = first_node;
    body.skin = content.skins.size() - 1;
    content.objects.push_back(std::move(body));
    for (const auto& [mesh, limb] : made.plates) {
        AnimatedObject plate;
        plate.object = {name + " " + content.meshes[mesh].name + " " +
                            std::to_string(content.objects.size()),
                        mesh, ObjectMotion::rigid};
        plate.node = first_node + 1 + limb;
        content.objects.push_back(std::move(plate));
    }
    AnimatedObject cloth;
    cloth.object = {name + " cloak", made.cloth, ObjectMotion::deforming};
    cloth.node = first_node;
    cloth.procedure = [cloak = made.cloak, walk](double time_s) {
        const double cycles = count_cycles(walk, get_knight_body(), time_s);
        return cloak->deform(cycles, measure_torso(cycles));
    };
    content.objects.push_back(std::move(cloth));
    m_walks.push_back(walk);
}

void KnightTroop::append_nodes(double time_s, std::vector<glm::dmat4>& nodes) const {
    for (const CircleWalk& walk : m_walks) {
        const glm::dmat4 frame = place_on_circle(walk, time_s);
        const WalkPose pose =
            pose_walk(get_knight_body(), count_cycles(walk, get_knight_body(), time_s), frame,
                      walk.curvature());
        nodes.push_back(frame);
        nodes.insert(nodes.end(), pose.begin(), pose.end());
        for (auto node = nodes.end() - kNodes; node != nodes.end(); ++node) {
            (*node)[3] = glm::dvec4(snap_to_grid(glm::dvec3((*node)[3])), 1.0);
        }
    }
}

} // namespace alcove
