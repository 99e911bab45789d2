#include "harness/app/metric_self_test.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/contract/temporal_metric.hpp"
#include "harness/run/external_metric.hpp"
#include "harness/run/metric_spec.hpp"

#include <cmath>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alcove {
namespace {

using Json = nlohmann::ordered_json;

struct CheckOutcome {
    std::string metric;
    std::string check;
    double expected = 0.0;
    std::optional<double> got;
    double tolerance = 0.0;
    std::string source;
    [[nodiscard]] bool holds() const { return got && std::abs(*got - expected) <= tolerance; }
};

/// `Check` is a MetricCheck or a TemporalCheck.
template <class Check>
CheckOutcome describe(const MetricUnit& unit, const Check& check, std::optional<double> got) {
    return {unit.name, check.name, check.expected, got, check.tolerance, check.source};
}

std::vector<CheckOutcome> run_checks(const MetricUnit& unit) {
    std::vector<CheckOutcome> outcomes;
    if (unit.is_temporal()) {
        const auto metric = unit.create_temporal(unit.parameters.resolve({}, {}));
        for (const TemporalCheck& check : unit.temporal_checks) {
            outcomes.push_back(describe(unit, check, check.run(*metric)));
        }
        return outcomes;
    }
    for (const MetricCheck& check : unit.checks) {
        const auto metric = unit.create(unit.parameters.resolve(check.parameters, {}));
        outcomes.push_back(describe(unit, check, evaluate_check(*metric, check).value));
    }
    return outcomes;
}

void print_line(const CheckOutcome& outcome) {
    fmt::print(
        "{:<20}{:<42}expected {:<12} got {:<12} difference {:<10} tolerance {:<9} {:<7} {}\n",
        outcome.metric, outcome.check, format_rounded(outcome.expected, 9),
        outcome.got ? format_rounded(*outcome.got, 9) : "none",
        outcome.got ? fmt::format("{:.1e}", *outcome.got - outcome.expected) : "-",
        fmt::format("{:.1e}", outcome.tolerance), outcome.holds() ? "ok" : "FAILED",
        outcome.source);
}

Json make_json(const CheckOutcome& outcome) {
    const auto number = [&](auto&& compute) { return outcome.got ? Json(compute()) : Json(); };
    return {{"metric", outcome.metric},
            {"check", outcome.check},
            {"expected", outcome.expected},
            {"got", number([&] { return *outcome.got; })},
            {"difference", number([&] { return *outcome.got - outcome.expected; })},
            {"tolerance", outcome.tolerance},
            {"holds", outcome.holds()},
            {"source", outcome.source}};
}

std::vector<const MetricUnit*> choose_units(const Registry<MetricUnit>& registry,
                                            const std::vector<std::string>& names) {
    std::vector<const MetricUnit*> units;
    for (const std::string& name : names) {
        if (is_external_metric(name)) {
            throw InputError("metric --self-test", "a program has no check values", name,
                             "a metric of Alcove's");
        }
    }
    check_metric_specs(registry, names, "--metric");
    std::set<std::string> seen;
    for (const std::string& name : names) {
        const MetricUnit* unit = resolve_metric(registry, parse_metric_spec(name, "--metric")).unit;
        if (seen.insert(unit->name).second) {
            units.push_back(unit);
        }
    }
    for (const MetricUnit& unit : registry.units()) {
        if (names.empty() && unit.reported) {
            units.push_back(&unit);
        }
    }
    return units;
}

} // namespace

void run_self_test(const Registry<MetricUnit>& registry, const std::vector<std::string>& names,
                   bool as_json) {
    Json checks = Json::array();
    int failed = 0;
    for (const MetricUnit* unit : choose_units(registry, names)) {
        for (const CheckOutcome& outcome : run_checks(*unit)) {
            failed += outcome.holds() ? 0 : 1;
            if (as_json) {
                checks.push_back(make_json(outcome));
            } else {
                print_line(outcome);
            }
        }
    }
    if (as_json) {
        fmt::print("{}\n", Json{{"checks", checks}, {"failed", failed}}.dump());
    }
    if (failed > 0) {
        throw FailureError("metric --self-test", std::to_string(failed) + " checks failed");
    }
}

} // namespace alcove
