#pragma once
// A cloak that hangs from a walker's shoulders and moves with the gait: a closed thin sheet under
// an analytic motion, so that its place at any time is exact.

#include "scenes/common/thin_sheet.hpp"

#include <array>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

namespace alcove {

class Cloak {
  public:
    /// `detail` scales the number of vertices, 27,000 at 1. `seed` chooses where folds lie. For a
    /// walker whose hips are at `hip_m` when it stands straight.
    Cloak(double detail, int seed, double hip_m);

    [[nodiscard]] Mesh make_mesh(std::string name, const glm::vec3& albedo) const;
    /// In the walker's frame (+x ahead, +y up) after `cycles` of the gait. Repeats every
    /// kRepeat cycles. `torso` is what moved the torso away from its place at rest: shoulders
    /// follow it, the hem does not.
    [[nodiscard]] Deformation deform(double cycles, const glm::dmat4& torso) const;

    static constexpr int kRepeat = 4;

  private:
    /// A wave that travels over the sheet and pushes it in or out.
    struct Wave {
        double amplitude = 0.0; ///< metres at the hem
        int frequency = 0;      ///< in kRepeat cycles
        double down = 0.0;      ///< radians from collar to hem
        double across = 0.0;    ///< radians from the middle to an edge
        double power = 1.0;     ///< amplitude grows with this power of the way from the collar
        double phase = 0.0;     ///< radians
    };
    struct Row {
        double v = 0.0;    ///< 0 at the collar, 1 at the hem
        double free = 0.0; ///< how little the shoulders hold it, 0 .. 1
    };
    [[nodiscard]] std::vector<glm::dvec3> compute_middle(double cycles,
                                                         const glm::dmat4& torso) const;

    ThinSheet m_sheet;
    std::vector<Wave> m_waves;
    std::vector<Row> m_rows;
    std::vector<double> m_columns;     ///< -1 (left) .. 1
    std::vector<glm::dvec3> m_rest;    ///< with its folds
    std::vector<glm::dvec3> m_outward; ///< level
};

} // namespace alcove
