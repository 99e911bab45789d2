#pragma once
// Parts of a frame by what its surfaces are: where errors of one kind live. Masks from the
// full-precision G-buffer, whatever the method saw.

#include "core/base/image.hpp"
#include "core/frame/reprojection.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace alcove {

struct StratumInfo {
    std::string name;
    std::string title;      ///< for people
    std::string definition; ///< which pixels
};

/// In the order of make_strata.
[[nodiscard]] const std::vector<StratumInfo>& list_strata();

/// "METRIC[STRATUM]": the column of a metric over a stratum.
[[nodiscard]] std::string make_stratum_column(const std::string& metric,
                                              const std::string& stratum);
/// The column that tells how many pixels a stratum counts.
[[nodiscard]] std::string make_pixels_column(const std::string& stratum);

/// Masks as MetricInput takes them, one for each of list_strata. `truth`: linear visibility, one
/// channel. `tangents`: of half the angles of view. A pixel may lie in several strata or in none;
/// the background lies in none. Asserts equal sizes.
[[nodiscard]] std::vector<Image> make_strata(const SurfaceImages& surfaces, const Image& truth,
                                             const glm::vec2& tangents);

/// Pixels that a mask counts.
[[nodiscard]] std::size_t count_pixels(const Image& mask);

} // namespace alcove
