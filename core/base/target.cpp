#include "core/base/target.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace alcove {
namespace {

constexpr std::array kFalloffs{"none", "linear", "quadratic"};
constexpr std::array kWeightings{"cosine", "uniform"};
constexpr std::array kNormals{"shading", "geometric"};
constexpr std::array kOutputs{"visibility", "radiance"};
constexpr std::array kReaches{"near", "full"};

template <class Enum, std::size_t N>
Enum parse_choice(std::string_view what, std::string_view text,
                  const std::array<const char*, N>& names) {
    for (std::size_t i = 0; i < N; ++i) {
        if (text == names[i]) {
            return static_cast<Enum>(i);
        }
    }
    const std::vector<std::string> choices(names.begin(), names.end());
    throw InputError("target", std::string("unknown ") + std::string(what), text,
                     describe_choices(text, choices));
}

} // namespace

std::string_view to_text(Falloff falloff) {
    return kFalloffs.at(static_cast<std::size_t>(falloff));
}
std::string_view to_text(Weighting weighting) {
    return kWeightings.at(static_cast<std::size_t>(weighting));
}
std::string_view to_text(Normals normals) {
    return kNormals.at(static_cast<std::size_t>(normals));
}
std::string_view to_text(TargetOutput output) {
    return kOutputs.at(static_cast<std::size_t>(output));
}
std::string_view to_text(Reach reach) {
    return kReaches.at(static_cast<std::size_t>(reach));
}

Falloff parse_falloff(std::string_view text) {
    return parse_choice<Falloff>("falloff", text, kFalloffs);
}
Weighting parse_weighting(std::string_view text) {
    return parse_choice<Weighting>("weighting", text, kWeightings);
}
Normals parse_normals(std::string_view text) {
    return parse_choice<Normals>("normals", text, kNormals);
}
TargetOutput parse_target_output(std::string_view text) {
    return parse_choice<TargetOutput>("output", text, kOutputs);
}
Reach parse_reach(std::string_view text) {
    return parse_choice<Reach>("reach", text, kReaches);
}

std::string describe(const Target& target) {
    std::string text = "radius=" + format_number(target.radius_m) +
                       ",falloff=" + std::string(to_text(target.falloff)) +
                       ",weighting=" + std::string(to_text(target.weighting)) +
                       ",normals=" + std::string(to_text(target.normals));
    if (target.output == TargetOutput::radiance) {
        text += ",output=" + std::string(to_text(target.output)) +
                ",reach=" + std::string(to_text(target.reach));
    }
    return text;
}

Target parse_target(std::string_view text, const Target& base) {
    Target target = base;
    std::set<std::string> seen;
    for (const KeyValue& entry : parse_key_values(text, "--target")) {
        if (!seen.insert(entry.key).second) {
            throw InputError("--target", "key given twice", entry.key);
        }
        if (entry.key == "radius") {
            target.radius_m = parse_number(entry.value, "--target radius");
            if (!(target.radius_m > 0.0) || !std::isfinite(target.radius_m)) {
                throw InputError("--target radius", "out of range", entry.value,
                                 "a positive finite number of metres");
            }
        } else if (entry.key == "falloff") {
            target.falloff = parse_falloff(entry.value);
        } else if (entry.key == "weighting") {
            target.weighting = parse_weighting(entry.value);
        } else if (entry.key == "normals") {
            target.normals = parse_normals(entry.value);
        } else if (entry.key == "output") {
            target.output = parse_target_output(entry.value);
        } else if (entry.key == "reach") {
            target.reach = parse_reach(entry.value);
        } else {
            const std::vector<std::string> keys{"radius",  "falloff", "weighting",
                                                "normals", "output",  "reach"};
            throw InputError("--target", "unknown key", entry.key,
                             describe_choices(entry.key, keys));
        }
    }
    if (target.output == TargetOutput::visibility && target.reach == Reach::full) {
        throw InputError("--target reach", "visibility ends at the radius", "full",
                         "reach=near, or output=radiance,reach=full");
    }
    return target;
}

} // namespace alcove
