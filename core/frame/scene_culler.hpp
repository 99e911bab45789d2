#pragma once
// Which objects and clusters of a scene a camera may see. What is left out has no pixel in the
// image: the frustum, the cones of clusters whose triangles all face away, and what the nearest
// surfaces hide, each tested with a margin for rounding. So an image is bit-identical to that of
// the whole scene. State comes from the frame alone: nothing is remembered between frames.

#include "core/contract/scene.hpp"
#include "core/frame/box_tree.hpp"
#include "core/frame/depth_pyramid.hpp"

#include <optional>
#include <vector>

namespace alcove {

/// none: every triangle is drawn. frustum: with the cones of clusters. occlusion: and what is
/// hidden.
enum class Culling { none, frustum, occlusion };

/// Consecutive triangles of a mesh.
struct IndexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

struct VisibleObject {
    std::uint32_t object = 0;
    bool culls_back_faces = false; ///< closed, not mirrored and wholly beyond the near plane
    std::uint32_t first_range = 0; ///< into VisibleSet::ranges; at least one
    std::uint32_t range_count = 0;
};

/// In ascending order of objects and ranges.
struct VisibleSet {
    std::vector<VisibleObject> objects;
    std::vector<IndexRange> ranges;
    std::size_t triangles = 0;
};

/// Where the objects of a frame are.
struct FramePose {
    Pose now;
    Pose before;
    struct Deformed {
        std::size_t object = 0;
        Deformation now;
        Deformation before;
    };
    std::vector<Deformed> deformed; ///< ascending in object
};

class SceneCuller {
  public:
    /// The scene must outlive this.
    explicit SceneCuller(const Scene& scene);

    /// Puts what moves where it is on this frame; `pose` must outlive the calls below.
    void set_frame(const FramePose& pose);
    /// Everything, visible or not.
    [[nodiscard]] VisibleSet find_all(const ViewVolume& volume) const;
    /// What lies in the frustum and, with `hider`, is not hidden behind its surfaces.
    struct Hider {
        const DepthPyramid& pyramid;
        const Precision& precision;
    };
    [[nodiscard]] VisibleSet find_visible(const ViewVolume& volume,
                                          const std::optional<Hider>& hider) const;
    /// What lies in the frustum, seen from either side.
    [[nodiscard]] VisibleSet find_in_frustum(const ViewVolume& volume) const;
    /// Of a visible set, the objects that hide most for their triangles: by projected area a
    /// triangle, until `triangles` is used up.
    [[nodiscard]] VisibleSet choose_hiders(const VisibleSet& visible, const ViewVolume& volume,
                                           std::size_t triangles) const;

  private:
    struct Item {
        OrientedBox box;
        bool is_one_sided = false; ///< closed and not mirrored
    };
    /// What an object and its clusters have to pass.
    struct Tests {
        bool tests_frustum = true;
        bool tests_cones = true;
        std::optional<Hider> hider;
    };
    void place(std::size_t object, const glm::dmat4& world_from_object);
    [[nodiscard]] static bool is_kept(const OrientedBox& box, const ViewVolume& volume,
                                      const Tests& tests);
    void add(std::uint32_t object, const ViewVolume& volume, const Tests& tests,
             VisibleSet& visible) const;
    void add_clusters(const Mesh& mesh, std::uint32_t object, const ViewVolume& volume,
                      const Tests& tests, VisibleSet& visible) const;
    [[nodiscard]] VisibleSet find(const ViewVolume& volume, const Tests& tests) const;

    const Scene& m_scene;
    struct MeshBox {
        glm::vec3 low;
        glm::vec3 high;
    };
    std::vector<MeshBox> m_mesh_boxes;
    std::vector<Item> m_items;          ///< one an object
    std::vector<std::uint32_t> m_still; ///< objects, in the order of the tree's boxes
    std::vector<std::uint32_t> m_moving;
    BoxTree m_tree;
    const FramePose* m_pose = nullptr;
};

} // namespace alcove
