#include "reports/analysis/fitness.hpp"

#include "core/base/spread.hpp"
#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace alcove {
namespace {

using Member = std::optional<double> MachineRecord::*;

/// Mean over the replays that have it, weighted by their length.
std::optional<double> average(const std::vector<MachineRecord>& machine, Member member) {
    double sum = 0.0;
    double weight = 0.0;
    for (const MachineRecord& record : machine) {
        if (record.*member) {
            sum += record.wall_s * *(record.*member);
            weight += record.wall_s;
        }
    }
    return weight > 0.0 ? std::optional(sum / weight) : std::nullopt;
}

std::vector<double> collect(const std::vector<MachineRecord>& machine, Member member) {
    std::vector<double> values;
    for (const MachineRecord& record : machine) {
        if (record.*member) {
            values.push_back(*(record.*member));
        }
    }
    return values;
}

class Judge {
  public:
    explicit Judge(Fitness& fitness) : m_fitness(fitness) {}

    void doubt(std::string reason) { raise(MachineVerdict::doubtful, std::move(reason)); }

    /// `format` writes a value and its limit for people.
    template <class Format>
    void hold(const std::optional<double>& value, FitnessLimit limit, std::string_view what,
              const Format& format) {
        if (!value || *value <= limit.doubtful) {
            return;
        }
        const bool is_unfit = *value > limit.unfit;
        raise(is_unfit ? MachineVerdict::unfit : MachineVerdict::doubtful,
              fmt::format("{} {} (limit {})", what, format(*value),
                          format(is_unfit ? limit.unfit : limit.doubtful)));
    }

    void require(bool is_known, const char* what) {
        if (!is_known) {
            m_fitness.unknown.emplace_back(what);
        }
    }

  private:
    void raise(MachineVerdict verdict, std::string reason) {
        m_fitness.verdict = std::max(m_fitness.verdict, verdict);
        m_fitness.reasons.push_back(std::move(reason));
    }

    Fitness& m_fitness;
};

void read_clock(Fitness& fitness, const std::vector<MachineRecord>& machine) {
    const std::vector<double> clocks = collect(machine, &MachineRecord::clock_mhz);
    if (clocks.empty()) {
        fitness.unknown.emplace_back("processor clock");
        return;
    }
    fitness.clock_mhz = compute_mean(clocks);
    const auto [lowest, highest] = std::minmax_element(clocks.begin(), clocks.end());
    if (clocks.size() > 1 && *lowest == *highest) {
        fitness.unknown.push_back(fmt::format("whether the processor clock moved ({} MHz in every "
                                              "repeat: locked, or a nominal value)",
                                              format_rounded(*highest, 4)));
    } else if (*highest > 0.0) {
        fitness.clock_spread = (*highest - *lowest) / *highest;
    }
}

std::string join(const std::vector<std::string>& parts, const char* separator) {
    std::string text;
    for (const std::string& part : parts) {
        text += (text.empty() ? "" : separator) + part;
    }
    return text;
}

} // namespace

std::string_view to_text(MachineVerdict verdict) {
    switch (verdict) {
    case MachineVerdict::unfit:
        return "unfit";
    case MachineVerdict::doubtful:
        return "doubtful";
    case MachineVerdict::fit:
        break;
    }
    return "fit";
}

Fitness judge_fitness(const RoundDone& done, const ContextRecord& context,
                      const std::optional<Estimate>& aa_ratio, std::span<const double> memories,
                      std::size_t repeats) {
    Fitness fitness;
    Judge judge(fitness);
    if (done.machine.empty()) {
        judge.doubt("nobody watched what else the machine did");
    } else {
        const double threads = std::max(1, context.cpu_threads);
        fitness.others_share = average(done.machine, &MachineRecord::others_share);
        fitness.steal_share = average(done.machine, &MachineRecord::steal_share);
        fitness.switches_per_s = average(done.machine, &MachineRecord::switches_per_s);
        const std::vector<double> loads = collect(done.machine, &MachineRecord::load);
        if (!loads.empty()) {
            fitness.load = *std::max_element(loads.begin(), loads.end());
        }
        judge.require(fitness.others_share.has_value(), "other processes (no /proc/stat)");
        judge.require(fitness.steal_share.has_value(), "steal time (no such column)");
        judge.require(fitness.load.has_value(), "load (no /proc/loadavg)");
        judge.require(fitness.switches_per_s.has_value(), "context switches");
        read_clock(fitness, done.machine);
        const auto by_thread = [&](const std::optional<double>& value) {
            return value ? std::optional(*value / threads) : std::nullopt;
        };
        const auto plain = [](double value) { return format_rounded(value); };
        judge.hold(fitness.others_share, kOthersLimit, "other processes took", format_percent);
        judge.hold(fitness.steal_share, kStealLimit, "other guests took", format_percent);
        judge.hold(by_thread(fitness.load), kLoadLimit, "load a hardware thread", plain);
        judge.hold(by_thread(fitness.switches_per_s), kSwitchLimit,
                   "involuntary switches a second and hardware thread", plain);
        judge.hold(fitness.clock_spread, kClockLimit, "the clock moved by", format_percent);
    }
    judge.require(aa_ratio.has_value(), "noise (the anchor was not timed twice)");
    if (aa_ratio) {
        judge.hold(compute_minimum_detectable_effect(*aa_ratio), kNoiseLimit,
                   "differences are not told from A/A noise under", format_percent);
    }
    if (!memories.empty()) {
        fitness.memory = compute_median(memories);
        const double limit = std::max(kMemoryFloor, compute_lag1_bound(repeats));
        if (*fitness.memory > limit) {
            judge.doubt(fmt::format(
                "repeats resemble the ones before (lag-1 autocorrelation {}, limit {}): intervals "
                "hold the truth less often than they say",
                format_rounded(*fitness.memory), format_rounded(limit)));
        }
    }
    return fitness;
}

Fitness judge_machine(const RoundRecord& round, const RoundSeries& series, const RoundDone& done,
                      const ContextRecord& context) {
    const auto find_role = [&](CellRole role) {
        const auto cell = std::find_if(round.cells.begin(), round.cells.end(),
                                       [&](const CellRecord& c) { return c.role == role; });
        const auto found =
            cell == round.cells.end() ? series.cells.end() : series.cells.find(cell->id);
        return found == series.cells.end() ? Series() : found->second.envelope;
    };
    const Series anchor = find_role(CellRole::anchor);
    std::vector<double> memories;
    std::size_t repeats = 0;
    for (const CellRecord& cell : round.cells) {
        const auto found = series.cells.find(cell.id);
        if (cell.role == CellRole::anchor || found == series.cells.end()) {
            continue;
        }
        const std::vector<double> logs =
            get_values(compute_log_ratios(found->second.envelope, anchor));
        if (const std::optional<double> memory = compute_lag1_autocorrelation(logs)) {
            memories.push_back(*memory);
            repeats = std::max(repeats, logs.size());
        }
    }
    return judge_fitness(done, context, estimate_ratio(find_role(CellRole::anchor_repeat), anchor),
                         memories, repeats);
}

std::string describe_fitness(const Fitness& fitness) {
    std::string text = fmt::format("machine {}", to_text(fitness.verdict));
    std::vector<std::string> facts = fitness.reasons;
    if (facts.empty()) {
        const auto add = [&](const std::optional<double>& share, const char* who) {
            if (share) {
                facts.push_back(fmt::format("{} took {}", who, format_percent(*share)));
            }
        };
        add(fitness.others_share, "other processes");
        add(fitness.steal_share, "other guests");
        if (fitness.load) {
            facts.push_back("load " + format_rounded(*fitness.load));
        }
        if (fitness.switches_per_s) {
            facts.push_back(format_rounded(*fitness.switches_per_s) + " involuntary switches/s");
        }
    }
    if (!facts.empty()) {
        text += ": " + join(facts, "; ");
    }
    if (!fitness.unknown.empty()) {
        text += "; not known: " + join(fitness.unknown, ", ");
    }
    return text;
}

} // namespace alcove
