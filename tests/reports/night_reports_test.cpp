// What a night leaves behind: JUnit's XML, Google Benchmark's JSON, Markdown, the dashboard.

#include "reports/google_benchmark/google_benchmark.hpp"
#include "reports/html/dashboard_page.hpp"
#include "reports/junit/escape.hpp"
#include "reports/junit/junit.hpp"
#include "reports/markdown/night_markdown.hpp"
#include "tests/reports/forged_store.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alcove {
namespace {

const std::string kMark = "<script>&\"']]></failure>\x01\xff`|*";

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

/// Twelve nights, then one with a slower envelope, another image and a worse metric of method_0.
class NightReports : public testing::Test {
  protected:
    explicit NightReports(const std::string& text = "") {
        forged::append_nights(m_store, {.nights = 12, .methods = 2, .text = text});
        const std::string method = "method_0" + text;
        const auto make = [&](SeriesKind kind, const char* pass, const char* metric, double value) {
            return forged::make_point(kind, forged::make_name(method, "cold", pass, metric), value);
        };
        const std::vector<NightPoint> points{
            make(SeriesKind::time, "envelope", "x anchor", 3.0),
            make(SeriesKind::pass, "forged/occlusion", "x anchor", 1.0),
            make(SeriesKind::milliseconds, "envelope", "ms", 12.0),
            make(SeriesKind::quality, "", "rmse", 0.05),
            make(SeriesKind::quality, "", "novel", 0.05),
            forged::make_images(method, "ffff")};
        m_night = judge_night(m_store.read(), forged::make_run(12), points);
        confirm_times(m_night, points);
        m_store.append(m_night.run, make_rows(m_night));
    }
    Store m_store{":memory:"};
    Night m_night;
};

class HostileNightReports : public NightReports {
  protected:
    HostileNightReports() : NightReports(kMark) {}
};

TEST(EscapeXml, NothingThatXmlHasNoFormForIsLeft) {
    EXPECT_EQ(escape_xml("a<b>&\"'\n"), "a&lt;b&gt;&amp;&quot;&apos; ");
    EXPECT_EQ(escape_xml("\x01"), "\xef\xbf\xbd");
    EXPECT_EQ(escape_xml("\xc3\xa9\xe2\x82\xac\xf0\x9f\x90\xb0"),
              "\xc3\xa9\xe2\x82\xac\xf0\x9f\x90\xb0");
    // Cut off, overlong, a surrogate, U+FFFF, beyond U+10FFFF.
    for (const char* bytes : {"\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xef\xbf\xbf",
                              "\xf5\x80\x80\x80", "\xe0\x80\x80", "\x80"}) {
        const std::string escaped = escape_xml(bytes);
        EXPECT_EQ(count(escaped, "\xef\xbf\xbd"), std::string(bytes).size()) << escaped;
    }
}

TEST_F(NightReports, JUnitHasACaseForEveryGatedSeries) {
    const std::string xml = make_junit_xml(m_night);
    EXPECT_NE(xml.find("tests=\"5\" failures=\"3\" errors=\"0\" skipped=\"1\""), std::string::npos)
        << xml;
    EXPECT_EQ(count(xml, "<testcase "), 5u) << "milliseconds are not gated";
    EXPECT_EQ(count(xml, "<failure "), 3u);
    EXPECT_NE(xml.find("type=\"slower\""), std::string::npos);
    EXPECT_NE(xml.find("type=\"image changed\""), std::string::npos);
    EXPECT_NE(xml.find("<skipped message=\"too little history"), std::string::npos);
    EXPECT_NE(xml.find("name=\"method_0: rmse cold\""), std::string::npos);
}

TEST_F(NightReports, MarkdownNamesFailuresFirst) {
    const std::string text = make_night_markdown(m_night);
    const std::size_t slower = text.find("**slower**");
    const std::size_t worse = text.find("**worse**");
    const std::size_t image = text.find("**image changed**");
    EXPECT_LT(slower, worse);
    EXPECT_LT(worse, image);
    EXPECT_NE(image, std::string::npos);
    EXPECT_NE(text.find("software"), std::string::npos);
    EXPECT_NE(text.find("second measurement"), std::string::npos);
}

TEST_F(NightReports, TheDashboardSaysEverythingWithoutTheScript) {
    std::string page = make_dashboard_page(m_store.read());
    page = page.substr(0, page.find("<script"));
    const std::size_t verdict = page.find(">slower</span>");
    ASSERT_NE(verdict, std::string::npos);
    EXPECT_LT(verdict, page.find("series, their last night")) << "findings first";
    for (const char* part :
         {"image changed", ">worse</span>", "software", "forged/occlusion", "x anchor", "12.00 ms",
          "Fence", "../night12/run/report/index.html", "13 nights"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
}

TEST_F(HostileNightReports, NothingOfAStoreBecomesMarkup) {
    const std::string xml = make_junit_xml(m_night);
    EXPECT_EQ(count(xml, "<script"), 0u);
    EXPECT_EQ(count(xml, "\x01"), 0u);
    EXPECT_EQ(count(xml, "\xff"), 0u);
    EXPECT_EQ(count(xml, "</failure>"), 3u);
    const std::string markdown = make_night_markdown(m_night);
    EXPECT_EQ(count(markdown, "<script"), 0u);
    const std::string page = make_dashboard_page(m_store.read());
    EXPECT_EQ(count(page, "<script>&"), 0u);
    EXPECT_EQ(count(page, "</failure>"), 0u);
    const std::string no_script = page.substr(0, page.find("<script"));
    EXPECT_GT(count(no_script, "&lt;script&gt;"), 0u);
}

TEST(DashboardPage, FoldersOutsideTheStoreAreNotLinked) {
    for (const char* folder : {"/etc/run", "../run", "a/../../run", "//host/run", ""}) {
        Store store(":memory:");
        StoredRun run = forged::make_run(0);
        run.folder = folder;
        forged::Noise noise(1);
        std::vector<NightRow> rows;
        for (NightPoint& point : forged::make_night({}, 0, noise)) {
            rows.push_back({std::move(point), {}});
        }
        store.append(run, rows);
        EXPECT_EQ(make_dashboard_page(store.read()).find("report/index.html"), std::string::npos)
            << folder;
    }
}

TEST(DashboardPage, AnEmptyStoreHasAPage) {
    EXPECT_NE(make_dashboard_page(Store(":memory:").read()).find("0 nights"), std::string::npos);
}

TEST(GoogleBenchmark, EveryRepeatIsAnEntryAndTheMeanIsTheirs) {
    const synthetic::TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {});
    const auto json = nlohmann::json::parse(make_google_benchmark_json(run));
    EXPECT_EQ(json.at("context").at("library_build_type"), "release");
    EXPECT_EQ(json.at("context").at("device_class"), "software");
    double sum = 0.0;
    double mean = 0.0;
    double log_ratios = 0.0;
    std::set<int> repeats;
    for (const auto& entry : json.at("benchmarks")) {
        EXPECT_EQ(entry.at("time_unit"), "ms");
        EXPECT_EQ(entry.at("label"), "software");
        EXPECT_TRUE(entry.at("cpu_time").is_number());
        const std::string name = entry.at("run_name");
        if (!name.starts_with("tssao/courtyard") || name.find("pass:") != std::string::npos) {
            continue;
        }
        if (entry.at("run_type") == "iteration") {
            repeats.insert(entry.at("repetition_index").get<int>());
            sum += entry.at("real_time").get<double>();
            log_ratios += std::log(entry.at("x_anchor").get<double>());
        } else if (entry.at("aggregate_name") == "mean") {
            mean = entry.at("real_time");
        }
    }
    EXPECT_EQ(repeats.size(), 6u);
    EXPECT_NEAR(mean, sum / 6.0, 1e-9);
    EXPECT_NEAR(std::exp(log_ratios / 6.0), synthetic::true_ratio("tssao"), 1e-6);
}

TEST(GoogleBenchmark, HostileNamesStayInsideTheirStrings) {
    const synthetic::TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {.hostile = true});
    const auto json = nlohmann::json::parse(make_google_benchmark_json(run));
    EXPECT_GT(json.at("benchmarks").size(), 10u);
}

} // namespace
} // namespace alcove
