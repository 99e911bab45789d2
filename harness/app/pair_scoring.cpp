#include "harness/app/pair_scoring.hpp"

#include "core/base/error.hpp"
#include "core/base/image_file.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// Metrics look at colour: an alpha channel is left out.
Image drop_alpha(Image image) {
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

/// A file's colour, proved to be finite: errors name the file, which a metric does not know.
ImageFile read_finite_image(const fs::path& path, std::optional<Domain> domain) {
    ImageFile file = read_image_file(path, domain);
    file.image = drop_alpha(std::move(file.image));
    PixelPosition position;
    if (find_non_finite(file.image, position)) {
        throw InputError(path.string(), fmt::format("NaN or infinity at pixel ({}, {}), channel {}",
                                                    position.x, position.y, position.channel));
    }
    return file;
}

std::string describe_size(const Image& image) {
    return fmt::format("{}x{}", image.width(), image.height());
}

std::string describe_shape(const Image& image) {
    return fmt::format("{} with {} channels", describe_size(image), image.channels());
}

/// What a program is given exists.
void check_file(const fs::path& path) {
    if (!fs::is_regular_file(path)) {
        throw InputError(path.string(), fs::exists(path) ? "not a regular file" : "no such file");
    }
}

void check_companion(const std::optional<Image>& companion, std::string_view flag,
                     const fs::path& path, const Image& image) {
    if (companion && companion->size() != image.size()) {
        throw InputError(flag, "not the size of " + path.string(), describe_size(*companion),
                         describe_size(image));
    }
}

} // namespace

std::vector<ChosenMetric> choose_metrics(const Registry<MetricUnit>& registry,
                                         const std::vector<std::string>& names,
                                         std::string_view where) {
    std::vector<ChosenMetric> chosen;
    std::set<std::string> seen;
    for (const std::string& name : names) {
        if (!seen.insert(name).second) {
            throw InputError(where, "metric stands twice", name, "each one once");
        }
        if (is_external_metric(name)) {
            chosen.push_back({name, std::nullopt, parse_external_metric(name, where)});
            continue;
        }
        const ResolvedMetric metric = resolve_metric(registry, parse_metric_spec(name, where));
        if (metric.unit->is_temporal()) {
            throw InputError(where, "is over time and needs motion; it is measured by `run`", name,
                             "a metric of images");
        }
        chosen.push_back({name, metric, std::nullopt});
    }
    return chosen;
}

std::vector<std::string> list_image_metrics(const Registry<MetricUnit>& registry) {
    std::vector<std::string> names;
    for (const MetricUnit& unit : registry.units()) {
        if (unit.reported && !unit.is_temporal()) {
            names.push_back(unit.name);
        }
    }
    return names;
}

PairScorer::PairScorer(const Registry<MetricUnit>& registry, std::vector<ChosenMetric> metrics,
                       ScoringOptions options)
    : m_metrics(std::move(metrics)), m_options(std::move(options)) {
    for (const MetricUnit& unit : registry.units()) {
        m_names.insert(unit.name);
    }
    for (const ChosenMetric& metric : m_metrics) {
        m_instances.push_back(metric.ours ? metric.ours->create() : nullptr);
    }
}

std::vector<PairScore> PairScorer::score(const fs::path& test, const fs::path& reference) const {
    std::vector<PairScore> ours;
    if (std::any_of(m_metrics.begin(), m_metrics.end(),
                    [](const ChosenMetric& metric) { return metric.ours.has_value(); })) {
        score_ours(test, reference, ours);
    }
    std::vector<PairScore> scores;
    std::size_t next = 0;
    for (const ChosenMetric& metric : m_metrics) {
        if (metric.ours) {
            scores.push_back(std::move(ours[next++]));
            continue;
        }
        check_file(test);
        check_file(reference);
        for (const ExternalValue& value :
             run_external_metric(*metric.program, test, reference, m_options.program_time)) {
            check_key(value.name, *metric.program, scores);
            MetricResult result;
            result.value = value.value;
            result.undefined_reason = value.value ? "" : "the program gave null";
            scores.push_back({value.name, "", std::move(result)});
        }
    }
    return scores;
}

void PairScorer::check_key(const std::string& key, const ExternalMetric& program,
                           const std::vector<PairScore>& scores) const {
    // `flip.max` is ours too.
    if (m_names.contains(key.substr(0, key.find('.')))) {
        throw InputError(program.text, "gives a metric that Alcove has itself", key,
                         "another name");
    }
    if (std::any_of(scores.begin(), scores.end(),
                    [&key](const PairScore& score) { return score.name == key; })) {
        throw InputError(program.text, "gives a metric that another program gives", key,
                         "another name");
    }
}

void PairScorer::score_ours(const fs::path& test_path, const fs::path& reference_path,
                            std::vector<PairScore>& scores) const {
    const ImageFile test = read_finite_image(test_path, m_options.domain);
    const ImageFile reference = read_finite_image(reference_path, m_options.domain);
    if (test.image.size() != reference.image.size() ||
        test.image.channels() != reference.image.channels()) {
        throw InputError(test_path.string(), "not the shape of " + reference_path.string(),
                         describe_shape(test.image), describe_shape(reference.image));
    }
    check_companion(m_options.mask, "--mask", test_path, test.image);
    check_companion(m_options.depth, "--depth", test_path, test.image);
    for (std::size_t i = 0; i < m_metrics.size(); ++i) {
        if (!m_metrics[i].ours) {
            continue;
        }
        const MetricUnit& unit = *m_metrics[i].ours->unit;
        const MetricDomain domain = m_metrics[i].ours->domain;
        std::optional<MetricResult> result = refuse_small_image(unit, test.image.size());
        if (!result) {
            // Each file is brought to the metric's domain from its own: an EXR may be held against
            // a PNG.
            const Image a = convert_for_unit(unit, test.image, test.domain, domain);
            const Image b = convert_for_unit(unit, reference.image, reference.domain, domain);
            MetricInput input{a, b};
            input.mask = m_options.mask ? &*m_options.mask : nullptr;
            input.depth = m_options.depth ? &*m_options.depth : nullptr;
            result = m_instances[i]->evaluate(input);
        }
        scores.push_back({m_metrics[i].name, unit.unit, std::move(*result)});
    }
}

Image read_mask(const fs::path& path) {
    const Image image = read_finite_image(path, std::nullopt).image;
    Image mask(image.size(), 1);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int c = 0; c < image.channels(); ++c) {
                mask.at(x, y) = image.at(x, y, c) != 0.0f ? 1.0f : mask.at(x, y);
            }
        }
    }
    return mask;
}

Image read_depth(const fs::path& path) {
    Image depth = take_channel(read_image_file(path).image, 0);
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            const float value = depth.at(x, y);
            if (!(value > 0.0f)) {
                throw InputError(path.string(), fmt::format("no depth at pixel ({}, {})", x, y),
                                 fmt::format("{}", value), "metres over 0, inf on the background");
            }
        }
    }
    return depth;
}

} // namespace alcove
