#pragma once
// One function a verb. Each adds its subcommand; `result` receives the exit code when it runs.

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
} // namespace CLI

namespace alcove {

/// A verb adds its flags to `app` and returns what to do once they are read.
using Action = std::function<int()>;

[[nodiscard]] Action add_run_verb(CLI::App& app, const std::string& command_line);
[[nodiscard]] Action add_report_verb(CLI::App& app);
/// Takes what it does not know itself as flags of `run`.
[[nodiscard]] Action add_ab_verb(CLI::App& app);
[[nodiscard]] Action add_compare_verb(CLI::App& app);
[[nodiscard]] Action add_nightly_verb(CLI::App& app, const std::string& command_line);
[[nodiscard]] Action add_list_verb(CLI::App& app);
[[nodiscard]] Action add_metric_verb(CLI::App& app);
[[nodiscard]] Action add_score_verb(CLI::App& app);
[[nodiscard]] Action add_reference_verb(CLI::App& app);
[[nodiscard]] Action add_reproduce_verb(CLI::App& app, const std::string& command_line);
[[nodiscard]] Action add_recommend_verb(CLI::App& app);
[[nodiscard]] Action add_stability_verb(CLI::App& app, const std::string& command_line);
[[nodiscard]] Action add_tune_verb(CLI::App& app, const std::string& command_line);
[[nodiscard]] Action add_plan_verb(CLI::App& app);
[[nodiscard]] Action add_scene_verb(CLI::App& app);
[[nodiscard]] Action add_why_verb(CLI::App& app);
[[nodiscard]] Action add_cache_verb(CLI::App& app);
[[nodiscard]] Action add_doctor_verb(CLI::App& app);

} // namespace alcove
