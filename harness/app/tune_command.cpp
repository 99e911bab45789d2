#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "harness/app/context_flags.hpp"
#include "harness/app/progress.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/calibration.hpp"
#include "harness/run/environment.hpp"
#include "harness/run/grid.hpp"
#include "harness/tune/tune_method.hpp"
#include "reports/csv/tune_csv.hpp"
#include "reports/html/tune_page.hpp"
#include "reports/terminal/tune_table.hpp"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

struct TuneFlags {
    std::vector<std::string> methods;
    std::vector<std::string> scenes;
    std::vector<std::string> held_out_scenes;
    std::string target;
    std::string size = "384x288";
    std::string objective = "rmse";
    std::string judge = "ssim";
    std::string free;
    int evaluations = 24;
    std::int64_t seed = 1;
    std::string reference;
    std::string out;
    ContextFlags context;
};

TunePlan make_plan(const TuneFlags& flags, const std::string& command_line, const Units& units) {
    TunePlan plan;
    for (const std::string& text : flags.methods) {
        MethodSpec spec = parse_method_spec(text, "METHOD");
        check_method_spec(units.methods, spec);
        plan.methods.push_back(std::move(spec));
    }
    plan.scenes = flags.scenes;
    plan.held_out_scenes = flags.held_out_scenes;
    plan.target = flags.target;
    plan.size = parse_size(flags.size);
    plan.objective = flags.objective;
    plan.judge = flags.judge;
    plan.free = flags.free.empty() ? std::vector<std::string>{} : split(flags.free, ',');
    plan.evaluations_per_parameter = flags.evaluations;
    plan.seed = static_cast<std::uint64_t>(flags.seed);
    if (!flags.reference.empty()) {
        plan.reference = parse_method_spec(flags.reference, "--reference");
        check_method_spec(units.methods, *plan.reference);
    }
    plan.command_line = command_line;
    return plan;
}

/// For people: how the values came about.
std::string describe_origin(const TuneRecord& record, const TunedMethodRecord& method) {
    const auto quote = [](const std::string& text) {
        std::string quoted = "'";
        for (const char c : text) {
            // A literal string of TOML holds neither quotes nor control characters.
            quoted += c == '\'' || static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
        return quoted + "'";
    };
    std::string text = "\n[origin]\ncommand = " + quote(record.command_line) +
                       "\nobjective = " + quote(record.objective) +
                       "\nbuild = " + quote(record.context.build_id) +
                       "\nconverged = " + (method.is_converged ? "true" : "false") + "\n";
    for (const TuneJudgementRecord& judgement : method.judgements) {
        text += quote(judgement.set + ", " + judgement.metric) + " = [" +
                format_number(judgement.before) + ", " + format_number(judgement.after) + "]\n";
    }
    return text;
}

void write_files(const fs::path& out, const TuneRecord& record) {
    write_tune(out, record);
    write_file_atomically(out / "tune.csv", make_tune_csv(record));
    write_file_atomically(out / "judgements.csv", make_judgements_csv(record));
    write_file_atomically(out / "tune.html", make_tune_page(record));
}

int run(const TuneFlags& flags, const std::string& command_line) {
    const Units units = get_units();
    const TunePlan plan = make_plan(flags, command_line, units);
    const std::unique_ptr<gl::Context> context = open_chosen_context(flags.context.parse());
    const fs::path out =
        flags.out.empty() ? fs::path("runs") / (make_utc_stamp() + "-tune") : fs::path(flags.out);
    create_output_folder(out);
    if (fs::exists(out / "tune.json")) {
        throw InputError(out.string(), "the folder already holds a calibration", "tune.json",
                         "an empty or new folder");
    }
    TuneRecord record;
    {
        Progress progress;
        TuneEvents events;
        events.progress = [&](double share, const std::string& what) {
            progress.show(share, what);
        };
        events.method_done = [&](const TuneRecord& so_far, const TunedMethodRecord& method,
                                 const std::string& calibration) {
            write_file_atomically(out / method.calibration,
                                  calibration + describe_origin(so_far, method));
            write_files(out, so_far);
        };
        record = run_tune(plan, *context, describe_environment(*context, {}), units, events);
    }
    fmt::print("{}{}\n", make_tune_table(record), (out / "tune.html").string());
    return 0;
}

} // namespace

Action add_tune_verb(CLI::App& app, const std::string& command_line) {
    auto flags = std::make_shared<TuneFlags>();
    app.add_option("method", flags->methods,
                   "METHOD[@PRESET][:key=value,...][#label] (several: equal effort for each)")
        ->required();
    app.add_option("--scene", flags->scenes,
                   "training scene (repeatable); every second of its single frames judges")
        ->expected(1)
        ->take_all()
        ->required();
    app.add_option("--held-out-scene", flags->held_out_scenes, "scene that judges (repeatable)")
        ->expected(1)
        ->take_all();
    app.add_option("--target", flags->target,
                   "radius=R,falloff=none|linear|quadratic,weighting=cosine|uniform");
    app.add_option("--size", flags->size, "WxH in pixels")->capture_default_str();
    app.add_option("--objective", flags->objective, "metric that is tuned on")
        ->capture_default_str();
    app.add_option("--judge", flags->judge, "metric that is not tuned on")->capture_default_str();
    app.add_option("--free", flags->free,
                   "parameters to fit, NAME,NAME,...; default radius and strength");
    app.add_option("--evaluations", flags->evaluations, "for each free parameter and attempt")
        ->capture_default_str();
    app.add_option("--seed", flags->seed, "of the first attempt")->capture_default_str();
    app.add_option("--reference", flags->reference,
                   "what is fitted to: M[@PRESET][:key=value,...]; default ray-traced truth");
    app.add_option("--out", flags->out, "folder; default runs/<UTC>-tune");
    flags->context.add_to(app);
    return [flags, command_line] { return run(*flags, command_line); };
}

} // namespace alcove
