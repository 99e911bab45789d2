#include "scenes/common/solids.hpp"
#include "scenes/common/split_mix.hpp"
#include "scenes/foliage_and_vehicle/elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove::foliage {
namespace {

constexpr double kHalf = 14.0;

/// Level beside the road, gently rolling farther away.
double compute_height(double x, double z) {
    const double away = std::clamp((std::abs(z) - kRoadHalf - 0.4) / 3.0, 0.0, 1.0);
    return 0.14 * away * std::sin(0.9 * x + 0.5 * z) * std::cos(0.7 * z - 0.3 * x);
}

/// Blades of grass: thin pyramids that lean outward from 0.
Mesh make_tuft(const Settings& settings) {
    SplitMix random(static_cast<std::uint64_t>(settings.seed) * 2 + 1);
    MeshBuilder builder;
    const int blades = settings.count(14);
    const double width = 0.03 / std::sqrt(settings.detail);
    for (int i = 0; i < blades; ++i) {
        const double angle = random.draw(0.0, 2.0 * std::numbers::pi);
        const double away = 0.16 * std::sqrt(random.draw_unit());
        const glm::dvec3 out(std::cos(angle), 0.0, std::sin(angle));
        const glm::dvec3 across(-out.z, 0.0, out.x);
        const glm::dvec3 root = away * out - glm::dvec3(0.0, 0.2, 0.0);
        const glm::dvec3 tip =
            (away + random.draw(0.02, 0.2)) * out + glm::dvec3(0.0, random.draw(0.15, 0.4), 0.0);
        const std::array<std::uint32_t, 3> foot{builder.add_point(root + width * across),
                                                builder.add_point(root - width * across),
                                                builder.add_point(root + 0.6 * width * out)};
        const std::uint32_t top = builder.add_point(tip);
        builder.add_triangle(foot[0], foot[1], foot[2]);
        for (std::size_t k = 0; k < 3; ++k) {
            builder.add_triangle(foot[(k + 1) % 3], foot[k], top);
        }
    }
    return builder.finish("tuft", {0.26f, 0.38f, 0.12f}, 60.0);
}

} // namespace

void add_ground(SceneKit& kit, const Settings& settings) {
    MeshBuilder builder;
    Sheet sheet;
    sheet.columns = settings.segments(40);
    sheet.rows = settings.segments(40);
    sheet.place = [&sheet](int column, int row) {
        return glm::dvec2(-kHalf + 2.0 * kHalf * column / sheet.columns,
                          -kHalf + 2.0 * kHalf * row / sheet.rows);
    };
    sheet.lower = [](int, int) { return -0.6; };
    sheet.upper = [&sheet](int column, int row) {
        const glm::dvec2 place = sheet.place(column, row);
        return compute_height(place.x, place.y);
    };
    sheet.falls = [](int column, int row) { return (column + row) % 2 != 0; };
    add_sheet(builder, sheet);
    kit.add(builder.finish("ground", {0.36f, 0.36f, 0.22f}, 60.0));
    kit.add(make_box_mesh("road", glm::vec3(0.3f), {-kHalf + 0.2, -0.2, -kRoadHalf},
                          {kHalf - 0.2, kRoad, kRoadHalf}));
    for (const double side : {-1.0, 1.0}) {
        const double z = side * kRoadHalf;
        kit.add(make_box_mesh(side < 0.0 ? "far kerb" : "near kerb", glm::vec3(0.55f),
                              {-kHalf + 0.1, -0.25, z - 0.09}, {kHalf - 0.1, 0.12, z + 0.09}));
    }
    const std::size_t tuft = kit.add_mesh(make_tuft(settings));
    SplitMix random(static_cast<std::uint64_t>(settings.seed) * 4 + 3);
    constexpr int kTufts = 90;
    for (int i = 0; i < kTufts; ++i) {
        const double side = i % 3 == 0 ? 1.0 : -1.0;
        const double z = side * (kRoadHalf + 0.45 + 4.5 * random.draw_unit() * random.draw_unit());
        const double x = random.draw(-7.5, 7.5);
        kit.place(tuft,
                  make_place({x, compute_height(x, z), z}, random.draw(0.0, 2.0 * std::numbers::pi),
                             glm::dvec3(random.draw(0.7, 1.3))));
    }
}

} // namespace alcove::foliage
