#pragma once
// A parameter that tuning may move: how a place between 0 and 1 becomes a value of it.

#include "core/contract/method.hpp"

#include <string>
#include <vector>

namespace alcove {

/// Lengths that follow the target's radius are searched as a multiple of it, from a quarter to four
/// times on a log scale; others over the range that is declared, on the scale that is declared.
class FreeParameter {
  public:
    /// Throws InputError if it is no number.
    explicit FreeParameter(const ParameterInfo& info);

    [[nodiscard]] const std::string& name() const noexcept { return m_info.name; }
    [[nodiscard]] bool is_relative() const noexcept { return m_is_relative; }
    /// At `place` in [0,1]: a number, or a multiple of the target's radius ("0.93 * scene_radius"),
    /// as a calibration holds it. Rounded to four digits, integers to whole numbers.
    [[nodiscard]] std::string describe(double place) const;

  private:
    ParameterInfo m_info;
    bool m_is_relative;
    bool m_is_log;
    double m_minimum;
    double m_maximum;
};

/// The parameters of these names, or, where there are none, what DESIGN 3.8 calls free: radius and
/// strength, as far as the method has them. Throws InputError on unknown names, names given twice,
/// and methods without any.
[[nodiscard]] std::vector<FreeParameter>
choose_free_parameters(const MethodUnit& unit, const std::vector<std::string>& names);

} // namespace alcove
