// The record of hard cases and what is made of it: read back strictly, hostile text stays text.
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "reports/analysis/stability_wording.hpp"
#include "reports/csv/stability_csv.hpp"
#include "reports/html/stability_page.hpp"
#include "reports/record/csv.hpp"
#include "reports/record/record_json.hpp"
#include "reports/terminal/stability_table.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::string kHostile = "</td><script>alert(1)</script>\"',\x1b[2J";

StabilityCellRecord make_cell(const std::string& label, std::vector<StabilityScoreRecord> scores) {
    StabilityCellRecord cell{"far", label, {}, "", 0.0, std::move(scores)};
    const StabilityVerdict verdict = judge(cell.scores);
    cell.outcome = verdict.outcome;
    cell.worst_margin = verdict.worst_margin;
    return cell;
}

/// One case of three severities; a method for each outcome.
StabilityRecord make_record() {
    StabilityRecord record;
    record.command_line = "alcove stability";
    record.width = 96;
    record.height = 72;
    record.context = synthetic::make_context();
    StabilityCaseRecord far;
    far.name = "far";
    far.title = "Far plane";
    far.axis = "far plane";
    far.axis_unit = "m";
    far.severities = {{100.0, "100 m"}, {1e3, "1000 m"}, {kInfinity, "no far plane"}};
    far.score_unit = "codes";
    record.cases = {far};
    for (const char* label : {"good", "half", "bad", "none"}) {
        record.methods.push_back({label, "tssao", "default", "abc", {}});
    }
    record.methods[0].overrides = {{"bias", "0", "px", "b", "command line"}};
    record.cells = {
        make_cell("good", {{0.0, 2.0, "", ""}, {0.5, 2.0, "", ""}, {1.0, 2.0, "", ""}}),
        make_cell("half", {{1.0, 2.0, "", ""}, {2.0, 2.0, "", ""}, {5.0, 2.0, "", "images/b.png"}}),
        make_cell("bad", {{0.0, 0.0, "NaN at pixel (3, 4)", "images/a.png"},
                          {kInfinity, 2.0, "", ""},
                          {0.0, 2.0, "", ""}}),
        {"far", "none", StabilityOutcome::not_applicable, "no history", 0.0, {}},
    };
    return record;
}

std::string error_of(const std::function<void(StabilityRecord&)>& change) {
    const synthetic::TemporaryFolder folder;
    StabilityRecord record = make_record();
    change(record);
    write_stability(folder.path(), record);
    try {
        static_cast<void>(read_stability(folder.path()));
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was wrong";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(StabilityMargin, IsRelativeToTheBound) {
    EXPECT_DOUBLE_EQ(compute_margin({0.5, 2.0, "", ""}), 0.75);
    EXPECT_DOUBLE_EQ(compute_margin({2.0, 2.0, "", ""}), 0.0);
    EXPECT_TRUE(holds({2.0, 2.0, "", ""}));
    EXPECT_DOUBLE_EQ(compute_margin({6.0, 2.0, "", ""}), -2.0);
    EXPECT_DOUBLE_EQ(compute_margin({0.0, 0.0, "", ""}), 1.0);
    EXPECT_DOUBLE_EQ(compute_margin({1.0, 0.0, "", ""}), -kInfinity);
    EXPECT_DOUBLE_EQ(compute_margin({0.0, 2.0, "NaN", ""}), -kInfinity);
    EXPECT_DOUBLE_EQ(compute_margin({std::numeric_limits<double>::quiet_NaN(), 2.0, "", ""}),
                     -kInfinity);
}

TEST(StabilityVerdict, FollowsFromTheFirstFailure) {
    const StabilityRecord record = make_record();
    EXPECT_EQ(record.cells[0].outcome, StabilityOutcome::holds);
    EXPECT_DOUBLE_EQ(record.cells[0].worst_margin, 0.5);
    EXPECT_EQ(record.cells[1].outcome, StabilityOutcome::holds_up_to);
    EXPECT_EQ(judge(record.cells[1].scores).held, 2u);
    EXPECT_EQ(record.cells[2].outcome, StabilityOutcome::fails);
    EXPECT_EQ(count_failures(record), 2u);
}

TEST(StabilityRecord, ReadsBackWhatWasWritten) {
    const synthetic::TemporaryFolder folder;
    const StabilityRecord record = make_record();
    write_stability(folder.path(), record);
    const StabilityRecord read = read_stability(folder.path());
    EXPECT_EQ(make_json(read), make_json(record));
    EXPECT_EQ(read.cells[2].worst_margin, -kInfinity);
    EXPECT_EQ(read.cases[0].severities[2].value, kInfinity);
    EXPECT_EQ(read.context.gl_renderer, record.context.gl_renderer);
}

TEST(StabilityRecord, RefusesWhatDoesNotFitByNameOfTheKey) {
    EXPECT_TRUE(contains(error_of([](StabilityRecord& r) { r.schema_version = 99; }),
                         "stability.json: schema_version: another schema version"));
    EXPECT_TRUE(contains(error_of([](StabilityRecord& r) { r.cases[0].name = "../x"; }),
                         "cases[0].name: not a safe folder name"));
    EXPECT_TRUE(contains(error_of([](StabilityRecord& r) { r.cells[0].worst_margin = 0.9; }),
                         "cells[0].outcome: does not follow"));
    EXPECT_TRUE(
        contains(error_of([](StabilityRecord& r) { r.cells[2].outcome = StabilityOutcome::holds; }),
                 "cells[2].outcome: does not follow"));
    EXPECT_TRUE(contains(error_of([](StabilityRecord& r) { r.cells[1].scores.pop_back(); }),
                         "cells[1].scores: wrong length"));
    EXPECT_TRUE(
        contains(error_of([](StabilityRecord& r) { r.cells.pop_back(); }), "cells: wrong length"));
    EXPECT_TRUE(contains(error_of([](StabilityRecord& r) { std::swap(r.cells[0], r.cells[1]); }),
                         "cells[0]: out of order"));
    EXPECT_TRUE(contains(error_of([](StabilityRecord& r) { r.cells[0].scores[0].bound = -1.0; }),
                         "scores[0].bound: no bound"));
    EXPECT_TRUE(
        contains(error_of([](StabilityRecord& r) { r.cases[0].severities[1].value = 100.0; }),
                 "cases[0].severities[1].value: not from mild to harsh"));
    EXPECT_TRUE(contains(error_of([](StabilityRecord& r) { r.cells[3].reason.clear(); }),
                         "cells[3]: not applicable"));
    EXPECT_NE(error_of([](StabilityRecord& r) { r.cells[2].scores[0].picture = "../../x.png"; }),
              "nothing was wrong");
    EXPECT_TRUE(contains(error_of([](StabilityRecord& r) { r.methods[1].label = "good"; }),
                         "methods: stands twice"));
}

TEST(StabilityRecord, RefusesUnknownOutcomesAndKeys) {
    const std::string good = make_json(make_record());
    const auto parse = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return [text] { static_cast<void>(parse_stability_json(text, "s.json")); };
    };
    EXPECT_THROW(parse("\"holds\"", "\"wins\"")(), InputError);
    EXPECT_THROW(parse("\"reason\"", "\"raeson\"")(), InputError);
    EXPECT_THROW(parse("\"width\": 96", "\"width\": \"96\"")(), InputError);
}

TEST(StabilityReports, SayEveryOutcome) {
    const StabilityRecord record = make_record();
    const std::string table = make_stability_table(record);
    for (const char* part : {"holds 0.50", "to 1000 m -1.5", "fails x", "n/a", "[4] none",
                             "far, bad: NaN at pixel (3, 4)",
                             "2 of 4 methods hold in every case that applies to them; 2 of 3 "
                             "combinations fail"}) {
        EXPECT_TRUE(contains(table, part)) << part << "\n" << table;
    }
    const std::string page = make_stability_page(record);
    for (const char* part : {"to 1000 m", "not applicable: no history", "NaN at pixel (3, 4)",
                             "src=\"images/a.png\"", "td.fails"}) {
        EXPECT_TRUE(contains(page, part)) << part;
    }
}

TEST(StabilityReports, CsvHasALineASeverityAndReadsBack) {
    StabilityRecord record = make_record();
    record.cells[3].reason = kHostile;
    const std::string text = make_stability_csv(record);
    CsvReader reader(text, "stability.csv");
    std::vector<std::string> fields;
    std::size_t lines = 0;
    std::size_t columns = 0;
    std::vector<std::string> last;
    while (reader.next(fields)) {
        columns = lines == 0 ? fields.size() : columns;
        EXPECT_EQ(fields.size(), columns);
        last = fields;
        ++lines;
    }
    EXPECT_EQ(lines, 1u + 3u * 3u + 1u);
    EXPECT_EQ(last.at(6), kHostile);
}

TEST(StabilityReports, HostileTextStaysText) {
    StabilityRecord record = make_record();
    for (std::string* text :
         {&record.command_line, &record.cases[0].title, &record.cases[0].trigger,
          &record.cases[0].source, &record.cases[0].axis, &record.cases[0].invariant,
          &record.cases[0].score, &record.cases[0].score_unit, &record.cases[0].bound_reason,
          &record.cases[0].severities[1].label, &record.methods[1].label, &record.cells[1].label,
          &record.cells[3].reason, &record.cells[2].scores[0].fault,
          &record.cells[2].scores[0].picture, &record.context.gl_renderer, &record.context.build_id,
          &record.context.started_utc}) {
        *text += kHostile;
    }
    const std::string page = make_stability_page(record);
    EXPECT_FALSE(contains(page, "<script"));
    EXPECT_FALSE(contains(page, "</td><script"));
    EXPECT_FALSE(contains(page, "\x1b"));
    EXPECT_FALSE(contains(make_stability_table(record), "\x1b"));
}

} // namespace
} // namespace alcove
