#include "core/gl/timer_validation.hpp"

#include "core/base/error.hpp"
#include "core/base/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace alcove::gl {
namespace {

struct Sequence {
    const char* name;
    std::vector<LoadKind> loads;
};

std::vector<Sequence> make_sequences() {
    constexpr LoadKind kD = LoadKind::draw;
    constexpr LoadKind kC = LoadKind::compute;
    return {{"D", {kD}},      {"C", {kC}},      {"DD", {kD, kD}},
            {"DC", {kD, kC}}, {"CD", {kC, kD}}, {"DCD", {kD, kC, kD}}};
}

/// Doubles the work until one load alone takes long enough; median of 3, because first uses
/// compile.
std::int64_t size_load(TimerBench& bench, LoadKind kind, double smallest_ns, double& alone_ns) {
    constexpr std::int64_t kMost = std::int64_t{1} << 40;
    for (std::int64_t iterations = 16; iterations <= kMost;) {
        bench.set_iterations(kind, iterations);
        const std::vector<double> times{bench.run_alone(kind), bench.run_alone(kind),
                                        bench.run_alone(kind)};
        alone_ns = compute_median(times);
        if (alone_ns >= smallest_ns) {
            return iterations;
        }
        // Aim a fifth above, in steps of at most 8, since the first times hold fixed costs.
        const double wanted = 1.2 * smallest_ns / std::max(alone_ns, 1.0);
        iterations = static_cast<std::int64_t>(static_cast<double>(iterations) *
                                               std::clamp(wanted, 1.3, 8.0));
    }
    throw FailureError("timer validation", "the load's time does not grow with its work");
}

class Validator {
  public:
    Validator(TimerBench& bench, const TimerValidationOptions& options)
        : m_bench(bench), m_options(options) {}

    TimerReport run() {
        const auto size = [this](LoadKind kind, double& alone) {
            return size_load(m_bench, kind, m_options.smallest_load_ns, alone);
        };
        m_report.draw_iterations = size(LoadKind::draw, m_report.draw_alone_ns);
        m_report.compute_iterations = size(LoadKind::compute, m_report.compute_alone_ns);
        for (const TimerMode mode : kQueryModes) {
            if (validate_mode(mode)) {
                m_report.accepted.push_back(mode);
                if (!m_options.exhaustive) {
                    break;
                }
            }
        }
        m_report.tick_ns = m_bench.get_tick_ns(m_report.chosen());
        return std::move(m_report);
    }

  private:
    bool validate_mode(TimerMode mode) {
        bool all = true;
        for (const Sequence& sequence : make_sequences()) {
            if (!validate_sequence(mode, sequence)) {
                all = false;
                if (!m_options.exhaustive) {
                    break;
                }
            }
        }
        return all;
    }

    bool validate_sequence(TimerMode mode, const Sequence& sequence) {
        for (int attempt = 0; attempt < m_options.attempts; ++attempt) {
            TimerTrial trial = run_attempt(mode, sequence);
            trial.attempt = attempt;
            m_report.trials.push_back(trial);
            if (trial.accepted) {
                return true;
            }
            if (is_hopeless(trial)) {
                return false;
            }
        }
        return false;
    }

    [[nodiscard]] bool is_hopeless(const TimerTrial& trial) const {
        return std::any_of(trial.ratios.begin(), trial.ratios.end(), [this](double ratio) {
            return !(ratio < m_options.hopeless_factor && ratio > 1.0 / m_options.hopeless_factor);
        });
    }

    TimerTrial run_attempt(TimerMode mode, const Sequence& sequence) {
        const std::size_t passes = sequence.loads.size();
        std::vector<std::vector<double>> ratios(passes);
        TimerTrial trial;
        trial.mode = mode;
        trial.sequence = sequence.name;
        const auto time_alone = [&](std::array<double, 2>& alone) {
            for (const LoadKind kind : {LoadKind::draw, LoadKind::compute}) {
                if (std::find(sequence.loads.begin(), sequence.loads.end(), kind) !=
                    sequence.loads.end()) {
                    alone.at(static_cast<std::size_t>(kind)) = m_bench.run_alone(kind);
                }
            }
        };
        for (int i = 0; i < m_options.ratios; ++i) {
            // Lone runs come before and after the sequence in turn, so that a drift of the machine
            // cancels.
            std::array<double, 2> alone{};
            if (i % 2 == 0) {
                time_alone(alone);
            }
            const std::vector<double> timed = m_bench.run_sequence(mode, sequence.loads);
            ALCOVE_ASSERT(timed.size() == passes, "one time a pass");
            if (i % 2 == 1) {
                time_alone(alone);
            }
            for (std::size_t pass = 0; pass < passes; ++pass) {
                const auto kind = static_cast<std::size_t>(sequence.loads[pass]);
                ratios[pass].push_back(timed[pass] / alone.at(kind));
            }
        }
        trial.accepted = true;
        for (const std::vector<double>& pass : ratios) {
            trial.ratios.push_back(compute_median(pass));
            const bool close = std::abs(trial.ratios.back() - 1.0) <= m_options.tolerance;
            trial.accepted = trial.accepted && close;
        }
        return trial;
    }

    TimerBench& m_bench;
    TimerValidationOptions m_options;
    TimerReport m_report;
};

} // namespace

TimerReport validate_timers(TimerBench& bench, const TimerValidationOptions& options) {
    return Validator{bench, options}.run();
}

std::string format_timer_report(const TimerReport& report) {
    std::string text;
    std::vector<char> line(256);
    const auto add = [&text, &line](int written) {
        text.append(line.data(), static_cast<std::size_t>(written));
    };
    add(std::snprintf(line.data(), line.size(),
                      "known loads: draw %.1f ms (%lld iterations), compute %.1f ms (%lld)\n",
                      report.draw_alone_ns * 1e-6, static_cast<long long>(report.draw_iterations),
                      report.compute_alone_ns * 1e-6,
                      static_cast<long long>(report.compute_iterations)));
    add(std::snprintf(line.data(), line.size(), "%-22s %-9s %-8s %-9s %s\n", "mode", "sequence",
                      "attempt", "verdict", "each pass / the same pass alone (median)"));
    for (const TimerTrial& trial : report.trials) {
        add(std::snprintf(line.data(), line.size(), "%-22s %-9s %-8d %-9s",
                          std::string(to_text(trial.mode)).c_str(), trial.sequence.c_str(),
                          trial.attempt + 1, trial.accepted ? "ok" : "rejected"));
        for (const double ratio : trial.ratios) {
            add(std::snprintf(line.data(), line.size(), " %.4g", ratio));
        }
        text += '\n';
    }
    add(std::snprintf(line.data(), line.size(), "used: %s%s, tick %.0f ns\n",
                      std::string(to_text(report.chosen())).c_str(),
                      report.accepted.empty() ? " (no query mode was accepted)" : "",
                      report.tick_ns));
    return text;
}

} // namespace alcove::gl
