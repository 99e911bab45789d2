#pragma once
// A timer mode counts only once it has been checked in the running context (DESIGN 3.4): on a known
// load, every pass of six sequences of draws (D) and dispatches (C) must be within 5 % of that pass
// run alone under wall clock. Not the sum: a clock that moves time between passes keeps the sum
// right. Knows no OpenGL, so that lying clocks can be tested.

#include "core/gl/timer.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace alcove::gl {

enum class LoadKind { draw, compute };

/// What is validated: a device that can run a known load alone and in sequences.
class TimerBench {
  public:
    TimerBench() = default;
    virtual ~TimerBench() = default;
    TimerBench(const TimerBench&) = delete;
    TimerBench& operator=(const TimerBench&) = delete;
    /// How much work one load of this kind is, in iterations of its inner loop.
    virtual void set_iterations(LoadKind kind, std::int64_t iterations) = 0;
    /// One load, alone, in ns of wall clock, with the device idle before and after.
    [[nodiscard]] virtual double run_alone(LoadKind kind) = 0;
    /// The loads one after the other, each timed by `mode`; ns a pass.
    [[nodiscard]] virtual std::vector<double> run_sequence(TimerMode mode,
                                                           std::span<const LoadKind> sequence) = 0;
    [[nodiscard]] virtual double get_tick_ns(TimerMode mode) = 0;
};

struct TimerTrial {
    TimerMode mode = TimerMode::time_elapsed;
    std::string sequence; ///< "D", "C", "DD", "DC", "CD", "DCD"
    int attempt = 0;      ///< from 0
    /// For each pass the median of 9 ratios: timed in the sequence / alone under wall clock, taken
    /// in alternation.
    std::vector<double> ratios;
    bool accepted = false;
};

struct TimerReport {
    std::vector<TimerTrial> trials;
    /// Accepted in all six sequences, cheapest first.
    std::vector<TimerMode> accepted;
    std::int64_t draw_iterations = 0;
    std::int64_t compute_iterations = 0;
    double draw_alone_ns = 0.0;
    double compute_alone_ns = 0.0;
    double tick_ns = 0.0; ///< of chosen()
    /// The cheapest accepted mode, else fenced wall time.
    [[nodiscard]] TimerMode chosen() const {
        return accepted.empty() ? TimerMode::fenced_wall : accepted.front();
    }
};

struct TimerValidationOptions {
    /// doctor: every mode through every sequence. Otherwise cheapest first, a mode is dropped at
    /// its first failing sequence, and the first accepted one ends the search.
    bool exhaustive = false;
    double smallest_load_ns = 20e6; ///< loads are sized at run time to at least this
    int ratios = 9;                 ///< an attempt's pass ratio is the median of as many
    int attempts = 3;
    double tolerance = 0.05;
    /// A ratio of any pass off by more than this factor is no noise: the attempts that are left are
    /// skipped.
    double hopeless_factor = 2.0;
};

/// Throws FailureError if a load cannot be sized (the device's time does not grow with the work).
[[nodiscard]] TimerReport validate_timers(TimerBench& bench,
                                          const TimerValidationOptions& options = {});

/// The modes and sequences as a table for the terminal.
[[nodiscard]] std::string format_timer_report(const TimerReport& report);

} // namespace alcove::gl
