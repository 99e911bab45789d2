// Motion of glTF scenes, held against poses that can be written down.

#include "tests/scenes/common/gltf_fixture.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr double kPi = std::numbers::pi;

/// A file whose one buffer grows value by value.
class AnimatedFile {
  public:
    template <class T>
    int add(const std::vector<T>& values, const std::string& type, int component,
            std::size_t components, const std::string& more = "") {
        m_bytes.resize((m_bytes.size() + 3) / 4 * 4);
        m_views += (m_count > 0 ? "," : "") + std::string(R"({"buffer":0,"byteOffset":)") +
                   std::to_string(m_bytes.size()) + R"(,"byteLength":)" +
                   std::to_string(values.size() * sizeof(T)) + "}";
        m_accessors +=
            (m_count > 0 ? "," : "") + std::string(R"({"bufferView":)") + std::to_string(m_count) +
            R"(,"componentType":)" + std::to_string(component) + R"(,"count":)" +
            std::to_string(values.size() / components) + R"(,"type":")" + type + "\"" + more + "}";
        append(m_bytes, values);
        return m_count++;
    }
    int add_floats(const std::vector<float>& values, const std::string& type,
                   std::size_t components) {
        return add(values, type, 5126, components);
    }

    [[nodiscard]] std::string text(const std::string& primitive, const std::string& nodes,
                                   const std::string& more) const {
        std::string glb_json = R"({"asset":{"version":"2.0"},"nodes":)" + nodes +
                               R"(,"scenes":[{"nodes":[0]}],)" + R"("meshes":[{"primitives":[)" +
                               primitive + R"(]}],"accessors":[)" + m_accessors +
                               R"(],"bufferViews":[)" + m_views + R"(],"buffers":[{"byteLength":)" +
                               std::to_string(m_bytes.size()) + "}]" + more + "}";
        return make_glb(glb_json, m_bytes);
    }

  private:
    std::string m_bytes;
    std::string m_views;
    std::string m_accessors;
    int m_count = 0;
};

using GltfAnimation = GltfTest;

std::string attribute(const char* name, int accessor) {
    return std::string("\"") + name + "\":" + std::to_string(accessor);
}

std::string play(const std::string& path, int times, int values, const std::string& how, int node) {
    return R"(,"animations":[{"channels":[{"sampler":0,"target":{"node":)" + std::to_string(node) +
           R"(,"path":")" + path + R"("}}],"samplers":[{"input":)" + std::to_string(times) +
           R"(,"output":)" + std::to_string(values) + R"(,"interpolation":")" + how + R"("}]}])";
}

/// Two texts of play() as one.
std::string join_clips(const std::string& a, const std::string& b) {
    return a.substr(0, a.size() - 1) + "," + b.substr(b.find('[') + 1);
}

/// A strip of two joints: four vertices at the root's, two at the tip, upright in x-y. The tip
/// joint stands at y = 1 and turns by 90 degrees about z in one second.
struct Strip {
    AnimatedFile file;
    std::string primitive;
    std::string nodes = R"([{"children":[1,2]},{"mesh":0,"skin":0,"translation":[5,5,5]},)"
                        R"({"children":[3]},{"translation":[0,1,0]}])";
    std::string more;

    explicit Strip(const std::vector<float>& tip_weights = {0, 1, 0, 0}) {
        const int positions = file.add_floats({0, 0, 0, 1, 0, 0, 0, 2, 0}, "VEC3", 3);
        const int normals = file.add_floats({0, 0, 1, 0, 0, 1, 1, 0, 0}, "VEC3", 3);
        const int joints =
            file.add<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 5121, 4);
        std::vector<float> weights{1, 0, 0, 0, 1, 0, 0, 0};
        weights.insert(weights.end(), tip_weights.begin(), tip_weights.end());
        const int weight = file.add_floats(weights, "VEC4", 4);
        const int binds = file.add_floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                           1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1},
                                          "MAT4", 16);
        const float half = std::sqrt(0.5f);
        const int times = file.add_floats({0, 1}, "SCALAR", 1);
        const int turns = file.add_floats({0, 0, 0, 1, 0, 0, half, half}, "VEC4", 4);
        primitive = R"({"attributes":{)" + attribute("POSITION", positions) + "," +
                    attribute("NORMAL", normals) + "," + attribute("JOINTS_0", joints) + "," +
                    attribute("WEIGHTS_0", weight) + "}}";
        more = R"(,"skins":[{"joints":[2,3],"inverseBindMatrices":)" + std::to_string(binds) +
               "}]" + play("rotation", times, turns, "LINEAR", 3);
    }
    [[nodiscard]] std::string text() const { return file.text(primitive, nodes, more); }
};

TEST_F(GltfAnimation, SkinnedVerticesMoveAsTheirJointsSay) {
    const auto scene = open(Strip().text());
    ASSERT_EQ(scene->get_objects().size(), 1u);
    EXPECT_EQ(scene->get_objects()[0].motion, ObjectMotion::deforming);
    EXPECT_FALSE(scene->is_static());
    // The node's own transform does not move skinned vertices.
    EXPECT_EQ(scene->compute_pose(0.3).object_to_world[0], glm::dmat4(1.0));
    const auto tip = [](double time_s) {
        const double angle = 0.5 * kPi * time_s;
        return glm::dvec3(-std::sin(angle), 1.0 + std::cos(angle), 0.0);
    };
    for (const double time_s : {0.0, 0.1, 0.25, 0.5, 0.9}) {
        const Deformation shape = scene->deform(0, time_s);
        EXPECT_EQ(shape.positions[1], glm::vec3(1.0f, 0.0f, 0.0f));
        EXPECT_LT(glm::distance(glm::dvec3(shape.positions[2]), tip(time_s)), 1e-6) << time_s;
        const double angle = 0.5 * kPi * time_s;
        EXPECT_LT(glm::distance(glm::dvec3(shape.normals[2]),
                                glm::dvec3(std::cos(angle), std::sin(angle), 0.0)),
                  1e-6);
    }
    // Motion between two frames against the derivative of the analytic pose.
    const double step_s = 1e-3;
    const glm::dvec3 moved(scene->deform(0, 0.5 + step_s).positions[2] -
                           scene->deform(0, 0.5 - step_s).positions[2]);
    const double rate = 0.5 * kPi;
    const glm::dvec3 speed(-rate * std::cos(0.25 * kPi), -rate * std::sin(0.25 * kPi), 0.0);
    EXPECT_LT(glm::distance(moved / (2.0 * step_s), speed), 1e-3);
    // The clip repeats: a time is all that counts.
    EXPECT_EQ(scene->deform(0, 0.25).positions, scene->deform(0, 3.25).positions);
    EXPECT_EQ(scene->deform(0, 0.25).positions, scene->deform(0, 0.25).positions);
}

TEST_F(GltfAnimation, WeightsOfAVertexAreMadeToSumToOne) {
    // Half as much of each joint, weighing 0.5 together.
    const auto scene = open(Strip({0.25f, 0.25f, 0, 0}).text());
    const Deformation shape = scene->deform(0, 0.5);
    const double angle = 0.25 * kPi;
    const glm::dvec3 expected = 0.5 * glm::dvec3(0.0, 2.0, 0.0) +
                                0.5 * glm::dvec3(-std::sin(angle), 1.0 + std::cos(angle), 0.0);
    EXPECT_LT(glm::distance(glm::dvec3(shape.positions[2]), expected), 1e-6);
}

TEST_F(GltfAnimation, SkinsThatCannotBeHonouredAreNamed) {
    const auto scene = open(Strip({0, 0, 0, 0}).text());
    EXPECT_TRUE(has_warning("skin is ignored"));
    EXPECT_NE(scene->get_objects()[0].motion, ObjectMotion::deforming);
    Strip strip;
    strip.nodes = R"([{"mesh":0,"skin":0},{},{},{}])"; // the joints are not in the scene
    static_cast<void>(open(strip.text()));
    EXPECT_TRUE(has_warning("skin is ignored"));
}

TEST_F(GltfAnimation, RejectsHostileSkins) {
    const auto replace = [this](const std::string& from, const std::string& to,
                                const std::string& part) {
        Strip strip;
        for (std::string* text : {&strip.more, &strip.nodes, &strip.primitive}) {
            const std::size_t at = text->find(from);
            if (at != std::string::npos) {
                text->replace(at, from.size(), to);
                expect_error(strip.text(), part);
                return;
            }
        }
        FAIL() << from;
    };
    replace(R"("joints":[2,3])", R"("joints":[2,99])", "skins[0].joints[1]");
    replace(R"("joints":[2,3])", R"("joints":[2,-4])", "skins[0].joints[1]");
    replace(R"("joints":[2,3])", R"("joints":[2])", "joint that its skin lacks");
    replace(R"("joints":[2,3])", R"("joints":[2,3,3])", "inverse bind");
    replace(R"("inverseBindMatrices":4)", R"("inverseBindMatrices":0)", "accessors[0]");
    replace(R"("skin":0)", R"("skin":3)", "skins[3]");
    replace(R"("JOINTS_0":2,)", "", "do not stand together");
    replace(R"("JOINTS_0":2)", R"("JOINTS_0":0)", "accessors[0]");
    replace(R"("WEIGHTS_0":3)", R"("WEIGHTS_0":1)", "accessors[1]");
    replace(R"("node":3)", R"("node":77)", "channels[0].target.node");
    replace(R"("output":6)", R"("output":3)", "accessors[3]");
    replace(R"("input":5)", R"("input":1)", "accessors[1]");
    replace(R"("sampler":0)", R"("sampler":4)", "channels[0].sampler");
}

TEST_F(GltfAnimation, LightsMoveAndTurnWithTheirNodes) {
    AnimatedFile file;
    const int positions = file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
    const int times = file.add_floats({0.0f, 1.0f, 2.0f}, "SCALAR", 1);
    const int places = file.add_floats({0, 0, 0, 3, 0, 0, 0, 0, 0}, "VEC3", 3);
    // A quarter turn about y and back.
    const int turns =
        file.add_floats({0, 0, 0, 1, 0, 0.70710678f, 0, 0.70710678f, 0, 0, 0, 1}, "VEC4", 4);
    const auto hang = [](int light) {
        return R"({"extensions":{"KHR_lights_punctual":{"light":)" + std::to_string(light) + "}}}";
    };
    const auto scene = open(file.text(
        R"({"attributes":{)" + attribute("POSITION", positions) + "}}",
        R"([{"children":[1,2,3,4]},{"mesh":0},)" + hang(0) + "," + hang(1) + "," + hang(2) + "]",
        join_clips(join_clips(play("translation", times, places, "LINEAR", 2),
                              play("rotation", times, turns, "LINEAR", 2)),
                   play("rotation", times, turns, "LINEAR", 3)) +
            R"(,"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","spot":{}},)"
            R"({"type":"directional"},{"type":"point"}]}})"));
    const Lights begin = scene->compute_lights(0.0);
    const Lights middle = scene->compute_lights(1.0);
    ASSERT_EQ(begin.points.size(), 2u);
    ASSERT_EQ(middle.points.size(), 2u);
    EXPECT_LT(glm::distance(begin.points[0].position, glm::dvec3(0.0)), 1e-9);
    EXPECT_LT(glm::distance(middle.points[0].position, glm::dvec3(3.0, 0.0, 0.0)), 1e-6);
    EXPECT_LT(glm::distance(begin.points[0].cone->direction, glm::dvec3(0.0, 0.0, -1.0)), 1e-9);
    EXPECT_LT(glm::distance(middle.points[0].cone->direction, glm::dvec3(-1.0, 0.0, 0.0)), 1e-6);
    EXPECT_LT(glm::distance(begin.directional.at(0).to_light, glm::dvec3(0.0, 0.0, 1.0)), 1e-9);
    EXPECT_LT(glm::distance(middle.directional.at(0).to_light, glm::dvec3(1.0, 0.0, 0.0)), 1e-6);
    EXPECT_EQ(begin.points[1].position, middle.points[1].position);
}

TEST_F(GltfAnimation, PlaysStepLinearAndCubicKeys) {
    const auto open_moving = [this](const std::string& how, const std::vector<float>& values) {
        AnimatedFile file;
        const int positions = file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
        const int times = file.add_floats({0.5f, 1.0f, 2.0f}, "SCALAR", 1);
        const int keys = file.add_floats(values, "VEC3", 3);
        return open(file.text(R"({"attributes":{)" + attribute("POSITION", positions) + "}}",
                              R"([{"children":[1]},{"mesh":0}])",
                              play("translation", times, keys, how, 0)));
    };
    const auto x_at = [](const Scene& scene, double time_s) {
        return scene.compute_pose(time_s).object_to_world[0][3].x;
    };
    const auto step = open_moving("STEP", {1, 0, 0, 3, 0, 0, 7, 0, 0});
    EXPECT_EQ(step->get_objects()[0].motion, ObjectMotion::rigid);
    EXPECT_EQ(x_at(*step, 0.1), 1.0);
    EXPECT_EQ(x_at(*step, 0.99), 1.0);
    EXPECT_EQ(x_at(*step, 1.0), 3.0);
    const auto linear = open_moving("LINEAR", {1, 0, 0, 3, 0, 0, 7, 0, 0});
    EXPECT_EQ(x_at(*linear, 0.75), 2.0);
    EXPECT_EQ(x_at(*linear, 1.25), 4.0);
    EXPECT_EQ(x_at(*linear, 2.25), x_at(*linear, 0.25)); // repeats after its last key
    // x = t^3 between 1 and 2 has slopes 3 and 12; a Hermite cubic is that polynomial.
    const auto cubic = open_moving("CUBICSPLINE", {0,  0, 0, 1, 0, 0, 0, 0, 0, //
                                                   0,  0, 0, 1, 0, 0, 3, 0, 0, //
                                                   12, 0, 0, 8, 0, 0, 0, 0, 0});
    EXPECT_NEAR(x_at(*cubic, 1.5), 3.375, 1e-12);
    EXPECT_NEAR(x_at(*cubic, 1.8), 5.832, 1e-12);
    static_cast<void>(open_moving("WOBBLE", {1, 0, 0, 3, 0, 0, 7, 0, 0}));
    EXPECT_TRUE(has_warning("unknown interpolation"));
}

TEST_F(GltfAnimation, TurnsTheShortWay) {
    AnimatedFile file;
    const int positions = file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
    const int times = file.add_floats({0, 1}, "SCALAR", 1);
    const float c = static_cast<float>(std::cos(0.1 * kPi));
    const float s = static_cast<float>(std::sin(0.1 * kPi));
    // 36 degrees about z, with the quaternion of the long way.
    const int keys = file.add_floats({0, 0, 0, 1, 0, 0, -s, -c}, "VEC4", 4);
    const auto scene =
        open(file.text(R"({"attributes":{)" + attribute("POSITION", positions) + "}}",
                       R"([{"mesh":0}])", play("rotation", times, keys, "LINEAR", 0)));
    const glm::dvec3 x_axis(scene->compute_pose(0.5).object_to_world[0][0]);
    EXPECT_LT(glm::distance(x_axis, glm::dvec3(std::cos(0.1 * kPi), std::sin(0.1 * kPi), 0.0)),
              1e-7);
}

TEST_F(GltfAnimation, RejectsHostileKeys) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto try_keys = [this](const std::vector<float>& seconds,
                                 const std::vector<float>& values, const std::string& part) {
        AnimatedFile file;
        const int positions = file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
        const int times = file.add_floats(seconds, "SCALAR", 1);
        const int keys = file.add_floats(values, "VEC3", 3);
        expect_error(file.text(R"({"attributes":{)" + attribute("POSITION", positions) + "}}",
                               R"([{"mesh":0}])", play("translation", times, keys, "LINEAR", 0)),
                     part);
    };
    try_keys({0, 0}, {0, 0, 0, 1, 0, 0}, "ascend");
    try_keys({1, 0}, {0, 0, 0, 1, 0, 0}, "ascend");
    try_keys({-1, 0}, {0, 0, 0, 1, 0, 0}, "ascend");
    try_keys({0, 1e30f}, {0, 0, 0, 1, 0, 0}, "accessors[1]");
    try_keys({0, nan}, {0, 0, 0, 1, 0, 0}, "accessors[1]");
    try_keys({0, 1}, {0, 0, 0, nan, 0, 0}, "accessors[2]");
    try_keys({0, 1}, {0, 0, 0}, "accessors[2]");
    try_keys({0, 1}, {0, 0, 0, 1e30f, 0, 0}, "too far out");
}

TEST_F(GltfAnimation, TheClipIsAnOption) {
    AnimatedFile file;
    const int positions = file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
    const int times = file.add_floats({0, 10}, "SCALAR", 1);
    const int keys = file.add_floats({0, 0, 0, 10, 0, 0}, "VEC3", 3);
    // Both move the same node.
    const std::string clip = play("translation", times, keys, "LINEAR", 0);
    const std::string clips = join_clips(clip, clip);
    const std::string text = file.text(
        R"({"attributes":{)" + attribute("POSITION", positions) + "}}", R"([{"mesh":0}])", clips);
    const auto first = open(text);
    EXPECT_FALSE(first->is_static());
    EXPECT_EQ(first->get_walkthrough().cameras.size(), 300u); // ten seconds
    EXPECT_TRUE(has_warning("animations[0]"));
    EXPECT_THROW(static_cast<void>(open(text, {{}, 2, {}})), InputError);
    EXPECT_THROW(static_cast<void>(open(Parts{}.text(), {{}, 0, {}})), InputError);
}

TEST_F(GltfAnimation, ClipsThatMoveDifferentThingsPlayTogether) {
    AnimatedFile file;
    const int positions = file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
    const int times = file.add_floats({0, 10}, "SCALAR", 1);
    const int keys = file.add_floats({0, 0, 0, 10, 0, 0}, "VEC3", 3);
    const int sizes = file.add_floats({1, 1, 1, 3, 3, 3}, "VEC3", 3);
    const std::string clips = join_clips(play("translation", times, keys, "LINEAR", 0),
                                         play("scale", times, sizes, "LINEAR", 0));
    const std::string text = file.text(
        R"({"attributes":{)" + attribute("POSITION", positions) + "}}", R"([{"mesh":0}])", clips);
    const auto both = open(text);
    EXPECT_FALSE(has_warning("animations[0]"));
    const glm::dmat4 pose = both->compute_pose(5.0).object_to_world[0];
    EXPECT_NEAR(pose[3].x, 5.0, 1e-6);
    EXPECT_NEAR(pose[0].x, 2.0, 1e-6);
    const auto second = open(text, {{}, 1, {}});
    EXPECT_NEAR(second->compute_pose(5.0).object_to_world[0][3].x, 0.0, 1e-6);
}

TEST_F(GltfAnimation, MorphTargetsAddUpBeforeTheSkinMoves) {
    Strip strip;
    const int deltas = strip.file.add_floats({0, 0, 0, 0, 0, 0, 0, 1, 0}, "VEC3", 3);
    const int times = strip.file.add_floats({0, 1}, "SCALAR", 1);
    const int weights = strip.file.add_floats({0, 2}, "SCALAR", 1);
    strip.primitive.insert(strip.primitive.size() - 1,
                           R"(,"targets":[{)" + attribute("POSITION", deltas) + "}]");
    const std::size_t end = strip.more.find(R"(],"samplers":[)");
    strip.more.insert(end, R"(,{"sampler":1,"target":{"node":1,"path":"weights"}})");
    strip.more.insert(strip.more.size() - 3, R"(,{"input":)" + std::to_string(times) +
                                                 R"(,"output":)" + std::to_string(weights) + "}");
    const auto scene = open(strip.text());
    for (const double time_s : {0.0, 0.25, 0.75}) {
        const double angle = 0.5 * kPi * time_s;
        const double length = 1.0 + 2.0 * time_s; // of the tip beyond its joint
        const glm::dvec3 expected(-std::sin(angle) * length, 1.0 + std::cos(angle) * length, 0.0);
        EXPECT_LT(glm::distance(glm::dvec3(scene->deform(0, time_s).positions[2]), expected), 2e-6)
            << time_s;
    }
}

TEST_F(GltfAnimation, MorphsWithoutSkinAndWithSparseTargets) {
    AnimatedFile file;
    const int positions = file.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
    const int indices = file.add<std::uint16_t>({2}, "SCALAR", 5123, 1);
    const int values = file.add_floats({0, 0, 4}, "VEC3", 3);
    const std::string sparse =
        R"(,"sparse":{"count":1,"indices":{"bufferView":)" + std::to_string(indices) +
        R"(,"componentType":5123},"values":{"bufferView":)" + std::to_string(values) + "}}";
    const int deltas = file.add<float>({0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3", 5126, 3, sparse);
    const auto scene =
        open(file.text(R"({"attributes":{)" + attribute("POSITION", positions) +
                           R"(},"targets":[{)" + attribute("POSITION", deltas) + "}]}",
                       R"([{"mesh":0,"weights":[0.25]}])", ""));
    EXPECT_TRUE(scene->is_static());
    const Deformation shape = scene->deform(0, 0.0);
    EXPECT_EQ(shape.positions[2], glm::vec3(0.0f, 1.0f, 1.0f));
    // Without normals in the file they are the moved triangle's.
    const glm::vec3 expected = glm::normalize(glm::vec3(0.0f, -1.0f, 1.0f));
    EXPECT_LT(glm::distance(shape.normals[0], expected), 1e-6f);
}

} // namespace
} // namespace alcove
