// Seconds from a store of 365 nights x 200 series to its dashboard: at most 3.

#include "core/base/error.hpp"
#include "reports/html/dashboard_page.hpp"
#include "tests/benchmark/ratio.hpp"
#include "tests/reports/forged_store.hpp"

#include <cstdio>
#include <filesystem>

int main(int argc, char** argv) {
    using namespace alcove;
    if (argc != 2) {
        std::printf("usage: benchmark_dashboard NEW_STORE\n");
        return 2;
    }
    try {
        constexpr double kTarget_s = 3.0;
        constexpr int kSeries = 200;
        const forged::Scenario scenario{
            .nights = 365, .methods = kSeries / forged::kSeriesOfMethod, .new_driver_from = 200};
        {
            Store store(argv[1]);
            forged::Noise noise(scenario.seed);
            for (int index = 0; index < scenario.nights; ++index) {
                std::vector<NightRow> rows;
                for (NightPoint& point : forged::make_night(scenario, index, noise)) {
                    rows.push_back({std::move(point), {}});
                }
                store.append(forged::make_run(index), rows);
            }
        }
        std::vector<double> seconds;
        std::size_t bytes = 0;
        for (int i = 0; i < 5; ++i) {
            seconds.push_back(
                time_call([&] { bytes = make_dashboard_page(Store(argv[1]).read()).size(); }));
        }
        std::printf("# store %.1f MB, page %.1f MB\n",
                    1e-6 * static_cast<double>(std::filesystem::file_size(argv[1])),
                    1e-6 * static_cast<double>(bytes));
        return print_target("dashboard of 365 nights x 200 series, seconds", kTarget_s, false,
                            seconds)
                   ? 0
                   : 3;
    } catch (const Error& error) {
        std::printf("%s\n", error.what());
        return error.exit_code();
    }
}
