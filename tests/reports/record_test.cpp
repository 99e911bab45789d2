#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "reports/record/csv.hpp"
#include "reports/record/record.hpp"
#include "reports/record/record_csv.hpp"
#include "reports/record/record_json.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace alcove {
namespace {

namespace fs = std::filesystem;
using synthetic::TemporaryFolder;

/// The text of the InputError that `act` throws.
template <class Act>
std::string error_of(const Act& act) {
    try {
        act();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t position = text.find(from);
    EXPECT_NE(position, std::string::npos) << from;
    return text.replace(position, from.size(), to);
}

::testing::AssertionResult contains(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) {
        return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << "`" << part << "` is not in `" << text << "`";
}

TEST(Csv, QuotesWhatNeedsItAndReadsItBack) {
    const std::vector<std::string> fields = {"plain",     "",           "a,b",
                                             "say \"x\"", "two\nlines", " space "};
    std::string text;
    append_csv_line(text, fields);
    EXPECT_EQ(text, "plain,,\"a,b\",\"say \"\"x\"\"\",\"two\nlines\", space \n");
    CsvReader reader(text, "t.csv");
    std::vector<std::string> read;
    ASSERT_TRUE(reader.next(read));
    EXPECT_EQ(read, fields);
    EXPECT_FALSE(reader.next(read));
}

TEST(Csv, CountsLinesAcrossQuotedLineBreaks) {
    CsvReader reader("a,\"1\n2\"\r\nb,c\r\nd\"e,f\n", "t.csv");
    std::vector<std::string> read;
    ASSERT_TRUE(reader.next(read));
    ASSERT_TRUE(reader.next(read));
    EXPECT_EQ(read, (std::vector<std::string>{"b", "c"}));
    EXPECT_TRUE(contains(error_of([&] { static_cast<void>(reader.next(read)); }), "t.csv:4"));
}

TEST(Csv, RefusesACutFile) {
    for (const char* text : {"a,b", "a,\"b\n", "a,\"b\""}) {
        CsvReader reader(text, "t.csv");
        std::vector<std::string> read;
        EXPECT_TRUE(contains(error_of([&] { static_cast<void>(reader.next(read)); }), "cut off"));
    }
}

TEST(RecordJson, SafeIds) {
    for (const char* id : {"a", "tssao-strong_blur.2", "..a"}) {
        EXPECT_TRUE(is_safe_id(id)) << id;
    }
    for (const char* id : {"", ".", "..", "a/b", "A", "a b", "a.tmp-1", "\xc3\xa4"}) {
        EXPECT_FALSE(is_safe_id(id)) << id;
    }
}

TEST(RecordJson, PlanAndContextRoundTrip) {
    const PlanRecord plan = synthetic::make_plan({.hostile = true});
    const std::string text = make_json(plan);
    const PlanRecord read = parse_plan_json(text, "plan.json");
    EXPECT_EQ(make_json(read), text);
    EXPECT_EQ(read.shuffle_seed, plan.shuffle_seed);
    EXPECT_EQ(read.rounds[1].cells[5].role, CellRole::method);
    EXPECT_EQ(read.rounds[1].cells[1].role, CellRole::anchor_repeat);
    EXPECT_EQ(read.rounds[0].cells[3].label, plan.rounds[0].cells[3].label);

    ContextRecord context = synthetic::make_context();
    context.timer_trials[0].ratio = std::numeric_limits<double>::infinity();
    context.timer_tick_ns = 0.1 + 0.2;
    const ContextRecord back = parse_context_json(make_json(context), "context.json");
    EXPECT_EQ(back.timer_trials[0].ratio, context.timer_trials[0].ratio);
    EXPECT_EQ(back.timer_tick_ns, context.timer_tick_ns);
}

TEST(RecordJson, NamesFileAndKeyOfWhatIsWrong) {
    const std::string good = make_json(synthetic::make_plan({}));
    const auto error = [&](const std::string& from, const std::string& to) {
        return error_of(
            [&] { static_cast<void>(parse_plan_json(replaced(good, from, to), "dir/plan.json")); });
    };
    const std::string current = std::to_string(kRunSchemaVersion);
    for (const std::string& version :
         {std::to_string(kRunSchemaVersion - 1), std::to_string(kRunSchemaVersion + 1)}) {
        EXPECT_TRUE(contains(
            error("\"schema_version\": " + current, "\"schema_version\": " + version),
            "dir/plan.json: schema_version: another schema version: found `" + version + "`"));
    }
    EXPECT_TRUE(contains(error("\"repeats\"", "\"repeat\""), "repeats: the key is missing"));
    EXPECT_TRUE(
        contains(error("\"repeats\": 6", "\"extra\": 1, \"repeats\": 6"), "extra: unknown key"));
    EXPECT_TRUE(contains(error("\"repeats\": 6", "\"repeats\": \"6\""), "repeats: wrong type"));
    EXPECT_TRUE(
        contains(error("\"repeats\": 6", "\"repeats\": -6"), "repeats: wrong type or range"));
    EXPECT_TRUE(contains(error("\"repeats\": 6", "\"repeats\": 6000000000"),
                         "repeats: wrong type or range"));
    EXPECT_TRUE(contains(error("\"repeats\": 6", "\"repeats\": 2000000000"), "repeats: too many"));
    EXPECT_TRUE(contains(error("\"id\": \"tssao\"", "\"id\": \"../x\""),
                         "rounds[0].cells[5].id: not a safe folder name: found `../x`"));
    EXPECT_TRUE(contains(error("\"id\": \"tssao\"", "\"id\": \"none\""), "stands twice"));
    EXPECT_TRUE(contains(error("\"id\": \"tssao\"", "\"id\": \"reference\""), "stands twice"));
    EXPECT_TRUE(contains(error("\"role\": \"anchor\"", "\"role\": \"boss\""),
                         "rounds[0].cells[0].role: unknown role"));
    EXPECT_TRUE(
        contains(error("\"end\": 16", "\"end\": 0"), "rounds[0].segments[0]: an empty segment"));
    EXPECT_TRUE(contains(
        error_of([&] { static_cast<void>(parse_plan_json(good.substr(0, good.size() / 2), "p")); }),
        "not JSON or cut off"));
    EXPECT_TRUE(
        contains(error_of([&] { static_cast<void>(parse_plan_json("[]", "p")); }), "an object"));
}

/// What reading says of a plan that somebody changed.
std::string error_of_plan(const std::function<void(PlanRecord&)>& change) {
    PlanRecord plan = synthetic::make_plan({});
    change(plan);
    return error_of([&] { static_cast<void>(parse_plan_json(make_json(plan), "p")); });
}

TEST(RecordJson, AClosingNoteKeepsWhatTheMachineDidAndWhatItDoesNotSay) {
    RoundDone done;
    done.repeats = {24, StopReason::width, 0.0098, "tssao"};
    done.machine = {{2.5, 3.25, 0.125, 0.01, 40.0, 2400.0}, {2.0, {}, {}, {}, {}, {}}};
    const std::string text = make_json(done);
    const RoundDone back = parse_done_json(text, "done.json");
    EXPECT_EQ(back.repeats.taken, 24);
    EXPECT_EQ(back.repeats.reason, StopReason::width);
    EXPECT_EQ(back.repeats.widest, 0.0098);
    EXPECT_EQ(back.repeats.widest_cell, "tssao");
    ASSERT_EQ(back.machine.size(), 2u);
    EXPECT_EQ(back.machine[0].others_share, 0.125);
    EXPECT_EQ(back.machine[0].clock_mhz, 2400.0);
    EXPECT_FALSE(back.machine[1].load || back.machine[1].steal_share);
    EXPECT_TRUE(contains(text, "\"load\": null"));
    const auto error = [&](const std::string& from, const std::string& to) {
        return error_of(
            [&] { static_cast<void>(parse_done_json(replaced(text, from, to), "done.json")); });
    };
    EXPECT_TRUE(contains(error("\"width\"", "\"mood\""), "repeats.reason: unknown reason"));
    EXPECT_TRUE(contains(error("\"load\": null", "\"load\": \"much\""), "machine[1].load"));
}

TEST(RecordJson, AFilmIsAShortPartOfABurst) {
    const auto error = [](int begin, int end) {
        return error_of_plan([&](PlanRecord& plan) {
            plan.rounds[0].segments.push_back({1000, 3000});
            plan.rounds[0].film = {begin, end};
        });
    };
    for (const auto& [begin, end] : {std::pair(0, 0), {7, 7}, {0, 16}, {1000, 2000}}) {
        EXPECT_EQ(error(begin, end), "no error") << begin << ":" << end;
    }
    EXPECT_TRUE(contains(error(9, 8), "p: rounds[0].film: no film: found `9:8`"));
    EXPECT_TRUE(contains(error(1000, 2001), "rounds[0].film: no film"));
    EXPECT_TRUE(contains(error(0, 17), "rounds[0].film: not in a burst"));
    EXPECT_TRUE(contains(error(18, 19), "rounds[0].film: not in a burst")); // a single
}

TEST(RecordJson, EventsAreInOrderFewAndShort) {
    const auto error = [](std::vector<EventRecord> events) {
        return error_of_plan([&](PlanRecord& plan) { plan.rounds[1].events = events; });
    };
    EXPECT_EQ(error({{3, "a"}, {3, std::string(200, 'b')}}), "no error");
    EXPECT_EQ(error(std::vector<EventRecord>(10000)), "no error");
    EXPECT_TRUE(contains(error({{3, "a"}, {2, "b"}}), "rounds[1].events[1].frame: not in order"));
    EXPECT_TRUE(
        contains(error({{3, std::string(201, 'b')}}), "rounds[1].events[0].label: too long"));
    EXPECT_TRUE(
        contains(error(std::vector<EventRecord>(10001)), "rounds[1].events: too many events"));
}

TEST(RecordJson, TheReferenceAndTheKindsOfMetricsAreNamed) {
    EXPECT_TRUE(
        contains(error_of_plan([](PlanRecord& plan) { plan.rounds[0].reference.id = "../truth"; }),
                 "rounds[0].reference.id: not the reference's id: found `../truth`"));
    EXPECT_TRUE(contains(error_of_plan([](PlanRecord& plan) { plan.metrics[1].kind = "smell"; }),
                         "metrics[1].kind: unknown kind: found `smell`"));
}

TEST(RecordCsv, RowsRoundTrip) {
    const PlanRecord plan = synthetic::make_plan({});
    const RoundRecord& round = plan.rounds[0];
    std::vector<SampleRow> samples = {{round.id, "harness", 0, 3, 5, SampleKind::divided,
                                       SampleState::cold, "input/base", -12345678901234, true}};
    const auto sample =
        parse_samples_csv(make_samples_csv(samples), "s", round, plan.repeats).at(0);
    EXPECT_EQ(sample.time_ns, -12345678901234);
    EXPECT_TRUE(sample.cached);
    EXPECT_EQ(sample.pass, "input/base");

    std::vector<MetricRow> metrics = {{round.id, "tssao", 3, 6, SampleState::converged, "psnr",
                                       std::nullopt, 0.1 + 0.2, std::nullopt, "equal, \"infinite\"",
                                       "00ff00ff00ff00ff"}};
    const auto metric = parse_metrics_csv(make_metrics_csv(metrics), "m", round).at(0);
    EXPECT_FALSE(metric.value);
    EXPECT_EQ(metric.debiased, 0.1 + 0.2);
    EXPECT_EQ(metric.state, SampleState::converged);
    EXPECT_EQ(metric.note, "equal, \"infinite\"");
}

TEST(RecordCsv, WhatIsNotFiniteIsNoValue) {
    const PlanRecord plan = synthetic::make_plan({});
    const RoundRecord& round = plan.rounds[0];
    MetricRow row{round.id, "tssao", 0, 0, SampleState::cold, "psnr", 1.0, {}, {}, "equal", ""};
    const std::string finite = make_metrics_csv({row});
    row.value = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(parse_metrics_csv(make_metrics_csv({row}), "m", round).at(0).value);
    const std::string text = replaced(finite, "psnr,1,", "psnr,inf,");
    EXPECT_TRUE(contains(error_of([&] { static_cast<void>(parse_metrics_csv(text, "m", round)); }),
                         "m:2: column value: not finite"));
}

TEST(RecordCsv, NamesLineAndColumnOfWhatIsWrong) {
    const PlanRecord plan = synthetic::make_plan({});
    const RoundRecord& round = plan.rounds[0];
    const SampleRow row{round.id,          "tssao",    0,    3,    5, SampleKind::envelope,
                        SampleState::cold, "envelope", 1000, false};
    const std::string good = make_samples_csv({row, row});
    const auto error = [&](const std::string& from, const std::string& to) {
        return error_of([&] {
            static_cast<void>(
                parse_samples_csv(replaced(good, from, to), "samples.csv", round, plan.repeats));
        });
    };
    EXPECT_EQ(error("tssao,0,3", "tssao,0,3"), "no error");
    EXPECT_TRUE(
        contains(error("pass,time_ns", "time_ns,pass"), "samples.csv:1: the header is wrong"));
    EXPECT_TRUE(
        contains(error("tssao,0,3", "ghost,0,3"), "samples.csv:2: column cell: unknown cell"));
    EXPECT_TRUE(
        contains(error("tssao,0,3", "tssao,11,3"), "samples.csv:2: column segment: out of range"));
    EXPECT_TRUE(contains(error("tssao,0,3", "tssao,0,16"), "column frame: out of range"));
    EXPECT_TRUE(contains(error("3,5,env", "3,6,env"), "column repeat: out of range"));
    EXPECT_TRUE(contains(error("envelope,cold", "sideways,cold"), "column kind: unknown name"));
    EXPECT_TRUE(contains(error("1000,0", "1000.5,0"), "column time_ns: not an integer"));
    EXPECT_TRUE(contains(error("1000,0", "1000,yes"), "column cached"));
    EXPECT_TRUE(
        contains(error("1000,0\n", "1000\n"), "samples.csv:2: the number of fields is wrong"));
    const std::string current = std::to_string(kRunSchemaVersion);
    for (const int other : {kRunSchemaVersion - 1, kRunSchemaVersion + 1}) {
        EXPECT_TRUE(contains(error("\n" + current + ",", "\n" + std::to_string(other) + ","),
                             "samples.csv:2: column schema: another schema version"));
    }
    EXPECT_TRUE(contains(error(current + ",r0-balls", current + ",r1-courtyard"),
                         "a row of another round"));
    const std::string cut = good.substr(0, good.size() - 4);
    EXPECT_TRUE(contains(error_of([&] {
                             static_cast<void>(
                                 parse_samples_csv(cut, "samples.csv", round, plan.repeats));
                         }),
                         "samples.csv:3: the file is cut off"));
}

TEST(RunFolder, KeepsEveryRow) {
    const TemporaryFolder temporary;
    const RunFolder run = synthetic::write_run(temporary.path() / "run", {});
    EXPECT_TRUE(run.is_complete());
    std::vector<SampleRow> expected;
    for (const RoundRecord& round : run.plan().rounds) {
        const auto part = synthetic::make_samples(run.plan(), round);
        expected.insert(expected.end(), part.begin(), part.end());
    }
    EXPECT_EQ(make_samples_csv(run.read_samples()), make_samples_csv(expected));
    EXPECT_EQ(read_file(run.path() / "samples.csv"), make_samples_csv(expected));
    EXPECT_EQ(read_file(run.path() / "metrics.csv"), make_metrics_csv(run.read_metrics()));
    EXPECT_EQ(run.read_done("r0-balls")->wall_s, 61.5);
    EXPECT_FALSE(run.read_done("nobody"));
}

TEST(RunFolder, RefusesAFolderThatHoldsARun) {
    const TemporaryFolder temporary;
    const auto create = [&] {
        static_cast<void>(RunFolder::create(temporary.path() / "run", synthetic::make_context(),
                                            synthetic::make_plan({})));
    };
    create();
    EXPECT_TRUE(contains(error_of(create), "already holds a run"));
}

TEST(RunFolder, RefusesAPlanThatNobodyCouldRead) {
    const TemporaryFolder temporary;
    PlanRecord plan = synthetic::make_plan({});
    plan.rounds[0].cells[2].id = "../../x";
    EXPECT_TRUE(contains(error_of([&] {
                             static_cast<void>(RunFolder::create(temporary.path() / "run",
                                                                 synthetic::make_context(), plan));
                         }),
                         "rounds[0].cells[2].id"));
    EXPECT_FALSE(fs::exists(temporary.path() / "run" / "plan.json"));
}

TEST(RunFolder, ACreateThatWasKilledIsNoRunAndCanBeDoneAgain) {
    const TemporaryFolder temporary;
    write_file_atomically(temporary.path() / "plan.json", "half");
    EXPECT_TRUE(contains(error_of([&] { static_cast<void>(RunFolder::open(temporary.path())); }),
                         "not a run folder"));
    static_cast<void>(
        RunFolder::create(temporary.path(), synthetic::make_context(), synthetic::make_plan({})));
    EXPECT_FALSE(RunFolder::open(temporary.path()).is_complete());
}

TEST(RunFolder, AKilledRoundIsIgnoredAndCleared) {
    const TemporaryFolder temporary;
    static_cast<void>(synthetic::write_run(temporary.path(), {.finished_rounds = 1}));
    // No process has this number: it is above the kernel's limit of 2^22.
    const fs::path stray = temporary.path() / "rounds" / "r1-courtyard.tmp-2000000000";
    write_file_atomically(stray / "samples.csv", "schema,rou");
    // Process 1 is always there.
    const fs::path live = temporary.path() / "rounds" / "r1-courtyard.tmp-1";
    write_file_atomically(live / "samples.csv", "schema,rou");
    RunFolder run = RunFolder::open(temporary.path());
    EXPECT_FALSE(fs::exists(stray));
    EXPECT_TRUE(fs::exists(live));
    EXPECT_FALSE(run.is_finished("r1-courtyard"));
    EXPECT_TRUE(run.is_finished("r0-balls"));
    const RoundRecord round = run.plan().rounds[1];
    run.finish_round(round.id, synthetic::make_samples(run.plan(), round), {}, {});
    EXPECT_TRUE(run.is_complete());
    EXPECT_EQ(read_file(temporary.path() / "samples.csv"), make_samples_csv(run.read_samples()));
}

TEST(RunFolder, ADamagedRoundIsNamed) {
    const TemporaryFolder temporary;
    const RunFolder run = synthetic::write_run(temporary.path(), {.finished_rounds = 1});
    const fs::path file = temporary.path() / "rounds" / "r0-balls" / "samples.csv";
    const std::string text = read_file(file);
    write_file_atomically(file, text.substr(0, text.size() - 3));
    EXPECT_TRUE(contains(error_of([&] { static_cast<void>(run.read_samples()); }), file.string()));
    write_file_atomically(temporary.path() / "rounds" / "r0-balls" / "done.json", "{}");
    EXPECT_TRUE(contains(error_of([&] { static_cast<void>(run.read_done("r0-balls")); }),
                         "done.json: schema_version: the key is missing"));
}

TEST(RoundRecord, MeasuresPicturesWhereItsTargetIsRadiance) {
    RoundRecord round;
    for (const char* target :
         {"", "radius=1", "radius=1,output=visibility", "my-output=radiance"}) {
        round.target = target;
        EXPECT_FALSE(measures_pictures(round)) << target;
    }
    for (const char* target : {"output=radiance", "radius=1,output=radiance,reach=full"}) {
        round.target = target;
        EXPECT_TRUE(measures_pictures(round)) << target;
    }
}

TEST(RunFolder, ImagePaths) {
    EXPECT_EQ(RunFolder::make_image_path("r0-balls", "reference", 7, "visibility"),
              "images/r0-balls/reference/0007_visibility.png");
}

TEST(RunFolderDeathTest, ImagePathsOfUnsafeNames) {
    EXPECT_DEATH(static_cast<void>(RunFolder::make_image_path("..", "a", 0, "visibility")), "safe");
}

} // namespace
} // namespace alcove
