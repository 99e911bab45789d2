#include "scenes/cathedral/elements.hpp"
#include "scenes/common/solids.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alcove::cathedral {
namespace {

constexpr double kPi = std::numbers::pi;

/// Groin vaults over a row of bays: the union of one elliptic barrel along x and one across each
/// bay, cut out of a slab.
struct GroinVault {
    double half_width = 0.0; ///< in z, walls' sinkage included
    double spring = 0.0;
    double rise = 0.0;
    double top = 0.0; ///< of the slab
};

Mesh make_vault(Kit& kit, const char* name, const GroinVault& vault) {
    // Even, and equal along and across, so that the groins run along diagonals of cells.
    const int n = 2 * kit.segments(7, 2);
    const auto get_phase = [n](int index) { return kPi * (index % n) / n; };
    Sheet sheet;
    sheet.columns = n * kBays;
    sheet.rows = n;
    sheet.place = [&](int column, int row) {
        const int bay = std::min(column / n, kBays - 1);
        const int in_bay = column - bay * n;
        double x = get_bay_x(bay) - 0.5 * kBayLength * std::cos(kPi * in_bay / n);
        if (column == 0 || column == sheet.columns) {
            x = column == 0 ? -kHalfLength - kSink : kHalfLength + kSink;
        }
        return glm::dvec2(x, -vault.half_width * std::cos(kPi * row / n));
    };
    sheet.lower = [&](int column, int row) {
        const double along = row == n ? 0.0 : std::sin(get_phase(row));
        const double across = std::sin(get_phase(column));
        return vault.spring + vault.rise * std::max(along, across);
    };
    sheet.upper = [&](int, int) { return vault.top; };
    sheet.falls = [n](int column, int row) { return (column % n < n / 2) != (row < n / 2); };
    MeshBuilder builder;
    add_sheet(builder, sheet);
    return builder.finish(name, kPlaster, 25.0);
}

} // namespace

void add_vaults(Kit& kit) {
    kit.place(kit.add_mesh(
        make_vault(kit, "nave_vault", {kNaveHalfWidth + kSink, kNaveSpring, kNaveRise, 14.6})));
    const double inner = kNaveHalfWidth + kNaveWall;
    const std::size_t aisle = kit.add_mesh(make_vault(
        kit, "aisle_vault", {0.5 * (kAisleOuter - inner) + kSink, kArcadeSpring, kAisleRise, 7.9}));
    for (const double side : {-1.0, 1.0}) {
        kit.place(aisle, {0.0, 0.0, side * 0.5 * (kAisleOuter + inner)});
    }
}

} // namespace alcove::cathedral
