// `metric` over anybody's images, `list` and `reference`.

#include "core/base/image_file.hpp"
#include "tests/harness/metric_verb.hpp"

#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

std::set<std::string> list_keys(const json& object) {
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items()) {
        keys.insert(key);
    }
    return keys;
}

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
        EXPECT_NEAR(other.at("mae").get<double>(), exr.at("mae").get<double>(), kRmseBound);
        EXPECT_NEAR(other.at("ssim").get<double>(), exr.at("ssim").get<double>(), kSsimBound);
        // One code of mid grey is 0.029863 of FLIP (its published check), and more than what two
        // roundings of half a code do.
        EXPECT_NEAR(other.at("flip").get<double>(), exr.at("flip").get<double>(), 0.029863);
        EXPECT_NEAR(other.at("flip").get<double>(), exr.at("flip").get<double>(),
                    0.1 * exr.at("flip").get<double>());
    }
    EXPECT_GT(exr.at("rmse").get<double>(), 4.0 * kRmseBound) << "the images must differ by more";
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
