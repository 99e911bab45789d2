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

Falloff parse_falloff(std::string_view text) {
    return parse_choice<Falloff>("falloff", text, kFalloffs);
}
Weighting parse_weighting(std::string_view text) {
    return parse_choice<Weighting>("weighting", text, kWeightings);
}
Normals parse_normals(std::string_view text) {
    return parse_choice<Normals>("normals", text, kNormals);
}

std::string describe(const Target& target) {
    return "radius=" + format_number(target.radius_m) +
           ",falloff=" + std::string(to_text(target.falloff)) +
           ",weighting=" + std::string(to_text(target.weighting)) +
           ",normals=" + std::string(to_text(target.normals));
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
        } else {
            const std::vector<std::string> keys{"radius", "falloff", "weighting", "normals"};
            throw InputError("--target", "unknown key", entry.key,
                             describe_choices(entry.key, keys));
        }
    }
    return target;
}

} // namespace alcove
