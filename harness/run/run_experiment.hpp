#pragma once
// Executes the rounds of a run folder that are not finished yet.

#include "core/gl/context.hpp"
#include "core/gl/timer.hpp"
#include "harness/run/plan.hpp"

#include <functional>
#include <string>
#include <vector>

namespace alcove {

/// A cell's median envelope after the first repeat of a round: time only, n = 1.
struct FirstTime {
    std::string round;
    std::string cell;
    std::string label;
    double time_ms = 0.0;
};

struct RunEvents {
    /// Share of the whole run that is done, in [0,1], and what is being done.
    std::function<void(double, const std::string&)> progress = [](double, const std::string&) {};
    /// Before each piece of work: preparing a round, a timing repeat, the capture. Work waits until
    /// it returns.
    std::function<void(const std::string&)> before_step = [](const std::string&) {};
    /// The page can be rewritten: a round is finished (no first times), or has its first repeat.
    std::function<void(const std::vector<FirstTime>&)> update = [](const std::vector<FirstTime>&) {
    };
};

/// Runs what is left of the run's plan. Throws what scenes, devices and disks throw; rounds already
/// finished stay.
void run_experiment(RunFolder& run, gl::Context& context, gl::TimerMode timer_mode,
                    const Units& units, const RunEvents& events);

} // namespace alcove
