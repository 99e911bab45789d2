// The store: what is appended is read back, older files are brought up to date, and what is no
// store or a newer one is refused.

#include "core/base/file.hpp"
#include "reports/record/store.hpp"
#include "tests/harness/expect_error.hpp"
#include "tests/reports/forged_store.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace alcove {
namespace {

using synthetic::TemporaryFolder;

using forged::execute_sql;

std::vector<NightRow> make_rows_of_one(double value) {
    NightPoint point = forged::make_point(
        SeriesKind::time, forged::make_name("tssao", "cold", "envelope", "x anchor"), value, 0.25);
    return {{point, {}}};
}

TEST(Store, WhatIsAppendedIsReadBack) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "below" / "store.sqlite";
    StoredVerdict verdict{0, StepKind::slower, 0.0625, 0.03125, 0.0703125, true};
    {
        Store store(path);
        EXPECT_EQ(store.append(forged::make_run(0), make_rows_of_one(2.5)), 1);
        std::vector<NightRow> rows = make_rows_of_one(2.75);
        rows[0].verdict = verdict;
        rows.push_back({forged::make_images("tssao", "00ff"), {}});
        EXPECT_EQ(store.append(forged::make_run(1), rows), 2);
    }
    const StoredHistory history = Store(path).read();
    ASSERT_EQ(history.runs.size(), 2u);
    EXPECT_EQ(history.runs[1].utc, forged::make_run(1).utc);
    EXPECT_EQ(history.runs[1].commit, "commit 1");
    EXPECT_EQ(history.runs[1].folder, "night1/run");
    ASSERT_EQ(history.segments.size(), 1u) << "both nights have one segment";
    EXPECT_EQ(history.segments[0].anchor, "1");
    ASSERT_EQ(history.series.size(), 2u) << "equal names are one series";
    const StoredSeries& time = history.series[0];
    EXPECT_EQ(time.name, make_rows_of_one(0.0)[0].point.name);
    EXPECT_EQ(time.kind, SeriesKind::time);
    ASSERT_EQ(time.points.size(), 2u);
    EXPECT_EQ(time.points[0].value, 2.5);
    ASSERT_TRUE(time.points[1].interval);
    EXPECT_EQ(time.points[1].interval->upper, 3.0);
    ASSERT_EQ(time.verdicts.size(), 1u);
    EXPECT_EQ(time.verdicts[0].run, 2);
    EXPECT_EQ(time.verdicts[0].kind, StepKind::slower);
    EXPECT_EQ(time.verdicts[0].change, verdict.change);
    EXPECT_EQ(time.verdicts[0].fence, verdict.fence);
    EXPECT_EQ(time.verdicts[0].second, verdict.second);
    EXPECT_TRUE(time.verdicts[0].is_confirmed);
    EXPECT_EQ(history.series[1].points[0].image_hash, "00ff");
}

TEST(Store, EveryPartOfANameMakesAnotherSeries) {
    Store store(":memory:");
    const SeriesName name = forged::make_name("tssao", "cold", "envelope", "x anchor");
    std::vector<NightRow> rows{{forged::make_point(SeriesKind::time, name, 1.0), {}}};
    for (std::string SeriesName::*part :
         {&SeriesName::device, &SeriesName::suite, &SeriesName::scene, &SeriesName::walkthrough,
          &SeriesName::frames, &SeriesName::target, &SeriesName::size, &SeriesName::precision,
          &SeriesName::method, &SeriesName::effects, &SeriesName::state, &SeriesName::pass,
          &SeriesName::metric}) {
        SeriesName other = name;
        other.*part += "'; DROP TABLE runs; --";
        rows.push_back({forged::make_point(SeriesKind::time, other, 1.0), {}});
    }
    store.append(forged::make_run(0), rows);
    const StoredHistory history = store.read();
    EXPECT_EQ(history.series.size(), 14u);
    EXPECT_EQ(history.runs.size(), 1u);
    EXPECT_EQ(history.series[1].name, rows[1].point.name);
}

TEST(Store, ANightIsAppendedWholeOrNotAtAll) {
    const TemporaryFolder folder;
    Store store(folder.path() / "store.sqlite");
    store.append(forged::make_run(0), make_rows_of_one(2.5));
    std::vector<NightRow> twice = make_rows_of_one(2.5);
    twice.push_back(twice.front());
    expect_error([&] { store.append(forged::make_run(1), twice); }, 2, {"UNIQUE"});
    EXPECT_EQ(store.read().runs.size(), 1u);
    EXPECT_EQ(store.append(forged::make_run(1), make_rows_of_one(2.5)), 2);
}

/// A file of schema version 1, written down as that version had it.
constexpr const char* kVersion1 = R"(
CREATE TABLE runs(id INTEGER PRIMARY KEY, utc TEXT NOT NULL, build TEXT NOT NULL,
    device TEXT NOT NULL, device_class TEXT NOT NULL, timer_mode TEXT NOT NULL,
    suite TEXT NOT NULL, folder TEXT NOT NULL) STRICT;
CREATE TABLE series(id INTEGER PRIMARY KEY, device TEXT NOT NULL, suite TEXT NOT NULL,
    scene TEXT NOT NULL, walkthrough TEXT NOT NULL, frames TEXT NOT NULL, target TEXT NOT NULL,
    size TEXT NOT NULL, precision TEXT NOT NULL, method TEXT NOT NULL, effects TEXT NOT NULL,
    state TEXT NOT NULL, pass TEXT NOT NULL, metric TEXT NOT NULL, kind TEXT NOT NULL,
    lower_is_better INTEGER NOT NULL,
    UNIQUE(device, suite, scene, walkthrough, frames, target, size, precision, method, effects,
           state, pass, metric)) STRICT;
CREATE TABLE segments(id INTEGER PRIMARY KEY, device TEXT NOT NULL, anchor TEXT NOT NULL,
    scene TEXT NOT NULL, reference TEXT NOT NULL, UNIQUE(device, anchor, scene, reference)) STRICT;
CREATE TABLE points(series INTEGER NOT NULL REFERENCES series(id),
    run INTEGER NOT NULL REFERENCES runs(id), segment INTEGER NOT NULL REFERENCES segments(id),
    value REAL NOT NULL, lower REAL, upper REAL, n INTEGER NOT NULL, image_hash TEXT NOT NULL,
    PRIMARY KEY(series, run)) STRICT, WITHOUT ROWID;
INSERT INTO runs VALUES(7, '2026-01-01T02:00:00Z', 'b', 'd', 'software', 't', 'nightly', 'f');
INSERT INTO series VALUES(3, 'd', 'nightly', 's', 'w', '0:16', 't', '8x8', 'p', 'm', 'all', 'cold',
    'envelope', 'x anchor', 'time', 1);
INSERT INTO segments VALUES(1, 'd', '1', 's', '');
INSERT INTO points VALUES(3, 7, 1, 2.5, 2.4, 2.6, 6, '');
PRAGMA user_version = 1;
PRAGMA application_id = 1095517014;
)";

TEST(Store, AFileOfVersion1IsBroughtUpToDateWithItsRows) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "store.sqlite";
    execute_sql(path, kVersion1);
    Store store(path);
    StoredHistory history = store.read();
    ASSERT_EQ(history.runs.size(), 1u);
    EXPECT_EQ(history.runs[0].id, 7);
    EXPECT_EQ(history.runs[0].commit, "");
    ASSERT_EQ(history.series.size(), 1u);
    EXPECT_EQ(history.series[0].points.at(0).value, 2.5);
    EXPECT_TRUE(history.series[0].verdicts.empty());
    // Fit to be appended to, with what version 1 could not keep.
    std::vector<NightRow> rows = make_rows_of_one(2.75);
    rows[0].verdict = StoredVerdict{0, StepKind::slower, 0.1, 0.05, {}, true};
    EXPECT_EQ(store.append(forged::make_run(1), rows), 8);
    EXPECT_EQ(store.read().runs[1].commit, "commit 1");
    EXPECT_EQ(Store(path).read().series.size(), 2u) << "opened again, nothing is left to migrate";
}

TEST(Store, ANewerFileIsRefusedByNameAndLeftAlone) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "store.sqlite";
    { Store store(path); }
    execute_sql(path, "PRAGMA user_version = 99");
    const std::string before = read_file(path);
    expect_error([&] { Store store(path); }, 2, {"store.sqlite", "newer", "99", "2"});
    EXPECT_EQ(read_file(path), before);
}

TEST(Store, WhatIsNoStoreIsRefusedAndLeftAlone) {
    const TemporaryFolder folder;
    const auto foreign = folder.path() / "foreign.sqlite";
    execute_sql(foreign, "CREATE TABLE diary(text)");
    expect_error([&] { Store store(foreign); }, 2, {"foreign.sqlite", "no store"});
    const auto text = folder.path() / "notes.txt";
    write_file_atomically(text, std::string(4096, 'x'));
    expect_error([&] { Store store(text); }, 2, {"notes.txt", "not a database"});
    EXPECT_EQ(read_file(text), std::string(4096, 'x'));
    expect_error([&] { Store store(folder.path()); }, 1, {"unable to open"});
}

TEST(Store, DamagedRowsAreNamed) {
    const auto refuse = [](const std::string& sql, std::initializer_list<const char*> parts) {
        SCOPED_TRACE(sql);
        const TemporaryFolder folder;
        const auto path = folder.path() / "store.sqlite";
        {
            Store store(path);
            store.append(forged::make_run(0), make_rows_of_one(2.5));
        }
        execute_sql(path, sql);
        expect_error([&] { static_cast<void>(Store(path).read()); }, 2, parts);
    };
    refuse("UPDATE points SET value = 9e999", {"store.sqlite", "no finite number"});
    refuse("UPDATE points SET lower = -9e999", {"no finite number"});
    refuse("UPDATE points SET value = 0", {"no logarithm"});
    refuse("UPDATE series SET kind = 'mood'", {"unknown kind", "mood"});
    refuse("UPDATE points SET run = 5", {"run that is not there", "5"});
    refuse("UPDATE points SET segment = 5", {"segment that is not there"});
    refuse("UPDATE points SET series = 5", {"series that is not there"});
    refuse("DROP TABLE points", {"no such table"});
}

} // namespace
} // namespace alcove
