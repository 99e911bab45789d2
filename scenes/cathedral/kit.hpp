#pragma once
// What the elements of the cathedral share: its main dimensions, resolution, variation, and the
// growing scene.

#include "scenes/common/polygon.hpp"
#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/split_mix.hpp"

#include <cstddef>
#include <string>

#include <glm/vec3.hpp>

namespace alcove::cathedral {

// x runs from the west portal to the apse in the east, z to the south; the nave's floor is y = 0.
// Metres.
inline constexpr int kBays = 6;
inline constexpr double kBayLength = 5.0;
inline constexpr double kHalfLength =
    0.5 * kBays * kBayLength;                 ///< inner faces of west and east wall
inline constexpr double kNaveHalfWidth = 4.0; ///< inner faces of the nave walls
inline constexpr double kNaveWall = 0.9;      ///< thickness
inline constexpr double kColumnZ = kNaveHalfWidth + 0.5 * kNaveWall;
inline constexpr double kArcadeSpring = 5.0; ///< arcade and aisle vault spring from here
inline constexpr double kAisleRise = 2.4;
inline constexpr double kAisleOuter = 8.4; ///< inner faces of the outer walls
inline constexpr double kNaveSpring = 10.0;
inline constexpr double kNaveRise = 4.0; ///< the vault's crown is 14 m high
inline constexpr double kApseX = 15.5;   ///< axis of the apse
inline constexpr double kApseRadius = 3.7;
inline constexpr double kApseSpring = 8.0;
inline constexpr double kChoirFloor = 0.9;
/// Solids that meet are sunk into each other by this much or more, so that no two faces share a
/// plane.
inline constexpr double kSink = 0.05;

/// Middle of bay 0 .. kBays - 1.
[[nodiscard]] double get_bay_x(int bay);
/// Line between two bays, 0 .. kBays.
[[nodiscard]] double get_column_x(int line);

class Kit {
  public:
    /// `detail` scales the number of vertices, about; `seed` chooses sizes of ornament and wear.
    Kit(double detail, int seed);

    /// Number of segments of a curve that has `at_four` of them at detail 4, half as many at
    /// detail 1.
    [[nodiscard]] int segments(int at_four, int minimum) const;
    /// Distance between things that stand in a row, `at_default` at detail 1; closer with more
    /// detail.
    [[nodiscard]] double spacing(double at_default) const;
    /// False below detail 0.2, where mouldings, wall ribs, clerestory tracery, urns and pew ends
    /// are left out.
    [[nodiscard]] bool has_ornament() const noexcept { return m_has_ornament; }
    /// True above detail 8, where chairs and candles are put in.
    [[nodiscard]] bool is_crowded() const noexcept { return m_is_crowded; }
    /// A value within +-fraction of the given one. Calls follow each other in a fixed order.
    [[nodiscard]] double vary(double value, double fraction);

    std::size_t add_mesh(Mesh mesh);
    /// Turned by quarters of a circle around +y (from x towards -z), then moved. Positions are
    /// rounded to 2^-20 m.
    void place(std::size_t mesh, const glm::dvec3& position, int quarter_turns = 0);
    /// At the scene's zero.
    void place(std::size_t mesh) { place(mesh, glm::dvec3(0.0)); }

    /// Meshes, objects and transforms; lights and walkthrough are left to the scene.
    [[nodiscard]] RigidSceneContent take();

  private:
    double m_scale;
    bool m_has_ornament;
    bool m_is_crowded;
    SplitMix m_random;
    RigidSceneContent m_content;
};

/// Axis-aligned box as a mesh.
[[nodiscard]] Mesh make_box(std::string name, const glm::vec3& albedo, const glm::dvec3& low,
                            const glm::dvec3& high);
/// Surface of revolution around +y as a mesh.
[[nodiscard]] Mesh make_lathe(std::string name, const glm::vec3& albedo, const Contour& profile,
                              int segments);
/// A smooth curve through the profile's points with `steps` pieces between two of them; sharp at no
/// point.
[[nodiscard]] Contour smooth_profile(const Contour& points, int steps);
/// Opening with a round arch on top, counter-clockwise from its lower left corner.
[[nodiscard]] Contour make_arched_opening(double centre_x, double half_width, double bottom,
                                          double spring, int segments);

inline constexpr glm::vec3 kStone{0.62f, 0.58f, 0.50f};
inline constexpr glm::vec3 kLightStone{0.72f, 0.69f, 0.62f};
inline constexpr glm::vec3 kDarkStone{0.42f, 0.39f, 0.35f};
inline constexpr glm::vec3 kPlaster{0.76f, 0.73f, 0.67f};
inline constexpr glm::vec3 kWood{0.36f, 0.24f, 0.15f};

} // namespace alcove::cathedral
