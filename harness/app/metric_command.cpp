#include "core/base/error.hpp"
#include "core/base/image_file.hpp"
#include "core/base/text.hpp"
#include "core/contract/temporal_metric.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/plan.hpp"

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

/// Metrics over time only where `with_temporal`: images alone do not say what moved where.
std::vector<const MetricUnit*> choose_metrics(const Registry<MetricUnit>& registry,
                                              const std::vector<std::string>& names,
                                              bool with_temporal) {
    std::vector<const MetricUnit*> chosen;
    for (const std::string& name : names) {
        const MetricUnit& unit = registry.find(name);
        if (unit.is_temporal() && !with_temporal) {
            throw InputError("--metric", "is over time and needs motion; it is measured by `run`",
                             name, "a metric of images");
        }
        chosen.push_back(&unit);
    }
    if (chosen.empty()) {
        for (const MetricUnit& unit : registry.units()) {
            if (unit.reported && (with_temporal || !unit.is_temporal())) {
                chosen.push_back(&unit);
            }
        }
    }
    return chosen;
}

/// Prints one check and says whether it holds.
bool report_check(const MetricUnit& unit, const std::string& name, double expected,
                  double tolerance, std::optional<double> value) {
    const bool holds = value && std::abs(*value - expected) <= tolerance;
    fmt::print("{:<20}{:<36}expected {:<14} got {:<22} {}\n", unit.name, name,
               format_number(expected), value ? format_number(*value) : "none",
               holds ? "ok" : "FAILED");
    return holds;
}

int count_failed_checks(const MetricUnit& unit) {
    int failures = 0;
    const ResolvedParameters parameters = unit.parameters.resolve({}, {});
    if (unit.is_temporal()) {
        const auto metric = unit.create_temporal(parameters);
        for (const TemporalCheck& check : unit.temporal_checks) {
            const double value = check.run(*metric);
            failures +=
                report_check(unit, check.name, check.expected, check.tolerance, value) ? 0 : 1;
        }
        return failures;
    }
    const auto metric = unit.create(parameters);
    for (const MetricCheck& check : unit.checks) {
        const Image test = check.make_test();
        const Image reference = check.make_reference();
        const MetricResult result = metric->evaluate({test, reference});
        failures +=
            report_check(unit, check.name, check.expected, check.tolerance, result.value) ? 0 : 1;
    }
    return failures;
}

int run_self_test(const std::vector<const MetricUnit*>& metrics) {
    int failures = 0;
    for (const MetricUnit* unit : metrics) {
        failures += count_failed_checks(*unit);
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
                   const std::vector<const MetricUnit*>& metrics,
                   std::map<std::string, Score>& scores) {
    const std::optional<Domain> domain =
        flags.domain.empty() ? std::nullopt : std::optional(parse_domain(flags.domain));
    const ImageFile test = read_finite_image(pair.test, domain);
    const ImageFile reference = read_finite_image(pair.reference, domain);
    if (test.image.size() != reference.image.size() ||
        test.image.channels() != reference.image.channels()) {
        throw InputError(pair.test.string(), "not the shape of " + pair.reference.string(),
                         describe_shape(test.image), describe_shape(reference.image));
    }
    for (const MetricUnit* unit : metrics) {
        const auto metric = unit->create(unit->parameters.resolve({}, {}));
        // Each file is brought to the metric's domain from its own: an EXR may be held against a
        // PNG.
        const auto convert = [unit](const Image& image, Domain from) {
            const Image converted = convert_for_metric(image, from, unit->domain);
            return unit->luma ? compute_luma(converted) : converted;
        };
        check_metric_input({test.image, reference.image}, unit->name, unit->smallest_side);
        const Image a = convert(test.image, test.domain);
        const Image b = convert(reference.image, reference.domain);
        const MetricResult result = metric->evaluate({a, b});
        Score& score = scores[unit->name];
        if (result.value) {
            score.sum += *result.value;
            ++score.frames;
        } else {
            score.undefined_reason = pair.test.string() + ": " + result.undefined_reason;
        }
        if (!flags.map_folder.empty() && result.map) {
            const std::string name = pair.test.stem().string() + "_" + unit->name + ".exr";
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
    const std::vector<const MetricUnit*> metrics =
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
    for (const MetricUnit* unit : metrics) {
        const Score& score = scores.at(unit->name);
        const std::optional<double> mean = score.mean();
        if (mean) {
            object[unit->name] = *mean;
        } else {
            object[unit->name] = nullptr;
            fmt::print(stderr, "alcove: {} has no value: {}\n", unit->name, score.undefined_reason);
        }
        if (!flags.json) {
            fmt::print("{:<10}{} {}\n", unit->name, mean ? format_number(*mean) : "-", unit->unit);
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
    app.add_option("--metric", flags->metrics, "repeatable; default all of images")
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
