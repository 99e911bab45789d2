#include "harness/app/metric_flags.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <cmath>

#include <CLI/CLI.hpp>

namespace alcove {

CLI::Option* add_metric_option(CLI::App& app, std::vector<std::string>& metrics,
                               const std::string& remark) {
    return app
        .add_option("--metric", metrics,
                    "NAME[@values|view|linear|codes][:key=value,...], or exec:COMMAND: a program "
                    "that gets two paths and writes one JSON object of numbers; repeatable; " +
                        remark)
        ->expected(1)
        ->take_all();
}

void add_program_time_option(CLI::App& app, double& seconds) {
    app.add_option("--exec-timeout", seconds,
                   "seconds that one call of an exec: program may take; default " +
                       format_number(kDefaultProgramTime));
}

std::chrono::milliseconds read_program_time(double seconds) {
    constexpr double kDay = 86400.0;
    if (!(seconds >= 0.001 && seconds <= kDay)) {
        throw InputError("--exec-timeout", "out of range", format_number(seconds),
                         "0.001 to 86400 seconds");
    }
    return std::chrono::milliseconds(std::lround(seconds * 1000.0));
}

} // namespace alcove
