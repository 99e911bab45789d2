#pragma once
// Which contexts this machine can open, and as what.

#include <string>
#include <vector>

namespace alcove::gl {

struct ContextFinding {
    std::string context; ///< as in DeviceInfo.context
    std::string device_class;
    std::string renderer; ///< empty if it cannot be opened
    std::string failure;  ///< why it cannot be opened; empty otherwise
};

/// Tries OSMesa, EGL's two platforms and GLFW, software renderers allowed. Each in a child process
/// of its own, which has 20 s: a driver that crashes or hangs is a finding and not this process's
/// end, and no library of theirs stays in it. Call it before there are other threads.
[[nodiscard]] std::vector<ContextFinding> survey_contexts();

} // namespace alcove::gl
