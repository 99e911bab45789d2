#pragma once
// Posed geometry as a tree that rays are traced through. What stands still is built once and kept;
// in large scenes a mesh that is placed many times is built once and stays an instance.

#include "core/frame/posed_geometry.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include <glm/mat3x3.hpp>

// Embree's own types, whose header stays out of this one.
struct RTCDeviceTy;
struct RTCSceneTy;

namespace alcove {

/// Where a ray hit, in Embree's numbers.
struct TracedHit {
    unsigned instance = 0; ///< RTC_INVALID_GEOMETRY_ID outside of instances
    unsigned geometry = 0;
    unsigned primitive = 0;
};

/// The corners of a triangle and what lies on them, relative to the scene's origin.
struct TracedTriangle {
    std::array<glm::vec3, 3> corners;
    std::array<glm::vec3, 3> normals;
    const Mesh* mesh = nullptr;            ///< whose triangle it is
    std::array<std::uint32_t, 3> vertices; ///< indices into the mesh's vertices
};

class TracedScene {
  public:
    /// Scenes of at least this many triangles keep repeated meshes as instances. Below, copies cost
    /// little memory and are faster: rays need not be carried into the instance's space.
    static constexpr std::size_t kInstancesFrom = 1'000'000;

    /// Throws FailureError if Embree has no device.
    explicit TracedScene(std::size_t instances_from = kInstancesFrom);

    /// Builds the tree, unless it is already that of this static scene. The scene must outlive its
    /// use. Throws FailureError if Embree fails.
    void update(const PosedGeometry& geometry);

    [[nodiscard]] bool is_built() const noexcept { return m_top != nullptr; }
    [[nodiscard]] RTCSceneTy* top() const noexcept { return m_top.get(); }
    [[nodiscard]] const glm::dvec3& origin() const noexcept { return m_origin; }
    [[nodiscard]] TracedTriangle get_triangle(const TracedHit& hit) const;

  private:
    struct DeviceDeleter {
        void operator()(RTCDeviceTy* device) const;
    };
    struct SceneDeleter {
        void operator()(RTCSceneTy* scene) const;
    };
    using DeviceHandle = std::unique_ptr<RTCDeviceTy, DeviceDeleter>;
    using SceneHandle = std::unique_ptr<RTCSceneTy, SceneDeleter>;

    /// Triangles of one object or of one mesh.
    struct Surface {
        std::vector<glm::vec3> positions;
        std::vector<glm::vec3> normals;
        const Mesh* mesh = nullptr;
    };
    /// A mesh that is placed more than once, or all that stands still.
    struct Shared {
        SceneHandle tree;
        std::vector<Surface> surfaces;
    };

    struct Instance {
        const Shared* shared = nullptr;
        glm::mat4 origin_from_part{1.0f};
        glm::mat3 normal_matrix{1.0f};
    };

    [[nodiscard]] static Surface place(const PosedObject& object);
    [[nodiscard]] SceneHandle make_tree() const;
    void attach(RTCSceneTy* tree, const Surface& surface, unsigned id) const;
    void add_instance(const Shared& shared, const glm::mat4& origin_from_part);
    void commit(RTCSceneTy* tree) const;
    void forget_other_scenes(const PosedGeometry& geometry);
    void build_still(const PosedGeometry& geometry, const std::vector<bool>& is_instance);
    [[nodiscard]] std::vector<bool> choose_instances(const PosedGeometry& geometry) const;
    const Shared& get_mesh(const Mesh& mesh);

    std::size_t m_instances_from;
    DeviceHandle m_device;
    std::map<const Mesh*, Shared> m_meshes;
    std::unique_ptr<Shared> m_still;   ///< what stands still in a scene where something moves
    std::vector<Instance> m_instances; ///< the first geometries of the top scene
    std::vector<Surface> m_direct;     ///< and those behind them
    SceneHandle m_top;
    const Scene* m_built_for = nullptr;
    bool m_is_static = false;
    glm::dvec3 m_origin{0.0};
};

} // namespace alcove
