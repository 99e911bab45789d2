#include "harness/app/planned.hpp"

#include "core/base/error.hpp"

#include <array>

namespace alcove {

std::span<const Planned> list_planned_verbs() {
    static constexpr std::array kVerbs{
        Planned{"view", "a window: fly, switch methods, record"},
    };
    return kVerbs;
}

std::span<const Planned> list_planned_run_flags() {
    static constexpr std::array kFlags{
        Planned{"--shard", "part I of N of the rounds"},
    };
    return kFlags;
}

void throw_planned(const std::string& name) {
    throw InputError("`" + name + "` is planned, not built yet");
}

} // namespace alcove
