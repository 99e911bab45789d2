#pragma once
// A walking knight: a skinned body, rigid plates of armour, sword and shield, and a cloak.

#include "scenes/common/animated_scene.hpp"
#include "scenes/common/cloak.hpp"
#include "scenes/common/gait.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace alcove {

/// Metres; about 1.9 high with the crest.
[[nodiscard]] const WalkerBody& get_knight_body();

struct KnightLook {
    glm::vec3 cloak{0.42f, 0.05f, 0.05f};
    glm::vec3 surcoat{0.16f, 0.2f, 0.42f};
    int seed = 1; ///< of the cloak's folds
};

/// A mesh whose vertices limbs pull along.
struct SkinnedMesh {
    Mesh mesh; ///< at rest (pose_rest)
    SkinInfluences influences;
};
/// Torso, head, arms and legs under mail, and the surcoat: knight_body.cpp.
[[nodiscard]] SkinnedMesh make_knight_body(double detail, const glm::vec3& surcoat);
/// Helmet, plates, boots, sword and shield with the limb that carries each, in the limb's space:
/// knight_armour.cpp.
struct KnightPlate {
    Mesh mesh;
    Limb limb = kTorso;
};
[[nodiscard]] std::vector<KnightPlate> make_knight_plates(double detail, const glm::vec3& colour);

/// Knights in the making of a scene. Those of one look share meshes.
class KnightTroop {
  public:
    /// `detail` scales the number of vertices of every knight, 43,000 at 1.
    explicit KnightTroop(double detail) : m_detail(detail) {}

    /// Adds meshes; returns the look's number.
    std::size_t add_look(AnimatedSceneContent& content, const KnightLook& look);
    /// Adds objects. Knights must be the last to add nodes: theirs follow those before them.
    void add_knight(AnimatedSceneContent& content, std::size_t look, const CircleWalk& walk,
                    const std::string& name, std::size_t first_node);
    static constexpr std::size_t kNodes = 1 + kLimbs; ///< a knight: its frame, then its limbs

    /// Appends the nodes of all knights in the order they were added.
    void append_nodes(double time_s, std::vector<glm::dmat4>& nodes) const;

  private:
    struct Look {
        std::size_t body = 0;                             ///< mesh
        std::vector<std::pair<std::size_t, Limb>> plates; ///< meshes
        std::size_t cloth = 0;                            ///< mesh
        std::shared_ptr<const Cloak> cloak;
    };
    double m_detail;
    std::vector<Look> m_looks;
    std::vector<CircleWalk> m_walks;
};

} // namespace alcove
