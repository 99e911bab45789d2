#include "harness/run/grid.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace alcove {
namespace {

using Combination = std::vector<std::pair<std::string, std::string>>;

void check_axes(const MethodGrid& grid) {
    std::set<std::string> names;
    for (const ParameterOverride& fixed : grid.base.overrides) {
        names.insert(fixed.name);
    }
    for (const std::vector<ParameterAxis>* axes : {&grid.crossed, &grid.zipped}) {
        for (const ParameterAxis& axis : *axes) {
            if (axis.values.empty()) {
                throw InputError(grid.base.label + "." + axis.parameter, "axis without a value");
            }
            if (!names.insert(axis.parameter).second) {
                throw InputError(grid.base.label + "." + axis.parameter,
                                 "the parameter is set twice");
            }
        }
    }
    for (const ParameterAxis& axis : grid.zipped) {
        const std::size_t length = grid.zipped.front().values.size();
        if (axis.values.size() != length) {
            throw InputError(grid.base.label + "." + axis.parameter, "zipped axes differ in length",
                             std::to_string(axis.values.size()), std::to_string(length));
        }
    }
    double combinations =
        grid.zipped.empty() ? 1.0 : static_cast<double>(grid.zipped.front().values.size());
    for (const ParameterAxis& axis : grid.crossed) {
        combinations *= static_cast<double>(axis.values.size());
    }
    if (combinations > static_cast<double>(kMostCombinations)) {
        throw InputError(grid.base.label, "too many combinations", format_rounded(combinations, 12),
                         "at most " + std::to_string(kMostCombinations));
    }
}

std::vector<Combination> list_combinations(const MethodGrid& grid) {
    std::vector<Combination> combinations{{}};
    for (const ParameterAxis& axis : grid.crossed) {
        std::vector<Combination> longer;
        for (const Combination& combination : combinations) {
            for (const std::string& value : axis.values) {
                longer.push_back(combination);
                longer.back().emplace_back(axis.parameter, value);
            }
        }
        combinations = std::move(longer);
    }
    if (grid.zipped.empty()) {
        return combinations;
    }
    std::vector<Combination> zipped;
    for (const Combination& combination : combinations) {
        for (std::size_t i = 0; i < grid.zipped.front().values.size(); ++i) {
            zipped.push_back(combination);
            for (const ParameterAxis& axis : grid.zipped) {
                zipped.back().emplace_back(axis.parameter, axis.values[i]);
            }
        }
    }
    return zipped;
}

/// Numbers compare as numbers: 0.50 is 0.5.
bool is_same_value(const ParameterTable& table, const std::string& parameter, const std::string& a,
                   const std::string& b) {
    const ParameterInfo& info = table.find(parameter);
    return table.parse(info, a) == table.parse(info, b);
}

bool meets(const Combination& combination, const GridSkip& skip, const ParameterTable& table) {
    return std::all_of(skip.where.begin(), skip.where.end(), [&](const auto& wanted) {
        return std::any_of(combination.begin(), combination.end(), [&](const auto& given) {
            return given.first == wanted.first &&
                   is_same_value(table, given.first, given.second, wanted.second);
        });
    });
}

/// The specification without its own values of swept parameters, which the sweep replaces.
MethodSpec free_swept(const MethodSpec& spec, const std::vector<ParameterAxis>& axes) {
    MethodSpec freed = spec;
    const auto is_swept = [&axes](const ParameterOverride& value) {
        return std::any_of(axes.begin(), axes.end(), [&value](const ParameterAxis& axis) {
            return axis.parameter == value.name;
        });
    };
    if (std::erase_if(freed.overrides, is_swept) == 0) {
        return freed;
    }
    freed.label = freed.method;
    freed.label += freed.preset == "default" ? "" : "@" + freed.preset;
    for (std::size_t i = 0; i < freed.overrides.size(); ++i) {
        freed.label +=
            (i == 0 ? ":" : ",") + freed.overrides[i].name + "=" + freed.overrides[i].value;
    }
    return freed;
}

/// Two specifications that differed only in what is swept are one now.
void remove_repeated(std::vector<MethodSpec>& specs) {
    std::set<std::string> labels;
    std::erase_if(specs,
                  [&labels](const MethodSpec& spec) { return !labels.insert(spec.label).second; });
}

/// The base's label with the combination's values behind it.
std::string make_label(const MethodSpec& base, const Combination& combination) {
    std::string label = base.label;
    // "m", "m@p" and a label of the user's have no parameters yet.
    bool has_values = base.label.find(':') != std::string::npos;
    for (const auto& [name, value] : combination) {
        label += has_values ? "," : ":";
        label += name;
        label += "=";
        label += value;
        has_values = true;
    }
    return label;
}

} // namespace

std::vector<std::string> list_values(const ValueRange& range, ParameterKind kind,
                                     std::string_view where) {
    constexpr std::int64_t kMostSteps = 1000;
    if (range.steps < 2 || range.steps > kMostSteps) {
        throw InputError(where, "steps out of range", std::to_string(range.steps), "2 to 1000");
    }
    if (!std::isfinite(range.from) || !std::isfinite(range.to)) {
        throw InputError(where, "an end of the range is not finite");
    }
    const bool is_log = range.scale == ParameterScale::log;
    if (is_log && (range.from <= 0.0 || range.to <= 0.0)) {
        throw InputError(where, "a log range needs ends above 0",
                         format_number(std::min(range.from, range.to)));
    }
    std::vector<std::string> values;
    for (std::int64_t i = 0; i < range.steps; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(range.steps - 1);
        double value = is_log ? range.from * std::pow(range.to / range.from, t)
                              : range.from + (range.to - range.from) * t;
        if (i + 1 == range.steps) {
            value = range.to; // free of rounding
        }
        const std::string text =
            format_number(kind == ParameterKind::integer ? std::round(value) : value);
        if (values.empty() || values.back() != text) {
            values.push_back(text);
        }
    }
    return values;
}

void check_method_spec(const Registry<MethodUnit>& methods, const MethodSpec& spec) {
    const MethodUnit& unit = methods.find(spec.method);
    static_cast<void>(unit.find_preset(spec.preset));
    for (const ParameterOverride& value : spec.overrides) {
        static_cast<void>(unit.parameters.parse(unit.parameters.find(value.name), value.value));
    }
}

void expand(const MethodGrid& grid, const Registry<MethodUnit>& methods, Experiment& experiment) {
    check_axes(grid);
    const ParameterTable& table = methods.find(grid.base.method).parameters;
    std::vector<std::size_t> met(grid.skips.size(), 0);
    for (const Combination& combination : list_combinations(grid)) {
        MethodSpec spec = grid.base;
        spec.label = make_label(grid.base, combination);
        for (const auto& [name, value] : combination) {
            spec.overrides.push_back({name, value, Provenance::command_line});
        }
        check_method_spec(methods, spec);
        const auto skip =
            std::find_if(grid.skips.begin(), grid.skips.end(),
                         [&](const GridSkip& s) { return meets(combination, s, table); });
        if (skip != grid.skips.end()) {
            ++met[static_cast<std::size_t>(skip - grid.skips.begin())];
            experiment.skipped.push_back({spec.label, skip->reason});
        } else {
            experiment.methods.push_back(std::move(spec));
        }
    }
    for (std::size_t i = 0; i < met.size(); ++i) {
        if (met[i] == 0) {
            throw InputError(grid.base.label, "a skip that no combination meets",
                             grid.skips[i].reason);
        }
    }
}

Sweep parse_sweep(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::size_t dot = text.substr(0, equals).find('.');
    const char* const expected = "METHOD.PARAM=v1,v2,...";
    if (equals == std::string_view::npos || dot == std::string_view::npos || dot == 0 ||
        dot + 1 == equals) {
        throw InputError("--sweep", "cannot be read", text, expected);
    }
    Sweep sweep;
    sweep.method = text.substr(0, dot);
    sweep.axis.parameter = text.substr(dot + 1, equals - dot - 1);
    sweep.axis.values = split(text.substr(equals + 1), ',');
    for (const std::string& value : sweep.axis.values) {
        if (value.empty()) {
            throw InputError("--sweep", "empty value", text, expected);
        }
    }
    return sweep;
}

void apply_sweeps(const std::vector<Sweep>& sweeps, const Registry<MethodUnit>& methods,
                  Experiment& experiment) {
    std::map<std::string, std::vector<ParameterAxis>> axes;
    for (const Sweep& sweep : sweeps) {
        static_cast<void>(methods.find(sweep.method));
        axes[sweep.method].push_back(sweep.axis);
        const bool is_there =
            std::any_of(experiment.methods.begin(), experiment.methods.end(),
                        [&sweep](const MethodSpec& spec) { return spec.method == sweep.method; });
        if (!is_there) {
            experiment.methods.push_back(parse_method_spec(sweep.method, "--sweep"));
        }
    }
    const std::vector<MethodSpec> before = std::move(experiment.methods);
    experiment.methods.clear();
    for (const MethodSpec& spec : before) {
        const auto found = axes.find(spec.method);
        if (found == axes.end()) {
            experiment.methods.push_back(spec);
        } else {
            expand({free_swept(spec, found->second), found->second, {}, {}}, methods, experiment);
        }
    }
    remove_repeated(experiment.methods);
}

} // namespace alcove
