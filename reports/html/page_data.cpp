#include "reports/html/page_data.hpp"

#include "reports/analysis/tradeoff.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/events.hpp"
#include "reports/html/film.hpp"
#include "reports/html/round_section.hpp"

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

using Json = nlohmann::ordered_json;

Json make_optional(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json make_ratio(const CellAnalysis& cell) {
    if (!cell.cell.has_passes) {
        return {{"value", 0.0}, {"lower", 0.0}, {"upper", 0.0}, {"text", "0 by definition"}};
    }
    if (!cell.ratio) {
        return {};
    }
    const Interval ends = get_bounds(*cell.ratio);
    return {{"value", cell.ratio->value},
            {"lower", ends.lower},
            {"upper", ends.upper},
            {"text", describe_estimate(*cell.ratio)}};
}

Json make_error(const MetricAnalysis* error) {
    if (error == nullptr) {
        return {};
    }
    const double value = error->is_below_floor ? *error->floor : error->shown();
    // What is shown as the floor spreads nowhere that is known.
    const Interval ends =
        error->is_below_floor ? Interval{value, value} : get_bounds(error->content);
    return {{"value", value},
            {"lower", ends.lower},
            {"upper", ends.upper},
            {"text", format_error(*error)},
            {"floor", make_optional(error->floor)},
            {"n", error->frames}};
}

Json make_cell(const RoundAnalysis& round, const CellAnalysis& cell, std::size_t index) {
    Json errors = Json::object();
    Json frame_errors = Json::object();
    for (const std::string& metric : round.metrics) {
        errors[metric] = {{"cold", make_error(cell.find(SampleState::cold, metric))},
                          {"converged", make_error(cell.find(SampleState::converged, metric))}};
    }
    for (const FrameError& error : cell.frame_errors) {
        frame_errors[error.metric].push_back(
            {error.segment, error.frame, make_optional(error.value)});
    }
    Json times = Json::array();
    for (const FrameTime& time : cell.frame_times) {
        times.push_back(
            {time.segment, time.frame, time.median_ms, time.minimum_ms, time.maximum_ms});
    }
    return {{"id", cell.cell.id},
            {"label", cell.cell.label},
            {"series", get_series_class(cell, index)},
            {"isMethod", cell.cell.role == CellRole::method},
            {"onFront", cell.is_on_front},
            {"ratio", make_ratio(cell)},
            {"errors", errors},
            {"times", times},
            {"frameErrors", frame_errors}};
}

/// The reference's floor of every frame: the same for all methods, so taken from the first that has
/// it.
Json make_frame_floors(const RoundAnalysis& round, const std::string& metric) {
    Json floors = Json::array();
    for (const CellAnalysis& cell : round.cells) {
        for (const FrameError& error : cell.frame_errors) {
            if (error.metric == metric && error.floor) {
                floors.push_back({error.segment, error.frame, *error.floor});
            }
        }
        if (!floors.empty()) {
            break;
        }
    }
    return floors;
}

Json make_kind(const PictureKind& kind) {
    return {{"key", kind.key}, {"title", kind.title}, {"ofReference", kind.is_of_reference}};
}

Json make_pictures(const RoundAnalysis& round, const PictureFinder& finder) {
    Json kinds = Json::array();
    for (const PictureKind& kind : list_picture_kinds(round.round)) {
        kinds.push_back(make_kind(kind));
    }
    Json urls = Json::object();
    for (const CellAnalysis* cell : list_pictured_cells(round)) {
        for (const int frame : round.round.image_frames) {
            for (const PictureKind& kind : list_picture_kinds(round.round)) {
                if (const auto url = finder.find_url(round.round.id, cell->cell.id, frame, kind)) {
                    urls[cell->cell.id][std::to_string(frame)][kind.key] = *url;
                }
            }
        }
    }
    return {{"frames", round.round.image_frames}, {"kinds", kinds}, {"urls", urls}};
}

/// Null if the round has no film with pictures.
Json make_film(const RoundAnalysis& round, const PictureFinder& finder) {
    const SegmentRecord& film = round.round.film;
    Json urls = Json::object();
    Json kinds = Json::array();
    for (const PictureKind& kind : list_film_kinds(round.round)) {
        bool is_kept = false;
        for (const CellAnalysis* cell : list_pictured_cells(round)) {
            Json frames = Json::array();
            bool has_frame = false;
            for (int frame = film.begin; frame < film.end; ++frame) {
                const auto url = finder.find_url(round.round.id, cell->cell.id, frame, kind);
                has_frame = has_frame || url;
                frames.push_back(url ? Json(*url) : Json());
            }
            if (has_frame) {
                is_kept = true;
                urls[kind.is_of_reference ? round.round.reference.id : cell->cell.id][kind.key] =
                    frames;
            }
            if (kind.is_of_reference) {
                break; // the same for all methods
            }
        }
        if (is_kept) {
            kinds.push_back(make_kind(kind));
        }
    }
    if (kinds.empty()) {
        return {};
    }
    return {{"begin", film.begin}, {"end", film.end}, {"kinds", kinds}, {"urls", urls}};
}

Json make_metrics(const RunAnalysis& analysis, const RoundAnalysis& round) {
    Json metrics = Json::array();
    for (const auto* names : {&round.metrics, &round.temporal_metrics, &round.history_numbers}) {
        for (const std::string& name : *names) {
            const MetricDescription* metric = analysis.find_metric(name);
            metrics.push_back({{"name", name},
                               {"title", metric == nullptr ? name : metric->title},
                               {"kind", metric == nullptr ? "image" : metric->kind},
                               {"lowerIsBetter", metric == nullptr || metric->lower_is_better},
                               {"frameFloors", make_frame_floors(round, name)}});
        }
    }
    return metrics;
}

Json make_events(const RoundRecord& round) {
    Json events = Json::array();
    for (const EventRecord& event : list_replayed_events(round)) {
        events.push_back({event.frame, event.label});
    }
    return events;
}

Json make_round(const RunAnalysis& analysis, const RoundAnalysis& round,
                const PictureFinder& finder) {
    Json segments = Json::array();
    for (const SegmentRecord& segment : round.round.segments) {
        segments.push_back({segment.begin, segment.end});
    }
    Json cells = Json::array();
    for (std::size_t i = 0; i < round.cells.size(); ++i) {
        cells.push_back(make_cell(round, round.cells[i], i));
    }
    return {{"id", round.round.id},
            {"width", round.round.width},
            {"height", round.round.height},
            {"segments", segments},
            {"events", make_events(round.round)},
            {"metrics", make_metrics(analysis, round)},
            {"frontMetric", round.front_metric},
            {"cells", cells},
            {"pictures", make_pictures(round, finder)},
            {"film", make_film(round, finder)}};
}

} // namespace

std::string make_page_data(const RunAnalysis& analysis, const PictureFinder& finder) {
    Json rounds = Json::array();
    for (const RoundAnalysis& round : analysis.rounds) {
        rounds.push_back(make_round(analysis, round, finder));
    }
    const Json data = {{"deviceClass", analysis.context.device_class}, {"rounds", rounds}};
    return escape_inline_json(data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

} // namespace alcove
