#include "core/contract/method.hpp"

namespace alcove {

const Preset& MethodUnit::find_preset(std::string_view preset) const {
    std::vector<std::string> names;
    for (const Preset& candidate : presets) {
        if (candidate.name == preset) {
            return candidate;
        }
        names.push_back(candidate.name);
    }
    throw InputError(name, "unknown preset", preset, describe_choices(preset, names));
}

} // namespace alcove
