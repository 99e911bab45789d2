#include "scenes/city/elements.hpp"
#include "scenes/common/solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove::city {
namespace {

constexpr int kVariants = 3;
constexpr double kPi = std::numbers::pi;

struct Tree {
    std::size_t wood = 0;
    std::size_t leaves = 0;
};

glm::dvec3 draw_direction(SplitMix& random) {
    const double y = random.draw(-1.0, 1.0);
    const double angle = random.draw(0.0, 2.0 * kPi);
    const double r = std::sqrt(1.0 - y * y);
    return {r * std::cos(angle), y, r * std::sin(angle)};
}

/// A tapering branch along a path.
void add_branch(MeshBuilder& builder, const std::vector<glm::dvec3>& path, double radius,
                double tip, int around) {
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const glm::dvec3 way =
            glm::normalize(path[std::min(i + 1, path.size() - 1)] - path[i == 0 ? 0 : i - 1]);
        const glm::dvec3 x = glm::normalize(glm::cross(
            std::abs(way.y) > 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0), way));
        const glm::dvec3 y = glm::cross(way, x);
        const double t = static_cast<double>(i) / static_cast<double>(path.size() - 1);
        const double r = radius + (tip - radius) * t;
        Ring ring;
        for (int k = 0; k < around; ++k) {
            const double angle = 2.0 * kPi * k / around;
            ring.push_back(path[i] + r * (std::cos(angle) * x + std::sin(angle) * y));
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::capped);
}

/// A flat body of eight faces, pointed at both ends: one end is `root`, from which it reaches
/// `length` along the unit vector `way`.
void add_leaf(MeshBuilder& builder, const glm::dvec3& root, const glm::dvec3& way, double length) {
    const glm::dvec3 side = glm::normalize(glm::cross(
        way, std::abs(way.y) > 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0)));
    const glm::dvec3 normal = glm::cross(side, way);
    const glm::dvec3 middle = root + 0.55 * length * way;
    const std::array<glm::dvec3, 4> rim{root, middle + 0.3 * length * side, root + length * way,
                                        middle - 0.3 * length * side};
    std::array<std::uint32_t, 4> points{};
    std::transform(rim.begin(), rim.end(), points.begin(),
                   [&builder](const glm::dvec3& point) { return builder.add_point(point); });
    const std::uint32_t above = builder.add_point(middle + 0.1 * length * normal);
    const std::uint32_t below = builder.add_point(middle + 0.02 * length * normal);
    for (std::size_t i = 0; i < 4; ++i) {
        builder.add_triangle(points[i], points[(i + 1) % 4], above);
        builder.add_triangle(points[(i + 1) % 4], points[i], below);
    }
}

Tree make_tree(Kit& kit, int variant) {
    SplitMix random = kit.make_random(0x72ee00u + static_cast<std::uint64_t>(variant));
    const double trunk = random.draw(2.9, 3.5);
    const double crown = random.draw(1.9, 2.4); // radius
    const glm::dvec3 heart(0.0, trunk + 0.75 * crown, 0.0);
    MeshBuilder wood;
    const int around = kit.segments(5, 5);
    const glm::dvec3 top(random.draw(-0.2, 0.2), heart.y + 0.4 * crown, random.draw(-0.2, 0.2));
    add_branch(wood,
               {{0.0, -0.1, 0.0},
                {0.02, 0.25, 0.0},
                {0.4 * top.x, 0.6 * trunk, 0.0},
                {0.6 * top.x, trunk, 0.5 * top.z},
                top},
               0.2, 0.04, around);
    // Each branch carries a cluster of leaves, so that the crown is no mere ball.
    constexpr int kBranches = 9;
    const int leaves = kit.count(8.0, 6);
    const double length = 1.35 * crown / std::sqrt(static_cast<double>(leaves));
    MeshBuilder green;
    for (int i = 0; i < kBranches; ++i) {
        const double angle = 2.4 * i + random.draw(-0.3, 0.3); // the golden angle
        const double rise = -0.55 + 1.5 * i / (kBranches - 1);
        const double flat = std::sqrt(std::max(0.05, 1.0 - rise * rise));
        const glm::dvec3 end =
            heart + 0.72 * crown * glm::dvec3(flat * std::cos(angle), rise, flat * std::sin(angle));
        const glm::dvec3 start(0.5 * top.x, std::min(trunk - 0.5 + 0.2 * i, end.y - 0.2),
                               0.3 * top.z);
        add_branch(wood, {start, 0.5 * (start + end) + glm::dvec3(0.0, 0.12, 0.0), end}, 0.07, 0.02,
                   kit.segments(4, 3));
        for (int k = 0; k < leaves; ++k) {
            // From the branch's outer part, away from the heart of the crown.
            const glm::dvec3 twig = start + (0.4 + 0.6 * (k + 0.5) / leaves) * (end - start) +
                                    glm::dvec3(0.0, 0.02, 0.0);
            const glm::dvec3 way =
                glm::normalize(draw_direction(random) + 0.7 * glm::normalize(end - start) +
                               glm::dvec3(0.0, 0.15, 0.0));
            add_leaf(green, twig, way, length * random.draw(0.8, 1.2));
        }
    }
    const auto tint = static_cast<float>(random.draw(0.85, 1.15));
    return {kit.add_mesh(wood.finish("tree_wood", kWood, 89.0)),
            kit.add_mesh(green.finish("tree_leaves", tint * glm::vec3(0.17f, 0.31f, 0.1f), 70.0))};
}

/// Up to `number` places in the square of half side `half`, those within reach.
void add_grove(Kit& kit, const std::vector<Tree>& trees, const Block& block, double half,
               int number, std::uint64_t salt) {
    SplitMix random = kit.make_random(salt);
    for (int i = 0; i < number; ++i) {
        const glm::dvec3 place = block.middle + glm::dvec3(random.draw(-half, half), kPavement,
                                                           random.draw(-half, half));
        const Tree& tree = trees[static_cast<std::size_t>(random.draw_index(kVariants))];
        const glm::dmat4 frame =
            make_frame(place, random.draw(0.0, 2.0 * kPi), random.draw(0.9, 1.35));
        if (measure_distance_to_route(place) < kit.reach_m()) {
            kit.place(tree.wood, frame);
            kit.place(tree.leaves, frame);
        }
    }
}

} // namespace

void add_trees(Kit& kit, const Plan& plan) {
    std::vector<Tree> trees;
    for (int variant = 0; variant < kVariants; ++variant) {
        trees.push_back(make_tree(kit, variant));
    }
    std::uint64_t salt = 0x9a0000u;
    for (const Block& block : plan.blocks) {
        ++salt;
        if (block.use == BlockUse::park) {
            add_grove(kit, trees, block, kHalfBlock - 5.0, 60, salt);
        } else if (block.use == BlockUse::houses) {
            add_grove(kit, trees, block, kHalfBlock - kLotDepth - 8.0, 8, salt);
        }
        // Along the kerb, opposite to the lamps.
        for (int turns = 0; turns < 4; ++turns) {
            SplitMix random = kit.make_random(salt * 8 + static_cast<std::uint64_t>(turns));
            for (int i = 0; i < 4; ++i) {
                const glm::dvec3 offset(-31.5 + kLotWidth * i, kPavement, kKerb - 0.9);
                const glm::dvec3 place(
                    glm::dvec3(make_frame(block.middle, turns) * glm::dvec4(offset, 1.0)));
                const Tree& tree = trees[static_cast<std::size_t>(random.draw_index(kVariants))];
                const glm::dmat4 frame =
                    make_frame(place, random.draw(0.0, 2.0 * kPi), random.draw(0.85, 1.0));
                if (measure_distance_to_route(place) < kit.reach_m()) {
                    kit.place(tree.wood, frame);
                    kit.place(tree.leaves, frame);
                }
            }
        }
    }
}

} // namespace alcove::city
