#include "scenes/common/round_solids.hpp"
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

constexpr double kPi = std::numbers::pi;

glm::dvec3 draw_direction(SplitMix& random) {
    const double y = random.draw(-1.0, 1.0);
    const double angle = random.draw(0.0, 2.0 * kPi);
    const double r = std::sqrt(1.0 - y * y);
    return {r * std::cos(angle), y, r * std::sin(angle)};
}

/// A flat body of eight faces, pointed at both ends, from `root` along the unit vector `way`.
void add_leaf(MeshBuilder& builder, const glm::dvec3& root, const glm::dvec3& way, double length) {
    const glm::dvec3 helper =
        std::abs(way.y) > 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 side = glm::normalize(glm::cross(way, helper));
    const glm::dvec3 normal = glm::cross(side, way);
    const glm::dvec3 middle = root + 0.5 * length * way;
    const std::array<glm::dvec3, 4> rim{root, middle + 0.28 * length * side, root + length * way,
                                        middle - 0.28 * length * side};
    std::array<std::uint32_t, 4> points{};
    std::transform(rim.begin(), rim.end(), points.begin(),
                   [&builder](const glm::dvec3& point) { return builder.add_point(point); });
    const std::uint32_t above = builder.add_point(middle + 0.08 * length * normal);
    const std::uint32_t below = builder.add_point(middle + 0.02 * length * normal);
    for (std::size_t i = 0; i < 4; ++i) {
        builder.add_triangle(points[i], points[(i + 1) % 4], above);
        builder.add_triangle(points[(i + 1) % 4], points[i], below);
    }
}

struct Tree {
    std::size_t wood = 0;
    std::size_t leaves = 0;
};

Tree make_tree(SceneKit& kit, const Settings& settings, int variant) {
    // Of its own, so that a tree has the same branches at every detail.
    SplitMix random((static_cast<std::uint64_t>(settings.seed) << 8u) + 2 +
                    static_cast<std::uint64_t>(variant));
    const double trunk = random.draw(1.5, 2.0);
    const double crown = random.draw(1.4, 1.8);
    const glm::dvec3 heart(random.draw(-0.2, 0.2), trunk + 0.8 * crown, random.draw(-0.2, 0.2));
    constexpr int kBranches = 16;
    const int leaves = settings.count(24); // a branch
    const double length = 2.0 * crown / std::sqrt(16.0 * std::sqrt(static_cast<double>(leaves)));
    MeshBuilder wood;
    MeshBuilder green;
    add_tube(wood,
             {{0.0, -0.2, 0.0},
              {0.0, 0.1, 0.0},
              {0.3 * heart.x, 0.5 * trunk, 0.0},
              {heart.x, trunk, 0.6 * heart.z},
              heart + glm::dvec3(0.0, 0.5 * crown, 0.0)},
             {0.28, 0.19, 0.16, 0.13, 0.03}, settings.segments(7));
    for (int i = 0; i < kBranches; ++i) {
        const double angle = 2.4 * i + random.draw(-0.3, 0.3); // the golden angle
        const double rise = -0.5 + 1.45 * i / (kBranches - 1);
        const double flat = std::sqrt(std::max(0.06, 1.0 - rise * rise));
        const glm::dvec3 end =
            heart + crown * random.draw(0.68, 0.88) *
                        glm::dvec3(flat * std::cos(angle), rise, flat * std::sin(angle));
        const glm::dvec3 start(heart.x, std::min(trunk - 0.35 + 0.11 * i, end.y - 0.2),
                               0.6 * heart.z);
        const glm::dvec3 bow = 0.5 * (start + end) + glm::dvec3(0.0, 0.14, 0.0);
        add_tube(wood, {start, bow, end}, {0.06, 0.04, 0.015}, settings.segments(4));
        SplitMix twigs((static_cast<std::uint64_t>(settings.seed) << 16u) +
                       static_cast<std::uint64_t>(100 * variant + i));
        for (int k = 0; k < leaves; ++k) {
            const double along = std::sqrt(0.12 + 0.88 * (k + 0.5) / leaves);
            const glm::dvec3 twig = start + along * (end - start) +
                                    0.3 * crown * twigs.draw_unit() * draw_direction(twigs);
            const glm::dvec3 way =
                glm::normalize(draw_direction(twigs) + 0.6 * glm::normalize(end - start) -
                               glm::dvec3(0.0, 0.25, 0.0));
            add_leaf(green, twig, way, length * twigs.draw(0.8, 1.2));
        }
    }
    const auto tint = static_cast<float>(random.draw(0.85, 1.15));
    return {kit.add_mesh(wood.finish("wood", {0.3f, 0.22f, 0.16f}, 89.0)),
            kit.add_mesh(green.finish("leaves", tint * glm::vec3(0.2f, 0.34f, 0.1f), 70.0))};
}

} // namespace

void add_trees(SceneKit& kit, const Settings& settings) {
    constexpr int kVariants = 3;
    std::vector<Tree> trees;
    for (int variant = 0; variant < kVariants; ++variant) {
        trees.push_back(make_tree(kit, settings, variant));
    }
    // Behind the road, and two before it that frame the picture.
    constexpr std::array<std::array<double, 2>, 9> kPlaces{{{-6.2, -4.2},
                                                            {-2.9, -5.0},
                                                            {0.4, -4.3},
                                                            {3.6, -5.1},
                                                            {6.6, -4.3},
                                                            {-4.5, -7.6},
                                                            {1.8, -7.8},
                                                            {-4.4, 3.6},
                                                            {5.0, 4.0}}};
    for (std::size_t i = 0; i < kPlaces.size(); ++i) {
        const Tree& tree = trees[i % trees.size()];
        const double size = 0.9 + 0.08 * static_cast<double>(i * 5 % 4);
        const glm::dmat4 place = make_place({kPlaces[i][0], 0.0, kPlaces[i][1]},
                                            1.3 * static_cast<double>(i), glm::dvec3(size));
        kit.place(tree.wood, place);
        kit.place(tree.leaves, place);
    }
}

} // namespace alcove::foliage
