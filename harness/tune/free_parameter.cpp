#include "harness/tune/free_parameter.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace alcove {
namespace {

constexpr const char* kTargetRadius = "scene_radius";
constexpr double kMostRelative = 4.0;
constexpr int kDigits = 4;

} // namespace

FreeParameter::FreeParameter(const ParameterInfo& info)
    : m_info(info), m_is_relative(info.default_expression == kTargetRadius),
      m_is_log(m_is_relative || info.scale == ParameterScale::log),
      m_minimum(m_is_relative ? 1.0 / kMostRelative : info.minimum),
      m_maximum(m_is_relative ? kMostRelative : info.maximum) {
    if (info.kind != ParameterKind::integer && info.kind != ParameterKind::real) {
        throw InputError("--free", "is no number", info.name, "a parameter with a range");
    }
}

std::string FreeParameter::describe(double place) const {
    ALCOVE_ASSERT(place >= 0.0 && place <= 1.0, "a place in the unit interval");
    const double value = m_is_log ? m_minimum * std::pow(m_maximum / m_minimum, place)
                                  : m_minimum + place * (m_maximum - m_minimum);
    if (m_info.kind == ParameterKind::integer) {
        return std::to_string(std::llround(value));
    }
    // Rounding must not leave the range.
    const double rounded = parse_number(format_rounded(value, kDigits), "free parameter");
    const std::string text = format_number(std::clamp(rounded, m_minimum, m_maximum));
    return m_is_relative ? text + " * " + kTargetRadius : text;
}

std::vector<FreeParameter> choose_free_parameters(const MethodUnit& unit,
                                                  const std::vector<std::string>& names) {
    std::vector<FreeParameter> free;
    if (names.empty()) {
        for (const ParameterTable::Entry& entry : unit.parameters.entries()) {
            if (entry.info.name == "radius" || entry.info.name == "strength") {
                free.emplace_back(entry.info);
            }
        }
    }
    std::set<std::string> seen;
    for (const std::string& name : names) {
        if (!seen.insert(name).second) {
            throw InputError("--free", "given twice", name);
        }
        free.emplace_back(unit.parameters.find(name));
    }
    if (free.empty()) {
        throw InputError("tune", "nothing to tune: neither radius nor strength", unit.name,
                         "--free with parameters of the method");
    }
    return free;
}

} // namespace alcove
