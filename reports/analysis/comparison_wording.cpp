#include "reports/analysis/comparison_wording.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace alcove {
namespace {

/// "+5.02 %"
std::string format_change(double ratio) {
    return fmt::format("{:+.2f} %", 100.0 * (ratio - 1.0));
}

std::string format_time_change(const TimeComparison& time) {
    const Estimate& change = time.change;
    if (!change.interval) {
        return fmt::format("{}, {}..{} (n={})", format_change(change.value),
                           format_change(change.minimum), format_change(change.maximum), change.n);
    }
    return fmt::format("{} [{}, {}] (n={})", format_change(change.value),
                       format_change(change.interval->lower), format_change(change.interval->upper),
                       change.n);
}

std::string format_signed(double value) {
    return (value > 0.0 ? "+" : "") + format_rounded(value);
}

std::string format_difference(const Estimate& difference, const char* units) {
    const double lower = difference.interval ? difference.interval->lower : difference.minimum;
    const double upper = difference.interval ? difference.interval->upper : difference.maximum;
    const std::string range =
        difference.interval ? fmt::format(" [{}, {}]", format_signed(lower), format_signed(upper))
                            : fmt::format(", {}..{}", format_signed(lower), format_signed(upper));
    return fmt::format("{}{} ({} {})", format_signed(difference.value), range, difference.n, units);
}

std::string join(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) {
        text += (text.empty() ? "" : ", ") + part;
    }
    return text;
}

std::string format_p_value(double p_value) {
    return p_value < 1e-4 ? "< 0.0001" : format_rounded(p_value, 2);
}

/// "MW 0.0043, KS 0.0043"
std::string describe_ranks(const RankEvidence& ranks) {
    if (!ranks.ks_adjusted_p_value) {
        return "W " + format_p_value(ranks.adjusted_p_value);
    }
    return "MW " + format_p_value(ranks.adjusted_p_value) + ", KS " +
           format_p_value(*ranks.ks_adjusted_p_value);
}

ComparisonRow make_time_row(const CellComparison& cell) {
    const TimeComparison& time = *cell.time;
    ComparisonRow row;
    row.verdict = time.verdict;
    row.cell = &cell;
    row.what = "time / anchor";
    row.base = describe_estimate(time.base);
    row.next = describe_estimate(time.next);
    row.change = format_time_change(time);
    row.margin = format_percent(time.margin);
    std::vector<std::string> notes;
    if (time.adjusted_p_value) {
        row.p_holm = format_p_value(*time.adjusted_p_value);
    } else {
        notes.emplace_back("under 5 repeats: no interval");
    }
    if (time.discovery_p_value) {
        row.p_bh = format_p_value(*time.discovery_p_value);
    }
    if (time.ranks) {
        row.ranks = describe_ranks(*time.ranks);
    }
    if (time.is_taken_back) {
        notes.emplace_back("taken back: the tests by ranks see nothing");
    }
    if (time.margin == time.detectable && time.detectable > 0.0) {
        notes.emplace_back("margin is the A/A noise");
    }
    row.note = join(notes);
    return row;
}

ComparisonRow make_quality_row(const CellComparison& cell, const QualityComparison& quality) {
    ComparisonRow row;
    row.verdict = quality.verdict;
    row.cell = &cell;
    row.what = fmt::format("{} {}", quality.metric, to_text(quality.column));
    row.note = quality.note;
    if (quality.frames == 0) {
        row.base = "-";
        row.next = "-";
        row.change = "-";
        return row;
    }
    row.base = format_rounded(quality.base);
    row.next = format_rounded(quality.next);
    row.change =
        format_difference(quality.difference, quality.is_by_segment ? "segments" : "frames");
    if (quality.discovery_p_value) {
        row.p_bh = format_p_value(*quality.discovery_p_value);
    }
    if (quality.verdict) {
        row.margin =
            format_rounded(quality.margin, 2) + (quality.is_margin_floor ? " (floor)" : " (1 %)");
    }
    return row;
}

ComparisonRow make_part_row(const CellComparison& cell, const PartComparison& part) {
    const auto format = [](const std::optional<Estimate>& estimate) {
        return estimate ? describe_estimate(*estimate) : std::string("-");
    };
    ComparisonRow row;
    row.cell = &cell;
    row.what = part.part + " / anchor";
    row.base = format(part.base);
    row.next = format(part.next);
    row.change = part.difference ? format_difference(*part.difference, "repeats") : "-";
    row.note = part.is_cached ? "cached" : "";
    return row;
}

int rank(const ComparisonRow& row) {
    return static_cast<int>(*row.verdict);
}

std::string describe_changed(const CellComparison& cell) {
    const ImageComparison& images = cell.images;
    std::string text =
        fmt::format("{} in {}: {} of {} images differ ({}{})", cell.base.label, cell.round.scene,
                    images.changed, images.images, join(images.first),
                    images.changed > images.first.size() ? ", ..." : "");
    if (images.pictures.empty()) {
        return text + "; no picture of them was kept by both runs";
    }
    double sum = 0.0;
    std::size_t measured = 0;
    for (const PictureChange& picture : images.pictures) {
        if (picture.mean_difference) {
            sum += *picture.mean_difference;
            ++measured;
        }
    }
    text += fmt::format("; pictures of {} were kept", images.pictures.size());
    if (measured > 0) {
        text += fmt::format(", mean |difference| {} codes of 255 (n={})",
                            format_rounded(sum / static_cast<double>(measured)), measured);
    }
    return text;
}

} // namespace

std::string describe_evidence(const ComparisonRow& row) {
    std::vector<std::string> parts;
    const auto add = [&](const char* name, const std::string& value) {
        if (!value.empty()) {
            parts.push_back(name + value);
        }
    };
    add("p ", row.p_holm);
    add("", row.ranks);
    add("BH ", row.p_bh);
    add("", row.note);
    return join(parts);
}

std::vector<ComparisonRow> list_verdicts(const Comparison& comparison) {
    std::vector<ComparisonRow> rows;
    for (const CellComparison& cell : comparison.cells) {
        if (cell.time) {
            rows.push_back(make_time_row(cell));
        }
        for (const QualityComparison& quality : cell.quality) {
            if (quality.verdict) {
                rows.push_back(make_quality_row(cell, quality));
            }
        }
    }
    std::stable_sort(rows.begin(), rows.end(), [](const ComparisonRow& a, const ComparisonRow& b) {
        return rank(a) < rank(b);
    });
    return rows;
}

std::vector<ComparisonRow> list_information(const Comparison& comparison) {
    std::vector<ComparisonRow> rows;
    for (const CellComparison& cell : comparison.cells) {
        for (const PartComparison& part : cell.parts) {
            rows.push_back(make_part_row(cell, part));
        }
        for (const QualityComparison& quality : cell.quality) {
            if (!quality.verdict) {
                rows.push_back(make_quality_row(cell, quality));
            }
        }
    }
    return rows;
}

std::string summarize_verdicts(const Comparison& comparison) {
    std::string text;
    for (const Verdict verdict :
         {Verdict::worse, Verdict::unknown, Verdict::better, Verdict::same}) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", comparison.count(verdict),
                            to_text(verdict));
    }
    return text;
}

std::string describe_discoveries(const Comparison& comparison) {
    const Discoveries count = comparison.count_discoveries();
    return fmt::format("discoveries among {} comparisons at a false share of {} "
                       "(Benjamini-Hochberg; decides nothing): {} of {} times, {} of {} metrics "
                       "over segments, {} of {} over frames, which resemble their neighbours",
                       count.tested(), format_percent(kFalseDiscoveryRate), count.times,
                       count.all_times, count.by_segment, count.all_by_segment, count.by_frame,
                       count.all_by_frame);
}

std::vector<std::string> describe_images(const Comparison& comparison) {
    std::vector<std::string> lines;
    std::size_t images = 0;
    for (const CellComparison& cell : comparison.cells) {
        images += cell.images.images;
        if (cell.images.changed > 0) {
            lines.push_back(describe_changed(cell));
        }
    }
    if (lines.empty()) {
        lines.push_back(images > 0 ? fmt::format("all {} images are identical", images)
                                   : "no image has a hash in either run");
    }
    return lines;
}

std::vector<std::string> describe_settings(const Comparison& comparison) {
    std::vector<std::string> lines;
    for (const CellComparison& cell : comparison.cells) {
        std::vector<std::string> changes;
        for (const ParameterChange& change : cell.parameters) {
            changes.push_back(fmt::format("{} {} -> {}", change.name, change.base.value_or("none"),
                                          change.next.value_or("none")));
        }
        if (!changes.empty()) {
            lines.push_back(fmt::format("{} in {}: same label, other settings: {}", cell.base.label,
                                        cell.round.scene, join(changes)));
        }
    }
    return lines;
}

std::vector<std::string> describe_unpaired(const Comparison& comparison) {
    std::vector<std::string> lines;
    for (const Unpaired& unpaired : comparison.unpaired) {
        lines.push_back(fmt::format("only {}: {}: {}", unpaired.is_base ? "BASE" : "NEW",
                                    unpaired.what, unpaired.reason));
    }
    return lines;
}

std::vector<std::string> describe_method(const Comparison& comparison) {
    const bool paired = comparison.options.paired;
    return {
        fmt::format("Times: NEW / BASE of the ratio to the anchor, {}, 95 % interval, p after Holm "
                    "over all times. worse: p at most 0.05 and the interval above the margin; "
                    "same: the interval inside it. Margin: {} or what the A/A pairs resolve.",
                    paired ? "repeats paired (taken in turns)" : "Welch across repeats",
                    format_percent(comparison.options.margin)),
        paired ? "W: Wilcoxon's signed ranks of the pairs. Above 0.05, better and worse are taken "
                 "back to unknown: under 6 pairs always."
               : "MW: Mann-Whitney, KS: Kolmogorov-Smirnov, after Holm over the two. With both "
                 "above 0.05, better and worse are taken back to unknown.",
        "Metrics: mean difference NEW - BASE on the same frames; the interval is spread over "
        "content, not noise: images are deterministic. Margin: 1 % of BASE or the reference's "
        "floor, the larger.",
        "Device " + describe_device(comparison.next.context) + ", timer " +
            comparison.next.context.timer_mode + ", anchor version " +
            comparison.next.context.anchor_version};
}

} // namespace alcove
