#pragma once
// Spheres that stand for a scene: clusters of points on its surfaces, found once in the rest pose,
// which follow those surfaces wherever they are posed.
// This work is based on: Shanmugam, Arikan. Hardware accelerated ambient occlusion techniques on
// GPUs. 2007, section 5; Lloyd. Least squares quantization in PCM. 1982.

#include "core/frame/posed_geometry.hpp"
#include "methods/shanmugam_arikan/shanmugam_arikan.hpp"

#include <cstdint>
#include <vector>

namespace alcove {

/// A point of an object that moves with its triangle.
struct ClusterMember {
    std::uint32_t triangle = 0; ///< index of its first corner among the mesh's indices
    float u = 0.0f;             ///< weight of the second corner
    float v = 0.0f;             ///< of the third
};

/// Neighbours in `ClusterSet::members`.
struct SphereCluster {
    std::uint32_t object = 0;
    std::uint32_t first = 0;
    std::uint32_t count = 0; ///< > 0
};

struct ClusterSet {
    std::vector<ClusterMember> members;
    std::vector<SphereCluster> clusters; ///< by object
};

struct ClusterSettings {
    int spheres = 2000;
    SphereMembers members = SphereMembers::surface;
};

/// Members a sphere, where they are spread over the surface.
inline constexpr int kMembersPerSphere = 16;

/// Spheres by objects' share of the area; an object with less than half a sphere's share gets none.
/// A function of the geometry and the settings alone.
[[nodiscard]] ClusterSet find_clusters(const PosedGeometry& rest, const ClusterSettings& settings);

/// As find_clusters, from the cache's folder `spheres` where they were found before; finds and
/// stores them otherwise. A damaged file is made anew.
[[nodiscard]] ClusterSet get_clusters(const PosedGeometry& rest, const ClusterSettings& settings);

struct Sphere {
    glm::vec3 center; ///< relative to the geometry's origin
    float radius = 0.0f;
};

/// One a cluster, in order, from the members' places in this pose: the mean of their places, pushed
/// back, and the radius that the rule gives.
class SpherePoser {
  public:
    /// `push_back`: see ShanmugamArikanParams::sphere_push_back.
    SpherePoser(ClusterSet clusters, RadiusRule rule, double push_back)
        : m_clusters(std::move(clusters)), m_rule(rule), m_push_back(push_back) {}
    /// What cannot deform is placed by its transform from what it was first.
    [[nodiscard]] std::vector<Sphere> pose(const PosedGeometry& geometry);
    [[nodiscard]] std::size_t size() const noexcept { return m_clusters.clusters.size(); }

  private:
    ClusterSet m_clusters;
    RadiusRule m_rule;
    double m_push_back;
    std::vector<Sphere> m_local; ///< in object space; those of deforming objects anew every time
};

} // namespace alcove
