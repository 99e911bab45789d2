#include "core/base/error.hpp"
#include "core/base/parameters_markdown.hpp"
#include "core/base/text.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/experiment_file.hpp"
#include "harness/run/plan.hpp"
#include "scenes/common/lighting.hpp"

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alcove {
namespace {

using Json = nlohmann::ordered_json;

struct ListFlags {
    std::string what;
    bool json = false;
    bool markdown = false;
};

Json describe_parameters_json(const ParameterTable& table) {
    Json list = Json::array();
    for (const ParameterTable::Entry& entry : table.entries()) {
        const ParameterInfo& info = entry.info;
        Json item;
        item["name"] = info.name;
        item["symbol"] = info.symbol;
        item["unit"] = info.unit;
        item["default"] = info.default_expression.empty() ? to_text(info.default_value)
                                                          : "= " + info.default_expression;
        const bool is_number =
            info.kind == ParameterKind::integer || info.kind == ParameterKind::real;
        if (is_number) {
            item["minimum"] = info.minimum;
            item["maximum"] = info.maximum;
            item["may_be_infinite"] = info.may_be_infinite;
            item["scale"] = info.scale == ParameterScale::log ? "log" : "linear";
        } else if (!info.choices.empty()) {
            item["choices"] = info.choices;
        }
        item["meaning"] = info.meaning;
        item["source"] = info.source;
        list.push_back(std::move(item));
    }
    return list;
}

Json list_methods(const Units& units) {
    Json list = Json::array();
    for (const MethodUnit& unit : units.methods.units()) {
        Json item{{"name", unit.name},
                  {"title", unit.title},
                  {"citation", unit.citation},
                  {"reported", unit.reported}};
        for (const Preset& preset : unit.presets) {
            item["presets"].push_back({{"name", preset.name}, {"meaning", preset.meaning}});
        }
        list.push_back(std::move(item));
    }
    return list;
}

Json list_scenes(const Units& units) {
    Json list = Json::array();
    for (const SceneUnit& unit : units.scenes.units()) {
        const std::optional<std::string> obstacle = unit.find_obstacle();
        list.push_back({{"name", unit.name},
                        {"title", unit.title},
                        {"stresses", unit.stresses},
                        {"license", unit.license},
                        {"reported", unit.reported},
                        {"obstacle", obstacle.value_or("")}});
    }
    return list;
}

Json list_metrics(const Units& units) {
    Json list = Json::array();
    for (const MetricUnit& unit : units.metrics.units()) {
        list.push_back(
            {{"name", unit.name},
             {"title", unit.title},
             {"over_time", unit.is_temporal()},
             {"unit", unit.unit},
             {"direction", unit.direction == Direction::lower_is_better ? "lower is better"
                                                                        : "higher is better"},
             {"definition", unit.definition},
             {"blind_to", unit.blind_to},
             {"reported", unit.reported}});
    }
    return list;
}

Json list_effects() {
    Json list = Json::array();
    for (const EffectInfo& info : kEffects) {
        list.push_back({{"name", info.name},
                        {"title", info.meaning},
                        {"left_out_where", info.rule},
                        {"reported", true}});
    }
    return list;
}

Json list_shipped_experiments(const Units& units) {
    Json list = Json::array();
    for (const std::string& name : list_experiments()) {
        list.push_back(
            {{"name", name}, {"title", load_experiment(name, units).title}, {"reported", true}});
    }
    return list;
}

Json list_parameters(const Units& units) {
    Json object = Json::object();
    for (const MethodUnit& unit : units.methods.units()) {
        object[unit.name] = describe_parameters_json(unit.parameters);
    }
    for (const MetricUnit& unit : units.metrics.units()) {
        object[unit.name] = describe_parameters_json(unit.parameters);
    }
    for (const SceneUnit& unit : units.scenes.units()) {
        object[unit.name] = describe_parameters_json(unit.parameters);
    }
    object[lighting_table().owner()] = describe_parameters_json(lighting_table());
    return object;
}

void print_units(const Json& list) {
    for (const Json& item : list) {
        if (!item.at("reported").get<bool>()) {
            continue;
        }
        fmt::print("{:<24}{}{}\n", item.at("name").get<std::string>(),
                   item.at("title").get<std::string>(),
                   item.value("over_time", false) ? " (over time)" : "");
        for (const char* key : {"stresses", "blind_to", "obstacle", "left_out_where"}) {
            if (item.contains(key) && !item.at(key).get<std::string>().empty()) {
                fmt::print("{:<24}{}: {}\n", "", key, item.at(key).get<std::string>());
            }
        }
        if (item.contains("presets")) {
            for (const Json& preset : item.at("presets")) {
                fmt::print("  @{:<21}{}\n", preset.at("name").get<std::string>(),
                           preset.at("meaning").get<std::string>());
            }
        }
    }
}

void print_parameters(const Json& object) {
    for (const auto& [unit, parameters] : object.items()) {
        for (const Json& item : parameters) {
            fmt::print("{:<44}{:<20}{:<24}{}\n", unit + "." + item.at("name").get<std::string>(),
                       item.at("default").get<std::string>(), item.at("unit").get<std::string>(),
                       item.at("meaning").get<std::string>());
        }
    }
}

/// The tables that stand between the marks of the units' READMEs.
void print_markdown(const Units& units) {
    const auto print = [](const ParameterTable& table) {
        if (!table.entries().empty()) {
            fmt::print("{}\n\n{}\n", table.owner(), make_markdown_table(table));
        }
    };
    for (const MethodUnit& unit : units.methods.units()) {
        print(unit.parameters);
    }
    for (const MetricUnit& unit : units.metrics.units()) {
        print(unit.parameters);
    }
    for (const SceneUnit& unit : units.scenes.units()) {
        print(unit.parameters);
    }
    print(lighting_table());
}

int list(const ListFlags& flags) {
    const Units units = get_units();
    if (flags.markdown) {
        if (flags.what != "parameters") {
            throw InputError("list --markdown", "only parameters have tables", flags.what);
        }
        print_markdown(units);
        return 0;
    }
    const std::vector<std::string> choices{"methods",    "scenes",  "metrics",
                                           "parameters", "effects", "experiments"};
    Json result;
    if (flags.what == "methods") {
        result = list_methods(units);
    } else if (flags.what == "scenes") {
        result = list_scenes(units);
    } else if (flags.what == "metrics") {
        result = list_metrics(units);
    } else if (flags.what == "parameters") {
        result = list_parameters(units);
    } else if (flags.what == "effects") {
        result = list_effects();
    } else if (flags.what == "experiments") {
        result = list_shipped_experiments(units);
    } else {
        throw InputError("list", "unknown kind", flags.what, describe_choices(flags.what, choices));
    }
    if (flags.json) {
        fmt::print("{}\n", result.dump(2));
    } else if (flags.what == "parameters") {
        print_parameters(result);
    } else {
        print_units(result);
    }
    return 0;
}

} // namespace

Action add_list_verb(CLI::App& app) {
    auto flags = std::make_shared<ListFlags>();
    app.add_option("what", flags->what,
                   "methods, scenes, metrics, parameters, effects or experiments")
        ->required();
    app.add_flag("--json", flags->json, "as JSON");
    app.add_flag("--markdown", flags->markdown, "parameters as the tables of the units' READMEs");
    return [flags] { return list(*flags); };
}

} // namespace alcove
