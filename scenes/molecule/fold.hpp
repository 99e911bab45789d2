#pragma once
// Where the atoms of a protein-like molecule are.

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace alcove::molecule {

struct Element {
    const char* name;
    double radius; ///< van der Waals, angstrom (A. Bondi. 1964)
    double share;  ///< of all atoms; as in proteins, hydrogen left out
    glm::vec3 albedo;
};
inline constexpr std::array<Element, 4> kElements{{{"carbon", 1.70, 0.63, {0.42f, 0.44f, 0.46f}},
                                                   {"nitrogen", 1.55, 0.17, {0.2f, 0.32f, 0.7f}},
                                                   {"oxygen", 1.52, 0.19, {0.72f, 0.18f, 0.14f}},
                                                   {"sulfur", 1.80, 0.01, {0.8f, 0.66f, 0.15f}}}};

struct Atom {
    glm::dvec3 position{0.0}; ///< angstrom, about 0
    std::size_t element = 0;  ///< index into kElements
};

/// Every atom but the first is bonded to an earlier one, 1.5 angstrom away, so that the two balls
/// overlap; others stay more than 2.1 angstrom apart. The chain branches and folds into a blob with
/// lobes and pockets. The same for the same arguments.
[[nodiscard]] std::vector<Atom> fold(int atoms, int seed);

} // namespace alcove::molecule
