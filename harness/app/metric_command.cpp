#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "harness/app/image_pairs.hpp"
#include "harness/app/metric_flags.hpp"
#include "harness/app/metric_gate.hpp"
#include "harness/app/metric_output.hpp"
#include "harness/app/metric_self_test.hpp"
#include "harness/app/progress.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/strata.hpp"
#include "harness/run/units.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

struct MetricFlags {
    std::string test;
    std::string reference;
    std::string list;
    std::vector<std::string> metrics;
    std::string domain;
    std::string mask;
    std::string depth;
    double exec_timeout_s = kDefaultProgramTime;
    bool json = false;
    std::string csv;
    std::string map_folder;
    std::string gate;
    bool self_test = false;
};

std::vector<ImagePair> find_pairs(const MetricFlags& flags) {
    if (!flags.list.empty()) {
        if (!flags.test.empty()) {
            throw InputError("metric", "--list and TEST at once", flags.test, "one of them");
        }
        return read_pair_list(flags.list);
    }
    if (flags.test.empty() || flags.reference.empty()) {
        throw InputError("metric", "needs TEST and REFERENCE, or --list FILE.csv");
    }
    return pair_images(flags.test, flags.reference);
}

ScoringOptions read_options(const MetricFlags& flags) {
    ScoringOptions options;
    options.program_time = read_program_time(flags.exec_timeout_s);
    if (!flags.domain.empty()) {
        options.domain = parse_domain(flags.domain);
    }
    if (!flags.mask.empty()) {
        options.mask = read_mask(flags.mask);
        const std::size_t counted = count_pixels(*options.mask);
        fmt::print(stderr, "alcove: mask: {} pixels counted, {} ignored\n", counted,
                   options.mask->size().pixel_count() - counted);
    }
    if (!flags.depth.empty()) {
        options.depth = read_depth(flags.depth);
    }
    return options;
}

/// Means of all pairs; writes maps and CSV on the way.
MetricMeans measure(const std::vector<ImagePair>& pairs, const PairScorer& scorer,
                    const MetricFlags& flags) {
    if (!flags.map_folder.empty()) {
        create_output_folder(flags.map_folder);
    }
    Progress progress;
    MetricMeans means;
    CsvTable table;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const ImagePair& pair = pairs[i];
        progress.show(static_cast<double>(i) / static_cast<double>(pairs.size()), pair.label);
        const std::vector<PairScore> scores = scorer.score(pair.test, pair.reference);
        means.add(scores, pair.test.string());
        append_pair_lines(table, pair, scores);
        if (!flags.map_folder.empty()) {
            write_maps(flags.map_folder, pair, scores);
        }
    }
    if (!flags.csv.empty()) {
        write_file_atomically(flags.csv, table.make_text());
    }
    return means;
}

/// A table of all metrics holds their names alone: extras are many.
std::vector<MetricMean> list_printed(const MetricMeans& means, bool with_extras) {
    std::vector<MetricMean> printed = means.list();
    std::erase_if(printed,
                  [with_extras](const MetricMean& mean) { return mean.is_extra && !with_extras; });
    return printed;
}

int evaluate(const MetricFlags& flags) {
    const Registry<MetricUnit> registry = get_units().metrics;
    if (flags.self_test) {
        run_self_test(registry, flags.metrics, flags.json);
        return 0;
    }
    const std::vector<std::string> names =
        flags.metrics.empty() ? list_image_metrics(registry) : flags.metrics;
    std::vector<ChosenMetric> metrics = choose_metrics(registry, names, "--metric");
    const std::vector<GateCondition> gate =
        flags.gate.empty() ? std::vector<GateCondition>() : parse_gate(flags.gate);
    const bool calls_programs =
        std::any_of(metrics.begin(), metrics.end(),
                    [](const ChosenMetric& metric) { return metric.program.has_value(); });
    for (ChosenMetric& metric : choose_metrics(
             registry, list_gated_metrics(gate, names, registry, calls_programs), "--gate")) {
        metrics.push_back(std::move(metric));
    }
    const std::vector<ImagePair> pairs = find_pairs(flags);
    const PairScorer scorer(registry, std::move(metrics), read_options(flags));
    const MetricMeans means = measure(pairs, scorer, flags);
    // What it names and nothing gave is an error: before anything is printed.
    const bool holds = check_gate(gate, means);
    const std::vector<MetricMean> printed = list_printed(means, !flags.metrics.empty());
    if (flags.json) {
        print_means_json(printed);
    } else {
        print_means_table(printed);
    }
    return holds ? 0 : 3;
}

} // namespace

Action add_metric_verb(CLI::App& app) {
    auto flags = std::make_shared<MetricFlags>();
    app.add_option("test", flags->test, "image (PNG, EXR, HDR), or folder of frames");
    app.add_option("reference", flags->reference, "image, or folder of frames with the same names");
    app.add_option("--list", flags->list,
                   "CSV with the header test,reference; paths relative to its folder");
    add_metric_option(app, flags->metrics, "default all of images");
    app.add_option("--domain", flags->domain,
                   "srgb, linear, visibility, view; default: the file's own, else srgb for PNG, "
                   "linear for EXR and HDR");
    app.add_option("--mask", flags->mask, "image: pixels that are 0 are ignored");
    app.add_option("--depth", flags->depth,
                   "EXR of eye depth in metres, inf on the background, for metrics that need it");
    add_program_time_option(app, flags->exec_timeout_s);
    app.add_flag("--json", flags->json, "one object");
    app.add_option("--csv", flags->csv, "file: one line a pair and metric");
    app.add_option("--map", flags->map_folder, "folder for the metrics' maps (EXR, PNG in magma)");
    app.add_option("--gate", flags->gate, "\"ssim>=0.9,flip:ppd=30<0.05\": exit 3 unless all hold");
    app.add_flag("--self-test", flags->self_test,
                 "check values of the definitions, with their sources");
    return [flags] { return evaluate(*flags); };
}

} // namespace alcove
