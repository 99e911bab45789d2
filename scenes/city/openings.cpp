#include "scenes/city/openings.hpp"

#include "scenes/common/solids.hpp"

#include <algorithm>
#include <numbers>

namespace alcove::city {
namespace {

Plane at_depth(double z) {
    return {{0.0, 0.0, z}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
}

} // namespace

Contour draw_opening(const Opening& opening, double by, int segments) {
    const double half = opening.half_width + by;
    const double left = opening.middle - half;
    const double right = opening.middle + half;
    if (opening.rise <= 0.0) {
        return make_rectangle(left, opening.bottom - by, right, opening.top + by);
    }
    Contour contour{{left, opening.bottom - by}, {right, opening.bottom - by}};
    const Contour arch = make_arc({opening.middle, opening.top - opening.rise},
                                  {half, opening.rise + by}, 0.0, std::numbers::pi, segments);
    contour.insert(contour.end(), arch.begin(), arch.end());
    return contour;
}

void add_surround(MeshBuilder& builder, const Opening& opening, int segments, int steps) {
    for (int step = 0; step < steps; ++step) {
        const double outer = 0.17 - 0.045 * step;
        const double front = kFacade + 0.07 + 0.035 * step;
        add_extrusion(builder, at_depth(kFacade - kSink - 0.01 * step),
                      draw_opening(opening, outer, segments),
                      {draw_opening(opening, -0.025 + 0.012 * step, segments)},
                      front - (kFacade - kSink - 0.01 * step));
    }
}

void add_sash(MeshBuilder& builder, const Opening& opening, int segments, int steps) {
    constexpr double kBar = 0.03; // half a glazing bar
    constexpr double kRim = 0.08;
    if (steps == 1) {
        add_box(builder, {opening.middle - kBar, opening.bottom - kBar, 0.09},
                {opening.middle + kBar, opening.top + kBar, 0.17});
        return;
    }
    // The wall hides the corners that an arch leaves of a rectangle.
    const double left = opening.middle - opening.half_width + kRim;
    const double right = opening.middle + opening.half_width - kRim;
    const double low = opening.bottom + kRim;
    const double spring = opening.top - std::max(opening.rise, kRim);
    std::vector<Contour> lights;
    for (int row = 0; row < steps; ++row) {
        const double pitch = (spring - low) / steps;
        const double bottom = low + pitch * row + kBar;
        const double top = low + pitch * (row + 1) - kBar;
        lights.push_back(make_rectangle(left, bottom, opening.middle - kBar, top));
        lights.push_back(make_rectangle(opening.middle + kBar, bottom, right, top));
    }
    if (opening.rise > 0.3) {
        lights.push_back(make_arc({opening.middle, spring + kBar},
                                  {right - opening.middle, opening.rise - kRim - kBar}, 0.0,
                                  std::numbers::pi, segments));
    }
    Opening square = opening;
    square.rise = 0.0;
    add_extrusion(builder, at_depth(0.09), draw_opening(square, 0.03, 1), lights, 0.08);
}

void add_pane(MeshBuilder& builder, const Opening& opening) {
    const double half = opening.half_width + 0.05;
    add_box(builder, {opening.middle - half, opening.bottom - 0.05, -0.08},
            {opening.middle + half, opening.top + 0.05, 0.12});
}

void add_sill(MeshBuilder& builder, const Opening& opening, int steps) {
    const double half = opening.half_width + 0.24;
    const double y = opening.bottom;
    if (steps == 1) {
        add_box(builder, {opening.middle - half, y - 0.2, 0.1},
                {opening.middle + half, y - 0.04, kFacade + 0.2});
        return;
    }
    add_bar(builder,
            {{0.1, y - 0.2},
             {kFacade + 0.12, y - 0.2},
             {kFacade + 0.19, y - 0.14},
             {kFacade + 0.19, y - 0.07},
             {kFacade + 0.15, y - 0.03},
             {0.1, y - 0.03}},
            opening.middle - half, opening.middle + half);
    for (const double side : {-1.0, 1.0}) {
        const double x = opening.middle + side * (opening.half_width + 0.02);
        add_bar(builder,
                {{kFacade - kSink, y - 0.52},
                 {kFacade + 0.05, y - 0.48},
                 {kFacade + 0.13, y - 0.18},
                 {kFacade - kSink, y - 0.18}},
                x - 0.06, x + 0.06);
    }
}

void add_pediment(MeshBuilder& builder, const Opening& opening, Pediment kind, int segments,
                  int steps) {
    const double half = opening.half_width + 0.28;
    const double y = opening.top + 0.1;
    const double back = kFacade - 0.08;
    add_box(builder, {opening.middle - half, y, back},
            {opening.middle + half, y + 0.11, kFacade + 0.26});
    if (kind == Pediment::hood) {
        if (steps > 1) {
            add_box(builder, {opening.middle - half - 0.05, y + 0.08, back + 0.02},
                    {opening.middle + half + 0.05, y + 0.14, kFacade + 0.31});
        }
        return;
    }
    const auto draw = [&](double by) {
        Contour contour;
        if (kind == Pediment::gable) {
            contour = {{opening.middle - half + 3.5 * by, y + 0.05 + by},
                       {opening.middle + half - 3.5 * by, y + 0.05 + by},
                       {opening.middle, y + 0.47 - by}};
        } else {
            contour = make_arc({opening.middle, y + 0.05 + by}, {half - by, 0.42 - 2.0 * by}, 0.0,
                               std::numbers::pi, segments);
        }
        return contour;
    };
    add_extrusion(builder, at_depth(back + 0.01), draw(0.0), {}, 0.2);
    add_extrusion(builder, at_depth(back + 0.04), draw(-0.004), {draw(0.07)}, 0.3);
}

} // namespace alcove::city
