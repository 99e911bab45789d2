#pragma once
// Flags that `metric` and `score` share.

#include <chrono>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace alcove {

/// Seconds that one call of a program may take.
inline constexpr double kDefaultProgramTime = 600.0;

/// --metric, repeatable. `remark` stands behind its description.
CLI::Option* add_metric_option(CLI::App& app, std::vector<std::string>& metrics,
                               const std::string& remark);
/// --exec-timeout.
void add_program_time_option(CLI::App& app, double& seconds);
/// Throws InputError on what is not over 0 and at most a day.
[[nodiscard]] std::chrono::milliseconds read_program_time(double seconds);

} // namespace alcove
