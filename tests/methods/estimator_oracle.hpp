#pragma once
// Estimators restated in double precision over a depth image: what they share, and how a method's
// image is compared with one.

#include "tests/methods/depth_image_rig.hpp"

#include <functional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// A depth image as a shader sees it, in double. Pixels count from the bottom left.
class OracleImage {
  public:
    /// `normal` as the texture holds it.
    OracleImage(const DepthImage& input, const Image& normal);

    struct Receiver {
        glm::ivec2 pixel;
        double depth; ///< infinite: background, the rest is undefined
        glm::dvec3 position;
        glm::dvec3 normal;
    };
    [[nodiscard]] Receiver get_receiver(int x, int y) const;
    [[nodiscard]] glm::ivec2 size() const { return m_size; }
    [[nodiscard]] glm::dvec2 tangents() const { return m_tangents; }
    /// Asserts that the pixel lies inside.
    [[nodiscard]] double get_depth(glm::ivec2 pixel) const;
    /// Through the pixel's centre, of unit depth.
    [[nodiscard]] glm::dvec3 get_ray(glm::ivec2 pixel) const;

    struct Place {
        glm::ivec2 pixel;
        bool is_inside = false;
        bool is_near_edge = false; ///< of its pixel: floats may take the neighbour
    };
    /// Where a view-space point in front of the camera is seen.
    [[nodiscard]] Place find_place(const glm::dvec3& point) const;
    /// The same for a place in pixels.
    [[nodiscard]] Place find_place(const glm::dvec2& place) const;

  private:
    const Image* m_depth;
    const Image* m_normal;
    glm::ivec2 m_size;
    glm::dvec2 m_tangents;
};

/// What an oracle says of a pixel; `is_doubtful` where a choice is too near to its switch.
struct OracleAnswer {
    double visibility = 1.0;
    bool is_doubtful = false;
};
using PixelOracle = std::function<OracleAnswer(const OracleImage&, const OracleImage::Receiver&)>;

struct OracleComparison {
    int pixels = 0;   ///< without background
    int compared = 0; ///< not doubtful
    int occluded = 0; ///< of those, visibility below 0.95
    double largest_deviation = 0.0;
};

/// Fails if fewer than 70 % of the surface pixels can be compared, fewer than 4 % are occluded, or
/// one of them deviates by more than `tolerance`; the background must be exactly 1.
void expect_oracle(const DepthImage& input, const RigResult& result, const PixelOracle& oracle,
                   double tolerance);

} // namespace alcove
