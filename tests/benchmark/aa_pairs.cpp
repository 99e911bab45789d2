// How often `compare` calls two groups of six repeats of one and the same run different: pairs of
// consecutive, disjoint groups of one long run, each judged by the function that judges runs.

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "reports/analysis/comparison_time.hpp"
#include "reports/analysis/fitness.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

namespace {

using namespace alcove;

constexpr int kRepeats = 6; // DESIGN 3.6
constexpr int kPairs = 200;
/// P(more than 18 of 200) is 0.6 % where each is wrong in 5 %.
constexpr std::size_t kMostDifferent = 18;

/// The only method with passes of the only round.
const CellRecord& find_method(const RunFolder& run, const RoundRecord& round) {
    const CellRecord* found = nullptr;
    for (const CellRecord& cell : round.cells) {
        if (cell.role == CellRole::method && cell.has_passes) {
            if (found != nullptr) {
                throw InputError(run.path().string(), "more than one method", cell.label,
                                 found->label + " alone");
            }
            found = &cell;
        }
    }
    if (found == nullptr) {
        throw InputError(run.path().string(), "nothing to compare", "no method with passes");
    }
    return *found;
}

/// Groups of consecutive repeats, each numbered from 0, as if each were a run.
std::vector<RoundSeries> split_repeats(const RunFolder& run, int groups) {
    std::vector<std::vector<SampleRow>> rows(static_cast<std::size_t>(groups));
    int repeats = 0;
    for (SampleRow& row : run.read_samples()) {
        repeats = std::max(repeats, row.repeat + 1);
        const int group = row.repeat / kRepeats;
        if (group < groups) {
            row.repeat %= kRepeats;
            rows[static_cast<std::size_t>(group)].push_back(std::move(row));
        }
    }
    if (repeats < groups * kRepeats) {
        throw InputError(run.path().string(), "too few repeats", std::to_string(repeats),
                         std::to_string(groups * kRepeats));
    }
    std::vector<RoundSeries> series;
    for (const std::vector<SampleRow>& group : rows) {
        series.push_back(sort_samples(group));
    }
    return series;
}

struct Tally {
    std::map<Verdict, std::size_t> verdicts;
    std::size_t apart = 0;      ///< intervals that leave "nothing changed" out
    std::size_t taken_back = 0; ///< by the tests by ranks
    std::size_t ranks = 0;      ///< p at most 0.05 in a test by ranks, after Holm
};

Tally judge_pairs(std::vector<RoundSeries>& groups, const RoundRecord& round,
                  const CellRecord& method, const ComparisonOptions& options) {
    Tally tally;
    for (std::size_t i = 0; i + 1 < groups.size(); i += 2) {
        std::optional<TimeComparison> time =
            compare_times(find_anchored_cell(groups[i], round, method),
                          find_anchored_cell(groups[i + 1], round, method), options);
        if (!time || !time->change.interval) {
            throw InputError("samples.csv", "a group without an interval", std::to_string(i));
        }
        judge_times({&*time});
        ++tally.verdicts[time->verdict];
        const Interval change = *time->change.interval;
        tally.apart += change.lower > 1.0 || change.upper < 1.0 ? 1 : 0;
        tally.taken_back += time->is_taken_back ? 1 : 0;
        tally.ranks += time->ranks && !time->ranks->is_silent() ? 1 : 0;
    }
    return tally;
}

int report(const RunFolder& run) {
    if (run.plan().rounds.size() != 1) {
        throw InputError(run.path().string(), "not one round",
                         std::to_string(run.plan().rounds.size()), "1");
    }
    const RoundRecord& round = run.plan().rounds.front();
    const CellRecord& method = find_method(run, round);
    std::vector<RoundSeries> groups = split_repeats(run, 2 * kPairs);
    const Fitness fitness =
        judge_machine(round, sort_samples(run.read_samples()),
                      run.read_done(round.id).value_or(RoundDone{}), run.context());
    std::printf("# %s in %s, %d pairs of R = %d against %d\n", method.label.c_str(),
                round.scene.c_str(), kPairs, kRepeats, kRepeats);
    std::printf("# %s\n", describe_fitness(fitness).c_str());
    std::size_t most = 0;
    for (const double margin : {kDefaultMargin, 0.0}) {
        ComparisonOptions options;
        options.margin = margin;
        Tally tally = judge_pairs(groups, round, method, options);
        const std::size_t different =
            tally.verdicts[Verdict::better] + tally.verdicts[Verdict::worse];
        std::printf(
            "# margin %s %% or the A/A noise: better %zu, worse %zu, same %zu, unknown %zu; "
            "intervals without 1: %zu; taken back: %zu; ranks reject: %zu\n",
            format_rounded(100.0 * margin).c_str(), tally.verdicts[Verdict::better],
            tally.verdicts[Verdict::worse], tally.verdicts[Verdict::same],
            tally.verdicts[Verdict::unknown], tally.apart, tally.taken_back, tally.ranks);
        // The interval alone is what the margin could hide: it is held to the same number.
        most = std::max({most, different, tally.apart});
    }
    const bool is_met = most <= kMostDifferent;
    std::printf("%-52s | <= %-6zu | %10zu | n=%d | %s\n",
                "A/A pairs that differ (most of verdict and interval)", kMostDifferent, most,
                kPairs, is_met ? "met" : "NOT MET");
    return is_met ? 0 : 3;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::printf("usage: benchmark_aa_pairs RUN\n");
        return 2;
    }
    try {
        return report(RunFolder::open(argv[1]));
    } catch (const Error& error) {
        std::printf("%s\n", error.what());
        return error.exit_code();
    }
}
