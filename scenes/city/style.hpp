#pragma once
// How a house looks: colours and the forms of its openings.

#include "scenes/city/kit.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace alcove::city {

enum class Pediment { hood, gable, arch };

/// Metres. Heights of windows are above their storey's floor.
struct Style {
    glm::vec3 wall{0.6f};
    glm::vec3 trim{0.7f};
    glm::vec3 roof{0.4f};
    double half_window = 0.6;
    double sill = 0.75;
    double head = 2.72; ///< top of the opening
    double rise = 0.0;  ///< of the arch within the opening's height; 0 is a flat head
    Pediment pediment = Pediment::hood;
    bool has_balcony = false;
};

/// kStyles of them.
[[nodiscard]] std::vector<Style> make_styles(const Kit& kit);

inline constexpr glm::vec3 kGlass{0.1f, 0.12f, 0.14f};
inline constexpr glm::vec3 kStone{0.55f, 0.53f, 0.49f};
inline constexpr glm::vec3 kAsphalt{0.23f, 0.23f, 0.24f};
inline constexpr glm::vec3 kPaving{0.42f, 0.41f, 0.39f};
inline constexpr glm::vec3 kGrass{0.2f, 0.33f, 0.13f};
inline constexpr glm::vec3 kIron{0.16f, 0.17f, 0.18f};
inline constexpr glm::vec3 kWood{0.3f, 0.2f, 0.13f};

} // namespace alcove::city
