#pragma once
// What the elements of the city share: its main dimensions, resolution, variation, and the growing
// scene.

#include "scenes/common/mesh_builder.hpp"
#include "scenes/common/polygon.hpp"
#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/split_mix.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace alcove::city {

// Street axes lie at the multiples of kPitch in x and z; carriageways are y = 0. Metres.
inline constexpr int kBlocks = 10;         ///< along x and along z
inline constexpr double kPitch = 118.0;    ///< from street axis to street axis
inline constexpr double kHalfBlock = 49.0; ///< middle of a block to its building line
inline constexpr double kKerb = 53.5;      ///< middle of a block to its kerb
inline constexpr double kHalfCarriageway = 0.5 * kPitch - kKerb;
inline constexpr double kPavement = 0.15; ///< height
inline constexpr double kBay = 3.5;       ///< from window axis to window axis
inline constexpr int kFrontBays = 6;
inline constexpr int kEndBays = 4;
inline constexpr double kLotWidth = kFrontBays * kBay;
inline constexpr double kLotDepth = kEndBays * kBay;
inline constexpr double kGroundFloor = 4.3; ///< height
inline constexpr double kStorey = 3.4;
inline constexpr double kAttic = 0.35;   ///< wall above the uppermost ceiling
inline constexpr double kRoofRise = 4.5; ///< from the wall's top to the ridge
inline constexpr double kFacade = 0.3;   ///< front of a facade before its building's wall
/// Solids that meet are sunk into each other by about this much, so that no two faces share a
/// plane.
inline constexpr double kSink = 0.05;

class Kit {
  public:
    /// `detail` scales the number of vertices, about; `seed` chooses sizes, colours and places.
    Kit(double detail, int seed);

    /// Number of segments of a curve that has `at_default` of them at detail 1; grows with the
    /// eighth root of detail.
    [[nodiscard]] int segments(int at_default, int minimum) const;
    /// Number of things in a row or cluster that has `at_default` of them at detail 1; grows with
    /// the fourth root of detail.
    [[nodiscard]] int count(double at_default, int minimum) const;
    /// Layers of a moulding: 1 below detail 4, else 2. With two, sashes, roofs, kerbs and wheels
    /// get their parts.
    [[nodiscard]] int steps() const noexcept { return m_steps; }
    /// Things farther than this from where the walkthroughs pass are left out, metres: 24 m at
    /// detail 1, 513 m at detail 64.
    [[nodiscard]] double reach_m() const noexcept { return m_reach_m; }
    /// Numbers that depend on the seed and on `salt` alone, so that a building is the same at every
    /// detail.
    [[nodiscard]] SplitMix make_random(std::uint64_t salt) const;

    std::size_t add_mesh(Mesh mesh);
    /// Places a mesh; returns the object's index. Positions are rounded to 2^-20 m.
    std::size_t place(std::size_t mesh, const glm::dmat4& transform);

    /// Meshes, objects and transforms; lights and walkthrough are left to the scene.
    [[nodiscard]] RigidSceneContent take();

  private:
    double m_detail;
    int m_steps;
    double m_reach_m;
    std::uint64_t m_seed;
    RigidSceneContent m_content;
};

/// Moved to `position`, turned by quarters of a circle around +y (from z towards x) without
/// rounding.
[[nodiscard]] glm::dmat4 make_frame(const glm::dvec3& position, int quarter_turns = 0);
/// Any angle and size.
[[nodiscard]] glm::dmat4 make_frame(const glm::dvec3& position, double radians, double scale);
/// `frame` moved by `offset` along its own axes.
[[nodiscard]] glm::dmat4 shift(const glm::dmat4& frame, const glm::dvec3& offset);

/// Metres in the plane from (x,z) to the streets that the walkthroughs pass.
[[nodiscard]] double measure_distance_to_route(const glm::dvec3& point);

[[nodiscard]] Contour make_rectangle(double left, double bottom, double right, double top);
/// A bar with a constant (z, y) section of either orientation, from x = `from` to `to`.
void add_bar(MeshBuilder& builder, const Contour& section_zy, double from, double to);

} // namespace alcove::city
