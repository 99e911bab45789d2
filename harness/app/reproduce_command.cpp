#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/nearest_name.hpp"
#include "harness/app/context_flags.hpp"
#include "harness/app/progress.hpp"
#include "harness/app/reports.hpp"
#include "harness/app/running.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/environment.hpp"
#include "harness/run/experiment_file.hpp"
#include "harness/run/plan.hpp"
#include "harness/run/run_experiment.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/csv/reproduction_csv.hpp"
#include "reports/html/reproduction_index.hpp"
#include "reports/html/reproduction_page.hpp"
#include "reports/latex/latex_table.hpp"
#include "reports/papers/paper_files.hpp"
#include "reports/papers/papers.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// What a paper's images are larger by than those of `--scale small`.
constexpr int kFullScale = 4;

/// In place of a paper's name: every one after another.
constexpr const char* kAll = "all";

struct ReproduceFlags {
    std::string paper;
    std::string scale = "small";
    std::string out;
    ContextFlags context;
};

/// The experiments of a paper, by the order of their names.
std::vector<Experiment> list_parts(const std::string& paper, const std::string& scale,
                                   const std::string& command_line, const Units& units) {
    std::vector<Experiment> parts;
    for (const EmbeddedFile& file : embedded_papers()) {
        const fs::path path(file.name);
        if (path.extension() != ".toml" || path.parent_path().filename() != paper) {
            continue;
        }
        Experiment part =
            parse_experiment(file.text, std::string(file.name), fs::current_path(), units);
        if (scale == "full") {
            for (ImageSize& size : part.sizes) {
                size = {size.width * kFullScale, size.height * kFullScale};
            }
        }
        part.command_line = command_line;
        parts.push_back(std::move(part));
    }
    return parts;
}

void check_choice(const std::string& option, const std::string& value,
                  const std::vector<std::string>& choices) {
    if (std::find(choices.begin(), choices.end(), value) == choices.end()) {
        throw InputError(option, "unknown choice", value, describe_choices(value, choices));
    }
}

/// Runs what is left of a part, in its own folder; a reproduction that was cut short goes on.
RunFolder run_part(const fs::path& folder, const Experiment& part, gl::Context& context,
                   const gl::TimerReport& timers, const Units& units,
                   const std::function<void(double)>& progress) {
    const ContextRecord here = describe_environment(context, timers);
    const bool exists = fs::exists(folder / "plan.json");
    if (!exists) {
        create_output_folder(folder);
    }
    RunFolder run = exists ? RunFolder::open(folder)
                           : RunFolder::create(folder, here, make_plan(part, units).record);
    if (exists && !run.is_complete()) {
        check_same_environment(run.context(), here);
    }
    RunEvents events;
    events.progress = [&](double share, const std::string&) { progress(share); };
    run_experiment(run, context, timers.chosen(), units, events);
    write_reports(run, false, {});
    return run;
}

void write_reproduction(const fs::path& out, const Reproduction& reproduction) {
    write_file_atomically(out / "index.html", make_reproduction_page(reproduction));
    write_file_atomically(out / "verdicts.csv", make_verdicts_csv(reproduction));
    std::string all;
    for (const PaperTable& table : reproduction.tables) {
        const std::string latex = make_latex_table(table);
        write_file_atomically(out / "tables" / (table.id + ".csv"), make_table_csv(table));
        write_file_atomically(out / "tables" / (table.id + ".tex"), latex);
        all += latex + "\n";
    }
    write_file_atomically(out / "tables.tex", all);
}

void print_reproduction(const fs::path& out, const Reproduction& reproduction) {
    for (const Outcome outcome : {Outcome::fails, Outcome::inconclusive}) {
        for (const ClaimVerdict& verdict : reproduction.verdicts) {
            if (verdict.outcome == outcome) {
                fmt::print("{:<13}{} ({}): {}{} ({})\n", to_text(outcome), verdict.claim.id,
                           verdict.claim.location, verdict.tested,
                           verdict.measured ? ": " + describe_estimate(*verdict.measured) : "",
                           verdict.why);
            }
        }
    }
    fmt::print("{}\nreport: {}\n", describe_counts(reproduction), (out / "index.html").string());
}

/// The paper of this name, or all; throws InputError for what is unknown.
std::vector<Paper> find_papers(const std::string& name) {
    std::vector<Paper> papers;
    std::vector<std::string> names{kAll};
    for (const Paper& paper : list_papers()) {
        if (name == paper.name || name == kAll) {
            papers.push_back(paper);
        }
        names.emplace_back(paper.name);
    }
    check_choice("reproduce", name, names);
    return papers;
}

/// Runs what is left of a paper's parts in `out` and writes what they say.
Reproduction reproduce_paper(const Paper& paper, const ReproduceFlags& flags, const fs::path& out,
                             const std::string& command_line, gl::Context& context,
                             const Units& units) {
    const std::vector<Experiment> parts = list_parts(paper.name, flags.scale, command_line, units);
    create_output_folder(out);
    const gl::TimerReport timers = validate_clock(context);
    Evidence evidence;
    {
        Progress progress;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto show = [&](double share) {
                progress.show((static_cast<double>(i) + share) / static_cast<double>(parts.size()),
                              parts[i].title);
            };
            evidence.add(parts[i].name, run_part(out / "parts" / parts[i].name, parts[i], context,
                                                 timers, units, show));
        }
    }
    Reproduction reproduction = paper.reproduce(evidence, flags.scale);
    write_reproduction(out, reproduction);
    print_reproduction(out, reproduction);
    return reproduction;
}

int reproduce(const ReproduceFlags& flags, const std::string& command_line) {
    const std::vector<Paper> papers = find_papers(flags.paper);
    check_choice("--scale", flags.scale, {"small", "full"});
    const Units units = get_units();
    const fs::path out = flags.out.empty()
                             ? fs::path("runs") / (make_utc_stamp() + "-reproduce-" + flags.paper)
                             : fs::path(flags.out);
    const std::unique_ptr<gl::Context> context = open_chosen_context(flags.context.parse());
    create_output_folder(out);
    fmt::print(stderr, "alcove: writing to {} (continue with --out {})\n", out.string(),
               out.string());
    if (flags.paper != kAll) {
        reproduce_paper(papers.front(), flags, out, command_line, *context, units);
        return 0;
    }
    std::vector<IndexedReproduction> done;
    for (const Paper& paper : papers) {
        done.push_back({paper.name, reproduce_paper(paper, flags, out / paper.name, command_line,
                                                    *context, units)});
    }
    write_file_atomically(out / "index.html", make_reproduction_index(done));
    fmt::print("all: {}\n", (out / "index.html").string());
    return 0;
}

} // namespace

Action add_reproduce_verb(CLI::App& app, const std::string& command_line) {
    auto flags = std::make_shared<ReproduceFlags>();
    std::string papers;
    for (const Paper& paper : list_papers()) {
        papers += (papers.empty() ? "" : ", ") + std::string(paper.name);
    }
    app.add_option("paper", flags->paper,
                   papers + ", or all: each after another, with a page over them")
        ->required();
    app.add_option("--scale", flags->scale,
                   "small: a quarter of the published size in each direction; full")
        ->capture_default_str();
    app.add_option("--out", flags->out,
                   "folder, default runs/<UTC>-reproduce-<paper>; one that was cut short goes on");
    flags->context.add_to(app);
    return [flags, command_line] { return reproduce(*flags, command_line); };
}

} // namespace alcove
