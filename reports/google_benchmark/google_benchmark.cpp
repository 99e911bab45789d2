#include "reports/google_benchmark/google_benchmark.hpp"

#include "reports/analysis/cell_series.hpp"
#include "reports/analysis/comparison_matching.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace alcove {
namespace {

using Json = nlohmann::ordered_json;

Json make_context(const RunFolder& run) {
    const ContextRecord& context = run.context();
    return {
        {"date", context.started_utc},
        {"executable", "alcove"},
        {"num_cpus", context.cpu_threads},
        {"library_build_type", context.build_type == "Debug" ? "debug" : "release"},
        {"build_id", context.build_id},
        {"device_class", context.device_class},
        {"renderer", context.gl_renderer},
        {"driver", context.gl_version},
        {"cpu", context.cpu},
        {"timer", context.timer_mode},
        {"note", "cpu_time repeats real_time, which readers insist on: CPU time is not measured. "
                 "Of times of different devices nothing follows."},
    };
}

/// Entries of one series, named by where it was measured.
class Entries {
  public:
    Entries(const RunFolder& run, Json& entries) : m_run(run), m_entries(entries) {}

    void add(const std::string& name, const Series& series, const Series* anchor) {
        const std::map<int, double> medians = series.compute_repeat_medians_ms();
        std::map<int, double> ratios;
        if (anchor != nullptr) {
            ratios = compute_log_ratios(series, *anchor);
        }
        const std::size_t index = m_families++;
        const auto make = [&](const char* type) {
            return Json{
                {"name", name},     {"family_index", index}, {"per_family_instance_index", 0},
                {"run_name", name}, {"run_type", type},      {"repetitions", medians.size()}};
        };
        for (const auto& [repeat, time_ms] : medians) {
            Json entry = make("iteration");
            entry["repetition_index"] = repeat;
            entry["iterations"] = series.times_ns().size();
            if (const auto ratio = ratios.find(repeat); ratio != ratios.end()) {
                entry["x_anchor"] = std::exp(ratio->second);
            }
            finish(std::move(entry), time_ms);
        }
        const std::vector<double> times = get_values(medians);
        if (times.size() < 2) {
            return;
        }
        const auto aggregate = [&](const char* what, double time_ms) {
            Json entry = make("aggregate");
            entry["name"] = name + "_" + what;
            entry["aggregate_name"] = what;
            entry["aggregate_unit"] = "time";
            entry["iterations"] = times.size();
            finish(std::move(entry), time_ms);
        };
        aggregate("mean", compute_mean(times));
        aggregate("median", compute_median(times));
        aggregate("stddev", compute_standard_deviation(times));
    }

  private:
    void finish(Json entry, double time_ms) {
        entry["threads"] = 1;
        entry["real_time"] = time_ms;
        entry["cpu_time"] = time_ms;
        entry["time_unit"] = "ms";
        entry["label"] = m_run.context().device_class;
        m_entries.push_back(std::move(entry));
    }

    const RunFolder& m_run;
    Json& m_entries;
    std::size_t m_families = 0;
};

void add_round(const RoundRecord& round, RoundSeries series, Entries& entries) {
    const auto anchor =
        std::find_if(round.cells.begin(), round.cells.end(),
                     [](const CellRecord& cell) { return cell.role == CellRole::anchor; });
    const CellSeries unit = anchor == round.cells.end() ? CellSeries() : series.cells[anchor->id];
    for (const CellRecord& cell : round.cells) {
        const CellSeries& times = series.cells[cell.id];
        if (cell.role != CellRole::method || !cell.has_passes || times.envelope.empty()) {
            continue;
        }
        const std::string name = cell.label + "/" + describe_place(round);
        entries.add(name, times.envelope, &unit.envelope);
        for (const std::string& pass : times.pass_order) {
            if (!is_input_pass(pass)) {
                entries.add(fmt::format("{}/pass:{}", name, pass), times.passes.at(pass), nullptr);
            }
        }
    }
}

} // namespace

std::string make_google_benchmark_json(const RunFolder& run) {
    std::map<std::string, std::vector<SampleRow>> samples;
    for (SampleRow& row : run.read_samples()) {
        samples[row.round].push_back(std::move(row));
    }
    Json entries = Json::array();
    Entries adder(run, entries);
    for (const RoundRecord& round : run.plan().rounds) {
        add_round(round, sort_samples(samples[round.id]), adder);
    }
    const Json file{{"context", make_context(run)}, {"benchmarks", entries}};
    return file.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace alcove
