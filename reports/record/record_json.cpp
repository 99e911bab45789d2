#include "reports/record/record_json.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <type_traits>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

using Json = nlohmann::ordered_json;

/// RoundDone is the one file without a version of its own in its struct.
struct DoneFile {
    int schema_version = kRunSchemaVersion;
    RoundDone done;
};

// One list of keys a struct, read and written through the same function.

template <class V>
void visit(V& v, SegmentRecord& r) {
    v("begin", r.begin);
    v("end", r.end);
}

template <class V>
void visit(V& v, ParameterRecord& r) {
    v("name", r.name);
    v("value", r.value);
    v("unit", r.unit);
    v("symbol", r.symbol);
    v("provenance", r.provenance);
}

template <class V>
void visit(V& v, CellRecord& r) {
    v("id", r.id);
    v("label", r.label);
    v("method", r.method);
    v("preset", r.preset);
    v("role", r.role);
    v("has_passes", r.has_passes);
    v("parameters", r.parameters);
    v("target", r.target);
    v("target_note", r.target_note);
    v("warm_frames", r.warm_frames);
    v("effects", r.effects);
}

template <class V>
void visit(V& v, RoundRecord& r) {
    v("id", r.id);
    v("scene", r.scene);
    v("walkthrough", r.walkthrough);
    v("target", r.target);
    v("width", r.width);
    v("height", r.height);
    v("precision", r.precision);
    v("segments", r.segments);
    v("image_frames", r.image_frames);
    v("cells", r.cells);
    v("scene_vertices", r.scene_vertices);
    v("scene_triangles", r.scene_triangles);
    v("ao_radius_m", r.ao_radius_m);
}

template <class V>
void visit(V& v, MetricDescription& r) {
    v("name", r.name);
    v("title", r.title);
    v("unit", r.unit);
    v("definition", r.definition);
    v("blind_to", r.blind_to);
    v("domain", r.domain);
    v("lower_is_better", r.lower_is_better);
}

template <class V>
void visit(V& v, MethodDescription& r) {
    v("name", r.name);
    v("title", r.title);
    v("citation", r.citation);
    v("content_hash", r.content_hash);
}

template <class V>
void visit(V& v, SceneDescription& r) {
    v("name", r.name);
    v("title", r.title);
    v("stresses", r.stresses);
    v("license", r.license);
    v("content_hash", r.content_hash);
}

template <class V>
void visit(V& v, SkippedScene& r) {
    v("scene", r.scene);
    v("reason", r.reason);
}

template <class V>
void visit(V& v, PlanRecord& r) {
    v("schema_version", r.schema_version);
    v("experiment", r.experiment);
    v("command_line", r.command_line);
    v("repeats", r.repeats);
    v("shuffle_seed", r.shuffle_seed);
    v("reference_rays_per_half", r.reference_rays_per_half);
    v("rounds", r.rounds);
    v("skipped", r.skipped);
    v("methods", r.methods);
    v("metrics", r.metrics);
    v("scenes", r.scenes);
}

template <class V>
void visit(V& v, TimerTrialRecord& r) {
    v("mode", r.mode);
    v("sequence", r.sequence);
    v("pass", r.pass);
    v("attempt", r.attempt);
    v("ratio", r.ratio);
    v("accepted", r.accepted);
}

template <class V>
void visit(V& v, ContextRecord& r) {
    v("schema_version", r.schema_version);
    v("started_utc", r.started_utc);
    v("build_id", r.build_id);
    v("build_type", r.build_type);
    v("compiler", r.compiler);
    v("device_class", r.device_class);
    v("gl_vendor", r.gl_vendor);
    v("gl_renderer", r.gl_renderer);
    v("gl_version", r.gl_version);
    v("context_kind", r.context_kind);
    v("cpu", r.cpu);
    v("cpu_features", r.cpu_features);
    v("cpu_threads", r.cpu_threads);
    v("driver_threads", r.driver_threads);
    v("timer_mode", r.timer_mode);
    v("timer_tick_ns", r.timer_tick_ns);
    v("timer_trials", r.timer_trials);
    v("anchor_version", r.anchor_version);
}

template <class V>
void visit(V& v, DoneFile& r) {
    v("schema_version", r.schema_version);
    v("wall_s", r.done.wall_s);
    v("gbuffer_s", r.done.gbuffer_s);
    v("passes_s", r.done.passes_s);
    v("metrics_s", r.done.metrics_s);
    v("reference_s", r.done.reference_s);
    v("images_s", r.done.images_s);
    v("reference_cached", r.done.reference_cached);
}

constexpr const char* kRoleNames[] = {"method", "anchor", "anchor_repeat"};
// Far above what a run can do; what a file from outside claims must not decide how much memory a
// report takes.
constexpr std::size_t kMaximumJsonBytes = 1u << 26;
constexpr int kMaximumRepeats = 10000;
constexpr std::size_t kMaximumCells = 64;
constexpr std::size_t kMaximumImageFrames = 1000;

class Writer {
  public:
    template <class T>
    void operator()(const char* key, T& value) {
        m_object[key] = make(value);
    }
    [[nodiscard]] Json& object() { return m_object; }

  private:
    template <class T>
    static Json make(T& value) {
        if constexpr (std::is_same_v<T, CellRole>) {
            return kRoleNames[static_cast<std::size_t>(value)];
        } else if constexpr (std::is_same_v<T, double>) {
            return std::isfinite(value) ? Json(value) : Json(format_number(value));
        } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
            return value;
        } else {
            Writer writer;
            visit(writer, value);
            return std::move(writer.m_object);
        }
    }
    template <class T>
    static Json make(std::vector<T>& values) {
        Json array = Json::array();
        for (T& value : values) {
            array.push_back(make(value));
        }
        return array;
    }

    Json m_object = Json::object();
};

class Reader {
  public:
    /// `prefix` is the path of `object` with its closing dot.
    Reader(const Json& object, std::string_view file, std::string prefix)
        : m_object(object), m_file(file), m_prefix(std::move(prefix)) {
        if (!object.is_object()) {
            fail(m_prefix, "wrong type", object.type_name(), "an object");
        }
    }

    template <class T>
    void operator()(const char* key, T& value) {
        const auto found = m_object.find(key);
        if (found == m_object.end()) {
            fail(m_prefix + key, "the key is missing", "", "a value");
        }
        m_known.insert(key);
        take(*found, value, m_prefix + key);
        if constexpr (std::is_same_v<T, int>) {
            if (std::string_view(key) == "schema_version" && value != kRunSchemaVersion) {
                fail(m_prefix + key, "another schema version", std::to_string(value),
                     std::to_string(kRunSchemaVersion) + ", which is what this build reads");
            }
        }
    }

    void finish() const {
        for (const auto& item : m_object.items()) {
            if (!m_known.contains(item.key())) {
                fail(m_prefix + item.key(), "unknown key", item.key(), "only documented keys");
            }
        }
    }

  private:
    [[noreturn]] void fail(const std::string& path, std::string_view what, std::string_view found,
                           std::string_view expected) const {
        throw InputError(std::string(m_file) + ": " + path, what, found, expected);
    }

    template <class T>
    void take(const Json& json, T& value, const std::string& path) {
        if constexpr (std::is_same_v<T, CellRole>) {
            const auto* name = std::find(std::begin(kRoleNames), std::end(kRoleNames),
                                         json.is_string() ? json.get<std::string>() : "");
            if (name == std::end(kRoleNames)) {
                fail(path, "unknown role", json.dump(), "method, anchor or anchor_repeat");
            }
            value = static_cast<CellRole>(name - std::begin(kRoleNames));
        } else if constexpr (std::is_same_v<T, bool>) {
            expect(json.is_boolean(), json, path, "true or false");
            value = json.get<bool>();
        } else if constexpr (std::is_same_v<T, double>) {
            if (json.is_string() && (json == "inf" || json == "-inf" || json == "nan")) {
                const double infinity = std::numeric_limits<double>::infinity();
                value = json == "nan" ? std::nan("") : (json == "inf" ? infinity : -infinity);
                return;
            }
            expect(json.is_number(), json, path, "a number");
            value = json.get<double>();
        } else if constexpr (std::is_unsigned_v<T>) {
            expect(json.is_number_unsigned(), json, path, "a non-negative integer");
            value = json.get<T>();
        } else if constexpr (std::is_integral_v<T>) {
            expect(json.is_number_unsigned() &&
                       json.get<std::uint64_t>() <=
                           static_cast<std::uint64_t>(std::numeric_limits<T>::max()),
                   json, path,
                   "an integer from 0 to " + std::to_string(std::numeric_limits<T>::max()));
            value = json.get<T>();
        } else if constexpr (std::is_same_v<T, std::string>) {
            expect(json.is_string(), json, path, "a string");
            value = json.get<std::string>();
        } else {
            Reader reader(json, m_file, path + ".");
            visit(reader, value);
            reader.finish();
        }
    }
    template <class T>
    void take(const Json& json, std::vector<T>& values, const std::string& path) {
        expect(json.is_array(), json, path, "an array");
        for (std::size_t i = 0; i < json.size(); ++i) {
            T value{};
            take(json[i], value, path + "[" + std::to_string(i) + "]");
            values.push_back(std::move(value));
        }
    }

    void expect(bool fits, const Json& json, const std::string& path,
                std::string_view expected) const {
        if (!fits) {
            fail(path, "wrong type or range", json.dump().substr(0, 80), expected);
        }
    }

    const Json& m_object;
    std::string_view m_file;
    std::string m_prefix;
    std::set<std::string> m_known;
};

template <class Record>
std::string write_record(Record& record) {
    Writer writer;
    visit(writer, record);
    // Bytes that are no UTF-8 (a driver's name) are replaced instead of failing a finished run.
    return writer.object().dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

template <class Record>
Record read_record(std::string_view text, std::string_view file) {
    if (text.size() > kMaximumJsonBytes) {
        throw InputError(file, "too large", std::to_string(text.size()) + " bytes",
                         "at most " + std::to_string(kMaximumJsonBytes));
    }
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw InputError(std::string(file) + ": byte " + std::to_string(error.byte),
                         "not JSON or cut off", "", "a whole JSON file");
    }
    Reader reader(json, file, "");
    Record record;
    visit(reader, record);
    reader.finish();
    return record;
}

void check_id(std::set<std::string>& seen, const std::string& id, const std::string& where) {
    if (!is_safe_id(id)) {
        throw InputError(where, "not a safe folder name", id,
                         "[a-z0-9_.-], neither `.` nor `..`, without `.tmp`");
    }
    if (!seen.insert(id).second) {
        throw InputError(where, "the id stands twice", id, "an id of its own");
    }
}

void check_round(const RoundRecord& round, const std::string& where) {
    if (round.width <= 0 || round.height <= 0) {
        throw InputError(where + ".width", "no size",
                         std::to_string(round.width) + "x" + std::to_string(round.height),
                         "positive numbers of pixels");
    }
    if (round.cells.size() > kMaximumCells) {
        throw InputError(where + ".cells", "too many cells", std::to_string(round.cells.size()),
                         "at most " + std::to_string(kMaximumCells));
    }
    if (round.image_frames.size() > kMaximumImageFrames) {
        throw InputError(where + ".image_frames", "too many frames",
                         std::to_string(round.image_frames.size()),
                         "at most " + std::to_string(kMaximumImageFrames));
    }
    for (std::size_t i = 0; i < round.segments.size(); ++i) {
        const SegmentRecord& segment = round.segments[i];
        if (segment.end <= segment.begin) {
            throw InputError(where + ".segments[" + std::to_string(i) + "]", "an empty segment",
                             std::to_string(segment.begin) + ":" + std::to_string(segment.end),
                             "begin below end");
        }
    }
    std::set<std::string> cells = {"harness", "reference"};
    for (std::size_t i = 0; i < round.cells.size(); ++i) {
        check_id(cells, round.cells[i].id, where + ".cells[" + std::to_string(i) + "].id");
    }
}

} // namespace

bool is_safe_id(std::string_view id) {
    return !id.empty() && id.size() <= 200 && id != "." && id != ".." &&
           id.find(".tmp") == std::string_view::npos &&
           id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.-") ==
               std::string_view::npos;
}

std::string make_json(const ContextRecord& record) {
    ContextRecord copy = record;
    return write_record(copy);
}

std::string make_json(const PlanRecord& record) {
    PlanRecord copy = record;
    return write_record(copy);
}

std::string make_json(const RoundDone& record) {
    DoneFile file{.done = record};
    return write_record(file);
}

ContextRecord parse_context_json(std::string_view text, std::string_view file) {
    return read_record<ContextRecord>(text, file);
}

PlanRecord parse_plan_json(std::string_view text, std::string_view file) {
    PlanRecord plan = read_record<PlanRecord>(text, file);
    if (plan.repeats > kMaximumRepeats) {
        throw InputError(std::string(file) + ": repeats", "too many", std::to_string(plan.repeats),
                         "at most " + std::to_string(kMaximumRepeats));
    }
    std::set<std::string> rounds;
    for (std::size_t i = 0; i < plan.rounds.size(); ++i) {
        const std::string where = std::string(file) + ": rounds[" + std::to_string(i) + "]";
        check_id(rounds, plan.rounds[i].id, where + ".id");
        check_round(plan.rounds[i], where);
    }
    return plan;
}

RoundDone parse_done_json(std::string_view text, std::string_view file) {
    return read_record<DoneFile>(text, file).done;
}

} // namespace alcove
