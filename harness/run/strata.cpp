#include "harness/run/strata.hpp"

#include "core/base/domain.hpp"
#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace alcove {
namespace {

/// Of the nearer depth; as halo_width's.
constexpr float kDepthEdge = 0.1f;
/// 20 degrees between the normals of neighbours: a corner, not a curve.
constexpr float kCreaseCosine = 0.94f;
/// Errors at an edge or a corner reach at least so far on each side.
constexpr int kNearby = 2;
/// Of the view: half of what a display shows.
constexpr float kDark = 0.5f;

class Surfaces {
  public:
    Surfaces(const SurfaceImages& images, const glm::vec2& tangents)
        : m_images(images), m_tangents(tangents) {}

    [[nodiscard]] ImageSize size() const { return m_images.eye_depth.size(); }
    [[nodiscard]] bool is_surface(int x, int y) const {
        return !std::isinf(m_images.eye_depth.at(x, y));
    }
    /// In view space.
    [[nodiscard]] glm::vec3 position(int x, int y) const {
        const auto width = static_cast<float>(size().width);
        const auto height = static_cast<float>(size().height);
        const glm::vec3 ray{(2.0f * (static_cast<float>(x) + 0.5f) / width - 1.0f) * m_tangents.x,
                            (1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / height) * m_tangents.y,
                            -1.0f};
        return m_images.eye_depth.at(x, y) * ray;
    }
    [[nodiscard]] glm::vec3 normal(int x, int y) const {
        return {m_images.normal.at(x, y, 0), m_images.normal.at(x, y, 1),
                m_images.normal.at(x, y, 2)};
    }
    [[nodiscard]] bool moves(int x, int y) const {
        return m_images.motion.at(x, y, 0) != 0.0f || m_images.motion.at(x, y, 1) != 0.0f ||
               m_images.motion.at(x, y, 2) != 0.0f;
    }
    [[nodiscard]] bool is_edge(int x, int y, int next_x, int next_y) const {
        const float here = m_images.eye_depth.at(x, y);
        const float there = m_images.eye_depth.at(next_x, next_y);
        return here != there && std::abs(here - there) > kDepthEdge * std::min(here, there);
    }
    /// Do the surfaces bend towards each other, as in a corner of a room?
    [[nodiscard]] bool is_crease(int x, int y, int next_x, int next_y) const {
        if (!is_surface(x, y) || !is_surface(next_x, next_y) || is_edge(x, y, next_x, next_y)) {
            return false;
        }
        const glm::vec3 here = normal(x, y);
        const glm::vec3 there = normal(next_x, next_y);
        return glm::dot(here, there) < kCreaseCosine &&
               glm::dot(here - there, position(next_x, next_y) - position(x, y)) > 0.0f;
    }
    /// Cosine between the normal and the direction to the viewer.
    [[nodiscard]] float facing(int x, int y) const {
        return glm::dot(normal(x, y), -glm::normalize(position(x, y)));
    }

  private:
    const SurfaceImages& m_images;
    glm::vec2 m_tangents;
};

/// Surface pixels that fulfil a condition.
Image mark(const Surfaces& surfaces, const std::function<bool(int x, int y)>& holds) {
    Image mask(surfaces.size(), 1);
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            mask.at(x, y) = surfaces.is_surface(x, y) && holds(x, y) ? 1.0f : 0.0f;
        }
    }
    return mask;
}

/// Surface pixels within kNearby of a pair of neighbours (right, below) that fulfils a condition.
Image mark_nearby(const Surfaces& surfaces,
                  const std::function<bool(int x, int y, int next_x, int next_y)>& holds) {
    Image pairs(surfaces.size(), 1);
    for (int y = 0; y < pairs.height(); ++y) {
        for (int x = 0; x < pairs.width(); ++x) {
            for (const auto& [next_x, next_y] : {std::pair{x + 1, y}, std::pair{x, y + 1}}) {
                if (next_x < pairs.width() && next_y < pairs.height() &&
                    holds(x, y, next_x, next_y)) {
                    pairs.at(x, y) = 1.0f;
                    pairs.at(next_x, next_y) = 1.0f;
                }
            }
        }
    }
    // Both pixels of a pair are marked, so that one less than kNearby lies beyond each.
    constexpr int kReach = kNearby - 1;
    return mark(surfaces, [&](int x, int y) {
        for (int v = std::max(0, y - kReach); v <= std::min(pairs.height() - 1, y + kReach); ++v) {
            for (int u = std::max(0, x - kReach); u <= std::min(pairs.width() - 1, x + kReach);
                 ++u) {
                if (pairs.at(u, v) != 0.0f) {
                    return true;
                }
            }
        }
        return false;
    });
}

/// Of angles to the viewer, by the cosines of its two ends.
Image mark_angles(const Surfaces& surfaces, float low, float high) {
    return mark(surfaces, [&, low, high](int x, int y) {
        const float cosine = surfaces.facing(x, y);
        return cosine > low && cosine <= high;
    });
}

} // namespace

const std::vector<StratumInfo>& list_strata() {
    static const std::vector<StratumInfo> strata{
        {"depth_edges", "depth edges",
         "surface within 2 pixels of neighbours whose eye depths differ by more than 10 % of the "
         "nearer"},
        {"creases", "creases",
         "surface within 2 pixels of neighbours without a depth edge between them whose normals "
         "differ by more than 20 degrees and lean towards each other"},
        {"angle_0_30", "seen at 0 to 30 degrees",
         "surface whose normal is up to 30 degrees away from the direction to the viewer"},
        {"angle_30_60", "seen at 30 to 60 degrees", "the same from 30 to 60 degrees"},
        {"angle_60_90", "seen at 60 to 90 degrees",
         "the same from 60 degrees on: grazing, and what shading normals turn away"},
        {"moving", "moving objects", "surface of objects that have moved since the last frame"},
        {"dark", "dark values",
         "surface where the view of truth (sRGB code; of a picture, of its luminance) is under "
         "0.5"},
    };
    return strata;
}

StratumInfo describe_region(const std::string& object) {
    return {object, "object " + object, "surface of the object `" + object + "`"};
}

void check_regions(const std::vector<std::string>& names, std::span<const Object> objects,
                   std::string_view where) {
    std::set<std::string> known;
    for (const Object& object : objects) {
        known.insert(object.name);
    }
    const std::vector<std::string> choices(known.begin(), known.end());
    std::set<std::string> seen;
    for (const std::string& name : names) {
        if (!known.contains(name)) {
            throw InputError(where, "no object of this name", name,
                             describe_choices(name, choices));
        }
        if (!seen.insert(name).second) {
            throw InputError(where, "region stands twice", name, "each one once");
        }
        const std::vector<StratumInfo>& strata = list_strata();
        const bool is_stratum =
            std::any_of(strata.begin(), strata.end(),
                        [&name](const StratumInfo& stratum) { return stratum.name == name; });
        // A column is METRIC[STRATUM].
        if (is_stratum || name.find_first_of("[]") != std::string::npos) {
            throw InputError(where, is_stratum ? "the name of a stratum" : "a name with brackets",
                             name, "an object whose name can stand in a column of its own");
        }
    }
}

std::string make_stratum_column(const std::string& metric, const std::string& stratum) {
    return metric + "[" + stratum + "]";
}

std::string make_pixels_column(const std::string& stratum) {
    return make_stratum_column("pixels", stratum);
}

std::vector<Image> make_strata(const SurfaceImages& images, const Image& truth,
                               const glm::vec2& tangents) {
    ALCOVE_ASSERT(truth.size() == images.eye_depth.size() && truth.channels() == 1,
                  "truth of the surfaces' frame");
    const Surfaces surfaces(images, tangents);
    // Cosines of 30 and 60 degrees; the ends are open, for rounding and shading normals.
    constexpr float kCosine30 = 0.8660254f;
    constexpr float kCosine60 = 0.5f;
    constexpr float kBeyond = 2.0f;
    std::vector<Image> masks;
    masks.push_back(mark_nearby(
        surfaces, [&](int x, int y, int u, int v) { return surfaces.is_edge(x, y, u, v); }));
    masks.push_back(mark_nearby(
        surfaces, [&](int x, int y, int u, int v) { return surfaces.is_crease(x, y, u, v); }));
    masks.push_back(mark_angles(surfaces, kCosine30, kBeyond));
    masks.push_back(mark_angles(surfaces, kCosine60, kCosine30));
    masks.push_back(mark_angles(surfaces, -kBeyond, kCosine60));
    masks.push_back(mark(surfaces, [&](int x, int y) { return surfaces.moves(x, y); }));
    masks.push_back(
        mark(surfaces, [&](int x, int y) { return encode_srgb(truth.at(x, y)) < kDark; }));
    ALCOVE_ASSERT(masks.size() == list_strata().size(), "a mask a stratum");
    return masks;
}

Image make_region(const Image& instance_id, std::span<const Object> objects,
                  const std::string& name) {
    Image mask(instance_id.size(), 1);
    for (std::size_t i = 0; i < mask.values().size(); ++i) {
        const auto id = static_cast<std::size_t>(instance_id.values()[i]);
        ALCOVE_ASSERT(id <= objects.size(), "ids of the scene's objects");
        mask.values()[i] = id > 0 && objects[id - 1].name == name ? 1.0f : 0.0f;
    }
    return mask;
}

std::size_t count_pixels(const Image& mask) {
    return static_cast<std::size_t>(std::count(mask.values().begin(), mask.values().end(), 1.0f));
}

} // namespace alcove
