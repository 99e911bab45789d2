#pragma once
// Parts of a frame by what its surfaces are: where errors of one kind live. Masks from the
// full-precision G-buffer, whatever the method saw.

#include "core/base/image.hpp"
#include "core/contract/scene.hpp"
#include "core/frame/reprojection.hpp"

#include <span>
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

/// The part of a frame that shows the objects of a name: a stratum of its own.
[[nodiscard]] StratumInfo describe_region(const std::string& object);
/// Throws InputError naming `where` unless every name is that of an object, with the nearest one;
/// on a name given twice, one of list_strata, and one that a column cannot hold.
void check_regions(const std::vector<std::string>& names, std::span<const Object> objects,
                   std::string_view where);

/// "METRIC[STRATUM]": the column of a metric over a stratum.
[[nodiscard]] std::string make_stratum_column(const std::string& metric,
                                              const std::string& stratum);
/// The column that tells how many pixels a stratum counts.
[[nodiscard]] std::string make_pixels_column(const std::string& stratum);

/// Masks as MetricInput takes them, one for each of list_strata. `truth`: linear visibility, or the
/// luminance of a picture, one channel. `tangents`: of half the angles of view. A pixel may lie in
/// several strata or in none; the background lies in none. Asserts equal sizes.
[[nodiscard]] std::vector<Image> make_strata(const SurfaceImages& surfaces, const Image& truth,
                                             const glm::vec2& tangents);

/// The mask of a region. `instance_id`: Channel::instance_id, one channel.
[[nodiscard]] Image make_region(const Image& instance_id, std::span<const Object> objects,
                                const std::string& name);

/// Pixels that a mask counts.
[[nodiscard]] std::size_t count_pixels(const Image& mask);

} // namespace alcove
