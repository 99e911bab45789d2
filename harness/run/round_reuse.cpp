#include "harness/run/round_reuse.hpp"

#include "harness/run/build_info.hpp"
#include "harness/run/environment.hpp"
#include "harness/run/metric_spec.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace alcove {
namespace {

constexpr const char* kReference = "reference";

std::string describe_segments(const RoundRecord& round) {
    std::string text = round.warm ? "warm" : "";
    for (const SegmentRecord& segment : round.segments) {
        text += text.empty() ? "" : " ";
        text += std::to_string(segment.begin) + ":" + std::to_string(segment.end);
    }
    return text;
}

/// What the walkthrough shows: geometry at every frame, and the cameras.
/// Which frames' pictures a capture holds: that of a pilot holds none.
std::string describe_pictures(const RoundRecord& round) {
    std::string text;
    for (const int frame : round.image_frames) {
        text += std::to_string(frame) + " ";
    }
    return text + "film " + std::to_string(round.film.begin) + ":" + std::to_string(round.film.end);
}

std::string hash_shown(const RoundStage& stage) {
    Hasher hasher;
    GeometryHash geometry;
    GeometryHash geometry_before;
    for (const RoundFrame& frame : stage.frames()) {
        hasher.add(geometry.get(stage.scene(), frame.view.time_s));
        hasher.add(geometry_before.get(stage.scene(), frame.view.previous_time_s));
        add_view(hasher, stage.scene(), frame.view);
        FrameView before = frame.view;
        before.camera = frame.view.previous_camera;
        add_view(hasher, stage.scene(), before);
        hasher.add(static_cast<int>(frame.view.history_valid)).add(frame.view.index);
    }
    return hasher.finish_hex();
}

std::string hash_lights_shown(const RoundStage& stage) {
    Hasher hasher;
    for (const RoundFrame& frame : stage.frames()) {
        hasher.add(hash_lights(stage.scene(), frame.view.time_s));
    }
    return hasher.finish_hex();
}

} // namespace

RoundReuse::RoundReuse(RoundStage& stage, std::filesystem::path run_folder)
    : m_stage(stage), m_run_folder(std::move(run_folder)),
      m_store(get_cache_folder()), m_audit{stage.plan().audit_share, stage.plan().audit_seed} {
    const bool has_methods =
        std::any_of(stage.round().cells.begin(), stage.round().cells.end(),
                    [](const CellRecord& cell) { return cell.role == CellRole::method; });
    if (!has_methods) {
        return;
    }
    add(kReference, describe_round());
    for (const CellRecord& cell : stage.round().cells) {
        if (cell.role == CellRole::method) {
            add(cell.id, describe_cell(cell));
        }
    }
}

CaptureIngredients RoundReuse::describe_round() const {
    const RoundRecord& round = m_stage.round();
    const PlanRecord& plan = m_stage.plan();
    const BuildInfo build = get_build_info();
    CaptureIngredients ingredients;
    std::string metrics;
    std::string metric_sources;
    for (const MetricDescription& metric : plan.metrics) {
        metrics += metric.name + " ";
        if (metric.kind != "history" && metric.kind != kStratumKind) {
            const MetricSpec spec = parse_metric_spec(metric.name, "metric of the plan");
            metric_sources += m_stage.units().metrics.find(spec.name).content_hash + " ";
        }
    }
    std::string reference = round.reference.method;
    for (const ParameterRecord& parameter : round.reference.parameters) {
        reference += " " + parameter.name + "=" + parameter.value;
    }
    ingredients.names = {
        {"scene", round.scene},
        {"walkthrough", round.walkthrough},
        {"frames", describe_segments(round)},
        {"pictures", describe_pictures(round)},
        {"size", std::to_string(round.width) + "x" + std::to_string(round.height)},
        {"precision", round.precision},
        {"target", round.target},
        {"reference", reference},
        {"rays", std::to_string(plan.reference_rays_per_half)},
        {"metrics", metrics},
    };
    ingredients.contents = {
        {std::string(kShownIngredient), hash_shown(m_stage)},
        {"sources of the reference",
         m_stage.units().methods.find(round.reference.method).content_hash},
        {"sources of metrics", Hasher().add(metric_sources).finish_hex()},
        {"sources that draw and capture", build.capture_id},
        {"compiler, driver and processor", describe_drawing(m_stage.context())},
    };
    if (m_stage.measures_pictures()) {
        ingredients.contents.push_back({"lights", hash_lights_shown(m_stage)});
    }
    return ingredients;
}

CaptureIngredients RoundReuse::describe_cell(const CellRecord& cell) const {
    CaptureIngredients ingredients = describe_round();
    std::string parameters;
    for (const ParameterRecord& parameter : cell.parameters) {
        parameters += parameter.name + "=" + parameter.value + " ";
    }
    ingredients.names.push_back({"method", cell.method});
    ingredients.names.push_back({"parameters", parameters});
    ingredients.names.push_back({"effects", cell.effects});
    ingredients.contents.push_back(
        {"sources of the method", m_stage.units().methods.find(cell.method).content_hash});
    return ingredients;
}

std::string RoundReuse::explain(const CaptureIngredients& ingredients) const {
    const std::optional<std::vector<IngredientRecord>> before =
        m_store.find_last_contents(ingredients);
    if (!before) {
        return "this cell was never captured here";
    }
    std::string changed;
    for (const IngredientRecord& now : ingredients.contents) {
        const auto then =
            std::find_if(before->begin(), before->end(),
                         [&now](const IngredientRecord& b) { return b.name == now.name; });
        if (then == before->end() || then->value != now.value) {
            changed += changed.empty() ? "changed since it was captured last: " : ", ";
            changed += now.name;
        }
    }
    return changed.empty() ? "nothing changed, but the cache no longer has it" : changed;
}

void RoundReuse::add(const std::string& cell, CaptureIngredients ingredients) {
    Item item;
    item.cell = cell;
    item.ingredients = std::move(ingredients);
    const std::string key = item.ingredients.make_key();
    if (!m_store.has(key)) {
        item.reason = explain(item.ingredients);
    } else if (m_audit.draws(key)) {
        item.outcome = Outcome::audited;
        item.reason = "nothing changed; drawn by the audit and made again";
    } else if (std::optional<std::vector<MetricRow>> rows =
                   m_store.restore(key, m_stage.round(), cell, get_pictures(cell))) {
        item.outcome = Outcome::reused;
        item.reason = "nothing changed";
        item.restored = std::move(*rows);
    } else {
        item.reason = "the cache's entry is damaged";
    }
    m_items.push_back(std::move(item));
}

std::filesystem::path RoundReuse::get_pictures(const std::string& cell) const {
    return m_run_folder / std::filesystem::path(
                              RunFolder::make_image_path(m_stage.round().id, cell, 0, "visibility"))
                              .parent_path();
}

bool RoundReuse::is_wanted(const std::string& cell) const {
    return std::any_of(m_items.begin(), m_items.end(), [&cell](const Item& item) {
        return item.cell == cell && item.outcome != Outcome::reused;
    });
}

bool RoundReuse::is_anything_wanted() const {
    return std::any_of(m_items.begin(), m_items.end(),
                       [](const Item& item) { return item.outcome != Outcome::reused; });
}

void RoundReuse::finish(std::vector<MetricRow>& rows, RoundDone& done) {
    for (Item& item : m_items) {
        const std::filesystem::path pictures = get_pictures(item.cell);
        const char* outcome = "made";
        switch (item.outcome) {
        case Outcome::made:
            m_store.store(item.ingredients, rows, item.cell, pictures);
            break;
        case Outcome::audited:
            m_store.compare(item.ingredients.make_key(), rows, item.cell, pictures);
            ++done.audited;
            outcome = "audited";
            break;
        case Outcome::reused:
            rows.insert(rows.end(), item.restored.begin(), item.restored.end());
            outcome = "reused";
            break;
        }
        done.reuse.push_back(
            {item.cell, outcome, item.reason, item.ingredients.names, item.ingredients.contents});
    }
    sort_rows(rows);
}

void RoundReuse::sort_rows(std::vector<MetricRow>& rows) const {
    std::map<std::string, std::size_t> places;
    for (const CellRecord& cell : m_stage.round().cells) {
        places.emplace(cell.id, places.size());
    }
    std::stable_sort(rows.begin(), rows.end(), [&places](const MetricRow& a, const MetricRow& b) {
        return std::tuple(a.state, a.segment, a.frame, places.at(a.cell)) <
               std::tuple(b.state, b.segment, b.frame, places.at(b.cell));
    });
}

} // namespace alcove
