#include "reports/html/dashboard_data.hpp"

#include "reports/analysis/history_wording.hpp"
#include "reports/html/escape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <unordered_map>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

using Json = nlohmann::ordered_json;

/// Six digits: a chart shows three, and a year of nights stays a third as large.
double shorten(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return std::strtod(text.data(), nullptr);
}

Json make_number(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(shorten(*value)) : Json();
}

/// Where a run stands among all, and among those of its device and suite.
struct Place {
    std::size_t night = 0;
    std::size_t position = 0;
};

std::unordered_map<std::int64_t, Place> place_runs(const StoredHistory& history) {
    std::unordered_map<std::int64_t, Place> places;
    std::map<std::pair<std::string, std::string>, std::size_t> counts;
    for (std::size_t i = 0; i < history.runs.size(); ++i) {
        const StoredRun& run = history.runs[i];
        places[run.id] = {i, counts[{run.device, run.suite}]++};
    }
    return places;
}

/// What tells two segments apart, shortly.
std::string describe_segment_change(const StoredSegment& before, const StoredSegment& now) {
    std::string text;
    const auto compare = [&](const char* what, const std::string& a, const std::string& b) {
        if (a != b) {
            text += (text.empty() ? "new " : ", ") + std::string(what);
        }
    };
    compare("device", before.device, now.device);
    compare("anchor", before.anchor, now.anchor);
    compare("scene", before.scene, now.scene);
    compare("reference", before.reference, now.reference);
    return text;
}

SeriesName strip_to_cell(SeriesName name) {
    name.state.clear();
    name.pass.clear();
    name.metric.clear();
    return name;
}

class DataMaker {
  public:
    DataMaker(const StoredHistory& history, const std::vector<ShownSeries>& shown)
        : m_places(place_runs(history)) {
        for (const StoredSegment& segment : history.segments) {
            m_segments[segment.id] = &segment;
        }
        for (const ShownSeries& one : shown) {
            const StoredSeries& series = *one.series;
            if (series.kind == SeriesKind::images) {
                m_images[strip_to_cell(series.name)] = &series;
            } else if (series.kind == SeriesKind::milliseconds) {
                SeriesName name = series.name;
                name.metric.clear();
                m_milliseconds[name] = &one;
            }
        }
    }

    Json make(const ShownSeries& shown) const {
        const StoredSeries& series = *shown.series;
        Json json{{"id", series.id},
                  {"title", describe_series(series.kind, series.name)},
                  {"unit", describe_unit(shown)}};
        add_points(json, shown);
        add_fences(json, shown);
        json["segments"] = make_segments(series);
        json["steps"] = make_steps(series);
        add_milliseconds(json, series);
        return json;
    }

  private:
    void add_points(Json& json, const ShownSeries& shown) const {
        Json positions = Json::array();
        Json nights = Json::array();
        Json values = Json::array();
        Json lower = Json::array();
        Json upper = Json::array();
        bool has_interval = false;
        for (const StoredPoint& point : shown.series->points) {
            const Place& place = m_places.at(point.run);
            positions.push_back(place.position);
            nights.push_back(place.night);
            values.push_back(shorten(point.value));
            has_interval = has_interval || point.interval.has_value();
            lower.push_back(point.interval ? make_number(point.interval->lower) : Json());
            upper.push_back(point.interval ? make_number(point.interval->upper) : Json());
        }
        json["positions"] = std::move(positions);
        json["nights"] = std::move(nights);
        json["values"] = std::move(values);
        json["lower"] = has_interval ? std::move(lower) : Json::array();
        json["upper"] = has_interval ? std::move(upper) : Json::array();
    }

    static void add_fences(Json& json, const ShownSeries& shown) {
        Json baseline = Json::array();
        Json low = Json::array();
        Json high = Json::array();
        const bool is_logarithmic = has_logarithm(shown.series->kind);
        for (const HistoryNight& night : shown.nights) {
            baseline.push_back(make_number(night.baseline));
            if (!night.fence) {
                low.push_back(nullptr);
                high.push_back(nullptr);
                continue;
            }
            const double fence = *night.fence;
            const double from = *night.baseline;
            low.push_back(make_number(is_logarithmic ? from * std::exp(-fence) : from - fence));
            high.push_back(make_number(is_logarithmic ? from * std::exp(fence) : from + fence));
        }
        json["baseline"] = std::move(baseline);
        json["fenceLow"] = std::move(low);
        json["fenceHigh"] = std::move(high);
    }

    Json make_segments(const StoredSeries& series) const {
        Json segments = Json::array();
        for (std::size_t i = 1; i < series.points.size(); ++i) {
            const std::int64_t before = series.points[i - 1].segment;
            const std::int64_t now = series.points[i].segment;
            if (before != now) {
                segments.push_back(
                    {i, describe_segment_change(*m_segments.at(before), *m_segments.at(now))});
            }
        }
        return segments;
    }

    Json make_steps(const StoredSeries& series) const {
        Json steps = Json::array();
        for (const StoredVerdict& verdict : series.verdicts) {
            steps.push_back({m_places.at(verdict.run).position,
                             std::string(to_text(verdict.kind)) + " " +
                                 describe_change(series.kind, verdict.change) +
                                 (verdict.is_confirmed ? "" : ", not repeated"),
                             verdict.is_confirmed});
        }
        if (const auto images = m_images.find(strip_to_cell(series.name));
            images != m_images.end()) {
            for (const StoredVerdict& verdict : images->second->verdicts) {
                steps.push_back({m_places.at(verdict.run).position, to_text(verdict.kind), true});
            }
        }
        return steps;
    }

    void add_milliseconds(Json& json, const StoredSeries& series) const {
        Json values = Json::array();
        std::string unit;
        SeriesName name = series.name;
        name.metric.clear();
        const auto found = m_milliseconds.find(name);
        if (series.kind == SeriesKind::time && found != m_milliseconds.end()) {
            unit = describe_unit(*found->second);
            const std::vector<StoredPoint>& times = found->second->series->points;
            auto time = times.begin(); // both ascend in run
            for (const StoredPoint& point : series.points) {
                time = std::find_if(time, times.end(), [&](const StoredPoint& other) {
                    return other.run >= point.run;
                });
                const bool is_there = time != times.end() && time->run == point.run;
                values.push_back(is_there ? Json(shorten(time->value)) : Json());
            }
        }
        json["milliseconds"] = std::move(values);
        json["millisecondsUnit"] = unit;
    }

    std::unordered_map<std::int64_t, Place> m_places;
    std::unordered_map<std::int64_t, const StoredSegment*> m_segments;
    std::map<SeriesName, const StoredSeries*> m_images;
    std::map<SeriesName, const ShownSeries*> m_milliseconds;
};

} // namespace

std::vector<ShownSeries> replay_series(const StoredHistory& history) {
    std::unordered_map<std::int64_t, const StoredRun*> runs;
    for (const StoredRun& run : history.runs) {
        runs[run.id] = &run;
    }
    std::vector<ShownSeries> all;
    for (const StoredSeries& series : history.series) {
        ShownSeries shown{&series, "", {}};
        if (!series.points.empty()) {
            shown.device_class = runs.at(series.points.back().run)->device_class;
        }
        if (series.kind != SeriesKind::images) {
            shown.nights = replay_history(list_history_points(series), get_rule(series.kind));
        }
        all.push_back(std::move(shown));
    }
    return all;
}

std::string describe_unit(const ShownSeries& shown) {
    const SeriesName& name = shown.series->name;
    const bool is_metric = shown.series->kind == SeriesKind::quality;
    return is_metric ? name.metric : name.metric + ", " + shown.device_class;
}

std::string make_dashboard_data(const StoredHistory& history,
                                const std::vector<ShownSeries>& shown) {
    Json nights = Json::array();
    for (const StoredRun& run : history.runs) {
        constexpr std::size_t kDay = 10; // of "2026-03-04T05:06:07Z"
        constexpr std::size_t kShownBuild = 8;
        nights.push_back({{"date", run.utc.substr(0, kDay)},
                          {"build", run.build.substr(0, kShownBuild)},
                          {"commit", run.commit}});
    }
    Json series = Json::array();
    const DataMaker maker(history, shown);
    for (const ShownSeries& one : shown) {
        if (!one.nights.empty() && one.series->kind != SeriesKind::milliseconds) {
            series.push_back(maker.make(one));
        }
    }
    const Json data{{"nights", nights}, {"series", series}};
    return escape_inline_json(data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

} // namespace alcove
