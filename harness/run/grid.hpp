#pragma once
// Parameter grids: one method over the values of some of its parameters.

#include "core/base/registry.hpp"
#include "core/contract/method.hpp"
#include "harness/run/experiment.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// A parameter and the values it takes, as text.
struct ParameterAxis {
    std::string parameter;
    std::vector<std::string> values;
};

/// Leaves out the combinations that have all these values.
struct GridSkip {
    std::map<std::string, std::string> where; ///< parameter -> value
    std::string reason;
};

struct MethodGrid {
    MethodSpec base;
    std::vector<ParameterAxis> crossed; ///< every value with every other
    std::vector<ParameterAxis> zipped;  ///< advance together: all of one length
    std::vector<GridSkip> skips;
};

/// More combinations than this are a mistake in the experiment, not an experiment.
inline constexpr std::size_t kMostCombinations = 10000;

/// `steps` values from `from` to `to`, both included, equal steps on the scale; rounded to integers
/// (and then without doubles) for an integer parameter. Throws InputError naming `where` if steps
/// is not 2 to 1000, an end is not finite, or a log range does not stay above 0.
struct ValueRange {
    double from = 0.0;
    double to = 0.0;
    std::int64_t steps = 0;
    ParameterScale scale = ParameterScale::linear;
};
[[nodiscard]] std::vector<std::string> list_values(const ValueRange& range, ParameterKind kind,
                                                   std::string_view where);

/// Throws InputError if the method, its preset, a parameter or a value is not what the unit
/// declares.
void check_method_spec(const Registry<MethodUnit>& methods, const MethodSpec& spec);

/// Appends the grid's combinations to methods and what it leaves out to skipped. The first crossed
/// axis changes slowest, zipped axes fastest. Every value is checked against the unit; values that
/// two axes give to one parameter, zipped axes of different length, and a skip that no combination
/// meets are errors. Throws InputError.
void expand(const MethodGrid& grid, const Registry<MethodUnit>& methods, Experiment& experiment);

/// "METHOD.PARAM=v1,v2,...": throws InputError naming --sweep.
struct Sweep {
    std::string method;
    ParameterAxis axis;
};
[[nodiscard]] Sweep parse_sweep(std::string_view text);

/// Puts in place of every specification of a swept method its combinations; sweeps of one method
/// cross, and replace a value that the specification sets itself. A method that is not in the
/// experiment joins it. Throws InputError.
void apply_sweeps(const std::vector<Sweep>& sweeps, const Registry<MethodUnit>& methods,
                  Experiment& experiment);

} // namespace alcove
