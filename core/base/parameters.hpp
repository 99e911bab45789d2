#pragma once
// The parameter table: every knob of a unit is declared once, beside the plain struct it lives in.
// From the table come the command line, --help, range errors, sweep axes, provenance in the run,
// report columns, the README's table and the GLSL constants. A value out of range or an unknown
// name is an error, never a silent clamp: a benchmark must not run another experiment than the one
// it was asked for.

#include "core/base/assert.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace alcove {

enum class ParameterKind { integer, real, boolean, enumeration };
enum class ParameterScale { linear, log };

/// integer: int64, real: double, boolean: bool, enumeration: the choice's name.
using ParameterValue = std::variant<std::int64_t, double, bool, std::string>;

/// What is declared about one parameter.
struct ParameterInfo {
    std::string name;
    ParameterKind kind = ParameterKind::real;
    ParameterScale scale = ParameterScale::linear; ///< how sweeps step through the range
    bool may_be_infinite = false;     ///< `inf` is allowed although it is above `maximum`
    double minimum = 0.0;             ///< inclusive; numbers only
    double maximum = 0.0;             ///< inclusive; numbers only
    std::vector<std::string> choices; ///< enumerations only
    std::string unit;                 ///< "m", "samples", "px", "1"
    std::string symbol;               ///< the paper's, may be empty
    std::string meaning;
    std::string source;           ///< paper and section, or "ours"
    ParameterValue default_value; ///< taken from the struct's initialiser
    std::string
        default_expression; ///< replaces default_value if not empty, see evaluate_expression
    bool rebuild =
        false; ///< compiled into the shaders as a constant; otherwise part of the uniform block
    std::string inert_reason; ///< why this parameter cannot change an image; empty for all that do
    /// Settings of other parameters under which this one does something ("estimator=fox_compton");
    /// empty where the defaults do.
    std::string alive_with;
};

/// Where a value came from; later ones override earlier ones.
enum class Provenance { default_value, target, preset, file, command_line };
[[nodiscard]] std::string_view to_text(Provenance provenance);

struct ParameterOverride {
    std::string name;
    std::string value;
    Provenance provenance = Provenance::command_line;
};

struct ResolvedParameter {
    std::string name;
    ParameterValue value;
    Provenance provenance = Provenance::default_value;
};

/// A full set of values, in the order of the table.
class ResolvedParameters {
  public:
    ResolvedParameters() = default;
    explicit ResolvedParameters(std::vector<ResolvedParameter> values)
        : m_values(std::move(values)) {}
    [[nodiscard]] std::span<const ResolvedParameter> values() const noexcept { return m_values; }
    /// Asserts that the name is declared.
    [[nodiscard]] const ParameterValue& get(std::string_view name) const;
    /// "radius=0.5,samples=16": all of them, as a cell's identity.
    [[nodiscard]] std::string to_text() const;

  private:
    std::vector<ResolvedParameter> m_values;
};

[[nodiscard]] std::string to_text(const ParameterValue& value);
/// A switch is 0 or 1. Asserts that it is no enumeration.
[[nodiscard]] double to_number(const ParameterValue& value);

/// Names that default expressions may use beside other parameters, e.g. {"scene_radius", 0.5}.
using ExpressionVariables = std::map<std::string, double, std::less<>>;

/// The declarations of one unit, and how its struct is filled. Build it with describe_parameters.
class ParameterTable {
  public:
    struct Entry {
        ParameterInfo info;
        std::function<void(void*, const ParameterValue&)> set;
        std::function<ParameterValue(const void*)> get;
    };

    ParameterTable() = default;
    /// `owner` is what errors call the unit. Asserts that names are unique and defaults in range.
    ParameterTable(std::string owner, std::vector<Entry> entries);

    [[nodiscard]] const std::string& owner() const noexcept { return m_owner; }
    [[nodiscard]] std::span<const Entry> entries() const noexcept { return m_entries; }
    /// Throws InputError with the nearest name.
    [[nodiscard]] const ParameterInfo& find(std::string_view name) const;

    /// Reads and checks one value. Throws InputError naming unit, parameter, value and range.
    [[nodiscard]] ParameterValue parse(const ParameterInfo& info, std::string_view text) const;

    /// Defaults, then the overrides in the order of their provenance. Default expressions are
    /// evaluated last, over the values of the other parameters and `variables`. Throws InputError.
    [[nodiscard]] ResolvedParameters resolve(std::span<const ParameterOverride> overrides,
                                             const ExpressionVariables& variables) const;

    /// Fills a struct of the type the table was made for.
    template <class Params>
    [[nodiscard]] Params bind(const ResolvedParameters& resolved) const {
        Params params{};
        for (const Entry& entry : m_entries) {
            entry.set(&params, resolved.get(entry.info.name));
        }
        return params;
    }
    /// Reads a struct of the type the table was made for.
    template <class Params>
    [[nodiscard]] ResolvedParameters read(const Params& params) const {
        std::vector<ResolvedParameter> values;
        for (const Entry& entry : m_entries) {
            values.push_back({entry.info.name, entry.get(&params), Provenance::default_value});
        }
        return ResolvedParameters{std::move(values)};
    }

  private:
    std::string m_owner;
    std::vector<Entry> m_entries;
};

/// One declaration under construction: integer/real/boolean/choice(...).range(...).unit(...)...
class ParameterBuilder {
  public:
    explicit ParameterBuilder(ParameterTable::Entry entry) : m_entry(std::move(entry)) {}
    ParameterBuilder&& range(double minimum, double maximum) && {
        m_entry.info.minimum = minimum;
        m_entry.info.maximum = maximum;
        return std::move(*this);
    }
    ParameterBuilder&& log_scale() && {
        m_entry.info.scale = ParameterScale::log;
        return std::move(*this);
    }
    ParameterBuilder&& may_be_infinite() && {
        m_entry.info.may_be_infinite = true;
        return std::move(*this);
    }
    ParameterBuilder&& default_expression(std::string text) && {
        m_entry.info.default_expression = std::move(text);
        return std::move(*this);
    }
    ParameterBuilder&& rebuild() && {
        m_entry.info.rebuild = true;
        return std::move(*this);
    }
    ParameterBuilder&& inert(std::string reason) && {
        m_entry.info.inert_reason = std::move(reason);
        return std::move(*this);
    }
    ParameterBuilder&& alive_with(std::string settings) && {
        m_entry.info.alive_with = std::move(settings);
        return std::move(*this);
    }
    ParameterBuilder&& unit(std::string text) && {
        m_entry.info.unit = std::move(text);
        return std::move(*this);
    }
    ParameterBuilder&& symbol(std::string text) && {
        m_entry.info.symbol = std::move(text);
        return std::move(*this);
    }
    ParameterBuilder&& meaning(std::string text) && {
        m_entry.info.meaning = std::move(text);
        return std::move(*this);
    }
    ParameterBuilder&& source(std::string text) && {
        m_entry.info.source = std::move(text);
        return std::move(*this);
    }
    [[nodiscard]] const ParameterTable::Entry& entry() const { return m_entry; }

  private:
    ParameterTable::Entry m_entry;
};

template <class Params>
[[nodiscard]] ParameterBuilder integer(int Params::*field, std::string name) {
    ParameterTable::Entry entry;
    entry.info.name = std::move(name);
    entry.info.kind = ParameterKind::integer;
    entry.info.default_value = std::int64_t{Params{}.*field};
    entry.set = [field](void* object, const ParameterValue& value) {
        static_cast<Params*>(object)->*field = static_cast<int>(std::get<std::int64_t>(value));
    };
    entry.get = [field](const void* object) {
        return ParameterValue{std::int64_t{static_cast<const Params*>(object)->*field}};
    };
    return ParameterBuilder{std::move(entry)};
}

template <class Params>
[[nodiscard]] ParameterBuilder real(double Params::*field, std::string name) {
    ParameterTable::Entry entry;
    entry.info.name = std::move(name);
    entry.info.kind = ParameterKind::real;
    entry.info.default_value = Params{}.*field;
    entry.set = [field](void* object, const ParameterValue& value) {
        static_cast<Params*>(object)->*field = std::get<double>(value);
    };
    entry.get = [field](const void* object) {
        return ParameterValue{static_cast<const Params*>(object)->*field};
    };
    return ParameterBuilder{std::move(entry)};
}

template <class Params>
[[nodiscard]] ParameterBuilder boolean(bool Params::*field, std::string name) {
    ParameterTable::Entry entry;
    entry.info.name = std::move(name);
    entry.info.kind = ParameterKind::boolean;
    entry.info.unit = "switch";
    entry.info.default_value = Params{}.*field;
    entry.set = [field](void* object, const ParameterValue& value) {
        static_cast<Params*>(object)->*field = std::get<bool>(value);
    };
    entry.get = [field](const void* object) {
        return ParameterValue{static_cast<const Params*>(object)->*field};
    };
    return ParameterBuilder{std::move(entry)};
}

/// `choices[i]` names the enumerator with value i.
template <class Params, class Enum>
[[nodiscard]] ParameterBuilder choice(Enum Params::*field, std::string name,
                                      std::vector<std::string> choices) {
    ParameterTable::Entry entry;
    entry.info.name = std::move(name);
    entry.info.kind = ParameterKind::enumeration;
    entry.info.unit = "choice";
    entry.info.choices = choices;
    entry.info.default_value = choices.at(static_cast<std::size_t>(Params{}.*field));
    entry.set = [field, choices](void* object, const ParameterValue& value) {
        for (std::size_t i = 0; i < choices.size(); ++i) {
            if (choices[i] == std::get<std::string>(value)) {
                static_cast<Params*>(object)->*field = static_cast<Enum>(i);
            }
        }
    };
    entry.get = [field, choices](const void* object) {
        const auto index = static_cast<std::size_t>(static_cast<const Params*>(object)->*field);
        return ParameterValue{choices.at(index)};
    };
    return ParameterBuilder{std::move(entry)};
}

[[nodiscard]] ParameterTable describe_parameters(std::string owner,
                                                 std::initializer_list<ParameterBuilder> builders);

/// Smallest and largest value of a parameter as text, the ends of a sweep and of the contract
/// tests.
[[nodiscard]] std::string get_extreme(const ParameterInfo& info, bool maximum);

} // namespace alcove
