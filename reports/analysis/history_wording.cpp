#include "reports/analysis/history_wording.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace alcove {
namespace {

std::string sign(double value) {
    return value < 0.0 ? "-" : "+";
}

/// "rmse cold worse", or why there is nothing to name.
std::string describe_moved(const Night& night, const SeriesName& cell, const char* what,
                           bool are_times) {
    std::string text;
    bool is_judged = false;
    for (const JudgedPoint& other : night.points) {
        const SeriesKind kind = other.point.kind;
        const bool is_metric = kind == SeriesKind::quality;
        const bool is_one = are_times ? !is_metric && kind != SeriesKind::images : is_metric;
        if (!is_one || !is_same_cell(other.point.name, cell)) {
            continue;
        }
        is_judged = is_judged || other.judged.fence.has_value();
        if (other.verdict < NightVerdict::unconfirmed) {
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                                describe_series(kind, other.point.name), to_text(other.verdict));
        }
    }
    if (!text.empty()) {
        return text;
    }
    return is_judged ? fmt::format("no {} moved", what)
                     : fmt::format("too little history to tell whether a {} moved", what);
}

std::string describe_note(const Night& night, const JudgedPoint& judged) {
    if (judged.verdict == NightVerdict::image_changed) {
        return fmt::format("was {}; {}; {}", judged.last_hash,
                           describe_moved(night, judged.point.name, "metric", false),
                           describe_moved(night, judged.point.name, "time", true));
    }
    if (judged.verdict == NightVerdict::too_little_history) {
        return judged.point.kind == SeriesKind::images
                   ? std::string("no earlier night of this segment")
                   : fmt::format("{} of {} differences", judged.judged.past_differences,
                                 kFewestDifferences);
    }
    if (judged.second) {
        const HistoryRule rule = get_rule(judged.point.kind);
        const double again = compute_difference(*judged.second, *judged.judged.baseline, rule);
        return "second measurement " + describe_change(judged.point.kind, to_change(again, rule));
    }
    return {};
}

} // namespace

std::string describe_series(SeriesKind kind, const SeriesName& name) {
    switch (kind) {
    case SeriesKind::time:
        return "time " + name.state;
    case SeriesKind::pass:
        return "pass " + name.pass;
    case SeriesKind::input:
        return name.pass;
    case SeriesKind::milliseconds:
        return "milliseconds " + name.state;
    case SeriesKind::quality:
        return name.metric + " " + name.state;
    default:
        return "images";
    }
}

std::string describe_place(const SeriesName& name) {
    return fmt::format("{} {}, frames {}, {}", name.scene, name.size, name.frames, name.target);
}

std::string describe_value(SeriesKind kind, double value) {
    switch (kind) {
    case SeriesKind::milliseconds:
        return format_rounded(value, 4) + " ms";
    case SeriesKind::quality:
        return format_rounded(value, 4);
    case SeriesKind::images:
        return fmt::format("{:.0f} images", value);
    default:
        return format_rounded(value, 4) + " x anchor";
    }
}

std::string describe_change(SeriesKind kind, double change) {
    return sign(change) + (has_logarithm(kind) ? format_percent(std::abs(change))
                                               : format_rounded(std::abs(change), 3));
}

NightLine describe_point(const Night& night, const JudgedPoint& judged) {
    NightLine line;
    line.judged = &judged;
    const SeriesKind kind = judged.point.kind;
    line.what = describe_series(kind, judged.point.name);
    line.tonight = describe_value(kind, judged.point.value);
    line.note = describe_note(night, judged);
    if (kind == SeriesKind::images) {
        line.tonight += ", hash " + judged.point.image_hash;
        return line;
    }
    const HistoryRule rule = get_rule(kind);
    if (judged.judged.baseline) {
        line.baseline = describe_value(kind, *judged.judged.baseline);
        line.change = describe_change(kind, to_change(*judged.judged.difference, rule));
    }
    if (judged.judged.fence) {
        line.fence = describe_change(kind, to_change(*judged.judged.fence, rule)).substr(1);
    }
    return line;
}

std::vector<NightLine> list_findings(const Night& night) {
    std::vector<NightLine> lines;
    for (const JudgedPoint& judged : night.points) {
        if (judged.verdict < NightVerdict::same) {
            lines.push_back(describe_point(night, judged));
        }
    }
    std::stable_sort(lines.begin(), lines.end(), [](const NightLine& a, const NightLine& b) {
        return a.judged->verdict < b.judged->verdict;
    });
    return lines;
}

std::string summarize_night(const Night& night) {
    std::string text;
    for (const NightVerdict verdict :
         {NightVerdict::slower, NightVerdict::worse, NightVerdict::image_changed,
          NightVerdict::faster, NightVerdict::better, NightVerdict::unconfirmed, NightVerdict::same,
          NightVerdict::too_little_history}) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", night.count(verdict),
                            to_text(verdict));
    }
    return text;
}

std::string describe_device(const StoredRun& run) {
    return fmt::format("{}, clock {}", run.device, run.timer_mode);
}

std::vector<std::string> describe_rules() {
    return {
        "times are gated as ratios to the anchor of the same frames; milliseconds never",
        fmt::format("baseline: median of the last {} nights since the last accepted step",
                    kBaselineNights),
        fmt::format("fence: Q3 + 3 IQR of the last {} absolute differences of the series itself; "
                    "under {} differences there is no verdict",
                    kFenceDifferences, kFewestDifferences),
        "slower, faster: beyond the fence in tonight's two measurements, on the same side; not "
        "repeated: in the first alone",
        fmt::format("metrics are deterministic on one device: their fence is at least {} of the "
                    "baseline",
                    format_number(kQualityFence)),
    };
}

} // namespace alcove
