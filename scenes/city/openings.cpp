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
    constexpr double kBack = 0.09;
    constexpr double kThick = 0.08;
    const Contour outline = draw_opening(opening, 0.03, segments);
    Opening clear = opening;
    clear.half_width -= 0.08;
    clear.bottom += 0.09;
    clear.top -= 0.08;
    clear.rise = std::max(0.0, opening.rise - 0.08);
    if (steps == 1) {
        add_extrusion(builder, at_depth(kBack), outline, {draw_opening(clear, 0.0, segments)},
                      kThick);
        return;
    }
    // Two lights side by side, `steps` rows, and one light under an arch.
    const double spring = clear.top - clear.rise;
    std::vector<Contour> lights;
    constexpr double kBar = 0.03; // half a glazing bar
    const double pitch = (spring - clear.bottom) / steps;
    for (int row = 0; row < steps; ++row) {
        const double low = clear.bottom + pitch * row + kBar;
        const double high = clear.bottom + pitch * (row + 1) - kBar;
        const double left = opening.middle - clear.half_width;
        const double right = opening.middle + clear.half_width;
        lights.push_back(make_rectangle(left, low, opening.middle - kBar, high));
        lights.push_back(make_rectangle(opening.middle + kBar, low, right, high));
    }
    if (clear.rise > 0.15) {
        lights.push_back(make_arc({opening.middle, spring + kBar},
                                  {clear.half_width, clear.rise - kBar}, 0.0, std::numbers::pi,
                                  segments));
    }
    add_extrusion(builder, at_depth(kBack), outline, lights, kThick);
}

void add_pane(MeshBuilder& builder, const Opening& opening, int segments) {
    add_extrusion(builder, at_depth(-kSink), draw_opening(opening, 0.05, segments), {},
                  0.12 + kSink);
}

void add_sill(MeshBuilder& builder, const Opening& opening, int segments, int steps) {
    const double half = opening.half_width + 0.24;
    const double y = opening.bottom;
    if (steps == 1) {
        add_box(builder, {opening.middle - half, y - 0.2, 0.1},
                {opening.middle + half, y - 0.04, kFacade + 0.2});
        return;
    }
    Contour section{{0.1, y - 0.2}, {kFacade + 0.08, y - 0.2}};
    const Contour nose = make_arc({kFacade + 0.12, y - 0.11}, {0.07, 0.06}, -0.5 * std::numbers::pi,
                                  0.5 * std::numbers::pi, segments / 2);
    section.insert(section.end(), nose.begin(), nose.end());
    section.emplace_back(0.1, y - 0.03);
    add_bar(builder, section, opening.middle - half, opening.middle + half);
    for (const double side : {-1.0, 1.0}) {
        Contour bracket{{kFacade - kSink, y - 0.52}, {kFacade - kSink, y - 0.18}};
        bracket.emplace_back(kFacade + 0.13, y - 0.18);
        const Contour hollow = make_arc({kFacade + 0.13, y - 0.49}, {0.1, 0.25},
                                        0.5 * std::numbers::pi, std::numbers::pi, segments / 2);
        bracket.insert(bracket.end(), hollow.begin(), hollow.end());
        const double x = opening.middle + side * (opening.half_width + 0.02);
        add_bar(builder, bracket, x - 0.06, x + 0.06);
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
            contour = {{opening.middle - half + 2.2 * by, y + 0.05 + by},
                       {opening.middle + half - 2.2 * by, y + 0.05 + by},
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
