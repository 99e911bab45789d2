#include "tests/reports/forged_reproduction.hpp"

#include "harness/run/experiment_file.hpp"
#include "harness/run/plan.hpp"
#include "reports/papers/paper_files.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace alcove {
namespace {

template <class Value>
Value find_or(const std::map<std::string, Value>& values, const std::string& place,
              const std::string& label, Value other) {
    for (const std::string& key : {place + label, label}) {
        const auto found = values.find(key);
        if (found != values.end()) {
            return found->second;
        }
    }
    return other;
}

std::string describe_place(const std::string& part, std::size_t round) {
    return part + ":" + std::to_string(round) + ":";
}

std::vector<MetricRow> forge_metrics(const PlanRecord& plan, std::size_t index,
                                     const Planted& planted) {
    const RoundRecord& round = plan.rounds[index];
    const std::string place = describe_place(plan.experiment, index);
    std::vector<MetricRow> rows;
    for (std::size_t s = 0; s < round.segments.size(); ++s) {
        for (int frame = round.segments[s].begin; frame < round.segments[s].end; ++frame) {
            for (const CellRecord& cell : round.cells) {
                for (const MetricDescription& metric : plan.metrics) {
                    MetricRow row;
                    row.round = round.id;
                    row.cell = cell.id;
                    row.segment = static_cast<int>(s);
                    row.frame = frame;
                    row.metric = metric.name;
                    row.value = find_or(planted.error, place, cell.label, 0.05) *
                                (1.0 + 0.001 * std::sin(3.0 * frame));
                    row.image_hash = find_or(planted.image_hash, place, cell.label, std::string());
                    rows.push_back(row);
                }
            }
        }
    }
    return rows;
}

} // namespace

std::vector<SampleRow> ForgedRuns::forge_samples(const PlanRecord& plan, std::size_t index,
                                                 const Planted& planted) const {
    const RoundRecord& round = plan.rounds[index];
    const std::string place = describe_place(plan.experiment, index);
    std::vector<SampleRow> rows;
    SampleRow row;
    row.round = round.id;
    const auto add = [&](const std::string& cell, const std::string& pass, double ns) {
        row.cell = cell;
        row.pass = pass;
        row.time_ns = static_cast<std::int64_t>(ns);
        rows.push_back(row);
    };
    for (std::size_t s = 0; s < round.segments.size(); ++s) {
        row.segment = static_cast<int>(s);
        for (row.frame = round.segments[s].begin; row.frame < round.segments[s].end; ++row.frame) {
            for (row.repeat = 0; row.repeat < plan.repeats; ++row.repeat) {
                const double scatter = 1.0 + 0.001 * std::sin(7.0 * row.repeat + row.frame);
                row.kind = SampleKind::divided;
                add("harness", "input/base", 10e6);
                for (const CellRecord& cell : round.cells) {
                    const double ns =
                        1e6 * scatter * find_or(planted.cost_ms, place, cell.label, 4.0);
                    row.kind = SampleKind::divided;
                    add(cell.id, "harness/compose", 0.0);
                    if ((row.repeat + row.frame) % 2 == 0) {
                        row.kind = SampleKind::envelope;
                        add(cell.id, "envelope", ns);
                        continue;
                    }
                    for (const std::string& pass : m_passes) {
                        add(cell.id, pass, ns / static_cast<double>(m_passes.size()));
                    }
                }
            }
        }
    }
    return rows;
}

ForgedRuns::ForgedRuns(const std::string& paper, std::vector<std::string> passes)
    : m_passes(std::move(passes)) {
    const Units units = get_units();
    for (const EmbeddedFile& file : embedded_papers()) {
        const std::filesystem::path path(file.name);
        if (path.extension() == ".toml" && path.parent_path().filename() == paper) {
            const Experiment part = parse_experiment(file.text, std::string(file.name),
                                                     std::filesystem::current_path(), units);
            m_plans.emplace(part.name, make_plan(part, units).record);
        }
    }
}

Evidence ForgedRuns::forge(const Planted& planted) {
    Evidence evidence;
    for (const auto& [part, plan] : m_plans) {
        RunFolder run = RunFolder::create(m_folder.path() / std::to_string(m_runs++),
                                          synthetic::make_context(), plan);
        for (std::size_t i = 0; i < plan.rounds.size(); ++i) {
            run.finish_round(plan.rounds[i].id, forge_samples(plan, i, planted),
                             forge_metrics(plan, i, planted), {});
        }
        evidence.add(part, run);
    }
    return evidence;
}

Outcome find_outcome(const Reproduction& reproduction, const std::string& id) {
    for (const ClaimVerdict& verdict : reproduction.verdicts) {
        if (verdict.claim.id == id) {
            return verdict.outcome;
        }
    }
    ADD_FAILURE() << id;
    return Outcome::not_testable;
}

} // namespace alcove
