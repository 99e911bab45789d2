#pragma once
// A scene's triangles in Embree and nothing around them: what the tracers' speed is held against.

#include "core/base/camera.hpp"
#include "core/frame/posed_geometry.hpp"

#include <functional>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

// Embree's own types, whose header stays out of this one.
struct RTCDeviceTy;
struct RTCSceneTy;

namespace alcove {

/// A place that rays start from, just off its surface, and the geometric normal of its side.
struct BareReceiver {
    glm::vec3 origin;
    glm::vec3 normal;
};

class BareScene {
  public:
    explicit BareScene(const PosedGeometry& geometry);
    ~BareScene();
    BareScene(const BareScene&) = delete;
    BareScene& operator=(const BareScene&) = delete;

    [[nodiscard]] RTCSceneTy* tree() const noexcept { return m_tree; }
    /// Where the rays through pixel centres hit, row by row.
    [[nodiscard]] std::vector<BareReceiver> find_receivers(const Camera& camera, ImageSize size,
                                                           const glm::dvec3& origin) const;

  private:
    RTCDeviceTy* m_device = nullptr;
    RTCSceneTy* m_tree = nullptr;
};

/// An orthonormal frame whose third axis is the unit vector `n`.
[[nodiscard]] glm::mat3 make_bare_frame(const glm::vec3& n);

/// The direction of density cos / pi about the frame's third axis for u in [0,1)^2.
[[nodiscard]] glm::vec3 make_bare_direction(const glm::mat3& frame, const glm::vec2& u);

/// `work(first, end)` over [0, count) in blocks, on all cores.
void run_blocks(std::size_t count, std::size_t block,
                const std::function<void(std::size_t, std::size_t)>& work);

} // namespace alcove
