#include "reports/csv/comparison_csv.hpp"

#include "core/base/text.hpp"
#include "reports/record/csv.hpp"

namespace alcove {
namespace {

using Fields = std::vector<std::string>;

const Fields kColumns = {
    "scene",          "walkthrough", "width",      "height",    "target",         "label",
    "method",         "base_round",  "next_round", "kind",      "name",           "column",
    "verdict",        "base",        "next",       "change",    "change_unit",    "change_lower95",
    "change_upper95", "change_min",  "change_max", "n",         "unit",           "margin",
    "p_value",        "p_holm",      "p_bh",       "rank_test", "p_rank",         "p_rank_holm",
    "p_ks",           "p_ks_holm",   "cached",     "images",    "images_changed", "note"};

/// What differs between the kinds of lines.
struct Line {
    std::string kind;
    std::string name;
    std::string column;
    std::optional<Verdict> verdict;
    std::optional<double> base;
    std::optional<double> next;
    std::optional<Estimate> change;
    std::string change_unit; ///< "ratio", "anchors", "metric"
    std::string unit;        ///< what n counts
    std::optional<double> margin;
    std::optional<double> p_value;
    std::optional<double> p_holm;
    std::optional<double> p_bh;
    std::optional<RankEvidence> ranks;
    bool is_cached = false;
    std::string note;
};

std::string format(const std::optional<double>& value) {
    return value ? format_number(*value) : std::string();
}

void append_line(std::string& text, const CellComparison& cell, const Line& line) {
    const auto end = [&](double Interval::*member) {
        return line.change && line.change->interval
                   ? format_number((*line.change->interval).*member)
                   : std::string();
    };
    const auto part = [&](double Estimate::*member) {
        return line.change ? format_number((*line.change).*member) : std::string();
    };
    const auto rank = [&](double RankEvidence::*member) {
        return line.ranks ? format_number((*line.ranks).*member) : std::string();
    };
    append_csv_line(text, {cell.round.scene,
                           cell.round.walkthrough,
                           std::to_string(cell.round.width),
                           std::to_string(cell.round.height),
                           cell.round.target,
                           cell.base.label,
                           cell.base.method,
                           cell.round.id,
                           cell.next_round,
                           line.kind,
                           line.name,
                           line.column,
                           line.verdict ? std::string(to_text(*line.verdict)) : std::string(),
                           format(line.base),
                           format(line.next),
                           part(&Estimate::value),
                           line.change_unit,
                           end(&Interval::lower),
                           end(&Interval::upper),
                           part(&Estimate::minimum),
                           part(&Estimate::maximum),
                           line.change ? std::to_string(line.change->n) : "0",
                           line.unit,
                           format(line.margin),
                           format(line.p_value),
                           format(line.p_holm),
                           format(line.p_bh),
                           line.ranks ? line.ranks->test : std::string(),
                           rank(&RankEvidence::p_value),
                           rank(&RankEvidence::adjusted_p_value),
                           line.ranks ? format(line.ranks->ks_p_value) : std::string(),
                           line.ranks ? format(line.ranks->ks_adjusted_p_value) : std::string(),
                           line.is_cached ? "1" : "0",
                           std::to_string(cell.images.images),
                           std::to_string(cell.images.changed),
                           line.note});
}

Line make_time_line(const TimeComparison& time) {
    Line line;
    line.kind = "time";
    line.name = "envelope";
    line.column = "cold";
    line.verdict = time.verdict;
    line.base = time.base.value;
    line.next = time.next.value;
    line.change = time.change;
    line.change_unit = "ratio";
    line.unit = "repeats";
    line.margin = time.margin;
    line.p_value = time.p_value;
    line.p_holm = time.adjusted_p_value;
    line.p_bh = time.discovery_p_value;
    line.ranks = time.ranks;
    line.note = time.is_taken_back ? "taken back: the tests by ranks see nothing" : "";
    return line;
}

Line make_part_line(const PartComparison& part) {
    Line line;
    line.kind = "part";
    line.name = part.part;
    const auto get = [](const std::optional<Estimate>& estimate) {
        return estimate ? std::optional(estimate->value) : std::nullopt;
    };
    line.base = get(part.base);
    line.next = get(part.next);
    line.change = part.difference;
    line.change_unit = "anchors";
    line.unit = "repeats";
    line.is_cached = part.is_cached;
    return line;
}

Line make_quality_line(const QualityComparison& quality) {
    Line line;
    line.kind = quality.verdict ? "metric" : "history";
    line.name = quality.metric;
    line.column = to_text(quality.column);
    line.verdict = quality.verdict;
    line.change_unit = "metric";
    line.unit = quality.is_by_segment ? "segments" : "frames";
    line.note = quality.note;
    if (quality.frames > 0) {
        line.base = quality.base;
        line.next = quality.next;
        line.change = quality.difference;
        line.margin = quality.margin;
        line.p_value = quality.p_value;
        line.p_bh = quality.discovery_p_value;
    }
    return line;
}

} // namespace

std::string make_comparison_csv(const Comparison& comparison) {
    std::string text;
    append_csv_line(text, kColumns);
    for (const CellComparison& cell : comparison.cells) {
        if (cell.time) {
            append_line(text, cell, make_time_line(*cell.time));
        }
        for (const QualityComparison& quality : cell.quality) {
            append_line(text, cell, make_quality_line(quality));
        }
        for (const PartComparison& part : cell.parts) {
            append_line(text, cell, make_part_line(part));
        }
    }
    return text;
}

} // namespace alcove
