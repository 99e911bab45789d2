#include "reports/record/record_json.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "reports/record/stability_fields.hpp"
#include "reports/record/tune_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <type_traits>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

using Json = nlohmann::ordered_json;

using record_fields::DoneFile;

constexpr std::array<std::string_view, 3> kRoleNames{"method", "anchor", "anchor_repeat"};
constexpr std::array kStopReasons{StopReason::planned, StopReason::width, StopReason::time,
                                  StopReason::most};
constexpr std::array kOutcomes{StabilityOutcome::holds, StabilityOutcome::holds_up_to,
                               StabilityOutcome::fails, StabilityOutcome::not_applicable};

/// Names of an enumeration's values, in their order.
std::vector<std::string_view> list_names(CellRole) {
    return {kRoleNames.begin(), kRoleNames.end()};
}
std::vector<std::string_view> list_names(StopReason) {
    std::vector<std::string_view> names;
    for (const StopReason reason : kStopReasons) {
        names.push_back(to_text(reason));
    }
    return names;
}
std::vector<std::string_view> list_names(StabilityOutcome) {
    std::vector<std::string_view> names;
    for (const StabilityOutcome outcome : kOutcomes) {
        names.push_back(to_text(outcome));
    }
    return names;
}

// Far above what a run can do; what a file from outside claims must not decide how much memory a
// report takes.
constexpr std::size_t kMaximumJsonBytes = 1u << 26;
constexpr int kMaximumRepeats = 10000;
constexpr std::size_t kMaximumCells = 64;
constexpr std::size_t kMaximumImageFrames = 1000;
constexpr int kMaximumFilmFrames = 1000;
constexpr std::size_t kMaximumEvents = 10000;
constexpr std::size_t kMaximumLabelBytes = 200;
constexpr std::string_view kReferenceCell = "reference";

std::string join(const std::vector<std::string_view>& names) {
    std::string text;
    for (const std::string_view name : names) {
        text += text.empty() ? "" : ", ";
        text += name;
    }
    return text;
}

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
        if constexpr (std::is_enum_v<T>) {
            return list_names(value).at(static_cast<std::size_t>(value));
        } else if constexpr (std::is_same_v<T, double>) {
            return std::isfinite(value) ? Json(value) : Json(format_number(value));
        } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
            return value;
        } else {
            Writer writer;
            record_fields::visit(writer, value);
            return std::move(writer.m_object);
        }
    }
    static Json make(std::optional<double>& value) { return value ? make(*value) : Json(nullptr); }
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
    /// `prefix` is the path of `object` with its closing dot; `version` what its key schema_version
    /// must hold, if it has one.
    Reader(const Json& object, std::string_view file, std::string prefix,
           int version = kRunSchemaVersion)
        : m_object(object), m_file(file), m_prefix(std::move(prefix)), m_version(version) {
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
            if (std::string_view(key) == "schema_version" && value != m_version) {
                fail(m_prefix + key, "another schema version", std::to_string(value),
                     std::to_string(m_version) + ", which is what this build reads");
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
        if constexpr (std::is_enum_v<T>) {
            const std::vector<std::string_view> names = list_names(value);
            const auto name = std::find(names.begin(), names.end(),
                                        json.is_string() ? json.get<std::string>() : "");
            if (name == names.end()) {
                fail(path, "unknown " + path.substr(path.rfind('.') + 1), json.dump().substr(0, 80),
                     join(names));
            }
            value = static_cast<T>(name - names.begin());
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
            record_fields::visit(reader, value);
            reader.finish();
        }
    }
    void take(const Json& json, std::optional<double>& value, const std::string& path) {
        if (json.is_null()) {
            value.reset();
        } else {
            take(json, value.emplace(), path);
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
    int m_version;
    std::set<std::string> m_known;
};

template <class Record>
std::string write_record(Record& record) {
    Writer writer;
    record_fields::visit(writer, record);
    // Bytes that are no UTF-8 (a driver's name) are replaced instead of failing a finished run.
    return writer.object().dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

template <class Record>
Record read_record(std::string_view text, std::string_view file, int version = kRunSchemaVersion) {
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
    Reader reader(json, file, "", version);
    Record record;
    record_fields::visit(reader, record);
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

void check_film(const RoundRecord& round, const std::string& where) {
    const SegmentRecord& film = round.film;
    const std::string found = std::to_string(film.begin) + ":" + std::to_string(film.end);
    if (film.end < film.begin || film.end - film.begin > kMaximumFilmFrames) {
        throw InputError(where, "no film", found,
                         "begin up to end, at most " + std::to_string(kMaximumFilmFrames) +
                             " frames");
    }
    const bool is_of_burst = std::any_of(
        round.segments.begin(), round.segments.end(), [&film](const SegmentRecord& segment) {
            return !segment.is_single() && segment.begin <= film.begin && film.end <= segment.end;
        });
    if (film.begin != film.end && !is_of_burst) {
        throw InputError(where, "not in a burst", found, "frames of one burst of the round");
    }
}

void check_events(const std::vector<EventRecord>& events, const std::string& where) {
    if (events.size() > kMaximumEvents) {
        throw InputError(where, "too many events", std::to_string(events.size()),
                         "at most " + std::to_string(kMaximumEvents));
    }
    for (std::size_t i = 0; i < events.size(); ++i) {
        const std::string place = where + "[" + std::to_string(i) + "]";
        if (i > 0 && events[i].frame < events[i - 1].frame) {
            throw InputError(place + ".frame", "not in order", std::to_string(events[i].frame),
                             std::to_string(events[i - 1].frame) + " or later");
        }
        if (events[i].label.size() > kMaximumLabelBytes) {
            throw InputError(place + ".label", "too long",
                             std::to_string(events[i].label.size()) + " bytes",
                             "at most " + std::to_string(kMaximumLabelBytes));
        }
    }
}

void check_metric_kind(const MetricDescription& metric, const std::string& where) {
    if (metric.kind != "image" && metric.kind != "temporal" && metric.kind != "history" &&
        metric.kind != kStratumKind) {
        throw InputError(where, "unknown kind", metric.kind, "image, temporal, history or stratum");
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
    check_film(round, where + ".film");
    check_events(round.events, where + ".events");
    if (round.reference.id != kReferenceCell) {
        throw InputError(where + ".reference.id", "not the reference's id", round.reference.id,
                         kReferenceCell);
    }
    std::set<std::string> cells = {"harness", std::string(kReferenceCell)};
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
    if (plan.limit_repeats() > kMaximumRepeats) {
        throw InputError(std::string(file) + ": repeats", "too many",
                         std::to_string(plan.limit_repeats()),
                         "at most " + std::to_string(kMaximumRepeats));
    }
    std::set<std::string> rounds;
    for (std::size_t i = 0; i < plan.rounds.size(); ++i) {
        const std::string where = std::string(file) + ": rounds[" + std::to_string(i) + "]";
        check_id(rounds, plan.rounds[i].id, where + ".id");
        check_round(plan.rounds[i], where);
    }
    for (std::size_t i = 0; i < plan.metrics.size(); ++i) {
        check_metric_kind(plan.metrics[i],
                          std::string(file) + ": metrics[" + std::to_string(i) + "].kind");
    }
    return plan;
}

std::string make_json(const StabilityRecord& record) {
    StabilityRecord copy = record;
    return write_record(copy);
}

StabilityRecord parse_stability_json(std::string_view text, std::string_view file) {
    return read_record<StabilityRecord>(text, file, kStabilitySchemaVersion);
}

std::string make_json(const TuneRecord& record) {
    TuneRecord copy = record;
    return write_record(copy);
}

TuneRecord parse_tune_json(std::string_view text, std::string_view file) {
    return read_record<TuneRecord>(text, file, kTuneSchemaVersion);
}

RoundDone parse_done_json(std::string_view text, std::string_view file) {
    RoundDone done = read_record<DoneFile>(text, file).done;
    if (done.machine.size() > static_cast<std::size_t>(kMaximumRepeats)) {
        throw InputError(std::string(file) + ": machine", "too many",
                         std::to_string(done.machine.size()),
                         "at most " + std::to_string(kMaximumRepeats));
    }
    return done;
}

} // namespace alcove
