#include "harness/run/experiment_file.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/target.hpp"
#include "harness/run/calibration.hpp"
#include "harness/run/experiment_texts.hpp"
#include "harness/run/grid.hpp"
#include "harness/run/metric_spec.hpp"
#include "harness/run/scene_source.hpp"
#include "harness/run/strict_toml.hpp"

#include <algorithm>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 20;

void check_range(std::int64_t value, std::int64_t least, std::int64_t most, const TomlTable& table,
                 const std::string& key) {
    if (value < least || value > most) {
        throw InputError(table.where(key) + ": " + key, "out of range", std::to_string(value),
                         std::to_string(least) + " to " + std::to_string(most));
    }
}

class ExperimentReader {
  public:
    ExperimentReader(TomlTable root, fs::path folder, const Units& units)
        : m_root(std::move(root)), m_folder(std::move(folder)), m_units(units) {}

    Experiment read() {
        read_head();
        if (const std::optional<FrameChoice> frames = read_frames(m_root)) {
            m_experiment.frames = *frames;
        }
        read_scenes();
        read_axes();
        read_methods();
        m_root.check_all_known();
        return std::move(m_experiment);
    }

  private:
    void read_head() {
        if (const auto name = m_root.get_string("name")) {
            check_name(*name);
            m_experiment.name = *name;
        }
        m_experiment.title = m_root.get_string("title").value_or("");
        if (const auto repeats = m_root.get_integer("repeats")) {
            check_range(*repeats, 1, kMostRepeats, m_root, "repeats");
            m_experiment.repeats = static_cast<int>(*repeats);
        }
        read_repeat_rule();
        if (const auto seed = m_root.get_integer("seed")) {
            m_experiment.shuffle_seed = static_cast<std::uint64_t>(*seed);
        }
        if (const auto rays = m_root.get_integer("reference_rays_per_half")) {
            constexpr std::int64_t kMostRays = 1 << 16;
            check_range(*rays, 1, kMostRays, m_root, "reference_rays_per_half");
            m_experiment.reference_rays_per_half = static_cast<int>(*rays);
        }
        if (const auto effects = m_root.get_string("effects")) {
            m_root.with_place("effects",
                              [&] { m_experiment.effects = parse_effects_choice(*effects); });
        }
        if (const auto settings = m_root.get_strings("settings")) {
            m_root.with_place("settings",
                              [&] { m_experiment.settings = parse_settings(*settings); });
        }
        if (const auto explains = m_root.get_boolean("explain_errors")) {
            m_experiment.explains_errors = *explains;
        }
        if (const auto counts = m_root.get_boolean("count_fetches")) {
            m_experiment.counts_fetches = *counts;
        }
        if (const auto strata = m_root.get_boolean("strata")) {
            m_experiment.measures_strata = *strata;
        }
        if (const auto regions = m_root.get_strings("regions")) {
            m_experiment.regions = *regions;
        }
        if (const auto reference = m_root.get_string("reference")) {
            m_root.with_place("reference",
                              [&] { m_experiment.reference = read_spec(*reference, "reference"); });
        }
        if (const auto metrics = m_root.get_strings("metrics")) {
            m_root.with_place("metrics",
                              [&] { check_metric_specs(m_units.metrics, *metrics, "metrics"); });
            m_experiment.metrics = *metrics;
        }
    }

    /// A calibration that it names lies below the file's folder.
    [[nodiscard]] MethodSpec read_spec(const std::string& text, std::string_view key) const {
        MethodSpec spec = parse_method_spec(text, key);
        load_calibration(spec, m_units.methods, [this](const std::string& path) {
            return resolve_inside(m_folder, path);
        });
        check_method_spec(m_units.methods, spec);
        return spec;
    }

    void read_repeat_rule() {
        m_experiment.until_width = m_root.get_number("until_width");
        m_experiment.time_limit_s = m_root.get_number("time_limit_s");
        if (const auto most = m_root.get_integer("most_repeats")) {
            check_range(*most, 1, kMostRepeats, m_root, "most_repeats");
            m_experiment.most_repeats = static_cast<int>(*most);
        }
        const std::string key = m_experiment.until_width    ? "until_width"
                                : m_experiment.time_limit_s ? "time_limit_s"
                                                            : "most_repeats";
        m_root.with_place(key, [&] {
            check_repeats(m_experiment, {"until_width", "time_limit_s", "most_repeats"});
        });
    }

    /// It becomes part of a folder's name.
    void check_name(const std::string& name) const {
        const bool is_safe =
            !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](char c) {
                return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
            });
        if (!is_safe) {
            throw InputError(m_root.where("name") + ": name", "not a name", name,
                             "1 to 64 of a-z, 0-9, _ and -");
        }
    }

    static std::optional<FrameChoice> read_frames(TomlTable& table) {
        const auto texts = table.get_strings("frames");
        const auto warm = table.get_boolean("warm");
        if (!texts) {
            if (warm) {
                throw InputError(table.where("warm") + ": warm", "holds the pose of A before [A,B)",
                                 "no frames", "frames = \"A:B\"");
            }
            return std::nullopt;
        }
        FrameChoice frames;
        if (*texts == std::vector<std::string>{"quick"}) {
            frames.kind = FrameChoice::Kind::quick;
        } else if (*texts != std::vector<std::string>{"default"}) {
            frames.kind = FrameChoice::Kind::ranges;
            frames.ranges = *texts;
        }
        frames.warm = warm.value_or(false);
        if (texts->empty() || (frames.warm && frames.kind != FrameChoice::Kind::ranges)) {
            throw InputError(table.where("frames") + ": frames", "no range", {},
                             "\"default\", \"quick\", \"A:B\" or an array of ranges");
        }
        return frames;
    }

    void add_scene(const TomlTable& table, const std::string& key, std::string spec,
                   const std::optional<FrameChoice>& frames) {
        table.with_place(key, [&] {
            spec = resolve_scene_paths(
                spec, [&](const std::string& path) { return resolve_inside(m_folder, path); });
            if (!is_scene_file(spec)) {
                static_cast<void>(choose_scene(m_units.scenes, spec));
            }
        });
        m_experiment.scenes.push_back({std::move(spec), frames});
    }

    void read_scenes() {
        if (const auto specs = m_root.get_strings("scenes")) {
            if (*specs == std::vector<std::string>{"first"}) {
                m_experiment.first_scene_only = true;
            } else if (*specs != std::vector<std::string>{"all"}) {
                for (const std::string& spec : *specs) {
                    add_scene(m_root, "scenes", spec, std::nullopt);
                }
            }
        }
        for (TomlTable& scene : m_root.get_tables("scene")) {
            const std::optional<std::string> spec = scene.get_string("use");
            if (!spec) {
                throw InputError(scene.where(), "a scene without a name", {},
                                 "use = \"NAME[:key=value,...]\"");
            }
            const std::optional<FrameChoice> frames = read_frames(scene);
            const std::vector<std::string> walkthroughs =
                scene.get_strings("walkthroughs").value_or(std::vector<std::string>{});
            if (walkthroughs.empty()) {
                add_scene(scene, "use", *spec, frames);
            }
            for (const std::string& walkthrough : walkthroughs) {
                // Behind the path of a file, a colon starts its options.
                const std::string path = is_scene_file(*spec) ? get_scene_file(*spec) : "";
                const char* const separator =
                    spec->find(':', path.size()) == std::string::npos ? ":" : ",";
                add_scene(scene, "walkthroughs", *spec + separator + "walkthrough=" + walkthrough,
                          frames);
            }
            scene.check_all_known();
        }
    }

    void read_axes() {
        if (const auto sizes = m_root.get_strings("sizes")) {
            m_experiment.sizes.clear();
            m_root.with_place("sizes", [&] {
                for (const std::string& size : *sizes) {
                    m_experiment.sizes.push_back(parse_size(size));
                }
            });
            check_axis("sizes", m_experiment.sizes.size());
        }
        if (const auto targets = m_root.get_strings("targets")) {
            m_root.with_place("targets", [&] {
                for (const std::string& target : *targets) {
                    static_cast<void>(target.empty() ? Target{} : parse_target(target, {}));
                }
            });
            m_experiment.targets = *targets;
            check_axis("targets", targets->size());
        }
        if (const auto precisions = m_root.get_strings("precisions")) {
            m_experiment.precisions.clear();
            m_root.with_place("precisions", [&] {
                for (const std::string& precision : *precisions) {
                    m_experiment.precisions.push_back(
                        precision.empty() ? Precision{} : parse_precision(precision));
                }
            });
            check_axis("precisions", m_experiment.precisions.size());
        }
    }

    void check_axis(const std::string& key, std::size_t values) const {
        if (values == 0) {
            throw InputError(m_root.where(key) + ": " + key, "axis without a value");
        }
    }

    void read_methods() {
        if (const auto specs = m_root.get_strings("methods")) {
            m_root.with_place("methods", [&] {
                for (const std::string& text : *specs) {
                    m_experiment.methods.push_back(read_spec(text, "methods"));
                }
            });
        }
        for (TomlTable& method : m_root.get_tables("method")) {
            read_grid(method);
        }
        if (m_experiment.methods.empty()) {
            throw InputError(m_root.where("methods"), "no method", {},
                             "methods = [...] or [[method]]");
        }
    }

    void read_grid(TomlTable& table) {
        const std::optional<std::string> use = table.get_string("use");
        if (!use) {
            throw InputError(table.where(), "a method without a name", {},
                             "use = \"M[@PRESET][:key=value,...]\"");
        }
        MethodGrid grid;
        table.with_place("use", [&] { grid.base = read_spec(*use, "use"); });
        if (const auto label = table.get_string("label")) {
            grid.base.label = *label;
        }
        const ParameterTable& parameters = m_units.methods.find(grid.base.method).parameters;
        if (auto cross = table.get_table("cross")) {
            grid.crossed = read_parameter_axes(*cross, parameters);
        }
        if (auto zip = table.get_table("zip")) {
            grid.zipped = read_parameter_axes(*zip, parameters);
        }
        for (TomlTable& skip : table.get_tables("skip")) {
            grid.skips.push_back(read_skip(skip, parameters));
        }
        table.check_all_known();
        table.with_place("use", [&] { expand(grid, m_units.methods, m_experiment); });
    }

    static std::vector<ParameterAxis> read_parameter_axes(TomlTable& table,
                                                          const ParameterTable& parameters) {
        std::vector<ParameterAxis> axes;
        for (const std::string& key : table.list_keys()) {
            table.with_place(key, [&] {
                const ParameterInfo& info = parameters.find(key);
                ParameterAxis axis{key, {}};
                if (table.is_table(key)) {
                    axis.values = read_range(table.get_table(key).value(), info);
                } else {
                    axis.values = table.get_values(key).value();
                }
                for (const std::string& value : axis.values) {
                    static_cast<void>(parameters.parse(info, value));
                }
                axes.push_back(std::move(axis));
            });
        }
        return axes;
    }

    static std::vector<std::string> read_range(TomlTable table, const ParameterInfo& info) {
        const auto from = table.get_number("from");
        const auto to = table.get_number("to");
        const auto steps = table.get_integer("steps");
        const auto scale = table.get_string("scale");
        table.check_all_known();
        if (!from || !to || !steps) {
            throw InputError(info.name, "not a range", {},
                             "{ from = A, to = B, steps = N, scale = \"linear\" | \"log\" }");
        }
        ValueRange range{*from, *to, *steps, info.scale};
        if (scale) {
            const std::vector<std::string> scales{"linear", "log"};
            if (*scale != scales[0] && *scale != scales[1]) {
                throw InputError("scale", "unknown choice", *scale,
                                 describe_choices(*scale, scales));
            }
            range.scale = *scale == "log" ? ParameterScale::log : ParameterScale::linear;
        }
        return list_values(range, info.kind, info.name);
    }

    static GridSkip read_skip(TomlTable& table, const ParameterTable& parameters) {
        GridSkip skip;
        auto where = table.get_table("where");
        const auto reason = table.get_string("reason");
        table.check_all_known();
        if (!where || where->list_keys().empty() || !reason || reason->empty()) {
            throw InputError(table.where(), "not a skip", {},
                             "where = { parameter = value, ... } and a reason");
        }
        for (const std::string& key : where->list_keys()) {
            where->with_place(key, [&] {
                const std::vector<std::string> values = where->get_values(key).value();
                if (values.size() != 1) {
                    throw InputError(key, "a skip names one value", std::to_string(values.size()));
                }
                static_cast<void>(parameters.parse(parameters.find(key), values.front()));
                skip.where[key] = values.front();
            });
        }
        skip.reason = *reason;
        return skip;
    }

    TomlTable m_root;
    fs::path m_folder;
    const Units& m_units;
    Experiment m_experiment;
};

std::string get_stem(std::string_view path) {
    return fs::path(path).stem().string();
}

} // namespace

Experiment parse_experiment(std::string_view text, const std::string& file, const fs::path& folder,
                            const Units& units) {
    return ExperimentReader(TomlTable::parse(text, file), folder, units).read();
}

std::vector<std::string> list_experiments() {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embedded_experiments()) {
        names.push_back(get_stem(file.name));
    }
    return names;
}

Experiment load_experiment(const std::string& name_or_path, const Units& units) {
    for (const EmbeddedFile& file : embedded_experiments()) {
        if (get_stem(file.name) == name_or_path) {
            return parse_experiment(file.text, std::string(file.name), fs::current_path(), units);
        }
    }
    if (!name_or_path.ends_with(".toml")) {
        throw InputError("experiment", "unknown name", name_or_path,
                         describe_choices(name_or_path, list_experiments()) +
                             ", or a path that ends in .toml");
    }
    const fs::path path = name_or_path;
    const std::string text = read_file(path, kLargestFile);
    Experiment experiment = parse_experiment(
        text, name_or_path, fs::absolute(path).lexically_normal().parent_path(), units);
    return experiment;
}

} // namespace alcove
