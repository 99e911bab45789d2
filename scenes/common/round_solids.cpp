#include "scenes/common/round_solids.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/figure_shapes.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

using Index = std::uint32_t;

struct Ball {
    std::vector<glm::dvec3> points; ///< unit
    std::vector<std::array<Index, 3>> triangles;
};

Ball make_icosahedron() {
    const double g = std::numbers::phi;
    Ball ball;
    ball.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (glm::dvec3& point : ball.points) {
        point = glm::normalize(point);
    }
    ball.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return ball;
}

void subdivide(Ball& ball) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto find_middle = [&](Index a, Index b) {
        const auto [entry, is_new] = middles.emplace(std::minmax(a, b), 0);
        if (is_new) {
            entry->second = static_cast<Index>(ball.points.size());
            ball.points.push_back(glm::normalize(ball.points[a] + ball.points[b]));
        }
        return entry->second;
    };
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [a, b, c] : ball.triangles) {
        const Index ab = find_middle(a, b);
        const Index bc = find_middle(b, c);
        const Index ca = find_middle(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    ball.triangles = std::move(finer);
}

} // namespace

void add_ball(MeshBuilder& builder, int subdivisions,
              const std::function<glm::dvec3(const glm::dvec3& direction)>& place) {
    ALCOVE_ASSERT(subdivisions >= 0 && subdivisions <= 7, "a ball that fits the memory");
    Ball ball = make_icosahedron();
    for (int i = 0; i < subdivisions; ++i) {
        subdivide(ball);
    }
    std::vector<Index> points;
    for (const glm::dvec3& point : ball.points) {
        points.push_back(builder.add_point(place(point)));
    }
    for (const auto& [a, b, c] : ball.triangles) {
        builder.add_triangle(points[a], points[b], points[c]);
    }
}

Mesh make_ball_mesh(std::string name, const glm::vec3& albedo, int subdivisions) {
    MeshBuilder builder;
    add_ball(builder, subdivisions, [](const glm::dvec3& direction) { return direction; });
    return builder.finish(std::move(name), albedo, 180.0);
}

void add_tube(MeshBuilder& builder, const std::vector<glm::dvec3>& path,
              const std::vector<double>& radii, int around) {
    ALCOVE_ASSERT(radii.size() == path.size(), "one radius a point");
    std::vector<TubePoint> line;
    for (std::size_t i = 0; i < path.size(); ++i) {
        line.push_back({path[i], radii[i]});
    }
    add_tube(builder, line, around);
}

} // namespace alcove
