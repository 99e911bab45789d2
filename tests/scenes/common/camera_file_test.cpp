#include "scenes/common/camera_file.hpp"

#include "core/base/error.hpp"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace alcove {
namespace {

const std::string kGood = R"({"position":[1,2,3],"target":[1,2,-7],"up":[0,2,0],)"
                          R"("fov_y_degrees":90,"near":0.5,"far":20})";

std::string replace(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

void expect_error(const std::string& text, const std::string& part) {
    try {
        static_cast<void>(parse_camera(text, "CAM.json"));
        FAIL() << "accepted: " << text;
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("CAM.json"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        EXPECT_EQ(error.exit_code(), 2);
    }
}

TEST(CameraFile, ReadsWhatDesignDescribes) {
    const Camera camera = parse_camera(kGood, "CAM.json");
    EXPECT_EQ(camera.position, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(camera.world_from_view[0], glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(camera.world_from_view[1], glm::dvec3(0.0, 1.0, 0.0));
    EXPECT_EQ(camera.world_from_view[2], glm::dvec3(0.0, 0.0, 1.0));
    EXPECT_DOUBLE_EQ(camera.fov_y_radians, std::numbers::pi / 2.0);
    EXPECT_EQ(camera.near_m, 0.5);
    EXPECT_EQ(camera.far_m, 20.0);
}

TEST(CameraFile, RejectsUnknownMissingAndRepeatedKeys) {
    expect_error(replace(kGood, "}", R"(,"fov":3})"), "fov");
    expect_error(replace(kGood, R"("near":0.5,)", ""), "near");
    expect_error(replace(kGood, "}", R"(,"near":1})"), "twice");
}

TEST(CameraFile, RejectsWrongTypes) {
    expect_error("[]", "object");
    expect_error(replace(kGood, "[1,2,3]", "[1,2]"), "position");
    expect_error(replace(kGood, "[1,2,3]", R"([1,2,"3"])"), "position[2]");
    expect_error(replace(kGood, "90", "null"), "fov_y_degrees");
    expect_error(replace(kGood, "90", "true"), "fov_y_degrees");
}

TEST(CameraFile, RejectsNumbersThatMakeNoCamera) {
    expect_error(replace(kGood, "90", "180"), "fov_y_degrees");
    expect_error(replace(kGood, "90", "0"), "fov_y_degrees");
    expect_error(replace(kGood, "0.5", "0"), "near");
    expect_error(replace(kGood, "20", "0.5"), "far");
    expect_error(replace(kGood, "[1,2,-7]", "[1,2,3]"), "target");
    expect_error(replace(kGood, "[0,2,0]", "[0,0,1]"), "up");
    expect_error(replace(kGood, "[1,2,3]", "[1e300,2,3]"), "position[0]");
    expect_error(replace(kGood, "[1,2,3]", "[1e999,2,3]"), "JSON");
    expect_error(replace(kGood, "[1,2,3]", "[NaN,2,3]"), "JSON");
}

TEST(CameraFile, RejectsTruncatedTextAndMissingFiles) {
    expect_error(kGood.substr(0, kGood.size() / 2), "JSON");
    expect_error(kGood + "x", "JSON");
    expect_error("", "JSON");
    EXPECT_THROW(static_cast<void>(read_camera_file("no/such/camera.json")), InputError);
}

} // namespace
} // namespace alcove
