// Wall time of rounds over what they are for (G-buffer, passes, metrics), from the done.json of a
// finished run with cached references: at most 1.25. Metrics over time and heatmaps: less than 10 %
// of the wall time.

#include "core/base/error.hpp"
#include "reports/record/record.hpp"
#include "tests/benchmark/ratio.hpp"

#include <cstdio>

int main(int argc, char** argv) {
    using namespace alcove;
    if (argc != 2) {
        std::printf("usage: benchmark_overhead RUN\n");
        return 2;
    }
    try {
        const RunFolder run = RunFolder::open(argv[1]);
        std::vector<double> ratios;
        std::vector<double> temporal_shares;
        for (const RoundRecord& round : run.plan().rounds) {
            const RoundDone done = run.read_done(round.id).value();
            const double work = done.gbuffer_s + done.passes_s + done.metrics_s + done.temporal_s;
            std::printf(
                "# %s: wall %.2f s = G-buffer %.2f + passes %.2f + metrics %.2f + over time "
                "%.2f + reference %.2f%s + images %.2f + rest %.2f\n",
                round.id.c_str(), done.wall_s, done.gbuffer_s, done.passes_s, done.metrics_s,
                done.temporal_s, done.reference_s, done.reference_cached ? " (cached)" : "",
                done.images_s, done.wall_s - work - done.reference_s - done.images_s);
            if (!done.reference_cached) {
                std::printf("the references were not cached\n");
                return 1;
            }
            ratios.push_back(done.wall_s / work);
            temporal_shares.push_back(done.temporal_s / done.wall_s);
        }
        const bool is_lean =
            print_target("wall / (G-buffer + passes + metrics), cached", 1.25, false, ratios);
        const bool is_cheap =
            print_target("metrics over time / wall, cached", 0.10, false, temporal_shares);
        return is_lean && is_cheap ? 0 : 3;
    } catch (const Error& error) {
        std::printf("%s\n", error.what());
        return error.exit_code();
    }
}
