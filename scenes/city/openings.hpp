#pragma once
// Windows and doors as contours and the solids around them, drawn on a facade: x along the front, y
// up, z towards the street.

#include "scenes/city/kit.hpp"
#include "scenes/city/style.hpp"

namespace alcove::city {

/// Metres. `rise` is the height of an elliptic arch within the opening, 0 a flat head.
struct Opening {
    double middle = 0.0;
    double half_width = 0.5;
    double bottom = 0.0;
    double top = 1.0;
    double rise = 0.0;
};

/// Larger by `by` on all sides, or smaller if negative. An arch has `segments`.
[[nodiscard]] Contour draw_opening(const Opening& opening, double by, int segments);

/// Frame around the opening in `steps` layers, each narrower and further out.
void add_surround(MeshBuilder& builder, const Opening& opening, int segments, int steps);
/// In the reveal: a mere mullion at one step, else a sash with two lights in each of `steps` rows
/// and one under an arch.
void add_sash(MeshBuilder& builder, const Opening& opening, int segments, int steps);
/// The dark plate behind a sash.
void add_pane(MeshBuilder& builder, const Opening& opening);
/// From two steps on with a nose and two brackets.
void add_sill(MeshBuilder& builder, const Opening& opening, int steps);
/// Above the surround.
void add_pediment(MeshBuilder& builder, const Opening& opening, Pediment kind, int segments,
                  int steps);

} // namespace alcove::city
