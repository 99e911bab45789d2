// `metric` over anybody's images, `list` and `reference`.

#include "core/base/file.hpp"
#include "core/base/image_file.hpp"
#include "tests/harness/program.hpp"

#include <cmath>
#include <limits>
#include <set>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

using nlohmann::json;

constexpr ImageSize kSize{48, 40};

/// A smooth visibility image in [0.1, 1].
Image make_visibility(double phase) {
    Image image(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            image.at(x, y) = static_cast<float>(0.55 + 0.45 * std::sin(0.2 * x + 0.1 * y + phase));
        }
    }
    return image;
}

std::set<std::string> list_keys(const json& object) {
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items()) {
        keys.insert(key);
    }
    return keys;
}

class MetricVerb : public ProgramTest {
  protected:
    static std::string write_exr_file(const std::string& name, const Image& image) {
        write_exr(folder() / name, image, Domain::visibility);
        return (folder() / name).string();
    }
    static std::string write_png_file(const std::string& name, const Image& visibility) {
        write_png(folder() / name, encode_view(visibility), Domain::view);
        return (folder() / name).string();
    }
    static json evaluate(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "metric");
        arguments.emplace_back("--json");
        const ChildResult result = run(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return json::parse(result.out);
    }
};

TEST_F(MetricVerb, ListsParseAndNameTheirUnits) {
    for (const char* what : {"methods", "scenes", "metrics"}) {
        const ChildResult result = run({"list", what, "--json"});
        EXPECT_EQ(result.exit_code, 0);
        EXPECT_EQ(result.err, "");
        const json list = json::parse(result.out);
        ASSERT_TRUE(list.is_array()) << what;
        for (const json& item : list) {
            EXPECT_FALSE(item.at("name").get<std::string>().empty());
            EXPECT_FALSE(item.at("title").get<std::string>().empty());
        }
        EXPECT_EQ(run({"list", what}).exit_code, 0);
    }
    const json parameters = json::parse(run({"list", "parameters", "--json"}).out);
    EXPECT_EQ(parameters.at("hemisphere_ssao").at(0).at("unit"), "m");
    EXPECT_EQ(run({"list", "parameters"}).exit_code, 0);
}

TEST_F(MetricVerb, JsonIsOneObjectWithTheReportedImageMetricsAsKeys) {
    const std::string a = write_exr_file("a.exr", make_visibility(0.0));
    const std::string b = write_exr_file("b.exr", make_visibility(0.3));
    const json scores = evaluate({a, b});
    std::set<std::string> reported;
    for (const json& metric : json::parse(run({"list", "metrics", "--json"}).out)) {
        if (metric.at("reported").get<bool>() && !metric.at("over_time").get<bool>()) {
            reported.insert(metric.at("name").get<std::string>());
        }
    }
    EXPECT_EQ(list_keys(scores), reported);
    for (const char* name : {"mse", "rmse", "psnr", "ssim"}) {
        EXPECT_TRUE(scores.at(name).is_number()) << name;
    }
    EXPECT_NEAR(scores.at("rmse").get<double>(), std::sqrt(scores.at("mse").get<double>()), 1e-12);
    EXPECT_EQ(list_keys(evaluate({a, b, "--metric", "ssim", "--metric", "mse"})),
              (std::set<std::string>{"mse", "ssim"}));
}

TEST_F(MetricVerb, MetricsOverTimeAreRefusedButForTheirChecks) {
    const std::string a = write_exr_file("a.exr", make_visibility(0.0));
    expect_refused({"metric", a, a, "--metric", "temporal_flicker"}, 2,
                   {"temporal_flicker", "over time", "`run`"});
    const ChildResult checks = run({"metric", "--self-test", "--metric", "temporal_flicker"});
    EXPECT_EQ(checks.exit_code, 0) << checks.err;
    EXPECT_NE(checks.out.find("temporal_flicker"), std::string::npos) << checks.out;
}

TEST_F(MetricVerb, AnInfiniteValueIsNullAndTheReasonStandsOnStandardError) {
    const std::string a = write_exr_file("a.exr", make_visibility(0.0));
    const ChildResult result =
        run({"metric", a, a, "--metric", "psnr", "--metric", "mse", "--json"});
    EXPECT_EQ(result.exit_code, 0);
    const json scores = json::parse(result.out);
    EXPECT_TRUE(scores.at("psnr").is_null());
    EXPECT_EQ(scores.at("mse").get<double>(), 0.0);
    EXPECT_NE(result.err.find("psnr"), std::string::npos) << result.err;
}

TEST_F(MetricVerb, ExrAndPngOfTheSameImagesAgreeUpToQuantisation) {
    const Image a = make_visibility(0.0);
    const Image b = make_visibility(0.3);
    const json exr = evaluate({write_exr_file("a.exr", a), write_exr_file("b.exr", b)});
    const json png = evaluate({write_png_file("a.png", a), write_png_file("b.png", b)});
    const json mixed = evaluate({write_exr_file("a.exr", a), write_png_file("b.png", b)});
    // Half a code, decoded at the curve's steepest (2.275 at 1), in each of two images: by the
    // triangle inequality no RMSE moves further.
    constexpr double kRmseBound = 2.0 * 0.5 / 255.0 * 2.275;
    // Of codes: noise of variance (1/255)^2/12 against C2 = 0.03^2 changes the structure term by
    // less than 2 * 1.3e-6 / 9e-4.
    constexpr double kSsimBound = 3e-3;
    for (const json& other : {png, mixed}) {
        EXPECT_NEAR(other.at("rmse").get<double>(), exr.at("rmse").get<double>(), kRmseBound);
        EXPECT_NEAR(other.at("ssim").get<double>(), exr.at("ssim").get<double>(), kSsimBound);
    }
    EXPECT_GT(exr.at("rmse").get<double>(), 4.0 * kRmseBound) << "the images must differ by more";
}

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

TEST_F(MetricVerb, AGateThatIsNotMetExitsThree) {
    const std::string a = write_exr_file("a.exr", make_visibility(0.0));
    const std::string b = write_exr_file("b.exr", make_visibility(0.3));
    EXPECT_EQ(run({"metric", a, b, "--gate", "mse<1,ssim>=0"}).exit_code, 0);
    const ChildResult missed = run({"metric", a, b, "--gate", "mse<1,rmse<=1e-6"});
    EXPECT_EQ(missed.exit_code, 3);
    EXPECT_NE(missed.err.find("rmse<=1e-6"), std::string::npos) << missed.err;
    // Specifications that no --metric names are measured for the gate.
    EXPECT_EQ(run({"metric", a, b, "--metric", "mse", "--gate", "flip:ppd=30,q=1<1"}).exit_code, 2);
    EXPECT_EQ(run({"metric", a, b, "--metric", "mse", "--gate",
                   "flip:distance_m=0.5,monitor_width_m=0.6<1,ssim@codes>=0,flip.max<=1"})
                  .exit_code,
              0);
    EXPECT_EQ(run({"metric", a, b, "--gate", "flip@codes<1e-9"}).exit_code, 3);
    // What has no value meets no gate.
    EXPECT_EQ(run({"metric", a, a, "--metric", "psnr", "--gate", "psnr>1"}).exit_code, 3);
    EXPECT_EQ(run({"metric", a, b, "--gate", "flib<1"}).exit_code, 2);
    EXPECT_EQ(run({"metric", a, b, "--gate", "mse"}).exit_code, 2);
}

TEST_F(MetricVerb, CheckValuesOfTheDefinitionsHold) {
    const ChildResult result = run({"metric", "--self-test"});
    EXPECT_EQ(result.exit_code, 0) << result.out;
    EXPECT_EQ(result.out.find("FAILED"), std::string::npos);
}

TEST_F(MetricVerb, SelfTestNamesExpectedGotDifferenceToleranceAndSource) {
    const ChildResult result = run({"metric", "--self-test", "--metric", "flip"});
    EXPECT_EQ(result.exit_code, 0) << result.out;
    for (const char* part : {"expected 0.967388", "got 0.9673", "difference", "tolerance 2.0e-05",
                             "NVIDIA FLIP.h 1.6"}) {
        EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
    }
}

TEST_F(MetricVerb, SelfTestIsReadByMachinesToo) {
    const json object = evaluate({"--self-test", "--metric", "flip:ppd=30", "--metric", "psnr"});
    EXPECT_EQ(object.at("failed").get<int>(), 0);
    std::set<std::string> metrics;
    for (const json& check : object.at("checks")) {
        metrics.insert(check.at("metric").get<std::string>());
        EXPECT_TRUE(check.at("holds").get<bool>());
        EXPECT_NEAR(check.at("got").get<double>() - check.at("expected").get<double>(),
                    check.at("difference").get<double>(), 1e-12);
        EXPECT_LE(std::abs(check.at("difference").get<double>()),
                  check.at("tolerance").get<double>());
        EXPECT_FALSE(check.at("source").get<std::string>().empty());
    }
    EXPECT_EQ(metrics, (std::set<std::string>{"flip", "psnr"}));
    expect_refused({"metric", "--self-test", "--metric", "exec:sh"}, 2, {"no check values"});
}

TEST_F(MetricVerb, ASpecificationIsTheKeyOfItsNumber) {
    const std::string a = write_exr_file("a.exr", make_visibility(0.0));
    const std::string b = write_exr_file("b.exr", make_visibility(0.3));
    const json scores =
        evaluate({a, b, "--metric", "flip", "--metric", "flip@codes", "--metric", "flip:ppd=30"});
    EXPECT_GT(std::abs(scores.at("flip").get<double>() - scores.at("flip@codes").get<double>()),
              0.01);
    EXPECT_NE(scores.at("flip").get<double>(), scores.at("flip:ppd=30").get<double>());
    EXPECT_GT(scores.at("flip.max").get<double>(), scores.at("flip").get<double>());
    expect_refused({"metric", a, b, "--metric", "flip@code"}, 2, {"code", "codes"});
    expect_refused({"metric", a, b, "--metric", "flip:ppd=0"}, 2, {"ppd"});
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

TEST_F(MetricVerb, MapsAreWritten) {
    const std::string a = write_exr_file("a.exr", make_visibility(0.0));
    const std::string b = write_exr_file("b.exr", make_visibility(0.3));
    static_cast<void>(evaluate({a, b, "--metric", "mse", "--map", (folder() / "maps").string()}));
    EXPECT_EQ(read_image_file(folder() / "maps" / "a_mse.exr").image.size(), kSize);
    EXPECT_EQ(read_image_file(folder() / "maps" / "a_mse.png").image.channels(), 3);
}

TEST_F(MetricVerb, FlipMapsAreMagmaOfTheValueInEightBits) {
    // FLIP of black and white is 0.967388 everywhere: entry 247.
    const std::string black = write_png_file("black.png", Image({16, 16}, 1, 0.0f));
    const std::string white = write_png_file("white.png", Image({16, 16}, 1, 1.0f));
    const std::string maps = (folder() / "flip_maps").string();
    static_cast<void>(evaluate({black, white, "--metric", "flip:ppd=30", "--map", maps}));
    const Image values = read_image_file(maps + "/black_flip_ppd=30.exr").image;
    const Image colours = read_image_file(maps + "/black_flip_ppd=30.png").image;
    EXPECT_EQ(std::lround(255.0f * values.at(8, 8)), 247);
    // #fceeb0 in the published table.
    EXPECT_EQ(std::lround(255.0f * colours.at(8, 8, 0)), 0xfc);
    EXPECT_EQ(std::lround(255.0f * colours.at(8, 8, 1)), 0xee);
    EXPECT_EQ(std::lround(255.0f * colours.at(8, 8, 2)), 0xb0);
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

TEST_F(MetricVerb, AHeaderOfABillionPixelsIsNotTrusted) {
    const std::string huge = write("huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"
                                               "-Y 40000 +X 40000\n");
    expect_refused({"metric", huge, huge}, 2, {"huge.hdr"});
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
    // Alcove itself is such a program.
    EXPECT_EQ(
        run({"metric", a, b, "--metric", "exec:" + program().string() + " list metrics"}).exit_code,
        1);
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

class ReferenceVerb : public MetricVerb {
  protected:
    static ImageFile trace(const std::vector<std::string>& more) {
        write("box.gltf", make_box_gltf());
        write("camera.json", R"({"position":[2,1.5,4],"target":[0,0.5,0],"up":[0,1,0],)"
                             R"("fov_y_degrees":60,"near":0.1,"far":100})");
        std::vector<std::string> arguments{"reference",   "box.gltf", "--camera",
                                           "camera.json", "--out",    "v.exr"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ChildResult result = run(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return read_image_file(folder() / "v.exr");
    }
};

TEST_F(ReferenceVerb, WritesOneChannelOfVisibilityTopRowFirst) {
    const ImageFile file = trace({"--radius", "1", "--spp", "32", "--size", "40x30"});
    EXPECT_EQ(file.image.size(), (ImageSize{40, 30}));
    EXPECT_EQ(file.image.channels(), 1);
    EXPECT_EQ(file.domain, Domain::visibility);
    // The sky stands in the top row, the floor (open but for the box) in the bottom row.
    for (int x = 0; x < 40; ++x) {
        EXPECT_EQ(file.image.at(x, 0), 1.0f) << x;
    }
    float darkest = 1.0f;
    for (const float value : file.image.values()) {
        EXPECT_GE(value, 0.0f);
        EXPECT_LE(value, 1.0f);
        darkest = std::min(darkest, value);
    }
    EXPECT_LT(darkest, 0.8f) << "the edge between box and floor";
}

TEST_F(ReferenceVerb, IsTheSameTwiceAndChangesWithWhatIsAsked) {
    const std::vector<std::string> plain{"--radius", "1", "--spp", "16", "--size", "40x30"};
    const std::uint64_t first = hash_image(trace(plain).image);
    EXPECT_EQ(hash_image(trace(plain).image), first);
    for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
             {"--falloff", "linear"}, {"--weighting", "uniform"}}) {
        std::vector<std::string> changed = plain;
        changed.insert(changed.end(), more.begin(), more.end());
        EXPECT_NE(hash_image(trace(changed).image), first) << more.front();
    }
}

TEST_F(ReferenceVerb, OnePixelIsAnImage) {
    EXPECT_EQ(trace({"--radius", "1", "--spp", "2", "--size", "1x1"}).image.size(),
              (ImageSize{1, 1}));
}

} // namespace
} // namespace alcove
