#pragma once
// Light that comes from infinitely far away, by direction: what an environment map holds. Kept as
// one small octahedral map, which the rasteriser's methods and the tracer look up alike, so that
// both mean the same light; finer detail than its texels (1.4 degrees and less) is averaged.
// This work is based on: Cigolle, Donow, Evangelakos, Mara, McGuire, Meyer. A survey of efficient
// representations for independent unit vectors. 2014 (octahedral map).

#include "core/base/image.hpp"

#include <functional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// Texture coordinates in [0,1]^2 of a direction (need not be unit, not 0). The pole is +Y, which
/// lies in the middle; u grows with x, v with z; row 0 of an octahedral image is at v = 0.
[[nodiscard]] glm::dvec2 encode_octahedral(const glm::dvec3& direction);
/// The unit direction of texture coordinates.
[[nodiscard]] glm::dvec3 decode_octahedral(const glm::dvec2& coordinates);
/// The texel of an octahedral map of `side` x `side` that lies on the sphere where `texel` would,
/// up to one beyond the border: each edge meets itself in mirror image, the corners meet in one
/// point.
[[nodiscard]] glm::ivec2 wrap_octahedral(const glm::ivec2& texel, int side);

class Environment {
  public:
    static constexpr int kSide = 128;           ///< texels a side of the map
    static constexpr int kPrefilteredSide = 32; ///< of the prefiltered one

    /// Radiance (linear Rec. 709, finite, not negative) of unit world directions. Every texel is
    /// the mean over 8x8 directions. Throws InputError naming `where` on other values.
    Environment(const std::function<glm::vec3(const glm::dvec3&)>& radiance,
                std::string_view where);
    /// From an equirectangular image of three channels or more: row 0 is +Y, the middle column
    /// looks along -Z, columns to the right of it turn towards +X. Throws InputError as above, and
    /// unless the width is twice the height within a pixel.
    [[nodiscard]] static Environment from_equirectangular(const Image& image,
                                                          std::string_view where);

    /// kSide x kSide x 3, linear Rec. 709 radiance.
    [[nodiscard]] const Image& radiance() const noexcept { return m_radiance; }
    /// kPrefilteredSide x kPrefilteredSide x 3: the mean of the radiance over the hemisphere
    /// around a direction, weighted by the cosine (irradiance / pi), from the texels of radiance().
    [[nodiscard]] const Image& prefiltered() const noexcept { return m_prefiltered; }
    /// The texel that a direction falls into.
    [[nodiscard]] glm::vec3 look_up(const glm::dvec3& direction) const;
    /// Between the middles of the four texels around, also across the map's border: for pictures
    /// of the surroundings themselves, which would show the texels. `direction` need not be unit,
    /// not 0.
    [[nodiscard]] glm::vec3 interpolate(const glm::dvec3& direction) const;
    /// Of the bits of radiance(): equal light, equal hash.
    [[nodiscard]] const std::string& content_hash() const noexcept { return m_hash; }

  private:
    Image m_radiance;
    Image m_prefiltered;
    std::string m_hash;
};

} // namespace alcove
