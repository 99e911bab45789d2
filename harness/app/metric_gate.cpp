#include "harness/app/metric_gate.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

namespace alcove {
namespace {

constexpr const char* kWhere = "--gate";

std::string_view trim(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) {
        return {};
    }
    return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

/// "flip.max" is an extra of "flip", but "flip:ppd=30.5" is none: an extra's name is a word.
std::string strip_extra(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    const auto is_word = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    };
    const bool has_extra =
        dot != std::string::npos && dot + 1 < name.size() && name[dot + 1] >= 'a' &&
        name[dot + 1] <= 'z' &&
        std::all_of(name.begin() + static_cast<std::ptrdiff_t>(dot) + 1, name.end(), is_word);
    return has_extra ? name.substr(0, dot) : name;
}

} // namespace

bool GateCondition::holds(double value) const {
    return (or_equal && value == bound) || (is_less ? value < bound : value > bound);
}

std::vector<GateCondition> parse_gate(std::string_view text) {
    std::vector<GateCondition> gate;
    for (std::string_view rest = text;;) {
        const std::size_t comparison = rest.find_first_of("<>");
        GateCondition condition;
        condition.metric = trim(rest.substr(0, comparison));
        if (comparison == std::string_view::npos || condition.metric.empty()) {
            throw InputError(kWhere, "cannot be read", trim(rest),
                             "METRIC<NUMBER,... with <, <=, > or >=");
        }
        condition.is_less = rest[comparison] == '<';
        std::string_view behind = rest.substr(comparison + 1);
        condition.or_equal = behind.starts_with('=');
        behind.remove_prefix(condition.or_equal ? 1 : 0);
        const std::size_t comma = behind.find(',');
        condition.bound = parse_number(trim(behind.substr(0, comma)), kWhere);
        const std::size_t used =
            comma == std::string_view::npos ? rest.size() : rest.size() - behind.size() + comma;
        condition.text = trim(rest.substr(0, used));
        gate.push_back(std::move(condition));
        if (comma == std::string_view::npos) {
            return gate;
        }
        rest.remove_prefix(used + 1);
    }
}

std::vector<std::string> list_gated_metrics(const std::vector<GateCondition>& gate,
                                            const std::vector<std::string>& chosen,
                                            const Registry<MetricUnit>& registry, bool may_be_key) {
    std::vector<std::string> names;
    for (const GateCondition& condition : gate) {
        const std::string name = strip_extra(condition.metric);
        const std::string unit = name.substr(0, name.find_first_of(":@"));
        const bool is_ours =
            std::any_of(registry.units().begin(), registry.units().end(),
                        [&unit](const MetricUnit& known) { return known.name == unit; });
        // A name that is no unit's is refused by choose_metrics, with the nearest one.
        const bool is_wanted = is_ours || !may_be_key;
        if (is_wanted && std::find(chosen.begin(), chosen.end(), name) == chosen.end() &&
            std::find(names.begin(), names.end(), name) == names.end()) {
            names.push_back(name);
        }
    }
    return names;
}

bool check_gate(const std::vector<GateCondition>& gate, const MetricMeans& means) {
    bool all = true;
    for (const GateCondition& condition : gate) {
        std::optional<MetricMean> found = means.find(condition.metric);
        if (!found) {
            // Without a value there are no extras.
            found = means.find(strip_extra(condition.metric));
            if (!found || found->values > 0) {
                std::vector<std::string> names;
                for (const MetricMean& mean : means.list()) {
                    names.push_back(mean.name);
                }
                throw InputError(kWhere, "nothing gave this metric", condition.metric,
                                 describe_choices(condition.metric, names));
            }
        }
        const std::optional<double> value = found->mean();
        if (!value || !condition.holds(*value)) {
            fmt::print(stderr, "alcove: gate not met: {} (is {})\n", condition.text,
                       value ? format_number(*value) : "undefined");
            all = false;
        }
    }
    return all;
}

} // namespace alcove
