#pragma once
// Was the machine fit to measure on? Stands beside a round's numbers; changes none of them.

#include "core/base/statistics.hpp"
#include "reports/analysis/cell_series.hpp"
#include "reports/record/record.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace alcove {

enum class MachineVerdict { fit, doubtful, unfit };
[[nodiscard]] std::string_view to_text(MachineVerdict verdict);

struct Fitness {
    MachineVerdict verdict = MachineVerdict::fit;
    std::vector<std::string> reasons; ///< for people; empty if fit
    std::vector<std::string> unknown; ///< sources that this system does not have, for people
    // Over the timing replays; shares and rates are weighted by their length.
    std::optional<double> others_share;
    std::optional<double> steal_share;
    std::optional<double> load; ///< the largest
    std::optional<double> switches_per_s;
    std::optional<double> clock_mhz;
    std::optional<double>
        clock_spread;             ///< (largest - smallest) / largest; none where it stands still
    std::optional<double> memory; ///< median over cells of the ratios' lag-1 autocorrelation
};

/// What speaks for doubt and for unfitness: above it.
struct FitnessLimit {
    double doubtful;
    double unfit;
};
/// Other processes take a share of the cores: with 2 of them, 10 % is a fifth of one.
inline constexpr FitnessLimit kOthersLimit{0.10, 0.30};
inline constexpr FitnessLimit kStealLimit{0.01, 0.05};
/// Runnable threads a hardware thread, our own included: 1 is our own work.
inline constexpr FitnessLimit kLoadLimit{1.5, 3.0};
/// Involuntary context switches a second and hardware thread.
inline constexpr FitnessLimit kSwitchLimit{100.0, 1000.0};
inline constexpr FitnessLimit kClockLimit{0.05, 0.15};
/// The minimum detectable effect: above the smallest change that anybody would act on (`compare`'s
/// margin), and above what even a rough decision asks for.
inline constexpr FitnessLimit kNoiseLimit{0.02, 0.10};
/// Less memory than this does not matter, however surely it is there: 0.1 takes 2 to 3 % off the
/// coverage of an interval.
inline constexpr double kMemoryFloor = 0.1;

/// `memories` are the cells' lag-1 autocorrelations over `repeats` repeats.
[[nodiscard]] Fitness judge_fitness(const RoundDone& done, const ContextRecord& context,
                                    const std::optional<Estimate>& aa_ratio,
                                    std::span<const double> memories, std::size_t repeats);

/// The same from a round's rows.
[[nodiscard]] Fitness judge_machine(const RoundRecord& round, const RoundSeries& series,
                                    const RoundDone& done, const ContextRecord& context);

/// "machine doubtful: other processes took 14 % of the cores (limit 10 %); not known: ..."
[[nodiscard]] std::string describe_fitness(const Fitness& fitness);

} // namespace alcove
