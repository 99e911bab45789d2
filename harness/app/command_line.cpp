#include "harness/app/command_line.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "harness/app/planned.hpp"
#include "harness/app/verbs.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace alcove {
namespace {

struct Verb {
    std::string name;
    CLI::App* app;
    Action action;
    bool passes_rest_on = false; ///< what it does not know is not for it to refuse
};

std::string join_arguments(int argc, char** argv) {
    std::string text = "alcove";
    for (int i = 1; i < argc; ++i) {
        text += " ";
        text += argv[i];
    }
    return text;
}

std::string describe_planned() {
    std::string text = "Planned:\n";
    for (const Planned& verb : list_planned_verbs()) {
        text += "  " + std::string(verb.name) +
                std::string(28 - std::string_view(verb.name).size(), ' ') + verb.meaning + "\n";
    }
    return text;
}

void check_verb(const std::string& name, const std::vector<Verb>& verbs) {
    std::vector<std::string> names{"test"};
    for (const Verb& verb : verbs) {
        names.push_back(verb.name);
    }
    for (const Planned& planned : list_planned_verbs()) {
        if (name == planned.name) {
            throw_planned(name);
        }
    }
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        throw InputError("alcove", "unknown verb", name, describe_choices(name, names));
    }
    if (name == "test") {
        throw InputError("`test` is the launcher's: ./alcove test builds and runs the tests");
    }
}

/// CLI11 names what it did not expect; the nearest flag is ours to say.
[[noreturn]] void throw_unexpected(const CLI::App& app, const std::string& argument) {
    if (app.get_name() == "run") {
        for (const Planned& flag : list_planned_run_flags()) {
            if (argument == flag.name || argument.starts_with(std::string(flag.name) + "=")) {
                throw_planned(flag.name);
            }
        }
    }
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    throw InputError("alcove " + app.get_name(), "unexpected argument", argument,
                     describe_choices(argument, names));
}

int parse_and_run(CLI::App& app, const std::vector<Verb>& verbs, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        for (const Verb& verb : verbs) {
            if (verb.app->parsed() && !verb.passes_rest_on) {
                const std::vector<std::string> rest = verb.app->remaining();
                if (!rest.empty()) {
                    throw_unexpected(*verb.app, rest.front());
                }
            }
        }
        throw InputError(error.what());
    }
    for (const Verb& verb : verbs) {
        if (verb.app->parsed()) {
            const std::vector<std::string> rest = verb.app->remaining();
            if (!rest.empty() && !verb.passes_rest_on) {
                throw_unexpected(*verb.app, rest.front());
            }
            return verb.action();
        }
    }
    throw InputError("alcove", "needs a verb", "", "alcove --help lists them");
}

} // namespace

int run_command_line(int argc, char** argv) {
    CLI::App app{"Alcove replays walkthroughs through ambient-occlusion methods, times every pass, "
                 "compares with "
                 "ray-traced truth and reports.",
                 "alcove"};
    app.footer(describe_planned());
    app.require_subcommand(0, 1);
    std::vector<Verb> verbs;
    const auto add = [&](const char* name, const char* meaning, auto&& make) {
        CLI::App* verb = app.add_subcommand(name, meaning);
        verb->allow_extras();
        verbs.push_back({name, verb, make(*verb), false});
    };
    const std::string line = join_arguments(argc, argv);
    add("run", "replay scenes through methods; ends with a table and a page",
        [&](CLI::App& verb) { return add_run_verb(verb, line); });
    add("report", "write page and tables of runs anew", add_report_verb);
    add("compare", "two runs, paired through the anchor", add_compare_verb);
    add("ab", "two builds, alternately in one go", add_ab_verb);
    verbs.back().passes_rest_on = true;
    add("nightly", "run, append to the store, gate against history, redraw the dashboard",
        [&](CLI::App& verb) { return add_nightly_verb(verb, line); });
    add("reproduce", "a paper's tables and figures, with a verdict a claim",
        [&](CLI::App& verb) { return add_reproduce_verb(verb, line); });
    add("list", "methods, scenes, metrics, parameters", add_list_verb);
    add("metric", "metrics over anybody's images", add_metric_verb);
    add("score", "new metrics over the images that a run kept", add_score_verb);
    add("reference", "ray-traced visibility of a scene", add_reference_verb);
    add("tune", "fit parameters to a target; held-out frames judge",
        [&](CLI::App& verb) { return add_tune_verb(verb, line); });
    add("stability", "the hard cases, method by case",
        [&](CLI::App& verb) { return add_stability_verb(verb, line); });
    add("plan", "the effects a scene calls for, with evidence and saving", add_plan_verb);
    add("recommend", "the fastest cell of a run with a quality", add_recommend_verb);
    add("scene", "export a scene as glTF", add_scene_verb);
    add("why", "which ingredient made a cell run or be reused", add_why_verb);
    add("cache", "path, size, verify, prune", add_cache_verb);
    add("doctor", "context, driver, timer validation", add_doctor_verb);
    app.add_subcommand("test", "build and run the tests (./alcove test [--all])");
    if (argc > 1 && argv[1][0] != '-') {
        check_verb(argv[1], verbs);
    }
    return parse_and_run(app, verbs, argc, argv);
}

} // namespace alcove
