#include "core/base/parameters.hpp"

#include "core/base/error.hpp"
#include "core/base/expression.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace alcove {
namespace {

std::string describe_range(const ParameterInfo& info) {
    std::string text = format_number(info.minimum) + " to " + format_number(info.maximum);
    if (info.may_be_infinite) {
        text += " or inf";
    }
    return text + " " + info.unit;
}

bool is_in_range(const ParameterInfo& info, double value) {
    if (info.may_be_infinite && value == std::numeric_limits<double>::infinity()) {
        return true;
    }
    return value >= info.minimum && value <= info.maximum;
}

/// Evaluates default expressions on demand, so that they may use each other in any order but not in
/// a circle.
class DefaultResolver {
  public:
    DefaultResolver(const ParameterTable& table, const ExpressionVariables& variables,
                    std::map<std::string, ResolvedParameter, std::less<>>& values)
        : m_table(table), m_variables(variables), m_values(values) {}

    double get_number(std::string_view name) {
        if (const auto variable = m_variables.find(name); variable != m_variables.end()) {
            return variable->second;
        }
        return to_number(get(m_table.find(name)).value);
    }

    const ResolvedParameter& get(const ParameterInfo& info) {
        if (const auto known = m_values.find(info.name); known != m_values.end()) {
            return known->second;
        }
        if (!m_in_progress.insert(info.name).second) {
            throw InputError(m_table.owner() + "." + info.name,
                             "default expressions depend on each other in a circle");
        }
        const double number = evaluate_expression(
            info.default_expression, [this](std::string_view name) { return get_number(name); });
        if (!is_in_range(info, number)) {
            throw InputError(m_table.owner() + "." + info.name,
                             "its default, " + info.default_expression + ", is out of range",
                             format_number(number), describe_range(info));
        }
        ResolvedParameter& resolved = m_values[info.name];
        resolved.name = info.name;
        if (info.kind == ParameterKind::integer) {
            resolved.value.emplace<std::int64_t>(std::llround(number));
        } else {
            resolved.value.emplace<double>(number);
        }
        return resolved;
    }

  private:
    const ParameterTable& m_table;
    const ExpressionVariables& m_variables;
    std::map<std::string, ResolvedParameter, std::less<>>& m_values;
    std::set<std::string, std::less<>> m_in_progress;
};

} // namespace

std::string_view to_text(Provenance provenance) {
    constexpr std::array kNames{"default", "target", "preset", "file", "command line"};
    return kNames.at(static_cast<std::size_t>(provenance));
}

double to_number(const ParameterValue& value) {
    if (const auto* integer_value = std::get_if<std::int64_t>(&value)) {
        return static_cast<double>(*integer_value);
    }
    if (const auto* boolean_value = std::get_if<bool>(&value)) {
        return *boolean_value ? 1.0 : 0.0;
    }
    const auto* real_value = std::get_if<double>(&value);
    ALCOVE_ASSERT(real_value != nullptr, "an enumeration is no number");
    return *real_value;
}

std::string to_text(const ParameterValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) {
        return *text;
    }
    if (const auto* boolean_value = std::get_if<bool>(&value)) {
        return *boolean_value ? "true" : "false";
    }
    if (const auto* integer_value = std::get_if<std::int64_t>(&value)) {
        return std::to_string(*integer_value);
    }
    return format_number(std::get<double>(value));
}

const ParameterValue& ResolvedParameters::get(std::string_view name) const {
    const auto found =
        std::find_if(m_values.begin(), m_values.end(),
                     [name](const ResolvedParameter& value) { return value.name == name; });
    ALCOVE_ASSERT(found != m_values.end(), "a declared parameter");
    return found->value;
}

std::string ResolvedParameters::to_text() const {
    std::string text;
    for (const ResolvedParameter& value : m_values) {
        text += text.empty() ? "" : ",";
        text += value.name + "=" + alcove::to_text(value.value);
    }
    return text;
}

ParameterTable::ParameterTable(std::string owner, std::vector<Entry> entries)
    : m_owner(std::move(owner)), m_entries(std::move(entries)) {
    std::set<std::string> names;
    for (const Entry& entry : m_entries) {
        const ParameterInfo& info = entry.info;
        ALCOVE_ASSERT(names.insert(info.name).second, "parameter names are unique");
        const bool is_number =
            info.kind == ParameterKind::integer || info.kind == ParameterKind::real;
        if (is_number && info.default_expression.empty()) {
            ALCOVE_ASSERT(is_in_range(info, to_number(info.default_value)), "default in range");
        }
        ALCOVE_ASSERT(is_number || info.default_expression.empty(),
                      "default expressions give numbers");
    }
}

const ParameterInfo& ParameterTable::find(std::string_view name) const {
    std::vector<std::string> names;
    for (const Entry& entry : m_entries) {
        if (entry.info.name == name) {
            return entry.info;
        }
        names.push_back(entry.info.name);
    }
    if (names.empty()) {
        throw InputError(m_owner, "has no parameters", name);
    }
    throw InputError(m_owner, "unknown parameter", name, describe_choices(name, names));
}

ParameterValue ParameterTable::parse(const ParameterInfo& info, std::string_view text) const {
    const std::string where = m_owner + "." + info.name;
    switch (info.kind) {
    case ParameterKind::boolean:
        if (text == "true" || text == "false") {
            return text == "true";
        }
        throw InputError(where, "not a switch", text, "true or false");
    case ParameterKind::enumeration:
        if (std::find(info.choices.begin(), info.choices.end(), text) != info.choices.end()) {
            return std::string(text);
        }
        throw InputError(where, "unknown choice", text, describe_choices(text, info.choices));
    case ParameterKind::integer: {
        const std::int64_t value = parse_integer(text, where);
        if (!is_in_range(info, static_cast<double>(value))) {
            throw InputError(where, "out of range", text, describe_range(info));
        }
        return value;
    }
    case ParameterKind::real:
        break;
    }
    const double value = parse_number(text, where);
    if (!is_in_range(info, value)) {
        throw InputError(where, "out of range", text, describe_range(info));
    }
    return value;
}

ResolvedParameters ParameterTable::resolve(std::span<const ParameterOverride> overrides,
                                           const ExpressionVariables& variables) const {
    std::map<std::string, ResolvedParameter, std::less<>> values;
    for (const Entry& entry : m_entries) {
        if (entry.info.default_expression.empty()) {
            values[entry.info.name] = {entry.info.name, entry.info.default_value};
        }
    }
    std::vector<ParameterOverride> ordered(overrides.begin(), overrides.end());
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const ParameterOverride& a, const ParameterOverride& b) {
                         return a.provenance < b.provenance;
                     });
    for (const ParameterOverride& override_value : ordered) {
        const ParameterInfo& info = find(override_value.name);
        values[info.name] = {info.name, parse(info, override_value.value),
                             override_value.provenance};
    }
    DefaultResolver resolver(*this, variables, values);
    std::vector<ResolvedParameter> resolved;
    for (const Entry& entry : m_entries) {
        resolved.push_back(resolver.get(entry.info));
    }
    return ResolvedParameters{std::move(resolved)};
}

ParameterTable describe_parameters(std::string owner,
                                   std::initializer_list<ParameterBuilder> builders) {
    std::vector<ParameterTable::Entry> entries;
    for (const ParameterBuilder& builder : builders) {
        entries.push_back(builder.entry());
    }
    return {std::move(owner), std::move(entries)};
}

std::string get_extreme(const ParameterInfo& info, bool maximum) {
    switch (info.kind) {
    case ParameterKind::boolean:
        return maximum ? "true" : "false";
    case ParameterKind::enumeration:
        return maximum ? info.choices.back() : info.choices.front();
    case ParameterKind::integer:
    case ParameterKind::real:
        break;
    }
    if (maximum && info.may_be_infinite) {
        return "inf";
    }
    return format_number(maximum ? info.maximum : info.minimum);
}

} // namespace alcove
