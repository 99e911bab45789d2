// passes.csv: a line a pass, with its time a pixel and a sample, and what it fetches.
#include "reports/csv/passes_csv.hpp"
#include "reports/record/csv.hpp"
#include "tests/reports/synthetic_run.hpp"

#include "core/base/text.hpp"

#include <gtest/gtest.h>

#include <map>

namespace alcove {
namespace {

using Line = std::map<std::string, std::string>;

std::vector<Line> read_table(const std::string& text) {
    CsvReader reader(text, "passes.csv");
    std::vector<std::string> columns;
    EXPECT_TRUE(reader.next(columns));
    std::vector<Line> lines;
    for (std::vector<std::string> fields; reader.next(fields);) {
        lines.emplace_back();
        for (std::size_t i = 0; i < fields.size(); ++i) {
            lines.back()[columns.at(i)] = fields[i];
        }
    }
    return lines;
}

TEST(PassesCsv, TellsTimesAPixelAndASampleWhereTheyExist) {
    const synthetic::TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {});
    const auto lines = read_table(make_passes_csv(analyze_run(run)));
    int sampling = 0;
    int inputs = 0;
    for (const Line& line : lines) {
        if (line.at("pass").starts_with("input/")) {
            EXPECT_EQ(line.at("ns_per_pixel"), "");
            ++inputs;
            continue;
        }
        const double ms = parse_number(line.at("time_ms"), "time_ms");
        const double pixels =
            parse_number(line.at("width"), "width") * parse_number(line.at("height"), "height");
        const double ns_per_pixel = parse_number(line.at("ns_per_pixel"), "ns_per_pixel");
        EXPECT_NEAR(ns_per_pixel, ms * 1e6 / pixels, 1e-9 * ns_per_pixel);
        if (line.at("ns_per_sample").empty()) {
            EXPECT_EQ(line.at("fetches_per_pixel"), "");
            continue;
        }
        EXPECT_EQ(line.at("fetches_per_pixel"), "18.5");
        EXPECT_EQ(line.at("cell"), "hemisphere_ssao");
        EXPECT_EQ(line.at("pass"), "hemisphere_ssao/occlusion");
        EXPECT_NEAR(parse_number(line.at("ns_per_sample"), "ns_per_sample"), ns_per_pixel / 16.0,
                    1e-9 * ns_per_pixel);
        ++sampling;
    }
    EXPECT_GT(inputs, 0);
    EXPECT_EQ(sampling, 2) << "one a round";
}

} // namespace
} // namespace alcove
