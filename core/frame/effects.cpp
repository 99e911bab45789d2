#include "core/frame/effects.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <vector>

namespace alcove {
namespace {

constexpr std::string_view kAll = "all";
constexpr std::string_view kWithout = "without ";

} // namespace

std::string describe(EffectSet effects) {
    std::string text;
    for (const EffectInfo& info : kEffects) {
        if (!effects.contains(info.effect)) {
            text += text.empty() ? kWithout : ",";
            text += info.name;
        }
    }
    return text.empty() ? std::string(kAll) : text;
}

EffectSet parse_effects(std::string_view text) {
    EffectSet effects = EffectSet::all();
    if (text == kAll) {
        return effects;
    }
    if (!text.starts_with(kWithout)) {
        throw InputError("effects", "cannot be read", text, "all, or without NAME,...");
    }
    std::vector<std::string> names;
    for (const EffectInfo& info : kEffects) {
        names.emplace_back(info.name);
    }
    for (const std::string& name : split(text.substr(kWithout.size()), ',')) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            throw InputError("effects", "unknown effect", name, describe_choices(name, names));
        }
        effects.remove(kEffects.at(static_cast<std::size_t>(found - names.begin())).effect);
    }
    return effects;
}

} // namespace alcove
