#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/html_report.hpp"
#include "reports/html/page_data.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

using synthetic::TemporaryFolder;

/// How often `part` stands in `text`.
std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

std::string write_page(const RunFolder& run, const HtmlOptions& options = {}) {
    write_html_report(run, options);
    return read_file((options.out.empty() ? run.path() / "report" : options.out) / "index.html");
}

TEST(Escape, TextCannotBecomeMarkup) {
    EXPECT_EQ(escape_html("<script>a && 'b' \"c\"</script>"),
              "&lt;script&gt;a &amp;&amp; &#39;b&#39; &quot;c&quot;&lt;/script&gt;");
    EXPECT_EQ(escape_html(std::string("a\0b\x1b[2Jc\nd", 10)), "a b [2Jc\nd");
}

TEST(Escape, InlineJsonCannotEndItsElement) {
    EXPECT_EQ(escape_inline_json("{\"a\":\"</script><!--&\"}"),
              "{\"a\":\"\\u003c/script\\u003e\\u003c!--\\u0026\"}");
    EXPECT_EQ(escape_inline_json("\xe2\x80\xa8\xe2\x80\xa9\xe2\x82\xac"),
              "\\u2028\\u2029\xe2\x82\xac");
}

TEST(Escape, PathsAreEncodedForUrls) {
    EXPECT_EQ(escape_url_path("../a b/c#d?e%f\".png"), "../a%20b/c%23d%3Fe%25f%22.png");
}

TEST(HtmlReport, SaysEverythingWithoutTheScript) {
    const TemporaryFolder folder;
    std::string page = write_page(synthetic::write_run(folder.path(), {}));
    page = page.substr(0, page.find("<script")); // the tables stand before
    for (const char* part : {"complete: 2 rounds",
                             "hemisphere_ssao:samples=64",
                             "software",
                             "llvmpipe",
                             "timestamp_finish",
                             "[2.4902, 2.5098] (n=6)",
                             "&lt; 0.00400",
                             "Not beaten in both time and error",
                             "under 50 ticks",
                             "input/motion",
                             "time_elapsed",
                             "refused",
                             "its mesh is not here",
                             "CC0-1.0",
                             "Blind to:",
                             "linear falloff is approximated",
                             "command line",
                             "A/A 1.0000",
                             "reference floor 0.00400 rmse",
                             "Over time",
                             "&times;255: 5.10",
                             "&times;255: &lt; 0.510",
                             "history_samples",
                             "neither good nor bad",
                             "11.5",
                             "Cold against converged",
                             "nothing came into view",
                             "reference_ray_traced",
                             "box lifts",
                             "Its pictures were not kept",
                             "<small>Balls on a floor</small>"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(count(page, "<td class=\"absent\">not kept"), 2u * 3u * 4u * 5u); // none was written
    EXPECT_EQ(page.find("in progress"), std::string::npos);
}

TEST(HtmlReport, HasNoAddressOfANetwork) {
    const TemporaryFolder folder;
    const std::string page = write_page(synthetic::write_run(folder.path(), {.images = true}));
    EXPECT_EQ(count(page, "src=\"http") + count(page, "href=\"http") + count(page, "@import"), 0u);
    EXPECT_EQ(count(page, "fetch("), 0u);
}

TEST(HtmlReport, HostileTextsStayTexts) {
    const TemporaryFolder folder;
    const std::string page =
        write_page(synthetic::write_run(folder.path(), {.hostile = true}),
                   {.in_progress = true,
                    .provisional = {{"r1-courtyard", "tssao", "</td><script>", 1.0}},
                    .out = {}});
    EXPECT_EQ(count(page, "<img src=x"), 0u);
    EXPECT_EQ(count(page, "<script>document"), 0u);
    EXPECT_EQ(count(page, "</script>"), count(page, "<script"));
    EXPECT_GT(count(page, "&lt;img src=x"), 20u);
}

TEST(HtmlReport, InProgressAndProvisionalAreMarked) {
    const TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {.finished_rounds = 1});
    const HtmlOptions options{
        .in_progress = true, .provisional = {{"r1-courtyard", "tssao", "tssao", 12.5}}, .out = {}};
    const std::string page = write_page(run, options);
    EXPECT_NE(page.find("in progress: 1 of 2 rounds"), std::string::npos);
    EXPECT_NE(page.find("provisional</span>"), std::string::npos);
    EXPECT_NE(page.find("12.5<small>(n=1)"), std::string::npos);
    EXPECT_NE(write_page(run).find("incomplete: 1 of 2 rounds"), std::string::npos);
}

TEST(HtmlReport, OneRoundIsNoRounds) {
    const TemporaryFolder folder;
    PlanRecord plan = synthetic::make_plan({.repeats = 1});
    plan.rounds.resize(1);
    RunFolder run = RunFolder::create(folder.path(), synthetic::make_context(), plan);
    EXPECT_NE(write_page(run).find("incomplete: 0 of 1 round;"), std::string::npos);
    run.finish_round("r0-balls", synthetic::make_samples(plan, plan.rounds[0]), {}, {});
    const std::string page = write_page(run);
    EXPECT_NE(page.find("complete: 1 round<"), std::string::npos);
    EXPECT_EQ(page.find("temporal_flicker</th>"), std::string::npos); // no rows, no table
}

TEST(HtmlReport, TheFilmIsMadeOfFilesThatAreThere) {
    const TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {.images = true});
    std::filesystem::remove(folder.path() / "images/r0-balls/tssao/0043_film_age.png");
    const std::string page = write_page(run);
    EXPECT_GT(count(page, "images/r0-balls/tssao/0042_film_age.png"), 0u);
    EXPECT_EQ(count(page, "0043_film_age.png"), 0u);
    EXPECT_EQ(count(page, "0040_film_temporal_flicker.png"), 0u); // none on the first frame
    EXPECT_EQ(count(page, "film_missed_invalidation.png"), 0u);
    EXPECT_EQ(count(page, "data-film="), 1u); // the second round has none
}

TEST(HtmlReport, AnEmptyRunHasAPage) {
    const TemporaryFolder folder;
    const std::string page =
        write_page(synthetic::write_run(folder.path(), {.finished_rounds = 0}));
    EXPECT_NE(page.find("waiting"), std::string::npos);
}

TEST(HtmlReport, ARoundOfRadianceShowsPicturesAndNamesTheirToneCurve) {
    const TemporaryFolder folder;
    const std::string page =
        write_page(synthetic::write_run(folder.path(), {.images = true, .radiance = true}));
    const std::size_t second = page.find("id=\"round-r1-");
    ASSERT_NE(second, std::string::npos);
    const std::string round = page.substr(0, second);
    EXPECT_NE(round.find("<dt>Measured</dt><dd>picture</dd>"), std::string::npos);
    EXPECT_NE(round.find("output=radiance,reach=near"), std::string::npos);
    EXPECT_NE(round.find("tone curve of Reinhard et al. 2002"), std::string::npos);
    EXPECT_NE(round.find("hemisphere_ssao/0006_picture.png"), std::string::npos);
    EXPECT_NE(round.find("reference/0006_picture.png"), std::string::npos);
    EXPECT_NE(round.find("reference/0040_film_picture.png"), std::string::npos);
    EXPECT_EQ(round.find("<th>Visibility</th>"), std::string::npos);
    EXPECT_EQ(round.find("<th>Shaded</th>"), std::string::npos);
    EXPECT_EQ(round.find("<td class=\"absent\">not kept"), std::string::npos);
    const std::string rest = page.substr(second);
    EXPECT_NE(rest.find("<dt>Measured</dt><dd>visibility</dd>"), std::string::npos);
    EXPECT_EQ(rest.find("tone curve"), std::string::npos);
}

TEST(HtmlReport, PicturesAreRelativeToThePage) {
    const TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path() / "run 1", {.images = true});
    EXPECT_GT(count(write_page(run), "src=\"../images/r0-balls/tssao/0006_error.png\""), 0u);
    const std::string elsewhere =
        write_page(run, {.in_progress = false, .provisional = {}, .out = folder.path() / "pages"});
    EXPECT_GT(count(elsewhere, "src=\"../run%201/images/r0-balls/tssao/0006_error.png\""), 0u);
    EXPECT_EQ(count(elsewhere, "<td class=\"absent\">not kept"),
              3u * 3u); // tssao's own three kinds in the second round
}

} // namespace
} // namespace alcove
