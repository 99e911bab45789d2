#include "reports/record/store.hpp"

#include "core/base/error.hpp"
#include "reports/record/store_schema.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace alcove {
namespace {

constexpr std::array<std::string_view, 6> kSeriesKinds{"time",         "pass",    "input",
                                                       "milliseconds", "quality", "images"};
constexpr std::array<std::string_view, 5> kStepKinds{"slower", "faster", "worse", "better",
                                                     "image changed"};

template <class Kind, std::size_t N>
Kind parse_kind(const std::array<std::string_view, N>& names, const std::string& text,
                const Database& database) {
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) {
        throw InputError(database.name(), "a row of an unknown kind", text);
    }
    return static_cast<Kind>(found - names.begin());
}

/// In the order of the table's columns.
template <class Name, class Visit>
void visit_columns(Name& name, const Visit& visit) {
    for (auto* column : {&name.device, &name.suite, &name.scene, &name.walkthrough, &name.frames,
                         &name.target, &name.size, &name.precision, &name.method, &name.effects,
                         &name.state, &name.pass, &name.metric}) {
        visit(*column);
    }
}

} // namespace

bool has_logarithm(SeriesKind kind) {
    return kind == SeriesKind::time || kind == SeriesKind::pass || kind == SeriesKind::milliseconds;
}

std::string_view to_text(SeriesKind kind) {
    return kSeriesKinds[static_cast<std::size_t>(kind)];
}

std::string_view to_text(StepKind kind) {
    return kStepKinds[static_cast<std::size_t>(kind)];
}

struct Store::Tables {
    explicit Tables(const std::filesystem::path& path) : database(path) { migrate_store(database); }

    std::int64_t add_run(const StoredRun& run) {
        Statement insert(database, "INSERT INTO runs(utc, build, commit_text, device, "
                                   "device_class, timer_mode, suite, folder) "
                                   "VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
        int parameter = 0;
        for (const std::string* text :
             {&run.utc, &run.build, &run.commit, &run.device, &run.device_class, &run.timer_mode,
              &run.suite, &run.folder}) {
            insert.bind(parameter++, *text);
        }
        insert.run();
        return database.get_last_row();
    }

    Database database;
};

namespace {

/// Ids of names: found, or made where there is none.
class NameFinder {
  public:
    explicit NameFinder(Database& database)
        : m_database(database),
          m_find_series(database,
                        "SELECT id FROM series WHERE device = ? AND suite = ? AND scene = ? AND "
                        "walkthrough = ? AND frames = ? AND target = ? AND size = ? AND precision "
                        "= ? AND method = ? AND effects = ? AND state = ? AND pass = ? AND metric "
                        "= ?"),
          m_add_series(database,
                       "INSERT INTO series(device, suite, scene, walkthrough, frames, target, "
                       "size, precision, method, effects, state, pass, metric, kind, "
                       "lower_is_better) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
          m_find_segment(database, "SELECT id FROM segments WHERE device = ? AND anchor = ? AND "
                                   "scene = ? AND reference = ?"),
          m_add_segment(
              database,
              "INSERT INTO segments(device, anchor, scene, reference) VALUES(?, ?, ?, ?)") {}

    std::int64_t find_series(const NightPoint& point) {
        const int columns = bind_name(m_find_series, point.name);
        if (const auto id = read_id(m_find_series)) {
            return *id;
        }
        bind_name(m_add_series, point.name);
        m_add_series.bind(columns, to_text(point.kind))
            .bind(columns + 1, std::int64_t{point.lower_is_better ? 1 : 0})
            .run();
        return m_database.get_last_row();
    }

    std::int64_t find_segment(const StoredSegment& segment) {
        const auto bind = [&](Statement& statement) {
            statement.bind(0, segment.device).bind(1, segment.anchor);
            statement.bind(2, segment.scene).bind(3, segment.reference);
        };
        bind(m_find_segment);
        if (const auto id = read_id(m_find_segment)) {
            return *id;
        }
        bind(m_add_segment);
        m_add_segment.run();
        return m_database.get_last_row();
    }

  private:
    static int bind_name(Statement& statement, const SeriesName& name) {
        int parameter = 0;
        visit_columns(name,
                      [&](const std::string& column) { statement.bind(parameter++, column); });
        return parameter;
    }

    static std::optional<std::int64_t> read_id(Statement& statement) {
        std::optional<std::int64_t> id;
        if (statement.step()) {
            id = statement.get_integer(0);
        }
        statement.reset();
        return id;
    }

    Database& m_database;
    Statement m_find_series;
    Statement m_add_series;
    Statement m_find_segment;
    Statement m_add_segment;
};

std::vector<StoredRun> read_runs(Database& database) {
    std::vector<StoredRun> runs;
    Statement rows(database, "SELECT id, utc, build, commit_text, device, device_class, "
                             "timer_mode, suite, folder FROM runs ORDER BY id");
    while (rows.step()) {
        runs.push_back({rows.get_integer(0), rows.get_text(1), rows.get_text(2), rows.get_text(3),
                        rows.get_text(4), rows.get_text(5), rows.get_text(6), rows.get_text(7),
                        rows.get_text(8)});
    }
    return runs;
}

std::vector<StoredSegment> read_segments(Database& database) {
    std::vector<StoredSegment> segments;
    Statement rows(database,
                   "SELECT id, device, anchor, scene, reference FROM segments ORDER BY id");
    while (rows.step()) {
        segments.push_back({rows.get_integer(0), rows.get_text(1), rows.get_text(2),
                            rows.get_text(3), rows.get_text(4)});
    }
    return segments;
}

std::vector<StoredSeries> read_series(Database& database) {
    std::vector<StoredSeries> all;
    Statement rows(database, "SELECT id, device, suite, scene, walkthrough, frames, target, size, "
                             "precision, method, effects, state, pass, metric, kind, "
                             "lower_is_better FROM series ORDER BY id");
    while (rows.step()) {
        StoredSeries series;
        series.id = rows.get_integer(0);
        int column = 1;
        visit_columns(series.name, [&](std::string& text) { text = rows.get_text(column++); });
        series.kind = parse_kind<SeriesKind>(kSeriesKinds, rows.get_text(column), database);
        series.lower_is_better = rows.get_integer(column + 1) != 0;
        all.push_back(std::move(series));
    }
    return all;
}

using SeriesById = std::unordered_map<std::int64_t, StoredSeries*>;

StoredSeries& find_series(const SeriesById& by_id, std::int64_t id, const Database& database) {
    const auto found = by_id.find(id);
    if (found == by_id.end()) {
        throw InputError(database.name(), "a row of a series that is not there",
                         std::to_string(id));
    }
    return *found->second;
}

void read_points(Database& database, const SeriesById& by_id) {
    Statement rows(database, "SELECT series, run, segment, value, lower, upper, n, image_hash "
                             "FROM points ORDER BY series, run");
    while (rows.step()) {
        StoredPoint point{rows.get_integer(1), rows.get_integer(2), rows.get_number(3), {},
                          rows.get_integer(6), rows.get_text(7)};
        const std::optional<double> lower = rows.get_optional_number(4);
        const std::optional<double> upper = rows.get_optional_number(5);
        if (lower && upper) {
            point.interval = Interval{*lower, *upper};
        }
        StoredSeries& series = find_series(by_id, rows.get_integer(0), database);
        if (has_logarithm(series.kind) && !(point.value > 0.0)) {
            throw InputError(database.name(), "a time that has no logarithm",
                             std::to_string(point.value), "more than 0");
        }
        series.points.push_back(std::move(point));
    }
}

void read_verdicts(Database& database, const SeriesById& by_id) {
    Statement rows(database, "SELECT series, run, kind, change, fence, second, confirmed "
                             "FROM verdicts ORDER BY series, run");
    while (rows.step()) {
        find_series(by_id, rows.get_integer(0), database)
            .verdicts.push_back({rows.get_integer(1),
                                 parse_kind<StepKind>(kStepKinds, rows.get_text(2), database),
                                 rows.get_number(3), rows.get_number(4),
                                 rows.get_optional_number(5), rows.get_integer(6) != 0});
    }
}

/// Foreign keys say so of what we wrote; a file of somebody else's is checked.
void check_runs(const StoredHistory& history, const Database& database) {
    const auto check = [&](const auto& known, std::int64_t id, const char* what) {
        const auto found =
            std::lower_bound(known.begin(), known.end(), id,
                             [](const auto& row, std::int64_t value) { return row.id < value; });
        if (found == known.end() || found->id != id) {
            throw InputError(database.name(), what, std::to_string(id));
        }
    };
    for (const StoredSeries& series : history.series) {
        for (const StoredPoint& point : series.points) {
            check(history.runs, point.run, "a point of a run that is not there");
            check(history.segments, point.segment, "a point of a segment that is not there");
        }
        for (const StoredVerdict& verdict : series.verdicts) {
            check(history.runs, verdict.run, "a verdict of a run that is not there");
        }
    }
}

} // namespace

Store::Store(const std::filesystem::path& path) : m_tables(std::make_unique<Tables>(path)) {}

Store::~Store() = default;

std::int64_t Store::append(const StoredRun& run, const std::vector<NightRow>& rows) {
    Database& database = m_tables->database;
    Transaction transaction(database);
    const std::int64_t run_id = m_tables->add_run(run);
    NameFinder names(database);
    Statement add_point(database, "INSERT INTO points(series, run, segment, value, lower, upper, "
                                  "n, image_hash) VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
    Statement add_verdict(database, "INSERT INTO verdicts(series, run, kind, change, fence, "
                                    "second, confirmed) VALUES(?, ?, ?, ?, ?, ?, ?)");
    for (const NightRow& row : rows) {
        const NightPoint& point = row.point;
        const std::int64_t series = names.find_series(point);
        using Number = std::optional<double>;
        add_point.bind(0, series).bind(1, run_id).bind(2, names.find_segment(point.segment));
        add_point.bind(3, point.value)
            .bind(4, point.interval ? Number(point.interval->lower) : Number())
            .bind(5, point.interval ? Number(point.interval->upper) : Number())
            .bind(6, point.n)
            .bind(7, point.image_hash)
            .run();
        if (row.verdict) {
            add_verdict.bind(0, series).bind(1, run_id).bind(2, to_text(row.verdict->kind));
            add_verdict.bind(3, row.verdict->change)
                .bind(4, row.verdict->fence)
                .bind(5, row.verdict->second)
                .bind(6, std::int64_t{row.verdict->is_confirmed ? 1 : 0})
                .run();
        }
    }
    transaction.commit();
    return run_id;
}

StoredHistory Store::read() const {
    Database& database = m_tables->database;
    // One transaction: a night that is appended meanwhile is seen whole or not at all.
    Transaction transaction(database);
    StoredHistory history{read_runs(database), read_segments(database), read_series(database)};
    SeriesById by_id;
    for (StoredSeries& series : history.series) {
        by_id.emplace(series.id, &series);
    }
    read_points(database, by_id);
    read_verdicts(database, by_id);
    check_runs(history, database);
    return history;
}

} // namespace alcove
