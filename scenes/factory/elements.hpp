#pragma once
// The elements of the factory, a file each, and what they share.

#include "scenes/common/mesh_builder.hpp"
#include "scenes/common/scene_kit.hpp"

#include <vector>

namespace alcove::factory {

// x runs along the hall, the floor is y = 0. Metres.
inline constexpr int kBays = 6;
inline constexpr double kBay = 5.0;
inline constexpr double kHalfLength = 0.5 * kBays * kBay;
inline constexpr double kHalfWidth = 8.0; ///< inner faces of the long walls
inline constexpr double kEaves = 8.0;     ///< top of the columns
inline constexpr double kHalfAisle = 1.5; ///< nothing but the crane stands or hangs in it
/// Solids that meet reach this deep into each other: no two faces in one plane.
inline constexpr double kSink = 0.03;

/// How fine things are.
class Fineness {
  public:
    explicit Fineness(double detail) : m_detail(detail) {}
    /// Of a curve that has `at_one` segments at detail 1: grows with its root.
    [[nodiscard]] int segments(int at_one) const;
    /// Of things in a row that has `at_one` of them at detail 1: grows with its root.
    [[nodiscard]] int count(int at_one) const;

  private:
    double m_detail;
};

/// A round bar between two points.
void add_bar(MeshBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double radius,
             int around);
/// A pipe through corners, which are rounded with `bend` > radius; flanges at both ends and on both
/// sides of every bend. Neighbouring corners are more than 2.5 bends apart.
void add_pipe(MeshBuilder& builder, const std::vector<glm::dvec3>& corners, double radius,
              double bend, const Fineness& fineness);
/// A ring with a round section about an axis through `centre` along z.
void add_ring(MeshBuilder& builder, const glm::dvec3& centre, double radius, double thickness,
              const Fineness& fineness);

void add_hall(SceneKit& kit, const Fineness& fineness);
void add_pipes(SceneKit& kit, const Fineness& fineness);
void add_machines(SceneKit& kit, const Fineness& fineness);
void add_gantry(SceneKit& kit, const Fineness& fineness);
/// The objects "crane" and "flywheel", which tracks of the walkthrough move.
void add_moving_parts(SceneKit& kit, const Fineness& fineness);

} // namespace alcove::factory
