#include "core/base/error.hpp"
#include "core/base/image_file.hpp"
#include "core/base/text.hpp"
#include "core/contract/temporal_metric.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/metric_spec.hpp"
#include "harness/run/units.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alcove {
namespace {

namespace fs = std::filesystem;

struct MetricFlags {
    std::string test;
    std::string reference;
    std::vector<std::string> metrics;
    std::string domain;
    bool json = false;
    std::string map_folder;
    std::string gate;
    bool self_test = false;
};

/// A metric's mean over frames; nothing where a frame has no value.
struct Score {
    double sum = 0.0;
    int frames = 0;
    std::string undefined_reason;
    [[nodiscard]] std::optional<double> mean() const {
        return undefined_reason.empty() && frames > 0 ? std::optional(sum / frames) : std::nullopt;
    }
};

void add_value(Score& score, std::optional<double> value, const std::string& undefined_reason) {
    if (value) {
        score.sum += *value;
        ++score.frames;
    } else {
        score.undefined_reason = undefined_reason;
    }
}

struct ImagePair {
    fs::path test;
    fs::path reference;
};

std::vector<fs::path> list_images(const fs::path& folder) {
    std::vector<fs::path> names;
    for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
        const std::string extension = file.path().extension().string();
        if (file.is_regular_file() && (extension == ".png" || extension == ".exr")) {
            names.push_back(file.path().filename());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// Two files, or the frames of two folders by name. What one folder lacks is an error, never left
/// out.
std::vector<ImagePair> pair_images(const MetricFlags& flags) {
    const fs::path test = flags.test;
    const fs::path reference = flags.reference;
    if (!fs::is_directory(test) && !fs::is_directory(reference)) {
        return {{test, reference}};
    }
    if (!fs::is_directory(test) || !fs::is_directory(reference)) {
        throw InputError("metric", "one is a folder, the other is not",
                         flags.test + " and " + flags.reference, "two files or two folders");
    }
    const std::vector<fs::path> names = list_images(test);
    if (names != list_images(reference)) {
        throw InputError("metric", "the folders do not hold the same PNG and EXR names", flags.test,
                         flags.reference);
    }
    if (names.empty()) {
        throw InputError(flags.test, "holds no PNG or EXR");
    }
    std::vector<ImagePair> pairs;
    for (const fs::path& name : names) {
        pairs.push_back({test / name, reference / name});
    }
    return pairs;
}

/// Metrics look at colour: an alpha channel is left out.
Image drop_alpha(const Image& image) {
    const int kept = image.channels() == 4 ? 3 : image.channels() == 2 ? 1 : image.channels();
    if (kept == image.channels()) {
        return image;
    }
    Image result(image.size(), kept);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int c = 0; c < kept; ++c) {
                result.at(x, y, c) = image.at(x, y, c);
            }
        }
    }
    return result;
}

/// A metric as it was named.
struct ChosenMetric {
    std::string name;
    ResolvedMetric resolved;
};

/// Metrics over time only where `with_temporal`: images alone do not say what moved where.
std::vector<ChosenMetric> choose_metrics(const Registry<MetricUnit>& registry,
                                         std::vector<std::string> names, bool with_temporal) {
    if (names.empty()) {
        for (const MetricUnit& unit : registry.units()) {
            if (unit.reported && (with_temporal || !unit.is_temporal())) {
                names.push_back(unit.name);
            }
        }
    }
    check_metric_specs(registry, names, "--metric");
    std::vector<ChosenMetric> chosen;
    for (const std::string& name : names) {
        const ResolvedMetric metric = resolve_metric(registry, parse_metric_spec(name, "--metric"));
        if (metric.unit->is_temporal() && !with_temporal) {
            throw InputError("--metric", "is over time and needs motion; it is measured by `run`",
                             name, "a metric of images");
        }
        chosen.push_back({name, metric});
    }
    return chosen;
}

/// Prints one check and says whether it holds. `Check` is a MetricCheck or a TemporalCheck.
template <class Check>
bool report_check(const MetricUnit& unit, const Check& check, std::optional<double> value) {
    const bool holds = value && std::abs(*value - check.expected) <= check.tolerance;
    fmt::print(
        "{:<20}{:<42}expected {:<12} got {:<12} difference {:<10} tolerance {:<9} {:<7} {}\n",
        unit.name, check.name, format_rounded(check.expected, 9),
        value ? format_rounded(*value, 9) : "none",
        value ? fmt::format("{:.1e}", *value - check.expected) : "-",
        fmt::format("{:.1e}", check.tolerance), holds ? "ok" : "FAILED", check.source);
    return holds;
}

int count_failed_checks(const MetricUnit& unit) {
    int failures = 0;
    const ResolvedParameters parameters = unit.parameters.resolve({}, {});
    if (unit.is_temporal()) {
        const auto metric = unit.create_temporal(parameters);
        for (const TemporalCheck& check : unit.temporal_checks) {
            failures += report_check(unit, check, check.run(*metric)) ? 0 : 1;
        }
        return failures;
    }
    for (const MetricCheck& check : unit.checks) {
        const auto metric = unit.create(unit.parameters.resolve(check.parameters, {}));
        failures += report_check(unit, check, evaluate_check(*metric, check).value) ? 0 : 1;
    }
    return failures;
}

int run_self_test(const std::vector<ChosenMetric>& metrics) {
    int failures = 0;
    for (const ChosenMetric& metric : metrics) {
        failures += count_failed_checks(*metric.resolved.unit);
    }
    if (failures > 0) {
        throw FailureError("metric --self-test", std::to_string(failures) + " checks failed");
    }
    return 0;
}

/// A file's colour, proved to be finite: errors name the file, which a metric does not know.
ImageFile read_finite_image(const fs::path& path, std::optional<Domain> domain) {
    ImageFile file = read_image_file(path, domain);
    file.image = drop_alpha(file.image);
    PixelPosition position;
    if (find_non_finite(file.image, position)) {
        throw InputError(path.string(), fmt::format("NaN or infinity at pixel ({}, {}), channel {}",
                                                    position.x, position.y, position.channel));
    }
    return file;
}

std::string describe_shape(const Image& image) {
    return fmt::format("{}x{} with {} channels", image.width(), image.height(), image.channels());
}

void evaluate_pair(const ImagePair& pair, const MetricFlags& flags,
                   const std::vector<ChosenMetric>& metrics, std::map<std::string, Score>& scores) {
    const std::optional<Domain> domain =
        flags.domain.empty() ? std::nullopt : std::optional(parse_domain(flags.domain));
    const ImageFile test = read_finite_image(pair.test, domain);
    const ImageFile reference = read_finite_image(pair.reference, domain);
    if (test.image.size() != reference.image.size() ||
        test.image.channels() != reference.image.channels()) {
        throw InputError(pair.test.string(), "not the shape of " + pair.reference.string(),
                         describe_shape(test.image), describe_shape(reference.image));
    }
    for (const ChosenMetric& chosen : metrics) {
        const MetricUnit& unit = *chosen.resolved.unit;
        // One that was named is refused on a small image; of all metrics it has no value.
        check_metric_input({test.image, reference.image}, unit.name,
                           flags.metrics.empty() ? 1 : unit.smallest_side);
        // Each file is brought to the metric's domain from its own: an EXR may be held against a
        // PNG.
        const auto evaluate_files = [&] {
            const Image a = convert_for_unit(unit, test.image, test.domain, chosen.resolved.domain);
            const Image b =
                convert_for_unit(unit, reference.image, reference.domain, chosen.resolved.domain);
            return chosen.resolved.create()->evaluate({a, b});
        };
        std::optional<MetricResult> refusal = refuse_small_image(unit, test.image.size());
        const MetricResult result = refusal ? std::move(*refusal) : evaluate_files();
        add_value(scores[chosen.name], result.value,
                  pair.test.string() + ": " + result.undefined_reason);
        // A JSON of all metrics holds their names alone.
        if (!flags.metrics.empty()) {
            for (const NamedValue& extra : result.extras) {
                add_value(scores[chosen.name + "." + extra.name], extra.value, "");
            }
        }
        if (!flags.map_folder.empty() && result.map) {
            const std::string name = pair.test.stem().string() + "_" + chosen.name + ".exr";
            write_exr(fs::path(flags.map_folder) / name, *result.map, Domain::linear);
        }
    }
}

/// "ssim>=0.9,rmse<0.05": every part must hold.
bool check_gate(const std::string& text, const std::map<std::string, Score>& scores) {
    bool all = true;
    for (const std::string& part : split(text, ',')) {
        const std::size_t position = part.find_first_of("<>");
        const std::string expected = "METRIC<NUMBER, with <, <=, > or >=";
        if (position == std::string::npos || position == 0) {
            throw InputError("--gate", "cannot be read", part, expected);
        }
        const bool or_equal = position + 1 < part.size() && part[position + 1] == '=';
        const auto score = scores.find(part.substr(0, position));
        if (score == scores.end()) {
            throw InputError("--gate", "metric was not evaluated", part.substr(0, position));
        }
        const double bound = parse_number(part.substr(position + (or_equal ? 2 : 1)), "--gate");
        const std::optional<double> value = score->second.mean();
        const bool less = part[position] == '<';
        const bool holds =
            value && ((less ? *value < bound : *value > bound) || (or_equal && *value == bound));
        if (!holds) {
            fmt::print(stderr, "alcove: gate not met: {} (is {})\n", part,
                       value ? format_number(*value) : "undefined");
        }
        all = all && holds;
    }
    return all;
}

int evaluate(const MetricFlags& flags) {
    const Registry<MetricUnit> registry = get_units().metrics;
    const std::vector<ChosenMetric> metrics =
        choose_metrics(registry, flags.metrics, flags.self_test);
    if (flags.self_test) {
        return run_self_test(metrics);
    }
    if (flags.test.empty() || flags.reference.empty()) {
        throw InputError("metric", "needs TEST and REFERENCE");
    }
    std::map<std::string, Score> scores;
    for (const ImagePair& pair : pair_images(flags)) {
        evaluate_pair(pair, flags, metrics, scores);
    }
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    const auto print = [&](const std::string& name, const std::string& unit) {
        const Score& score = scores.at(name);
        const std::optional<double> mean = score.mean();
        if (mean) {
            object[name] = *mean;
        } else {
            object[name] = nullptr;
            fmt::print(stderr, "alcove: {} has no value: {}\n", name, score.undefined_reason);
        }
        if (!flags.json) {
            fmt::print("{:<10}{} {}\n", name, mean ? format_number(*mean) : "-", unit);
        }
    };
    for (const ChosenMetric& metric : metrics) {
        print(metric.name, metric.resolved.unit->unit);
        const std::string prefix = metric.name + ".";
        for (const auto& [name, score] : scores) {
            if (name.starts_with(prefix)) {
                print(name, "");
            }
        }
    }
    if (flags.json) {
        fmt::print("{}\n", object.dump());
    }
    return flags.gate.empty() || check_gate(flags.gate, scores) ? 0 : 3;
}

} // namespace

Action add_metric_verb(CLI::App& app) {
    auto flags = std::make_shared<MetricFlags>();
    app.add_option("test", flags->test, "image, or folder of frames");
    app.add_option("reference", flags->reference, "image, or folder of frames with the same names");
    app.add_option("--metric", flags->metrics,
                   "NAME[@values|view|linear|codes][:key=value,...], repeatable; default all of "
                   "images")
        ->expected(1)
        ->take_all();
    app.add_option("--domain", flags->domain,
                   "srgb, linear, visibility, view; default: the file's own, else srgb for PNG, "
                   "linear for EXR");
    app.add_flag("--json", flags->json, "one object");
    app.add_option("--map", flags->map_folder, "folder for the metrics' maps (EXR)");
    app.add_option("--gate", flags->gate, "\"ssim>=0.9,rmse<0.05\": exit 3 unless all hold");
    app.add_flag("--self-test", flags->self_test, "check values of the definitions");
    return [flags] { return evaluate(*flags); };
}

} // namespace alcove
