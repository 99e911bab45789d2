#include "scenes/city/style.hpp"

#include "scenes/city/plan.hpp"

#include <array>

namespace alcove::city {

std::vector<Style> make_styles(const Kit& kit) {
    struct Colours {
        glm::vec3 wall;
        glm::vec3 roof;
    };
    // Plaster of a Central European street, roofs of tile or slate.
    constexpr std::array<Colours, kStyles> kColours{
        {{{0.70f, 0.60f, 0.40f}, {0.42f, 0.19f, 0.13f}},
         {{0.66f, 0.64f, 0.58f}, {0.25f, 0.26f, 0.29f}},
         {{0.58f, 0.44f, 0.35f}, {0.36f, 0.17f, 0.12f}},
         {{0.54f, 0.60f, 0.52f}, {0.30f, 0.24f, 0.21f}},
         {{0.72f, 0.67f, 0.56f}, {0.45f, 0.23f, 0.15f}},
         {{0.52f, 0.54f, 0.60f}, {0.22f, 0.22f, 0.25f}}}};
    std::vector<Style> styles;
    for (int i = 0; i < kStyles; ++i) {
        SplitMix random = kit.make_random(0x57000u + static_cast<std::uint64_t>(i));
        Style style;
        const Colours& colours = kColours[static_cast<std::size_t>(i)];
        const auto tint = static_cast<float>(random.draw(0.92, 1.08));
        style.wall = tint * colours.wall;
        style.trim = glm::vec3(0.3f) + 0.6f * style.wall;
        style.roof = tint * colours.roof;
        style.half_window = random.draw(0.55, 0.68);
        style.sill = random.draw(0.7, 0.85);
        style.head = random.draw(2.62, 2.74);
        constexpr std::array<double, 3> kRises{0.0, 1.0, 0.3}; // of half the width
        style.rise = kRises[static_cast<std::size_t>(i % 3)] * style.half_window;
        style.pediment = static_cast<Pediment>((i + 1) % 3);
        style.has_balcony = i % 2 == 0;
        styles.push_back(style);
    }
    return styles;
}

} // namespace alcove::city
