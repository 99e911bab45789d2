#include "reports/record/store_schema.hpp"

#include "core/base/error.hpp"
#include "reports/record/store.hpp"

#include <array>

namespace alcove {
namespace {

/// Migration N makes version N of version N - 1. Written once, never edited: files of every version
/// are out there.
constexpr std::array kMigrations{
    R"(
CREATE TABLE runs(
    id INTEGER PRIMARY KEY,
    utc TEXT NOT NULL,
    build TEXT NOT NULL,
    device TEXT NOT NULL,
    device_class TEXT NOT NULL,
    timer_mode TEXT NOT NULL,
    suite TEXT NOT NULL,
    folder TEXT NOT NULL
) STRICT;
CREATE TABLE series(
    id INTEGER PRIMARY KEY,
    device TEXT NOT NULL,
    suite TEXT NOT NULL,
    scene TEXT NOT NULL,
    walkthrough TEXT NOT NULL,
    frames TEXT NOT NULL,
    target TEXT NOT NULL,
    size TEXT NOT NULL,
    precision TEXT NOT NULL,
    method TEXT NOT NULL,
    effects TEXT NOT NULL,
    state TEXT NOT NULL,
    pass TEXT NOT NULL,
    metric TEXT NOT NULL,
    kind TEXT NOT NULL,
    lower_is_better INTEGER NOT NULL,
    UNIQUE(device, suite, scene, walkthrough, frames, target, size, precision, method, effects,
           state, pass, metric)
) STRICT;
CREATE TABLE segments(
    id INTEGER PRIMARY KEY,
    device TEXT NOT NULL,
    anchor TEXT NOT NULL,
    scene TEXT NOT NULL,
    reference TEXT NOT NULL,
    UNIQUE(device, anchor, scene, reference)
) STRICT;
CREATE TABLE points(
    series INTEGER NOT NULL REFERENCES series(id),
    run INTEGER NOT NULL REFERENCES runs(id),
    segment INTEGER NOT NULL REFERENCES segments(id),
    value REAL NOT NULL,
    lower REAL,
    upper REAL,
    n INTEGER NOT NULL,
    image_hash TEXT NOT NULL,
    PRIMARY KEY(series, run)
) STRICT, WITHOUT ROWID;
)",
    R"(
ALTER TABLE runs ADD COLUMN commit_text TEXT NOT NULL DEFAULT '';
CREATE TABLE verdicts(
    series INTEGER NOT NULL REFERENCES series(id),
    run INTEGER NOT NULL REFERENCES runs(id),
    kind TEXT NOT NULL,
    change REAL NOT NULL,
    fence REAL NOT NULL,
    second REAL,
    confirmed INTEGER NOT NULL,
    PRIMARY KEY(series, run)
) STRICT, WITHOUT ROWID;
)",
};
static_assert(kMigrations.size() == kStoreSchemaVersion, "a migration for every version");

void check_is_store(Database& database, std::int64_t version) {
    const bool is_empty = database.read_integer("SELECT count(*) FROM sqlite_master") == 0;
    const std::int64_t application = database.read_integer("PRAGMA application_id");
    if (is_empty && version == 0 && application == 0) {
        return; // new
    }
    if (application != kStoreApplication) {
        throw InputError(database.name(), "a database that is no store", "",
                         "a new file, or one made by `alcove nightly`");
    }
    if (version > kStoreSchemaVersion || version < 1) {
        throw InputError(database.name(),
                         version < 1 ? "a store of no known schema"
                                     : "a store of a newer alcove: its schema version",
                         std::to_string(version), "1 to " + std::to_string(kStoreSchemaVersion));
    }
}

} // namespace

void migrate_store(Database& database) {
    Transaction transaction(database); // nobody migrates at the same time
    const std::int64_t version = database.read_integer("PRAGMA user_version");
    check_is_store(database, version);
    for (auto step = static_cast<std::size_t>(version); step < kMigrations.size(); ++step) {
        database.execute(kMigrations[step]);
    }
    if (version < kStoreSchemaVersion) {
        // PRAGMA takes no bound parameters; both numbers are ours.
        database.execute(("PRAGMA user_version = " + std::to_string(kStoreSchemaVersion) +
                          "; PRAGMA application_id = " + std::to_string(kStoreApplication))
                             .c_str());
    }
    transaction.commit();
}

} // namespace alcove
