#include "core/base/error.hpp"
#include "core/base/image_file.hpp"
#include "reports/analysis/comparison.hpp"
#include "reports/analysis/comparison_time.hpp"
#include "reports/analysis/comparison_wording.hpp"
#include "reports/csv/comparison_csv.hpp"
#include "reports/html/comparison_page.hpp"
#include "reports/markdown/comparison_markdown.hpp"
#include "reports/record/csv.hpp"
#include "reports/terminal/comparison_table.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace alcove {
namespace {

using synthetic::TemporaryFolder;

/// How a run differs from the synthetic one.
struct Edits {
    synthetic::Options options;
    std::function<void(ContextRecord&)> context = [](ContextRecord&) {};
    std::function<void(PlanRecord&)> plan = [](PlanRecord&) {};
    std::function<void(SampleRow&)> sample = [](SampleRow&) {};
    std::function<void(MetricRow&)> metric = [](MetricRow&) {};
};

class ComparisonTest : public ::testing::Test {
  protected:
    RunFolder write(const std::string& name, const Edits& edits = {}) {
        ContextRecord context = synthetic::make_context();
        edits.context(context);
        PlanRecord plan = synthetic::make_plan(edits.options);
        edits.plan(plan);
        RunFolder run = RunFolder::create(folder.path() / name, context, plan);
        for (int i = 0; i < edits.options.finished_rounds; ++i) {
            const RoundRecord& round = run.plan().rounds[static_cast<std::size_t>(i)];
            std::vector<SampleRow> samples = synthetic::make_samples(run.plan(), round);
            std::for_each(samples.begin(), samples.end(), edits.sample);
            std::vector<MetricRow> metrics = synthetic::make_metrics(round);
            std::for_each(metrics.begin(), metrics.end(), edits.metric);
            run.finish_round(round.id, samples, metrics, {});
        }
        return run;
    }

    TemporaryFolder folder;
};

const CellComparison& find_cell(const Comparison& comparison, const std::string& round,
                                const std::string& cell) {
    return *std::find_if(
        comparison.cells.begin(), comparison.cells.end(),
        [&](const CellComparison& c) { return c.round.id == round && c.base.id == cell; });
}

const QualityComparison& find_quality(const CellComparison& cell, const std::string& metric,
                                      MetricColumn column) {
    return *std::find_if(cell.quality.begin(), cell.quality.end(), [&](const QualityComparison& q) {
        return q.metric == metric && q.column == column;
    });
}

/// One factor a cell and repeat, with a spread of 1 %.
std::function<void(SampleRow&)> make_noise(unsigned seed) {
    return [seed](SampleRow& row) {
        if (row.cell.starts_with("anchor") || row.cell == "harness") {
            return;
        }
        std::seed_seq key{seed, static_cast<unsigned>(row.repeat),
                          static_cast<unsigned>(std::hash<std::string>()(row.round + row.cell))};
        std::mt19937 random(key);
        std::normal_distribution<double> normal;
        row.time_ns = static_cast<std::int64_t>(static_cast<double>(row.time_ns) *
                                                std::exp(0.01 * normal(random)));
    };
}

TEST_F(ComparisonTest, IdenticalRunsAreTheSameInEverything) {
    for (const bool paired : {false, true}) {
        ComparisonOptions options;
        options.paired = paired;
        const std::string which = paired ? "p" : "w";
        const Comparison comparison = compare_runs(write("a" + which), write("b" + which), options);
        // two rounds of four methods, one of them without passes
        EXPECT_EQ(comparison.cells.size(), 8u);
        EXPECT_GT(comparison.count(Verdict::same), 30u);
        for (const Verdict verdict : {Verdict::worse, Verdict::better, Verdict::unknown}) {
            EXPECT_EQ(comparison.count(verdict), 0u) << to_text(verdict);
        }
        EXPECT_TRUE(comparison.unpaired.empty());
        const CellComparison& cell = find_cell(comparison, "r0-balls", "tssao");
        ASSERT_TRUE(cell.time);
        EXPECT_NEAR(cell.time->base.value, synthetic::true_ratio("tssao"), 1e-6);
        EXPECT_NEAR(cell.time->change.value, 1.0, 1e-12);
        EXPECT_TRUE(cell.images.are_identical());
        EXPECT_FALSE(find_cell(comparison, "r0-balls", "none").time);
    }
}

TEST_F(ComparisonTest, ASlowDownOfFivePercentInNoiseOfOneIsWorseAndTheOthersAreNot) {
    Edits base;
    base.sample = make_noise(1);
    Edits next;
    next.sample = [noise = make_noise(2)](SampleRow& row) {
        noise(row);
        if (row.cell == "tssao" && !row.pass.starts_with("input/")) {
            row.time_ns += row.time_ns / 20;
        }
    };
    const Comparison comparison = compare_runs(write("base", base), write("next", next), {});
    for (const CellComparison& cell : comparison.cells) {
        if (cell.base.id == "tssao") {
            EXPECT_EQ(cell.time->verdict, Verdict::worse) << cell.round.id;
            EXPECT_NEAR(cell.time->change.value, 1.05, 0.02);
            ASSERT_TRUE(cell.time->change.interval && cell.time->adjusted_p_value);
            EXPECT_GE(*cell.time->adjusted_p_value, *cell.time->p_value);
        } else if (cell.time) {
            EXPECT_NE(cell.time->verdict, Verdict::worse);
            EXPECT_NE(cell.time->verdict, Verdict::better);
        }
    }
    // Holm: the smallest of six p-values counts six times.
    std::vector<const TimeComparison*> times;
    for (const CellComparison& cell : comparison.cells) {
        if (cell.time) {
            times.push_back(&*cell.time);
        }
    }
    ASSERT_EQ(times.size(), 6u);
    const TimeComparison& least = **std::min_element(
        times.begin(), times.end(),
        [](const TimeComparison* a, const TimeComparison* b) { return *a->p_value < *b->p_value; });
    EXPECT_DOUBLE_EQ(*least.adjusted_p_value, 6.0 * *least.p_value);
    const Comparison reversed = compare_runs(RunFolder::open(folder.path() / "next"),
                                             RunFolder::open(folder.path() / "base"), {});
    EXPECT_EQ(find_cell(reversed, "r0-balls", "tssao").time->verdict, Verdict::better);
    // the rows are sorted: what is worse stands on top
    EXPECT_EQ(list_verdicts(comparison).front().verdict, Verdict::worse);
    EXPECT_EQ(comparison.count(Verdict::worse), 2u);
}

TEST_F(ComparisonTest, TestsByRanksStandBesideAVerdict) {
    ComparisonOptions options;
    options.margin = 0.0;
    Edits base;
    base.options.finished_rounds = 1;
    Edits next = base;
    next.sample = [](SampleRow& row) {
        if (row.cell == "tssao" && row.kind == SampleKind::envelope) {
            row.time_ns = std::llround(static_cast<double>(row.time_ns) * 1.012);
        }
    };
    const Comparison comparison = compare_runs(write("base", base), write("next", next), options);
    const TimeComparison& time = *find_cell(comparison, "r0-balls", "tssao").time;
    // repeats -0.5 .. 0.5 % against 0.7 .. 1.7 %: apart, and so are the ranks
    EXPECT_EQ(time.verdict, Verdict::worse);
    ASSERT_TRUE(time.ranks);
    EXPECT_EQ(time.ranks->test, "mann_whitney");
    EXPECT_NEAR(time.ranks->p_value, 2.0 / 924.0, 1e-12);
    EXPECT_NEAR(time.ranks->adjusted_p_value, 4.0 / 924.0, 1e-12);
    EXPECT_NEAR(*time.ranks->ks_adjusted_p_value, 4.0 / 924.0, 1e-12);
    EXPECT_FALSE(time.is_taken_back);
}

TEST_F(ComparisonTest, AVerdictWithoutRanksBehindItIsUnknown) {
    TimeComparison time;
    time.change = {1.1, Interval{1.05, 1.15}, 1.0, 1.2, 6};
    time.p_value = 0.001;
    time.margin = 0.02;
    time.ranks = RankEvidence{"mann_whitney", 0.03, 0.06, 0.03, 0.06};
    judge_times({&time});
    EXPECT_EQ(time.verdict, Verdict::unknown);
    EXPECT_TRUE(time.is_taken_back);
    time.ranks->ks_adjusted_p_value = 0.04; // one of them is enough
    time.is_taken_back = false;
    judge_times({&time});
    EXPECT_EQ(time.verdict, Verdict::worse);
    EXPECT_FALSE(time.is_taken_back);
    time.change = {1.0, Interval{0.99, 1.01}, 0.98, 1.02, 6};
    time.ranks->p_value = time.ranks->adjusted_p_value = 0.9; // what is the same stays so
    time.ranks->ks_adjusted_p_value = 0.9;
    judge_times({&time});
    EXPECT_EQ(time.verdict, Verdict::same);
}

TEST_F(ComparisonTest, PairsAreJudgedBySignedRanksAlone) {
    Edits next;
    next.sample = [](SampleRow& row) {
        if (row.cell == "tssao" && row.kind == SampleKind::envelope) {
            row.time_ns += row.time_ns / (20 + row.repeat);
        }
    };
    ComparisonOptions options;
    options.paired = true;
    const Comparison comparison = compare_runs(write("base"), write("next", next), options);
    const TimeComparison& time = *find_cell(comparison, "r0-balls", "tssao").time;
    ASSERT_TRUE(time.ranks);
    EXPECT_EQ(time.ranks->test, "signed_ranks");
    EXPECT_NEAR(time.ranks->adjusted_p_value, 2.0 / 64.0, 1e-12);
    EXPECT_FALSE(time.ranks->ks_p_value);
    EXPECT_EQ(time.verdict, Verdict::worse);
}

TEST_F(ComparisonTest, DiscoveriesAreCountedOverTimesAndMetrics) {
    Edits next;
    next.sample = [](SampleRow& row) {
        if (row.cell == "tssao") {
            row.time_ns += row.time_ns / 10;
        }
    };
    const Comparison comparison = compare_runs(write("base"), write("next", next), {});
    const Discoveries count = comparison.count_discoveries();
    EXPECT_EQ(count.all_times, 6u);
    EXPECT_EQ(count.times, 2u);
    EXPECT_GT(count.all_by_segment, 0u);
    EXPECT_GT(count.all_by_frame, 0u);
    EXPECT_EQ(count.by_segment + count.by_frame, 0u) << "images are identical";
    for (const CellComparison& cell : comparison.cells) {
        if (cell.time) {
            ASSERT_TRUE(cell.time->discovery_p_value);
            EXPECT_GE(*cell.time->discovery_p_value, *cell.time->p_value);
        }
    }
    const std::string csv = make_comparison_csv(comparison);
    const std::string page = make_comparison_page(comparison, folder.path());
    const std::string table = make_comparison_table(comparison);
    const std::string markdown = make_comparison_markdown(comparison);
    EXPECT_NE(csv.find("p_value,p_holm,p_bh,rank_test,p_rank,p_rank_holm,p_ks,p_ks_holm"),
              std::string::npos);
    EXPECT_NE(csv.find(",mann_whitney,"), std::string::npos);
    EXPECT_NE(page.find("<th>p (Holm)</th><th>p (BH)</th>"), std::string::npos);
    for (const std::string& text : {page, table, markdown}) {
        EXPECT_NE(text.find("MW 0.0043, KS 0.0043"), std::string::npos);
        EXPECT_NE(text.find("2 of 6 times"), std::string::npos);
    }
}

TEST_F(ComparisonTest, PassesExplainWhereTheTimeWent) {
    Edits next;
    next.sample = [](SampleRow& row) {
        if (row.pass == "tssao/blur") {
            row.time_ns *= 2;
        }
    };
    const Comparison comparison = compare_runs(write("base"), write("next", next), {});
    const CellComparison& cell = find_cell(comparison, "r0-balls", "tssao");
    const auto blur = std::find_if(cell.parts.begin(), cell.parts.end(),
                                   [](const PartComparison& p) { return p.part == "tssao/blur"; });
    ASSERT_NE(blur, cell.parts.end());
    // 0.25 of a cell that costs 3 anchors, over an anchor pass of 1.02: 0.735 more
    EXPECT_NEAR(blur->difference->value, 0.75 / 1.02, 1e-3);
    EXPECT_EQ(cell.time->verdict, Verdict::same) << "passes are never gated";
}

TEST_F(ComparisonTest, TheMarginIsNeverFinerThanTheNoiseOfTheAnchors) {
    Edits noisy;
    noisy.sample = [](SampleRow& row) {
        if (row.cell == "anchor_repeat") {
            row.time_ns += row.repeat % 2 == 0 ? row.time_ns / 10 : 0;
        }
    };
    const Comparison comparison = compare_runs(write("base"), write("next", noisy), {});
    const TimeComparison& time = *find_cell(comparison, "r0-balls", "tssao").time;
    EXPECT_GT(time.margin, 0.05);
    EXPECT_EQ(time.margin, time.detectable);
}

TEST_F(ComparisonTest, UnderFiveRepeatsThereIsNoVerdict) {
    Edits few;
    few.options.repeats = 4;
    const Comparison comparison = compare_runs(write("base", few), write("next"), {});
    const TimeComparison& time = *find_cell(comparison, "r0-balls", "tssao").time;
    EXPECT_EQ(time.verdict, Verdict::unknown);
    EXPECT_FALSE(time.change.interval);
    EXPECT_FALSE(time.p_value);
    EXPECT_EQ(time.change.n, 4u);
}

TEST_F(ComparisonTest, PairsTakeOutADriftThatTheyShare) {
    // 3 % a repeat, the same in both runs, and 3 % more in NEW.
    const auto drift = [](double factor) {
        return [factor](SampleRow& row) {
            if (row.cell == "tssao") {
                row.time_ns = static_cast<std::int64_t>(static_cast<double>(row.time_ns) * factor *
                                                        (1.0 + 0.03 * row.repeat));
            }
        };
    };
    Edits base;
    base.sample = drift(1.0);
    Edits next;
    next.sample = drift(1.03);
    const RunFolder a = write("base", base);
    const RunFolder b = write("next", next);
    ComparisonOptions options;
    EXPECT_EQ(find_cell(compare_runs(a, b, options), "r0-balls", "tssao").time->verdict,
              Verdict::unknown);
    options.paired = true;
    EXPECT_EQ(find_cell(compare_runs(a, b, options), "r0-balls", "tssao").time->verdict,
              Verdict::worse);
}

/// Every image of a cell is new, with its rmse changed.
Edits change_images(const std::string& cell, double factor, double offset = 0.0) {
    Edits edits;
    edits.metric = [=](MetricRow& row) {
        if (row.cell != cell || row.image_hash.empty()) {
            return;
        }
        row.image_hash = "fedcba9876543210";
        if (row.metric == "rmse") {
            row.value = factor * *row.value + offset;
            row.debiased = factor * *row.debiased + offset;
        }
    };
    return edits;
}

TEST_F(ComparisonTest, ErrorsAreJudgedByTheirMargin) {
    const RunFolder base = write("base");
    // rmse 0.06, floor 0.004: the floor is larger than 1 %
    const auto judge = [&](const std::string& name, double offset) {
        const Comparison comparison =
            compare_runs(base, write(name, change_images("hemisphere_ssao", 1.0, offset)), {});
        return find_quality(find_cell(comparison, "r0-balls", "hemisphere_ssao"), "rmse",
                            MetricColumn::cold);
    };
    const QualityComparison worse = judge("worse", 0.005);
    EXPECT_EQ(worse.verdict, Verdict::worse);
    EXPECT_NEAR(worse.difference.value, 0.005, 1e-12);
    EXPECT_NEAR(worse.margin, synthetic::kRmseFloor, 1e-12);
    EXPECT_TRUE(worse.is_margin_floor);
    EXPECT_FALSE(worse.is_by_segment) << "three bursts are too few units";
    EXPECT_EQ(worse.difference.n, 48u);
    EXPECT_EQ(judge("better", -0.005).verdict, Verdict::better);
    EXPECT_EQ(judge("same", 0.003).verdict, Verdict::same);
}

TEST_F(ComparisonTest, SegmentsAreTheUnitWhereThereAreEnough) {
    const Comparison comparison =
        compare_runs(write("base"), write("next", change_images("tssao", 3.0)), {});
    const QualityComparison& converged =
        find_quality(find_cell(comparison, "r0-balls", "tssao"), "rmse", MetricColumn::converged);
    EXPECT_TRUE(converged.is_by_segment);
    EXPECT_EQ(converged.difference.n, 8u);
    EXPECT_EQ(converged.verdict, Verdict::worse);
}

TEST_F(ComparisonTest, HigherIsBetterWhereTheMetricSaysSo) {
    Edits next = change_images("none", 1.0);
    next.metric = [change = next.metric](MetricRow& row) {
        change(row);
        if (row.cell == "none" && row.metric == "ssim") {
            row.value = *row.value + 0.1;
        }
    };
    const Comparison comparison = compare_runs(write("base"), write("next", next), {});
    EXPECT_EQ(
        find_quality(find_cell(comparison, "r0-balls", "none"), "ssim", MetricColumn::cold).verdict,
        Verdict::better);
}

TEST_F(ComparisonTest, AFewUnitsMustAgree) {
    const auto with_last = [](double last) {
        Edits edits;
        edits.plan = [](PlanRecord& plan) {
            for (RoundRecord& round : plan.rounds) {
                round.segments = {{0, 3}};
                round.image_frames = {0};
                round.film = {};
                round.events.clear();
            }
        };
        edits.metric = [last](MetricRow& row) {
            if (row.cell != "hemisphere_ssao" || last == 0.0 || row.image_hash.empty()) {
                return;
            }
            row.image_hash = "fedcba9876543210";
            if (row.metric == "rmse") {
                *row.debiased += row.frame == 2 ? last : 0.02;
            }
        };
        return edits;
    };
    const RunFolder base = write("base", with_last(0.0));
    const auto judge = [&](const std::string& name, double last) {
        const Comparison comparison = compare_runs(base, write(name, with_last(last)), {});
        return *find_quality(find_cell(comparison, "r0-balls", "hemisphere_ssao"), "rmse",
                             MetricColumn::cold)
                    .verdict;
    };
    EXPECT_EQ(judge("agree", 0.01), Verdict::worse);
    EXPECT_EQ(judge("disagree", -0.01), Verdict::unknown);
}

TEST_F(ComparisonTest, AValueThatOnlyOneRunHasIsNotTheSame) {
    Edits next = change_images("none", 1.0);
    next.metric = [change = next.metric](MetricRow& row) {
        change(row);
        if (row.cell == "none" && row.metric == "rmse" && row.frame == 0) {
            row.value.reset();
            row.debiased.reset();
            row.note = "not a number";
        }
    };
    const Comparison comparison = compare_runs(write("base"), write("next", next), {});
    const QualityComparison& quality =
        find_quality(find_cell(comparison, "r0-balls", "none"), "rmse", MetricColumn::cold);
    EXPECT_EQ(quality.verdict, Verdict::unknown);
    EXPECT_EQ(quality.frames, 47u);
    EXPECT_NE(quality.note.find("1 frames"), std::string::npos);
}

TEST_F(ComparisonTest, ChangedImagesAreListedWithTheirPictures) {
    synthetic::Options options;
    options.images = true;
    const RunFolder base = synthetic::write_run(folder.path() / "base", options);
    Edits edits = change_images("hemisphere_ssao", 1.0);
    edits.options = options;
    const RunFolder next = write("next", edits);
    std::filesystem::copy(folder.path() / "base" / "images", folder.path() / "next" / "images",
                          std::filesystem::copy_options::recursive);
    // the middle single: all white instead
    const std::string kept =
        RunFolder::make_image_path("r0-balls", "hemisphere_ssao", 54, "visibility");
    const Image before = read_image_file(folder.path() / "base" / kept).image;
    Image white(before.size(), before.channels());
    double expected = 0.0;
    for (std::size_t i = 0; i < white.values().size(); ++i) {
        white.values()[i] = 1.0f;
        expected += 255.0 * (1.0 - static_cast<double>(before.values()[i]));
    }
    expected /= static_cast<double>(white.values().size());
    write_png(folder.path() / "next" / kept, white, Domain::view);

    const Comparison comparison = compare_runs(base, next, {});
    const ImageComparison& images = find_cell(comparison, "r0-balls", "hemisphere_ssao").images;
    EXPECT_EQ(images.images, 3u * 16u + 8u);
    EXPECT_EQ(images.changed, images.images);
    EXPECT_EQ(images.first.front(), "frame 0 cold");
    const auto picture = std::find_if(images.pictures.begin(), images.pictures.end(),
                                      [&](const PictureChange& p) { return p.base == kept; });
    ASSERT_NE(picture, images.pictures.end());
    EXPECT_NEAR(picture->mean_difference.value(), expected, 1e-3);
    EXPECT_TRUE(find_cell(comparison, "r0-balls", "tssao").images.are_identical());
    // by relative path, from a folder beside both runs
    const std::string page = make_comparison_page(comparison, folder.path() / "out");
    EXPECT_NE(page.find("src=\"../base/" + kept), std::string::npos);
    EXPECT_NE(page.find("src=\"../next/" + kept), std::string::npos);
    EXPECT_EQ(describe_images(comparison).size(), 2u) << "one line a changed cell of each round";
}

TEST_F(ComparisonTest, PicturesThatWereNotKeptAreSaidToBeMissing) {
    const Comparison comparison =
        compare_runs(write("base"), write("next", change_images("none", 1.0)), {});
    EXPECT_NE(describe_images(comparison).front().find("no picture of them was kept by both"),
              std::string::npos);
}

TEST_F(ComparisonTest, WhatHasNoPartnerIsListedWithTheReason) {
    Edits edits;
    edits.options.finished_rounds = 1;
    edits.plan = [](PlanRecord& plan) {
        for (RoundRecord& round : plan.rounds) {
            for (CellRecord& cell : round.cells) {
                cell.label = cell.id == "tssao" ? "tssao#renamed" : cell.label;
                cell.effects = cell.id == "none" ? "contact" : cell.effects;
            }
        }
        plan.metrics.pop_back();
    };
    edits.metric = [](MetricRow& row) {
        row.metric = row.metric == "history_age" ? "history_samples" : row.metric;
    };
    const Comparison comparison = compare_runs(write("base"), write("next", edits), {});
    EXPECT_EQ(comparison.cells.size(), 2u) << "the two of hemisphere_ssao in the first round";
    std::string text;
    for (const std::string& line : describe_unpaired(comparison)) {
        text += line + "\n";
    }
    for (const char* part :
         {"only BASE: tssao in balls", "only NEW: tssao#renamed in balls", "effects contact there",
          "the round is not finished", "its round is not finished in the other run",
          "only BASE: metric history_age"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in\n" << text;
    }
}

TEST_F(ComparisonTest, NothingInCommonIsRefusedWithWhatDiffers) {
    Edits edits;
    edits.plan = [](PlanRecord& plan) {
        for (RoundRecord& round : plan.rounds) {
            round.width = 640;
        }
    };
    const RunFolder base = write("base");
    const RunFolder next = write("next", edits);
    try {
        static_cast<void>(compare_runs(base, next, {}));
        FAIL() << "compared";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("size 640x180 there"), std::string::npos)
            << error.what();
    }
}

TEST_F(ComparisonTest, OtherSettingsUnderTheSameLabelAreSaidAndCompared) {
    Edits edits;
    edits.plan = [](PlanRecord& plan) { plan.rounds[0].cells[3].parameters[0].value = "32"; };
    const Comparison comparison = compare_runs(write("base"), write("next", edits), {});
    EXPECT_EQ(comparison.cells.size(), 8u);
    const std::vector<std::string> lines = describe_settings(comparison);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NE(lines[0].find("samples 16 -> 32"), std::string::npos) << lines[0];
}

TEST_F(ComparisonTest, OtherAnchorsAndDevicesAreRefusedByName) {
    const ContextRecord base = synthetic::make_context();
    EXPECT_NO_THROW(check_comparable(base, base));
    const auto expect_refused = [&](const char* field, auto&& change) {
        ContextRecord next = base;
        change(next);
        try {
            check_comparable(base, next);
            ADD_FAILURE() << field << " was accepted";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
        }
    };
    expect_refused("anchor_version", [](ContextRecord& c) { c.anchor_version = "2"; });
    expect_refused("device_class", [](ContextRecord& c) { c.device_class = "discrete"; });
    expect_refused("gl_renderer", [](ContextRecord& c) { c.gl_renderer = "other"; });
    expect_refused("gl_version", [](ContextRecord& c) { c.gl_version = "4.6"; });
    expect_refused("driver_threads", [](ContextRecord& c) { c.driver_threads = 1; });
    expect_refused("timer_mode", [](ContextRecord& c) { c.timer_mode = "fenced_wall"; });
    Edits edits;
    edits.context = [](ContextRecord& c) { c.anchor_version = "2"; };
    const RunFolder a = write("base");
    const RunFolder b = write("next", edits);
    EXPECT_THROW(static_cast<void>(compare_runs(a, b, {})), InputError);
}

TEST_F(ComparisonTest, HostileTextStaysText) {
    Edits edits;
    edits.options.hostile = true;
    const Comparison comparison = compare_runs(write("base", edits), write("next", edits), {});
    for (const std::string& page :
         {make_comparison_page(comparison, folder.path()), make_comparison_markdown(comparison)}) {
        EXPECT_EQ(page.find("<img src=x"), std::string::npos);
        EXPECT_EQ(page.find("<script"), std::string::npos);
    }
    const std::string table = make_comparison_table(comparison);
    EXPECT_TRUE(std::none_of(table.begin(), table.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 && c != '\n';
    }));
}

TEST_F(ComparisonTest, EveryCsvLineHasTheColumnsOfTheHead) {
    const std::string text = make_comparison_csv(
        compare_runs(write("base"), write("next", change_images("tssao", 2.0)), {}));
    CsvReader reader(text, "comparison.csv");
    std::vector<std::string> head;
    std::vector<std::string> fields;
    ASSERT_TRUE(reader.next(head));
    const auto column = [&](const char* name) {
        return static_cast<std::size_t>(std::find(head.begin(), head.end(), name) - head.begin());
    };
    int times = 0;
    int parts = 0;
    while (reader.next(fields)) {
        ASSERT_EQ(fields.size(), head.size()) << reader.where();
        times += fields[column("kind")] == "time" ? 1 : 0;
        parts += fields[column("kind")] == "part" ? 1 : 0;
        EXPECT_EQ(fields[column("verdict")].empty(),
                  fields[column("kind")] == "part" || fields[column("kind")] == "history");
    }
    EXPECT_EQ(times, 6);
    EXPECT_GT(parts, times);
}

} // namespace
} // namespace alcove
