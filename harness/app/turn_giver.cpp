#include "harness/app/turn_giver.hpp"

#include "core/base/error.hpp"
#include "harness/app/turns.hpp"

#include <array>
#include <cstdio>
#include <optional>

#include <fmt/format.h>

namespace alcove {
namespace {

/// A side and the step it asks for.
struct Waiting {
    const TurnSide& side;
    bool has_asked = false;
    std::optional<std::string> step; ///< none: it has ended
};

[[noreturn]] void throw_failed(const Waiting& waiting, ProcessEnd end) {
    const std::string who = fmt::format("{} ({})", waiting.side.side, waiting.side.name);
    const std::string log = waiting.side.process.read_log();
    if (!waiting.has_asked && log.find("--turns") != std::string::npos) {
        throw FailureError(who, "does not know --turns", "an older alcove",
                           "a build of a commit that has `ab`");
    }
    std::fputs(log.c_str(), stderr);
    if (end.signal != 0) {
        throw FailureError(who, "was ended", fmt::format("signal {}", end.signal));
    }
    constexpr int kRefused = 2;
    if (end.exit_code == kRefused) {
        throw InputError(who, "refused its arguments");
    }
    throw FailureError(who, "failed", fmt::format("exit code {}", end.exit_code));
}

/// Waits until it asks for its next step or has ended well.
void await(Waiting& waiting) {
    waiting.step.reset();
    while (const std::optional<std::string> line = waiting.side.process.read_line()) {
        if (line->starts_with(kTurnPrefix)) {
            waiting.has_asked = true;
            waiting.step = line->substr(kTurnPrefix.size());
            return;
        }
    }
    const ProcessEnd end = waiting.side.process.finish();
    if (end.exit_code != 0) {
        throw_failed(waiting, end);
    }
    if (!waiting.has_asked) {
        throw FailureError(waiting.side.name, "ended without asking for a turn");
    }
}

void give_turn(Waiting& waiting, const std::function<void(const Turn&)>& turn_done) {
    Turn turn{waiting.side.side, *waiting.step, std::chrono::steady_clock::now(), {}};
    // If it no longer reads it has ended: await says how.
    static_cast<void>(waiting.side.process.write(kGoLine));
    await(waiting);
    turn.end = std::chrono::steady_clock::now();
    turn_done(turn);
}

} // namespace

void give_turns(const TurnSide& base, const TurnSide& next,
                const std::function<void(const Turn&)>& turn_done) {
    std::array<Waiting, 2> sides{Waiting{base, false, {}}, Waiting{next, false, {}}};
    // Nobody works before both have started up.
    await(sides[0]);
    await(sides[1]);
    for (std::size_t step = 0; sides[0].step || sides[1].step; ++step) {
        const std::size_t first = step % 2;
        for (Waiting* side : {&sides[first], &sides[1 - first]}) {
            if (side->step) {
                give_turn(*side, turn_done);
            }
        }
    }
}

} // namespace alcove
