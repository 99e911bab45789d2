#include "scenes/cathedral/elements.hpp"
#include "scenes/common/solids.hpp"

namespace alcove::cathedral {
namespace {

/// Seat, leaning back and a front board as one profile, pushed along z.
void add_pews(Kit& kit) {
    const double back = kit.vary(0.92, 0.04);
    const Contour profile{{0.0, -0.03},  {0.05, -0.03}, {0.05, 0.41},  {0.38, 0.41},
                          {0.38, -0.03}, {0.43, -0.03}, {0.43, 0.41},  {0.47, 0.41},
                          {0.47, 0.46},  {0.05, 0.46},  {-0.04, back}, {-0.09, back}};
    MeshBuilder builder;
    add_extrusion(builder, {{0.0, 0.0, -1.25}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, profile, {}, 2.5);
    const std::size_t pew = kit.add_mesh(builder.finish("pew", kWood, 30.0));
    const std::size_t end =
        kit.add_mesh(make_box("pew_end", kWood, {-0.13, -0.02, -0.035}, {0.5, back + 0.05, 0.035}));
    constexpr double kLength = 13.2;
    const int rows = 1 + static_cast<int>(kLength / kit.spacing(1.1));
    for (int row = 0; row < rows; ++row) {
        for (const double side : {-1.0, 1.0}) {
            const glm::dvec3 place(-8.6 + kLength * row / (rows - 1), 0.0, side * 2.15);
            kit.place(pew, place);
            if (kit.has_ornament()) {
                kit.place(end, place + glm::dvec3(0.0, 0.0, 1.25));
                kit.place(end, place - glm::dvec3(0.0, 0.0, 1.25));
            }
        }
    }
}

void add_urns(Kit& kit) {
    const double belly = kit.vary(0.3, 0.1);
    const std::size_t urn = kit.add_mesh(make_lathe("urn", kLightStone,
                                                    smooth_profile({{0.2, 1.27},
                                                                    {0.18, 1.36},
                                                                    {0.07, 1.45},
                                                                    {0.09, 1.52},
                                                                    {belly, 1.95},
                                                                    {0.2, 2.2},
                                                                    {0.12, 2.3},
                                                                    {0.2, 2.4},
                                                                    {0.08, 2.5},
                                                                    {0.0, 2.62}},
                                                                   kit.segments(3, 1)),
                                                    kit.segments(18, 6)));
    for (int bay = 0; bay < kBays; ++bay) {
        for (const double side : {-1.0, 1.0}) {
            kit.place(urn, {get_bay_x(bay), 0.0, side * (kAisleOuter + 0.22)});
        }
    }
}

} // namespace

void add_furniture(Kit& kit) {
    add_pews(kit);
    if (kit.has_ornament()) {
        add_urns(kit);
    }
}

} // namespace alcove::cathedral
