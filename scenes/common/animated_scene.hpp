#pragma once
// A scene whose objects hang on moving nodes and may be skinned and morphed: what glTF files and
// procedural characters become.

#include "core/contract/scene.hpp"
#include "scenes/common/morphing.hpp"
#include "scenes/common/object_tracks.hpp"
#include "scenes/common/skinning.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace alcove {

/// The joints of one skeleton.
struct Skin {
    std::vector<std::size_t> joints;      ///< nodes
    std::vector<glm::dmat4> inverse_bind; ///< mesh at rest to joint, one a joint
};

/// How the vertices of a mesh can move besides rigidly. First morphed, then skinned.
struct MeshDeformers {
    std::optional<SkinInfluences> influences; ///< joints index Skin::joints
    std::vector<MorphTarget> targets;
    bool is_flat = false;   ///< normals follow from the moved triangles, which share no vertices
    bool is_turned = false; ///< triangles are clockwise: for objects of mirroring nodes
};

struct AnimatedObject {
    Object object;                   ///< `motion` as the nodes and deformers move it
    std::size_t node = 0;            ///< where it hangs; skinned vertices ignore it
    std::optional<std::size_t> skin; ///< needs influences of its mesh
    bool is_morphed = false;         ///< needs `weights`
    /// Instead of skin and weights: its vertices in the space of its node, from the time alone.
    std::function<Deformation(double time_s)> procedure;
};

/// All that makes an animated scene, relative to `origin`.
struct AnimatedSceneContent {
    std::vector<Mesh> meshes;
    std::vector<MeshDeformers> deformers; ///< one a mesh, or none at all
    std::vector<Texture> textures;
    std::vector<AnimatedObject> objects;
    std::vector<Skin> skins;
    /// Node to scene for every node, from the time alone.
    std::function<std::vector<glm::dmat4>(double time_s)> nodes;
    /// Weights of the morph targets of an object, from the time alone.
    std::function<std::vector<double>(std::size_t object, double time_s)> weights;
    /// A promise: nodes and weights are the same at all times. Objects may still be deforming:
    /// their meshes are not what a skin or weights make of them.
    bool is_at_rest = false;
    Lights lights; ///< at time 0, in the world
    /// The moving nodes on which they hang, one a directional light and one a point; nothing, or
    /// missing at the end: it stands still. A light shines along -z of its node.
    std::vector<std::optional<std::size_t>> directional_nodes;
    std::vector<std::optional<std::size_t>> point_nodes;
    Walkthrough walkthrough; ///< cameras and the pivots of tracks relative to the origin as well
    double ao_radius_m = 0.5;
    glm::dvec3 origin{0.0}; ///< as RigidSceneContent's
};

/// The vertices of a deforming object, given where the nodes are at that time.
[[nodiscard]] Deformation deform_object(const AnimatedSceneContent& content, std::size_t object,
                                        const std::vector<glm::dmat4>& nodes, double time_s);

/// Tracks of the walkthrough move objects further, in front of their nodes (ObjectTracks::apply).
/// The object_to_world of a skinned object is that track and the origin, nothing else. Asserts
/// that meshes, skins and joints are in range and have what their objects need.
class AnimatedScene final : public Scene {
  public:
    explicit AnimatedScene(AnimatedSceneContent content);

    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_content.meshes; }
    [[nodiscard]] std::span<const Object> get_objects() const override { return m_objects; }
    [[nodiscard]] std::span<const Texture> get_textures() const override {
        return m_content.textures;
    }
    [[nodiscard]] const Lights& get_lights() const override { return m_content.lights; }
    [[nodiscard]] Lights compute_lights(double time_s) const override;
    [[nodiscard]] const Walkthrough& get_walkthrough() const override {
        return m_content.walkthrough;
    }
    [[nodiscard]] double get_ao_radius_m() const override { return m_content.ao_radius_m; }
    [[nodiscard]] glm::dvec3 get_origin() const override { return m_content.origin; }
    [[nodiscard]] Pose compute_pose(double time_s) const override;
    [[nodiscard]] Deformation deform(std::size_t object, double time_s) const override;
    /// True if all objects are still, or the content is at rest and no track moves anything;
    /// whether lights move is another matter.
    [[nodiscard]] bool is_static() const override { return m_is_static; }

  private:
    using Nodes = std::shared_ptr<const std::vector<glm::dmat4>>;
    [[nodiscard]] Nodes find_nodes(double time_s) const;

    AnimatedSceneContent m_content; ///< cameras already in the world, nodes not
    std::vector<Object> m_objects;
    ObjectTracks m_tracks;
    bool m_is_static = true;
    /// The nodes at the last two times asked for: every object of a frame asks for t and t - 1.
    struct Known {
        double time_s = 0.0;
        Nodes nodes;
    };
    mutable std::mutex m_mutex;
    mutable std::array<Known, 2> m_known;
};

} // namespace alcove
