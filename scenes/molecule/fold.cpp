#include "scenes/molecule/fold.hpp"

#include "scenes/common/split_mix.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>

namespace alcove::molecule {
namespace {

constexpr double kBond = 1.5;  ///< angstrom
constexpr double kApart = 2.1; ///< between atoms that are not bonded
/// Candidates for the next atom; the innermost free one is taken. With more the blob gets rounder.
constexpr int kCandidates = 6;
/// Radius of the ball that holds the middles of all atoms, angstrom for one atom: 22 cubic angstrom
/// each, as in proteins, of which balls of diameter kApart fill 0.22: there always is a free place.
/// Without it a few arms reach far out.
constexpr double kExtent = 1.74;
/// Share of atoms that start a branch anywhere instead of going on from the last one.
constexpr double kBranching = 0.06;

using Cell = std::tuple<int, int, int>;

/// Atoms by cubes of side kApart, so that only 27 of them are near any point.
class Grid {
  public:
    void add(const glm::dvec3& point) { m_cells[find_cell(point)].push_back(point); }
    [[nodiscard]] bool is_free(const glm::dvec3& point, const glm::dvec3& except) const {
        const auto [x, y, z] = find_cell(point);
        for (int i = 0; i < 27; ++i) {
            const auto cell = m_cells.find({x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1});
            if (cell == m_cells.end()) {
                continue;
            }
            for (const glm::dvec3& other : cell->second) {
                if (other != except && glm::distance(point, other) < kApart) {
                    return false;
                }
            }
        }
        return true;
    }

  private:
    static Cell find_cell(const glm::dvec3& point) {
        const auto floor = [](double value) {
            return static_cast<int>(std::floor(value / kApart));
        };
        return {floor(point.x), floor(point.y), floor(point.z)};
    }
    std::map<Cell, std::vector<glm::dvec3>> m_cells;
};

glm::dvec3 draw_direction(SplitMix& random) {
    const double y = random.draw(-1.0, 1.0);
    const double angle = random.draw(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt(1.0 - y * y);
    return {r * std::cos(angle), y, r * std::sin(angle)};
}

std::optional<glm::dvec3> find_place(const Grid& grid, const glm::dvec3& from, double extent,
                                     SplitMix& random) {
    std::optional<glm::dvec3> best;
    for (int i = 0; i < kCandidates; ++i) {
        const glm::dvec3 place = from + kBond * draw_direction(random);
        if (glm::length(place) < extent && grid.is_free(place, from) &&
            (!best || glm::length(place) < glm::length(*best))) {
            best = place;
        }
    }
    return best;
}

std::size_t draw_element(SplitMix& random) {
    double left = random.draw_unit();
    std::size_t element = 0;
    while (element + 1 < kElements.size() && left >= kElements[element].share) {
        left -= kElements[element].share;
        ++element;
    }
    return element;
}

} // namespace

std::vector<Atom> fold(int count, int seed) {
    SplitMix random(static_cast<std::uint64_t>(seed) * 2 + 1);
    const double extent = kExtent * std::cbrt(static_cast<double>(count));
    Grid grid;
    std::vector<Atom> atoms{{glm::dvec3(0.0), draw_element(random)}};
    grid.add(atoms[0].position);
    std::size_t last = 0;
    while (atoms.size() < static_cast<std::size_t>(count)) {
        if (random.draw_unit() < kBranching) {
            last = static_cast<std::size_t>(random.draw_index(static_cast<int>(atoms.size())));
        }
        const std::optional<glm::dvec3> place =
            find_place(grid, atoms[last].position, extent, random);
        if (!place) { // shut in: go on somewhere else
            last = static_cast<std::size_t>(random.draw_index(static_cast<int>(atoms.size())));
            continue;
        }
        grid.add(*place);
        last = atoms.size();
        atoms.push_back({*place, draw_element(random)});
    }
    return atoms;
}

} // namespace alcove::molecule
