#include "core/base/domain.hpp"
#include "core/base/file.hpp"
#include "core/base/image_file.hpp"
#include "harness/app/context_flags.hpp"
#include "harness/app/progress.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/environment.hpp"
#include "harness/stability/run_stability.hpp"
#include "reports/csv/stability_csv.hpp"
#include "reports/html/stability_page.hpp"
#include "reports/terminal/stability_table.hpp"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

struct StabilityFlags {
    std::vector<std::string> methods;
    std::vector<std::string> cases;
    std::string size = "96x72";
    std::string out;
    bool gate = false;
    ContextFlags context;
};

StabilityPlan make_plan(const StabilityFlags& flags, const std::string& command_line,
                        const Registry<MethodUnit>& methods) {
    StabilityPlan plan;
    plan.command_line = command_line;
    plan.size = parse_size(flags.size);
    if (plan.size.width < kSmallestStabilitySize || plan.size.height < kSmallestStabilitySize) {
        throw InputError("--size", "too small for the cases", flags.size,
                         fmt::format("{0}x{0} or more", kSmallestStabilitySize));
    }
    plan.cases = choose_cases(flags.cases);
    for (const std::string& text : flags.methods) {
        plan.methods.push_back(parse_method_spec(text));
    }
    if (plan.methods.empty()) {
        plan.methods = list_default_stability_methods(methods);
    }
    return plan;
}

void write_files(const fs::path& out, const StabilityRecord& record) {
    write_stability(out, record);
    write_file_atomically(out / "stability.csv", make_stability_csv(record));
    write_file_atomically(out / "stability.html", make_stability_page(record));
}

int run(const StabilityFlags& flags, const std::string& command_line) {
    const Units units = get_units();
    const StabilityPlan plan = make_plan(flags, command_line, units.methods);
    const std::unique_ptr<gl::Context> context = open_chosen_context(flags.context.parse());
    const fs::path out = flags.out.empty() ? fs::path("runs") / (make_utc_stamp() + "-stability")
                                           : fs::path(flags.out);
    create_output_folder(out);
    StabilityRecord record;
    {
        Progress progress;
        StabilityEvents events;
        events.progress = [&](double share, const std::string& what) {
            progress.show(share, what);
        };
        events.picture = [&](const StabilityPicture& picture) {
            write_png(out / picture.path, encode_view(picture.visibility), Domain::view);
        };
        record = run_stability(plan, *context, units.methods, events);
    }
    write_files(out, record);
    fmt::print("{}{}\n", make_stability_table(record), (out / "stability.html").string());
    const std::size_t failures = count_failures(record);
    if (flags.gate && failures > 0) {
        fmt::print(stderr, "alcove: the gate is not met: {} failures\n", failures);
        return 3;
    }
    return 0;
}

} // namespace

Action add_stability_verb(CLI::App& app, const std::string& command_line) {
    auto flags = std::make_shared<StabilityFlags>();
    app.add_option("--method", flags->methods,
                   "METHOD[@PRESET][:key=value,...][#label]; default: all that are reported, and "
                   "the presets that behave otherwise");
    app.add_option("--case", flags->cases, "a case's name; default: all");
    app.add_option("--size", flags->size, "WxH of the images")->capture_default_str();
    app.add_option("--out", flags->out, "folder; default runs/<UTC>-stability");
    app.add_flag("--gate", flags->gate, "exit 3 if a method fails a case that applies to it");
    flags->context.add_to(app);
    return [flags, command_line] { return run(*flags, command_line); };
}

} // namespace alcove
