#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "harness/app/comparing.hpp"
#include "harness/app/progress.hpp"
#include "harness/app/turn_giver.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/environment.hpp"
#include "reports/record/csv.hpp"

#include <fstream>
#include <memory>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

struct AbFlags {
    std::string base;
    std::string next;
    std::string base_name;
    std::string next_name;
    std::string out;
    GateFlags gate;
};

fs::path find_program(const std::string& path, const char* what) {
    if (!fs::is_regular_file(path) || ::access(path.c_str(), X_OK) != 0) {
        throw InputError(what, "not a program", path,
                         "an alcove program; ./alcove ab also takes commits and source trees");
    }
    return fs::absolute(path);
}

/// Flags of `run` that make no sense for two runs side by side.
void check_run_flags(const std::vector<std::string>& flags) {
    for (const std::string& flag : flags) {
        // Pairs of repeats need as many on both sides.
        for (const std::string own :
             {"--resume", "--turns", "--clock-of", "--dry-run", "--until-width"}) {
            if (flag == own || flag.starts_with(own + "=")) {
                throw InputError("alcove ab", "cannot be passed on to run", flag);
            }
        }
    }
}

/// turns.csv and the line that shows how far both are.
class TurnLog {
  public:
    explicit TurnLog(const fs::path& out) : m_base(out / "base"), m_file(out / "turns.csv") {
        write({"side", "step", "begin_s", "end_s"});
    }
    void add(const Turn& turn) {
        const auto seconds = [&](std::chrono::steady_clock::time_point time) {
            return fmt::format("{:.4f}", std::chrono::duration<double>(time - m_begin).count());
        };
        write({turn.side, turn.step, seconds(turn.begin), seconds(turn.end)});
        ++m_turns;
        if (m_all == 0 && fs::exists(m_base / "context.json")) {
            // Of each side the clock, and of each of its rounds preparation, repeats and capture.
            const PlanRecord plan = RunFolder::open(m_base).plan();
            m_all = 2 * (1 + plan.rounds.size() * static_cast<std::size_t>(plan.repeats + 2));
        }
        if (m_all > 0) {
            m_progress.show(static_cast<double>(m_turns) / static_cast<double>(m_all),
                            turn.side + ": " + turn.step);
        }
    }

  private:
    void write(const std::vector<std::string>& fields) {
        std::string line;
        append_csv_line(line, fields);
        m_file << line << std::flush; // line by line: what was begun can be read after a failure
    }

    fs::path m_base;
    std::ofstream m_file;
    Progress m_progress;
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
    std::size_t m_turns = 0;
    std::size_t m_all = 0;
};

/// Both runs, one working at a time. A side that still runs when the other fails is ended.
void run_both(const fs::path& base_program, const fs::path& next_program, const AbFlags& flags,
              const std::vector<std::string>& run_flags, const fs::path& out) {
    const auto make_arguments = [&](const fs::path& folder) {
        std::vector<std::string> arguments{"run"};
        arguments.insert(arguments.end(), run_flags.begin(), run_flags.end());
        arguments.insert(arguments.end(), {"--turns", "--out", folder.string()});
        return arguments;
    };
    std::vector<std::string> next_arguments = make_arguments(out / "new");
    // Times of different clocks are not compared: NEW takes the one that BASE has proved.
    next_arguments.insert(next_arguments.end(), {"--clock-of", (out / "base").string()});
    TurnLog log(out);
    PipedProcess base(base_program, make_arguments(out / "base"), out / "base.log");
    PipedProcess next(next_program, next_arguments, out / "new.log");
    give_turns({"base", flags.base_name, base}, {"new", flags.next_name, next},
               [&](const Turn& turn) { log.add(turn); });
}

int run_ab(AbFlags flags, const std::vector<std::string>& run_flags) {
    ComparisonOptions options = read_gate_flags(flags.gate);
    check_run_flags(run_flags);
    const fs::path base_program = find_program(flags.base, "BASE");
    const fs::path next_program = find_program(flags.next, "NEW");
    flags.base_name = flags.base_name.empty() ? flags.base : flags.base_name;
    flags.next_name = flags.next_name.empty() ? flags.next : flags.next_name;
    const fs::path out =
        fs::absolute(flags.out.empty() ? "runs/" + make_utc_stamp() + "-ab" : flags.out);
    create_output_folder(out);
    for (const char* side : {"base", "new"}) {
        if (fs::exists(out / side)) {
            throw InputError(out.string(), "the folder already holds a comparison", side,
                             "an empty or new folder");
        }
    }
    fmt::print(stderr, "alcove: writing to {}\n", out.string());
    run_both(base_program, next_program, flags, run_flags, out);
    options.paired = true;
    options.base_name = flags.base_name;
    options.next_name = flags.next_name;
    const RunFolder base = RunFolder::open(out / "base");
    const RunFolder next = RunFolder::open(out / "new");
    return report_comparison(compare_runs(base, next, options), flags.gate, out);
}

} // namespace

Action add_ab_verb(CLI::App& app) {
    auto flags = std::make_shared<AbFlags>();
    app.add_option("base", flags->base, "an alcove program (./alcove ab: also a commit or a tree)")
        ->required();
    app.add_option("new", flags->next, "what is judged")->required();
    add_gate_flags(app, flags->gate);
    app.add_option("--base-name", flags->base_name, "what reports call BASE");
    app.add_option("--new-name", flags->next_name, "what reports call NEW");
    app.add_option("--out", flags->out, "folder of both runs; default runs/<UTC>-ab");
    app.footer("Everything else is passed on to `run` of both sides.");
    return [flags, &app] { return run_ab(*flags, app.remaining()); };
}

} // namespace alcove
