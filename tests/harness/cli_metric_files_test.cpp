// What `metric` reads: folders, lists, masks, programs, and files that are small, broken or
// hostile.

#include "core/base/file.hpp"
#include "tests/harness/metric_verb.hpp"

#include <limits>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

TEST_F(MetricVerb, FoldersAreComparedFrameByFrame) {
    for (const char* name : {"0001", "0002"}) {
        const double phase = name[3] - '0';
        write_exr_file(std::string("test/") + name + ".exr", make_visibility(phase));
        write_exr_file(std::string("truth/") + name + ".exr", make_visibility(phase + 0.1 * phase));
    }
    const std::string test = (folder() / "test").string();
    const std::string truth = (folder() / "truth").string();
    const double first =
        evaluate({test + "/0001.exr", truth + "/0001.exr"}).at("mse").get<double>();
    const double second =
        evaluate({test + "/0002.exr", truth + "/0002.exr"}).at("mse").get<double>();
    EXPECT_NE(first, second);
    EXPECT_DOUBLE_EQ(evaluate({test, truth}).at("mse").get<double>(), 0.5 * (first + second));
    write_exr_file("truth/0003.exr", make_visibility(0.0));
    expect_refused({"metric", test, truth}, 2, {"same PNG, EXR and HDR names", "0003.exr"});
    expect_refused({"metric", test, truth + "/0001.exr"}, 2, {"folder"});
    std::filesystem::create_directory(folder() / "nothing");
    expect_refused({"metric", (folder() / "nothing").string(), (folder() / "nothing").string()}, 2,
                   {"nothing", "no PNG, EXR or HDR"});
}

TEST_F(MetricVerb, ListsAreMeasuredPairByPair) {
    write_exr_file("lists/a.exr", make_visibility(0.0));
    write_exr_file("lists/sub/b.exr", make_visibility(0.3));
    const std::string list = write("lists/list.csv", "test,reference\na.exr,sub/b.exr\n"
                                                     "a.exr,a.exr\n");
    const ChildResult result =
        run({"metric", "--list", list, "--metric", "psnr", "--metric", "flip", "--json", "--csv",
             "list_out.csv", "--map", "list_maps"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const json scores = json::parse(result.out);
    EXPECT_TRUE(scores.at("psnr").is_null());
    EXPECT_GT(scores.at("flip").get<double>(), 0.0);
    EXPECT_NE(result.err.find("1 of 2 pairs"), std::string::npos) << result.err;
    EXPECT_EQ(count_lines(folder() / "list_out.csv"), 1u + 2u * 2u);
    EXPECT_NE(read_file(folder() / "list_out.csv").find("weighted_median="), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder() / "list_maps/000002_a_flip.png"));
    expect_refused({"metric", "--list", write("lists/bad.csv", "test,reference\n../a.exr,a.exr\n")},
                   2, {"bad.csv:2", "../a.exr"});
    expect_refused({"metric", list, "--list", list}, 2, {"--list"});
    const std::string cut = write_png_file("lists/cut.png", make_visibility(0.0));
    std::filesystem::resize_file(cut, std::filesystem::file_size(cut) / 2);
    const ChildResult broken =
        run({"metric", "--list", write("lists/cut.csv", "test,reference\na.exr,cut.png\n")});
    EXPECT_EQ(broken.exit_code, 2);
    EXPECT_EQ(broken.out, "");
    EXPECT_NE(broken.err.find("cut.png"), std::string::npos) << broken.err;
}

TEST_F(MetricVerb, RadianceFilesAreLinear) {
    // Mantissas over 256, exponent 129: 2 * 128 / 256 = 1 and 2 * 64 / 256 = 0.5.
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
    const std::string one("\x80\x80\x80\x81", 4);
    const std::string half("\x40\x40\x40\x81", 4);
    const std::string a = write("a.hdr", head + one + one);
    const std::string b = write("b.hdr", head + one + half);
    EXPECT_NEAR(evaluate({a, b, "--metric", "mae"}).at("mae").get<double>(), 0.25, 0.005);
    expect_refused({"metric", a, write("cut.hdr", head)}, 2, {"cut.hdr"});
}

TEST_F(MetricVerb, AMaskLeavesPixelsOutAndSaysHowMany) {
    // The right half differs; the mask keeps the left one and one column more.
    Image b = make_visibility(0.0);
    Image mask(kSize, 1, 1.0f);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 24; x < kSize.width; ++x) {
            b.at(x, y) = 0.0f;
            mask.at(x, y) = x == 24 ? 0.25f : 0.0f;
        }
    }
    const std::string test = write_exr_file("a.exr", make_visibility(0.0));
    const std::string reference = write_exr_file("b.exr", b);
    write_exr(folder() / "mask.exr", mask, Domain::linear);
    const ChildResult result = run({"metric", test, reference, "--metric", "mae", "--mask",
                                    "mask.exr", "--json", "--csv", "out/pairs.csv"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("1000 pixels counted, 920 ignored"), std::string::npos) << result.err;
    double column = 0.0;
    for (int y = 0; y < kSize.height; ++y) {
        column += static_cast<double>(make_visibility(0.0).at(24, y));
    }
    EXPECT_NEAR(json::parse(result.out).at("mae").get<double>(), column / 1000.0, 1e-6);
    const std::string csv = read_file(folder() / "out/pairs.csv");
    EXPECT_NE(csv.find(",1000,920,"), std::string::npos) << csv;
    write_exr(folder() / "none.exr", Image(kSize, 1, 0.0f), Domain::linear);
    EXPECT_EQ(run({"metric", test, reference, "--mask", "none.exr", "--gate", "mae<1"}).exit_code,
              3);
    write_exr(folder() / "other.exr", Image({8, 8}, 1, 1.0f), Domain::linear);
    expect_refused({"metric", test, reference, "--depth", "mask.exr"}, 2,
                   {"mask.exr", "no depth", "(25, 0)"});
    const ChildResult other = run({"metric", test, reference, "--mask", "other.exr"});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_NE(other.err.find("--mask: not the size"), std::string::npos) << other.err;
}

TEST_F(MetricVerb, AHeaderOfABillionPixelsIsNotTrusted) {
    const std::string huge = write("huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"
                                               "-Y 40000 +X 40000\n");
    expect_refused({"metric", huge, huge}, 2, {"huge.hdr"});
}

TEST_F(MetricVerb, BadImagesAreNamed) {
    const std::string a = write_exr_file("a.exr", make_visibility(0.0));
    Image broken = make_visibility(0.3);
    broken.at(7, 5) = std::numeric_limits<float>::quiet_NaN();
    const std::string nan = write_exr_file("nan.exr", broken);
    expect_refused({"metric", nan, a}, 2, {"nan.exr", "NaN", "(7, 5)"});
    expect_refused({"metric", a, nan}, 2, {"nan.exr", "NaN", "(7, 5)"});
    broken.at(7, 5) = std::numeric_limits<float>::infinity();
    expect_refused({"metric", write_exr_file("inf.exr", broken), a}, 2, {"inf.exr", "infinity"});
    const std::string small = write_exr_file("small.exr", Image({8, 8}, 1));
    expect_refused({"metric", a, small}, 2, {"a.exr", "small.exr", "48x40", "8x8"});
    expect_refused({"metric", a, "missing.exr"}, 2, {"missing.exr", "no such file"});
    expect_refused({"metric", a, write("text.exr", "no image")}, 2, {"text.exr"});
    expect_refused({"metric", a}, 2, {"TEST and REFERENCE"});
    const std::string png = write_png_file("cut.png", make_visibility(0.0));
    std::filesystem::resize_file(png, std::filesystem::file_size(png) / 2);
    // libpng adds a line of its own.
    const ChildResult cut = run({"metric", png, a});
    EXPECT_EQ(cut.exit_code, 2);
    EXPECT_EQ(cut.out, "");
    EXPECT_NE(cut.err.find("alcove: " + png + ": image data cannot be read"), std::string::npos)
        << cut.err;
}

TEST_F(MetricVerb, AnImageThatIsTooSmallHasNoValueAndSaysSo) {
    const std::string a = write_exr_file("small_a.exr", Image({10, 8}, 1, 0.5f));
    const std::string b = write_exr_file("small_b.exr", Image({10, 8}, 1, 0.25f));
    const ChildResult result = run({"metric", a, b, "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const json scores = json::parse(result.out);
    EXPECT_TRUE(scores.at("ssim").is_null());
    EXPECT_EQ(scores.at("mae").get<double>(), 0.25);
    EXPECT_NE(result.err.find("ssim has no value"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("11 pixels"), std::string::npos) << result.err;
}

TEST_F(MetricVerb, OnePixelIsMeasuredByWhatCan) {
    const std::string a = write_exr_file("one_a.exr", Image({1, 1}, 1, 0.5f));
    const std::string b = write_exr_file("one_b.exr", Image({1, 1}, 1, 0.25f));
    const ChildResult result = run({"metric", a, b, "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const json scores = json::parse(result.out);
    EXPECT_EQ(scores.at("mae").get<double>(), 0.25);
    EXPECT_TRUE(scores.at("ms_ssim").is_null());
    EXPECT_TRUE(scores.at("flip").is_number());
}

TEST_F(MetricVerb, ProgramsGiveMetricsToo) {
    const std::string a = write_exr_file("a.exr", make_visibility(0.0));
    const std::string b = write_exr_file("b.exr", make_visibility(0.3));
    const auto make_program = [](const std::string& name, const std::string& script) {
        const std::string path = write(name, "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(path, std::filesystem::perms::owner_all);
        return "exec:" + path;
    };
    const std::string lpips = make_program("lpips", "echo '{\"lpips\": 0.125}'");
    const ChildResult good = run({"metric", a, b, "--metric", lpips, "--metric", "mse", "--json",
                                  "--gate", "lpips<=0.125,flip<1"});
    ASSERT_EQ(good.exit_code, 0) << good.err;
    EXPECT_EQ(json::parse(good.out).at("lpips").get<double>(), 0.125);
    EXPECT_EQ(run({"metric", a, b, "--metric", lpips, "--gate", "lpips<0.1"}).exit_code, 3);
    expect_refused({"metric", a, b, "--metric", lpips, "--gate", "lpis<0.1", "--json"}, 2,
                   {"lpis", "lpips"});
    expect_refused({"metric", a, b, "--metric", make_program("ours", "echo '{\"ssim\":1}'")}, 2,
                   {"ours", "ssim", "Alcove has itself"});
    expect_refused({"metric", a, b, "--metric", lpips, "--metric",
                    make_program("again", "echo '{\"lpips\":1}'")},
                   2, {"again", "lpips", "another program"});
    expect_refused({"metric", a, b, "--metric", make_program("dies", "echo oh no >&2; exit 4")}, 1,
                   {"dies", "exit code 4", "oh no"});
    expect_refused(
        {"metric", a, b, "--metric", make_program("hangs", "sleep 600"), "--exec-timeout", "0.2"},
        1, {"hangs", "in time"});
    expect_refused({"metric", a, b, "--metric", lpips, "--exec-timeout", "0"}, 2,
                   {"--exec-timeout"});
    expect_refused({"metric", a, "missing.exr", "--metric", lpips}, 2,
                   {"missing.exr", "no such file"});
}

} // namespace
} // namespace alcove
