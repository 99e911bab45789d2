#include "harness/run/experiment.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"
#include "harness/run/repeat_rule.hpp"

#include <algorithm>

#include <algorithm>
#include <array>

namespace alcove {

MethodSpec parse_method_spec(std::string_view text, std::string_view option) {
    MethodSpec spec;
    spec.label = text;
    std::string_view rest = text;
    if (const std::size_t mark = rest.find('#'); mark != std::string_view::npos) {
        spec.label = rest.substr(mark + 1);
        rest = rest.substr(0, mark);
        if (spec.label.empty()) {
            throw InputError(option, "empty label after #", text,
                             "M[@PRESET][:key=value,...][#label]");
        }
    }
    if (const std::size_t colon = rest.find(':'); colon != std::string_view::npos) {
        for (const KeyValue& entry : parse_key_values(rest.substr(colon + 1), option)) {
            spec.overrides.push_back({entry.key, entry.value, Provenance::command_line});
        }
        rest = rest.substr(0, colon);
    }
    if (const std::size_t at = rest.find('@'); at != std::string_view::npos) {
        spec.preset = rest.substr(at + 1);
        rest = rest.substr(0, at);
    }
    spec.method = rest;
    return spec;
}

std::string_view to_text(SettingsKind kind) {
    constexpr std::array kNames{"common", "calibrated", "native"};
    return kNames.at(static_cast<std::size_t>(kind));
}

std::vector<SettingsKind> parse_settings(const std::vector<std::string>& texts) {
    const std::vector<std::string> names{"common", "native"};
    std::vector<SettingsKind> kinds;
    if (texts.empty()) {
        throw InputError("--settings", "none", {}, "common, native or both");
    }
    for (const std::string& name : texts) {
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            throw InputError("--settings", "unknown choice", name, describe_choices(name, names));
        }
        const SettingsKind kind = name == "native" ? SettingsKind::native : SettingsKind::common;
        if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) {
            throw InputError("--settings", "given twice", name);
        }
        kinds.push_back(kind);
    }
    return kinds;
}

ImageSize parse_size(std::string_view text) {
    constexpr std::int64_t kLargest = 16384;
    const std::vector<std::string> parts = split(text, 'x');
    const char* const expected = "WxH with 1 to 16384 pixels each, for example 384x288";
    if (parts.size() != 2) {
        throw InputError("--size", "not a size", text, expected);
    }
    const std::int64_t width = parse_integer(parts[0], "--size");
    const std::int64_t height = parse_integer(parts[1], "--size");
    if (width < 1 || height < 1 || width > kLargest || height > kLargest) {
        throw InputError("--size", "out of range", text, expected);
    }
    return {static_cast<int>(width), static_cast<int>(height)};
}

std::string_view to_text(EffectsChoice choice) {
    return choice == EffectsChoice::all ? "all" : "auto";
}

EffectsChoice parse_effects_choice(std::string_view text) {
    const std::vector<std::string> names{"all", "auto"};
    if (text == names[0]) {
        return EffectsChoice::all;
    }
    if (text == names[1]) {
        return EffectsChoice::automatic;
    }
    throw InputError("--effects", "unknown choice", text, describe_choices(text, names));
}

MethodSpec get_default_reference(const Target& target) {
    MethodSpec spec;
    spec.method =
        target.output == TargetOutput::radiance ? "reference_path_traced" : "reference_ray_traced";
    spec.label = spec.method;
    return spec;
}

void check_repeats(const Experiment& experiment, const RepeatOptionNames& options) {
    const auto check = [](bool fits, const std::string& option, const std::string& found,
                          const std::string& expected) {
        if (!fits) {
            throw InputError(option, "out of range", found, expected);
        }
    };
    if (experiment.until_width) {
        check(*experiment.until_width > 0.0 && *experiment.until_width < 1.0, options.until_width,
              format_number(*experiment.until_width),
              "a relative half-width in (0, 1): 0.01 is 1 %");
    }
    if (experiment.time_limit_s) {
        constexpr double kMostSeconds = 1e6;
        check(*experiment.time_limit_s > 0.0 && *experiment.time_limit_s <= kMostSeconds,
              options.time_limit, format_number(*experiment.time_limit_s),
              "seconds in (0, 1000000]");
    }
    if (experiment.most_repeats) {
        const int least = std::max(kFirstLook, experiment.repeats);
        check(*experiment.most_repeats >= least && *experiment.most_repeats <= kMostRepeats,
              options.most_repeats, std::to_string(*experiment.most_repeats),
              std::to_string(least) + " to " + std::to_string(kMostRepeats));
    }
    if (!experiment.until_width && (experiment.time_limit_s || experiment.most_repeats)) {
        throw InputError(experiment.time_limit_s ? options.time_limit : options.most_repeats,
                         "limits repeats that go on", "no " + options.until_width,
                         options.until_width + " W");
    }
}

} // namespace alcove
