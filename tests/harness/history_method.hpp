#pragma once
// A method that counts: its visibility is 1 / (frames since its history was forgotten), and it
// writes down all that is done to it. What the runner does shows in its images as well as in its
// log.

#include "core/contract/method.hpp"

#include <memory>
#include <vector>

namespace alcove {

enum class HistoryEvent { reset, render };

struct HistoryEntry {
    HistoryEvent event = HistoryEvent::render;
    int instance = 0; ///< methods in the order of their creation
    int frame = 0;
    bool history_valid = false;
    bool is_held = false; ///< previous camera and time = current ones
    bool has_motion = false;
    bool has_lights = false;
    bool has_geometry = false;
    std::uint32_t noise_seed = 0;
    int count = 0; ///< frames since the reset, this one included
};

struct HistoryLog {
    std::vector<HistoryEntry> entries;
    int instances = 0;
};

inline constexpr int kHistoryWarmFrames = 4;

/// "history_method": reads the base, motion and the posed geometry, runs the passes
/// history_method/first and /second.
[[nodiscard]] MethodUnit make_history_method_unit(std::shared_ptr<HistoryLog> log);

} // namespace alcove
