#include "harness/app/metric_output.hpp"

#include "core/base/image_file.hpp"
#include "core/base/text.hpp"
#include "harness/run/magma.hpp"
#include "reports/terminal/text_table.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alcove {
namespace {

void print_lack(const MetricMean& mean) {
    fmt::print(stderr, "alcove: {} has no value: {}\n", mean.name,
               clean_text(mean.describe_lack()));
}

std::string format_count(std::optional<std::size_t> count) {
    return count ? std::to_string(*count) : std::string();
}

std::string make_map_name(const std::string& label, std::string metric) {
    std::replace_if(
        metric.begin(), metric.end(),
        [](unsigned char c) {
            return std::isalnum(c) == 0 && c != '_' && c != '-' && c != '.' && c != '@' && c != '=';
        },
        '_');
    return label + "_" + metric;
}

} // namespace

void print_means_json(const std::vector<MetricMean>& means) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (const MetricMean& mean : means) {
        const std::optional<double> value = mean.mean();
        object[mean.name] = nullptr;
        if (value) {
            object[mean.name] = *value;
        } else {
            print_lack(mean);
        }
    }
    fmt::print("{}\n", object.dump());
}

void print_means_table(const std::vector<MetricMean>& means) {
    TextLines lines;
    const bool has_several = !means.empty() && means.front().pairs > 1;
    if (has_several) {
        lines.push_back({"metric", "mean", "unit", "smallest", "largest", "n"});
    }
    for (const MetricMean& mean : means) {
        const std::optional<double> value = mean.mean();
        lines.push_back({mean.name, value ? format_number(*value) : "-", mean.unit});
        if (has_several) {
            const bool has_values = mean.values > 0;
            lines.back().push_back(has_values ? format_number(mean.smallest) : "-");
            lines.back().push_back(has_values ? format_number(mean.largest) : "-");
            lines.back().push_back(std::to_string(mean.values));
        }
        if (!value) {
            print_lack(mean);
        }
    }
    fmt::print("{}", align_columns(lines));
}

void append_pair_lines(CsvTable& table, const ImagePair& pair,
                       const std::vector<PairScore>& scores) {
    for (const PairScore& score : scores) {
        std::string extras;
        for (const NamedValue& extra : score.result.extras) {
            extras += (extras.empty() ? "" : " ") + extra.name + "=" + format_number(extra.value);
        }
        table.begin_line();
        table.add("test", pair.test.string());
        table.add("reference", pair.reference.string());
        table.add("metric", score.name);
        table.add("value", score.result.value);
        table.add("extras", extras);
        table.add("counted_pixels", format_count(score.result.counted_pixels));
        table.add("ignored_pixels", format_count(score.result.ignored_pixels));
        table.add("note", score.result.undefined_reason);
    }
}

void write_maps(const std::filesystem::path& folder, const ImagePair& pair,
                const std::vector<PairScore>& scores) {
    for (const PairScore& score : scores) {
        if (score.result.map) {
            const std::string name = make_map_name(pair.label, score.name);
            write_exr(folder / (name + ".exr"), *score.result.map, Domain::linear);
            write_png(folder / (name + ".png"), make_magma_map(*score.result.map), Domain::srgb);
        }
    }
}

} // namespace alcove
