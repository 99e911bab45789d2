// What a round measures and keeps (DESIGN 3.1 to 3.3).

#include "core/base/hash.hpp"
#include "tests/harness/round_runner_fixture.hpp"

#include <map>
#include <set>
#include <tuple>

namespace alcove {
namespace {

using FrameKey = std::tuple<int, int, int>; // repeat, segment, frame

std::map<FrameKey, std::vector<SampleRow>> group_by_frame(const std::vector<SampleRow>& rows) {
    std::map<FrameKey, std::vector<SampleRow>> groups;
    for (const SampleRow& row : rows) {
        groups[{row.repeat, row.segment, row.frame}].push_back(row);
    }
    return groups;
}

/// Rows of passes: not the G-buffer's, not compose's.
std::vector<SampleRow> keep_method_rows(std::vector<SampleRow> rows) {
    std::erase_if(rows, [](const SampleRow& row) {
        return row.pass.starts_with("input/") || row.pass.starts_with("harness/");
    });
    return rows;
}

std::map<std::string, std::string> list_hashes(const RoundResult& result) {
    std::map<std::string, std::string> hashes;
    for (const MetricRow& row : result.metrics) {
        hashes[row.cell + " " + std::to_string(row.segment) + " " + std::to_string(row.frame) +
               " " + std::string(to_text(row.state))] = row.image_hash;
    }
    return hashes;
}

/// Which instance rendered, in order: frame by frame the order of the cells.
std::vector<int> list_order(const std::vector<HistoryEntry>& log) {
    std::vector<int> order;
    for (const HistoryEntry& entry : log) {
        if (entry.event == HistoryEvent::render) {
            order.push_back(entry.instance);
        }
    }
    return order;
}

TEST_F(RoundRunnerTest, RepeatPlusFrameOddIsDividedEvenIsOneEnvelope) {
    run({"history_method", "template_method"}, 3);
    const std::vector<std::string> ids{cell(0).id, cell(1).id, "anchor-a", "anchor-b"};
    for (const std::string& id : ids) {
        const auto frames = group_by_frame(keep_method_rows(find_samples(id, SampleState::cold)));
        ASSERT_EQ(frames.size(), 3u * kRoundFrames) << id;
        for (const auto& [key, rows] : frames) {
            const bool divided = (std::get<0>(key) + std::get<2>(key)) % 2 != 0;
            ASSERT_EQ(rows.size(), divided && id == cell(0).id ? 2u : 1u) << id;
            for (const SampleRow& row : rows) {
                EXPECT_EQ(row.kind, divided ? SampleKind::divided : SampleKind::envelope);
                EXPECT_EQ(row.pass == "envelope", !divided) << row.pass;
                EXPECT_GT(row.time_ns, 0) << row.pass;
            }
        }
    }
}

TEST_F(RoundRunnerTest, PassesKeepTheirNamesAndOrder) {
    run({"history_method"});
    for (const auto& [key, rows] :
         group_by_frame(keep_method_rows(find_samples(cell(0).id, SampleState::cold)))) {
        if (rows.front().kind == SampleKind::divided) {
            ASSERT_EQ(rows.size(), 2u);
            EXPECT_EQ(rows[0].pass, "history_method/first");
            EXPECT_EQ(rows[1].pass, "history_method/second");
        }
    }
}

TEST_F(RoundRunnerTest, BothKindsAreSampledInEveryRepeat) {
    run({"template_method"}, 4);
    for (const char* id : {"anchor-a", "anchor-b", "c1-template_method"}) {
        std::map<SampleKind, std::set<int>> repeats;
        for (const SampleRow& row : keep_method_rows(find_samples(id, SampleState::cold))) {
            repeats[row.kind].insert(row.repeat);
        }
        EXPECT_EQ(repeats[SampleKind::divided].size(), 4u) << id;
        EXPECT_EQ(repeats[SampleKind::envelope].size(), 4u) << id;
    }
}

TEST_F(RoundRunnerTest, AMethodWithoutPassesHasNoTimeOfItsOwn) {
    run({"none"});
    EXPECT_TRUE(keep_method_rows(find_samples(cell(0).id, SampleState::cold)).empty());
    EXPECT_FALSE(list_hashes(m_result).empty());
}

TEST_F(RoundRunnerTest, ComposeIsTimedBesideEveryMethodAndNoAnchor) {
    run({"none", "template_method"});
    std::map<std::string, int> counts;
    for (const SampleRow& row : m_result.samples) {
        if (row.pass == "harness/compose") {
            EXPECT_EQ(row.kind, SampleKind::divided);
            ++counts[row.cell];
        }
    }
    EXPECT_EQ(counts, (std::map<std::string, int>{{cell(0).id, 2 * kRoundFrames},
                                                  {cell(1).id, 2 * kRoundFrames}}));
}

TEST_F(RoundRunnerTest, TheBaseIsChargedToNobodyAndWhatGoesBeyondToTheMethodThatAskedForIt) {
    run({"history_method", "template_method"});
    std::map<std::pair<std::string, std::string>, int> counts;
    for (const SampleRow& row : m_result.samples) {
        if (row.pass.starts_with("input/")) {
            EXPECT_FALSE(row.cached);
            ++counts[{row.cell, row.pass}];
        }
    }
    const std::map<std::pair<std::string, std::string>, int> expected{
        {{"harness", "input/base"}, 2 * kRoundFrames},
        {{cell(0).id, "input/motion"}, 2 * kRoundFrames}};
    EXPECT_EQ(counts, expected);
}

TEST_F(RoundRunnerTest, TheOrderIsShuffledFrameByFrameAndComesFromTheSeed) {
    const std::vector<std::string> methods{"history_method#a", "history_method#b",
                                           "history_method#c"};
    run(methods, 4, 1);
    const std::vector<int> first = list_order(log());
    // The warm-up frame comes in the plan's order; behind it every frame has an order of its own.
    std::set<std::vector<int>> orders;
    for (std::size_t frame = 0; frame < kRoundFrames; ++frame) {
        const auto begin = first.begin() + static_cast<std::ptrdiff_t>(3 * (frame + 1));
        orders.insert(std::vector<int>(begin, begin + 3));
        EXPECT_EQ(std::set<int>(begin, begin + 3), (std::set<int>{0, 1, 2}));
    }
    EXPECT_GT(orders.size(), 1u);
    run(methods, 4, 1);
    EXPECT_EQ(list_order(log()), first);
    run(methods, 4, 2);
    EXPECT_NE(list_order(log()), first);
}

TEST_F(RoundRunnerTest, ImagesDependNeitherOnTheOrderNorOnTheCompany) {
    run({"hemisphere_ssao", "history_method", "template_method"}, 1, 1);
    const std::map<std::string, std::string> images = list_hashes(m_result);
    EXPECT_EQ(images.size(), 3u * kRoundFrames + 3u);
    run({"hemisphere_ssao", "history_method", "template_method"}, 2, 77);
    EXPECT_EQ(list_hashes(m_result), images);
    run({"hemisphere_ssao"}, 1, 1);
    for (const auto& [key, hash] : list_hashes(m_result)) {
        EXPECT_EQ(images.at(key), hash) << key;
    }
}

TEST_F(RoundRunnerTest, MetricsCoverEveryImageOfEveryMethodAndNoAnchor) {
    run({"template_method", "none"});
    std::map<std::string, std::set<std::string>> metrics;
    for (const MetricRow& row : m_result.metrics) {
        metrics[row.cell + " " + std::to_string(row.frame)].insert(row.metric);
        EXPECT_TRUE(row.value.has_value() || !row.note.empty()) << row.metric;
    }
    EXPECT_EQ(metrics.size(), 2u * kRoundFrames);
    for (const auto& [image, names] : metrics) {
        for (const char* name : {"mse", "rmse", "psnr", "ssim"}) {
            EXPECT_TRUE(names.contains(name)) << image << " " << name;
        }
    }
}

TEST_F(RoundRunnerTest, PicturesAreKeptOfTheChosenFramesAndNoOthers) {
    run({"template_method", "history_method"}, 1);
    std::set<std::string> files;
    const std::filesystem::path images = m_folder.path() / "images";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(images)) {
        if (entry.is_regular_file()) {
            files.insert(std::filesystem::relative(entry.path(), m_folder.path()).generic_string());
        }
    }
    std::set<std::string> expected;
    for (const int frame : {10, 20, 30}) {
        for (const char* picture : {"visibility", "error", "shaded"}) {
            expected.insert(RunFolder::make_image_path(round().id, cell(0).id, frame, picture));
            expected.insert(RunFolder::make_image_path(round().id, cell(1).id, frame, picture));
        }
        expected.insert(RunFolder::make_image_path(round().id, "reference", frame, "visibility"));
        expected.insert(RunFolder::make_image_path(round().id, "reference", frame, "shaded"));
    }
    EXPECT_EQ(files, expected);
}

TEST_F(RoundRunnerTest, TheCallerHearsEveryFrameAndEveryRepeat) {
    std::size_t last = 0;
    std::size_t calls = 0;
    std::vector<std::size_t> samples;
    RoundEvents events;
    events.progress = [&](const RoundProgress& progress) {
        EXPECT_EQ(progress.done, last + 1);
        EXPECT_EQ(progress.all, 3u * kRoundFrames);
        EXPECT_EQ(progress.is_timing, progress.done <= 2u * kRoundFrames);
        last = progress.done;
        ++calls;
    };
    events.repeat_done = [&](const std::vector<SampleRow>& rows, int repeats) {
        samples.push_back(rows.size());
        EXPECT_EQ(static_cast<std::size_t>(repeats), samples.size());
    };
    run({"template_method"}, 2, 1, events);
    EXPECT_EQ(calls, 3u * kRoundFrames);
    ASSERT_EQ(samples.size(), 2u);
    EXPECT_GT(samples[1], samples[0]);
    EXPECT_EQ(samples[1], m_result.samples.size());
}

TEST_F(RoundRunnerTest, RepeatsGoOnUntilIntervalsAreNarrowAndEachSaysWhatTheMachineDid) {
    m_until_width = 0.9999; // so wide that the first look ends it
    int repeats = 0;
    RoundEvents events;
    events.repeat_done = [&](const std::vector<SampleRow>&, int done) { repeats = done; };
    run({"template_method"}, 2, 1, events);
    EXPECT_GE(repeats, 12);
    EXPECT_EQ(m_result.done.repeats.taken, repeats);
    EXPECT_EQ(m_result.done.repeats.reason, StopReason::width);
    EXPECT_LE(m_result.done.repeats.widest.value(), 0.9999);
    ASSERT_EQ(m_result.done.machine.size(), static_cast<std::size_t>(repeats));
    for (const MachineRecord& machine : m_result.done.machine) {
        EXPECT_GT(machine.wall_s, 0.0);
    }
    // What a folder of this plan takes: repeats beyond the fewest.
    RunFolder folder = RunFolder::create(m_folder.path() / "run", ContextRecord{}, m_plan);
    folder.finish_round(round().id, m_result.samples, m_result.metrics, m_result.done);
    EXPECT_EQ(RunFolder::open(folder.path()).read_samples().size(), m_result.samples.size());
}

TEST_F(RoundRunnerTest, TheSecondTimeReferencesComeFromTheCacheAndChangeNothing) {
    run({"template_method"}, 1);
    EXPECT_FALSE(m_result.done.reference_cached);
    const std::vector<MetricRow> first = m_result.metrics;
    run({"template_method"}, 1);
    EXPECT_TRUE(m_result.done.reference_cached);
    ASSERT_EQ(m_result.metrics.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(m_result.metrics[i].value, first[i].value);
        EXPECT_EQ(m_result.metrics[i].floor, first[i].floor);
    }
}

TEST_F(RoundRunnerTest, PartsOfTheWallTimeDoNotExceedIt) {
    run({"template_method", "history_method"});
    const RoundDone& done = m_result.done;
    for (const double part :
         {done.gbuffer_s, done.passes_s, done.metrics_s, done.reference_s, done.images_s}) {
        EXPECT_GT(part, 0.0);
    }
    EXPECT_LE(done.gbuffer_s + done.passes_s + done.metrics_s + done.reference_s + done.images_s,
              done.wall_s);
}

TEST_F(RoundRunnerTest, ARunFolderTakesWhatARoundGives) {
    run({"none", "history_method", "hemisphere_ssao"});
    ContextRecord record;
    record.started_utc = "2026-01-01T00:00:00Z";
    record.cpu_threads = 1;
    record.driver_threads = 1;
    RunFolder folder = RunFolder::create(m_folder.path() / "run", record, m_plan);
    folder.finish_round(round().id, m_result.samples, m_result.metrics, m_result.done);
    const RunFolder read = RunFolder::open(m_folder.path() / "run");
    EXPECT_TRUE(read.is_complete());
    EXPECT_EQ(read.read_samples().size(), m_result.samples.size());
    EXPECT_EQ(read.read_metrics().size(), m_result.metrics.size());
}

} // namespace
} // namespace alcove
