// `score`: new metrics over what a run kept, and nothing of the run changed.

#include "core/base/file.hpp"
#include "core/base/image_file.hpp"
#include "reports/record/csv.hpp"
#include "tests/harness/program.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <algorithm>

namespace alcove {
namespace {

namespace fs = std::filesystem;

class ScoreVerb : public ProgramTest {
  protected:
    /// One finished round of two. Truth is open; of `cell`, `blocked` of 16 rows are not.
    static fs::path write_run(const std::string& name) {
        synthetic::Options options;
        options.finished_rounds = 1;
        const fs::path path = folder() / name;
        const RunFolder run = synthetic::write_run(path, options);
        const RoundRecord& round = run.plan().rounds.front();
        for (const int frame : {round.image_frames[0], round.image_frames[1]}) {
            write_picture(run, "reference", frame, "visibility", 0);
            write_picture(run, "none", frame, "visibility", 4);
            write_picture(run, "tssao", frame, "visibility",
                          frame == round.image_frames[0] ? 8 : 0);
        }
        write_picture(run, "reference", round.film.begin, "film_visibility", 0);
        write_picture(run, "none", round.film.begin, "film_visibility", 16);
        return path;
    }
    static void write_picture(const RunFolder& run, const std::string& cell, int frame,
                              const std::string& picture, int blocked) {
        Image image({16, 16}, 1, 1.0f);
        std::fill_n(image.values().begin(), 16 * blocked, 0.0f);
        write_png(run.path() / RunFolder::make_image_path(run.plan().rounds.front().id, cell, frame,
                                                          picture),
                  image, Domain::view);
    }
    /// A program that counts what it is given.
    static std::string write_counter() {
        const std::string path = write("count.sh", "#!/bin/sh\necho \"{\\\"seen\\\": $#}\"\n");
        fs::permissions(path, fs::perms::owner_all);
        return path;
    }
    static std::map<std::string, std::string> read_all(const fs::path& path) {
        std::map<std::string, std::string> files;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path)) {
            if (entry.is_regular_file()) {
                files[entry.path().string()] = read_file(entry.path());
            }
        }
        return files;
    }
    static std::vector<std::vector<std::string>> read_lines(const fs::path& file) {
        const std::string text = read_file(file);
        CsvReader reader(text, "scores");
        std::vector<std::vector<std::string>> lines;
        for (std::vector<std::string> fields; reader.next(fields);) {
            lines.push_back(fields);
        }
        return lines;
    }
};

TEST_F(ScoreVerb, MeasuresEveryKeptVisibilityAndAltersNothing) {
    const fs::path path = write_run("run");
    const std::map<std::string, std::string> before = read_all(path);
    const ChildResult result = run({"score", "run", "--metric", "mse", "--metric", "psnr@codes",
                                    "--metric", "exec:" + write_counter()});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("1/510"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("1 rounds are not finished"), std::string::npos) << result.out;
    std::map<std::string, std::string> after = read_all(path);
    EXPECT_EQ(after.erase((path / "scores.csv").string()), 1u);
    EXPECT_EQ(after, before);
    const auto lines = read_lines(path / "scores.csv");
    // Two frames of two cells and one of the film, three metrics each.
    ASSERT_EQ(lines.size(), 1u + 15u);
    EXPECT_EQ(lines[0], (std::vector<std::string>{"round", "scene", "cell", "label", "frame",
                                                  "picture", "metric", "value", "note"}));
    const auto find = [&](const std::string& cell, const std::string& frame,
                          const std::string& picture, const std::string& metric) {
        for (const auto& line : lines) {
            if (line[2] == cell && line[4] == frame && line[5] == picture && line[6] == metric) {
                return line;
            }
        }
        return std::vector<std::string>(9);
    };
    EXPECT_EQ(find("none", "6", "visibility", "mse")[7], "0.25");
    EXPECT_EQ(find("tssao", "6", "visibility", "mse")[7], "0.5");
    EXPECT_EQ(find("none", "40", "film_visibility", "mse")[7], "1");
    EXPECT_EQ(find("none", "6", "visibility", "seen")[7], "2");
    // Equal images: no psnr, and why.
    EXPECT_EQ(find("tssao", "54", "visibility", "psnr@codes")[7], "");
    EXPECT_NE(find("tssao", "54", "visibility", "psnr@codes")[8], "");
    // The mean of 0.5 and 0 over 2 frames.
    EXPECT_NE(result.out.find("0.25"), std::string::npos);
    EXPECT_NE(result.out.find("0..0.5"), std::string::npos) << result.out;
}

TEST_F(ScoreVerb, OutputsInsideTheRunAreRefused) {
    const fs::path path = write_run("outputs");
    for (const char* out : {"outputs/../outputs/metrics.csv", "outputs/new.csv", "outputs"}) {
        expect_refused({"score", "outputs", "--metric", "mse", "--out", out}, 2, {"--out"});
    }
    EXPECT_EQ(run({"score", "outputs", "--metric", "mse", "--out", "elsewhere.csv"}).exit_code, 0);
    EXPECT_FALSE(fs::exists(path / "scores.csv"));
    EXPECT_GT(read_lines(folder() / "elsewhere.csv").size(), 1u);
}

TEST_F(ScoreVerb, WhatCannotBeScoredIsRefused) {
    write_run("refused");
    expect_refused({"score", "refused", "--metric", "temporal_flicker"}, 2,
                   {"temporal_flicker", "over time", "motion"});
    expect_refused({"score", "refused", "--metric", "flib"}, 2, {"flib", "flip"});
    expect_refused({"score", "nowhere", "--metric", "mse"}, 2, {"nowhere"});
    EXPECT_EQ(run({"score", "refused"}).exit_code, 2);
    // A picture that is a link out of the run.
    const fs::path picture =
        folder() / "refused" / RunFolder::make_image_path("r0-balls", "none", 6, "visibility");
    ASSERT_TRUE(fs::remove(picture));
    write("outside.png", "");
    fs::create_symlink(folder() / "outside.png", picture);
    expect_refused({"score", "refused", "--metric", "mse"}, 2, {"leaves", "none"});
    fs::remove(picture);
    write("refused/" + fs::relative(picture, folder() / "refused").string(), "cut");
    expect_refused({"score", "refused", "--metric", "mse"}, 2, {"0006_visibility.png"});
}

} // namespace
} // namespace alcove
