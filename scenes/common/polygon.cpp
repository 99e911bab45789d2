#include "scenes/common/polygon.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Positive if c lies left of the line from a to b.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool cross_properly(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                    const glm::dvec2& d) {
    return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}

bool lies_between(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    return p != a && p != b && std::abs(turn(a, b, p)) < 1e-12 && glm::dot(p - a, p - b) < 0.0;
}

/// The loop of point indices under work; holes are spliced in through bridges, along which points
/// appear twice.
class EarClipper {
  public:
    EarClipper(const Contour& outline, const std::vector<Contour>& holes) {
        m_loop = append(outline, true);
        std::vector<std::vector<std::uint32_t>> rims;
        rims.reserve(holes.size());
        for (const Contour& hole : holes) {
            rims.push_back(append(hole, false));
        }
        while (!rims.empty()) {
            splice_nearest(rims);
        }
    }

    std::vector<std::array<std::uint32_t, 3>> clip() {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        while (m_loop.size() > 3) {
            std::optional<std::size_t> ear = find_ear(true);
            if (!ear) {
                ear = find_ear(false);
            }
            ALCOVE_ASSERT(ear.has_value(), "a simple polygon has an ear");
            const std::size_t n = m_loop.size();
            triangles.push_back({m_loop[(*ear + n - 1) % n], m_loop[*ear], m_loop[(*ear + 1) % n]});
            m_loop.erase(m_loop.begin() + static_cast<std::ptrdiff_t>(*ear));
            m_start = *ear; // walk on, so that the triangles do not all fan out of one corner
        }
        triangles.push_back({m_loop[0], m_loop[1], m_loop[2]});
        return triangles;
    }

  private:
    std::vector<std::uint32_t> append(const Contour& contour, bool counter_clockwise) {
        ALCOVE_ASSERT(contour.size() >= 3, "a contour has three points");
        std::vector<std::uint32_t> rim(contour.size());
        std::iota(rim.begin(), rim.end(), static_cast<std::uint32_t>(m_points.size()));
        m_points.insert(m_points.end(), contour.begin(), contour.end());
        if ((compute_double_area(contour) > 0.0) != counter_clockwise) {
            std::reverse(rim.begin(), rim.end());
        }
        return rim;
    }

    [[nodiscard]] const glm::dvec2& at(std::size_t place) const {
        return m_points[m_loop[place % m_loop.size()]];
    }

    /// True if a point seen from loop place `place` lies in the polygon's inner angle there.
    [[nodiscard]] bool is_in_cone(std::size_t place, const glm::dvec2& point) const {
        const glm::dvec2& before = at(place + m_loop.size() - 1);
        const glm::dvec2& here = at(place);
        const glm::dvec2& after = at(place + 1);
        const bool left_in = turn(before, here, point) > 0.0;
        const bool left_out = turn(here, after, point) > 0.0;
        return turn(before, here, after) > 0.0 ? left_in && left_out : left_in || left_out;
    }

    template <class Rim>
    [[nodiscard]] bool blocks(const Rim& rim, const glm::dvec2& a, const glm::dvec2& b) const {
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const glm::dvec2& c = m_points[rim[i]];
            const glm::dvec2& d = m_points[rim[(i + 1) % rim.size()]];
            if (cross_properly(a, b, c, d) || lies_between(a, b, c) || lies_between(c, d, b)) {
                return true;
            }
        }
        return false;
    }

    /// Joins the hole that has the shortest free bridge to the loop.
    void splice_nearest(std::vector<std::vector<std::uint32_t>>& rims) {
        struct Bridge {
            double length = 0.0;
            std::size_t place = 0;
            std::size_t rim = 0;
            std::size_t start = 0;
        };
        std::optional<Bridge> best;
        for (std::size_t r = 0; r < rims.size(); ++r) {
            for (std::size_t start = 0; start < rims[r].size(); ++start) {
                const glm::dvec2 b = m_points[rims[r][start]];
                for (std::size_t place = 0; place < m_loop.size(); ++place) {
                    const double length = glm::distance(at(place), b);
                    if ((best && length >= best->length) || !is_in_cone(place, b)) {
                        continue;
                    }
                    const bool blocked =
                        blocks(m_loop, at(place), b) ||
                        std::any_of(rims.begin(), rims.end(),
                                    [&](const auto& rim) { return blocks(rim, at(place), b); });
                    if (!blocked) {
                        best = Bridge{length, place, r, start};
                    }
                }
            }
        }
        ALCOVE_ASSERT(best.has_value(), "a hole inside the outline sees it");
        std::vector<std::uint32_t>& rim = rims[best->rim];
        std::vector<std::uint32_t> inserted;
        for (std::size_t i = 0; i <= rim.size(); ++i) {
            inserted.push_back(rim[(best->start + i) % rim.size()]);
        }
        inserted.push_back(m_loop[best->place]);
        m_loop.insert(m_loop.begin() + static_cast<std::ptrdiff_t>(best->place) + 1,
                      inserted.begin(), inserted.end());
        rims.erase(rims.begin() + static_cast<std::ptrdiff_t>(best->rim));
    }

    /// `strict`: no other point may touch the ear; otherwise none may lie inside it.
    [[nodiscard]] std::optional<std::size_t> find_ear(bool strict) const {
        const std::size_t n = m_loop.size();
        for (std::size_t step = 0; step < n; ++step) {
            const std::size_t place = (m_start + step) % n;
            if (is_ear(place, strict)) {
                return place;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] bool is_ear(std::size_t place, bool strict) const {
        const glm::dvec2& a = at(place + m_loop.size() - 1);
        const glm::dvec2& b = at(place);
        const glm::dvec2& c = at(place + 1);
        if (!(turn(a, b, c) > 1e-12)) {
            return false;
        }
        const double slack = strict ? -1e-12 : 1e-12;
        return std::none_of(m_loop.begin(), m_loop.end(), [&](std::uint32_t index) {
            const glm::dvec2& p = m_points[index];
            return p != a && p != b && p != c && turn(a, b, p) > slack && turn(b, c, p) > slack &&
                   turn(c, a, p) > slack;
        });
    }

    std::vector<glm::dvec2> m_points;
    std::vector<std::uint32_t> m_loop;
    std::size_t m_start = 0;
};

} // namespace

double compute_double_area(const Contour& contour) {
    double sum = 0.0;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const glm::dvec2& a = contour[i];
        const glm::dvec2& b = contour[(i + 1) % contour.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

Contour make_arc(const glm::dvec2& centre, const glm::dvec2& radii, double from, double to,
                 int segments) {
    Contour points;
    for (int i = 0; i <= segments; ++i) {
        const double angle = from + (to - from) * i / segments;
        points.emplace_back(centre.x + radii.x * std::cos(angle),
                            centre.y + radii.y * std::sin(angle));
    }
    return points;
}

std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const Contour& outline,
                                                              const std::vector<Contour>& holes) {
    return EarClipper(outline, holes).clip();
}

} // namespace alcove
