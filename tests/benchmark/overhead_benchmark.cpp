// Wall time of rounds over what they are for (G-buffer, passes, metrics), from the done.json of a
// finished run with cached references: at most 1.25.

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
        for (const RoundRecord& round : run.plan().rounds) {
            const RoundDone done = run.read_done(round.id).value();
            const double work = done.gbuffer_s + done.passes_s + done.metrics_s;
            std::printf(
                "# %s: wall %.2f s = G-buffer %.2f + passes %.2f + metrics %.2f + reference "
                "%.2f%s + images %.2f + rest %.2f\n",
                round.id.c_str(), done.wall_s, done.gbuffer_s, done.passes_s, done.metrics_s,
                done.reference_s, done.reference_cached ? " (cached)" : "", done.images_s,
                done.wall_s - work - done.reference_s - done.images_s);
            if (!done.reference_cached) {
                std::printf("the references were not cached\n");
                return 1;
            }
            ratios.push_back(done.wall_s / work);
        }
        return print_target("wall / (G-buffer + passes + metrics), cached", 1.25, false, ratios)
                   ? 0
                   : 3;
    } catch (const Error& error) {
        std::printf("%s\n", error.what());
        return error.exit_code();
    }
}
