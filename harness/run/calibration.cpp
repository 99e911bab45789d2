#include "harness/run/calibration.hpp"

#include "core/base/error.hpp"
#include "core/base/expression.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "harness/run/strict_toml.hpp"

#include <cmath>

namespace alcove {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 20;

bool is_number(const ParameterInfo& info) {
    return info.kind == ParameterKind::integer || info.kind == ParameterKind::real;
}

} // namespace

ParameterOverride evaluate_calibrated(const ParameterTable& table, const ParameterOverride& value,
                                      const ExpressionVariables& variables) {
    const ParameterInfo& info = table.find(value.name);
    ParameterOverride result{value.name, value.value, Provenance::file};
    if (is_number(info) && value.value != "inf") {
        const double number = evaluate_expression(value.value, [&](std::string_view name) {
            const auto found = variables.find(name);
            if (found == variables.end()) {
                throw InputError(table.owner() + "." + info.name, "unknown name in an expression",
                                 name, "scene_radius");
            }
            return found->second;
        });
        result.value = info.kind == ParameterKind::integer ? std::to_string(std::llround(number))
                                                           : format_number(number);
    }
    static_cast<void>(table.parse(info, result.value));
    return result;
}

void load_calibration(MethodSpec& spec, const Registry<MethodUnit>& methods,
                      const std::function<std::filesystem::path(const std::string&)>& resolve) {
    if (!spec.preset.ends_with(".toml")) {
        return;
    }
    const MethodUnit& unit = methods.find(spec.method);
    const std::string name = spec.preset;
    TomlTable root = TomlTable::parse(read_file(resolve(name), kLargestFile), name);
    const std::string method = root.get_string("method").value_or("");
    if (method != spec.method) {
        throw InputError(root.where("method") + ": method", "the calibration of another method",
                         method, spec.method);
    }
    spec.preset = root.get_string("preset").value_or("default");
    static_cast<void>(unit.find_preset(spec.preset));
    auto parameters = root.get_table("parameters");
    if (!parameters || parameters->list_keys().empty()) {
        throw InputError(root.where(), "no parameters", {}, "[parameters] with name = value");
    }
    // Any radius in range does: what is read here is checked before a scene is opened.
    const ExpressionVariables variables{{"scene_radius", 1.0}};
    for (const std::string& key : parameters->list_keys()) {
        parameters->with_place(key, [&] {
            const std::vector<std::string> values = parameters->get_values(key).value();
            if (values.size() != 1) {
                throw InputError(key, "a calibration has one value a parameter",
                                 std::to_string(values.size()) + " values");
            }
            spec.calibrated.push_back({key, values.front(), Provenance::file});
            static_cast<void>(
                evaluate_calibrated(unit.parameters, spec.calibrated.back(), variables));
        });
    }
    // What is written for people, whatever it says.
    static_cast<void>(root.get_table("origin"));
    root.check_all_known();
    spec.settings = SettingsKind::calibrated;
}

std::string make_calibration_text(const std::string& method, const std::string& preset,
                                  const std::vector<ParameterOverride>& parameters) {
    std::string text = "method = \"" + method + "\"\npreset = \"" + preset + "\"\n\n[parameters]\n";
    for (const ParameterOverride& parameter : parameters) {
        text += parameter.name + " = \"" + parameter.value + "\"\n";
    }
    return text;
}

} // namespace alcove
