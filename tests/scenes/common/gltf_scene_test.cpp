#include "tests/scenes/common/gltf_fixture.hpp"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

using GltfScene = GltfTest;

TEST_F(GltfScene, OpensASquareWithFlatNormals) {
    const std::unique_ptr<Scene> scene = open(Parts{}.text());
    ASSERT_EQ(scene->get_meshes().size(), 1u);
    EXPECT_EQ(count_size(*scene).triangles, 2u);
    for (const glm::vec3& normal : scene->get_meshes()[0].normals) {
        EXPECT_EQ(normal, glm::vec3(0.0f, 0.0f, 1.0f));
    }
    EXPECT_DOUBLE_EQ(scene->get_ao_radius_m(), 0.05 * std::sqrt(2.0));
    EXPECT_EQ(scene->get_walkthrough().cameras.size(), 120u);
    EXPECT_TRUE(has_warning("circles"));
    EXPECT_DOUBLE_EQ(open(Parts{}.text(), {0.3, {}, {}})->get_ao_radius_m(), 0.3);
    EXPECT_THROW(static_cast<void>(open(Parts{}.text(), {-1.0, {}, {}})), InputError);
}

TEST_F(GltfScene, OpensBinaryContainersAndDataUris) {
    Parts parts;
    parts.buffers = R"([{"byteLength":60}])";
    EXPECT_EQ(count_size(*open(make_glb(parts.text(), make_square()))).triangles, 2u);
    parts.buffers =
        R"([{"uri":"data:application/octet-stream;base64,)"
        R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAABAAIAAAACAAMA)"
        R"(","byteLength":60}])";
    EXPECT_EQ(count_size(*open(parts.text())).triangles, 2u);
    fs::copy_file(m_folder / "square.bin", m_folder / "a square.bin");
    parts.buffers = R"([{"uri":"a%20square.bin","byteLength":60}])";
    EXPECT_EQ(count_size(*open(parts.text())).triangles, 2u);
}

TEST_F(GltfScene, ABufferMayUseTheBeginningOfAFile) {
    write("square.bin", make_square() + "more");
    EXPECT_EQ(count_size(*open(Parts{}.text())).triangles, 2u);
}

TEST_F(GltfScene, TurnsStripsAndFansIntoTrianglesOfOneFacing) {
    Parts parts;
    parts.primitive = R"({"attributes":{"POSITION":0},"mode":6})";
    const std::unique_ptr<Scene> fan = open(parts.text());
    EXPECT_EQ(count_size(*fan).triangles, 2u);
    std::string strip;
    append<float>(strip, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    strip.resize(60);
    write("square.bin", strip);
    parts.primitive = R"({"attributes":{"POSITION":0},"mode":5})";
    const std::unique_ptr<Scene> strips = open(parts.text());
    EXPECT_EQ(count_size(*strips).triangles, 2u);
    for (const Scene* scene : {fan.get(), strips.get()}) {
        for (const glm::vec3& normal : scene->get_meshes()[0].normals) {
            EXPECT_EQ(normal.z, 1.0f);
        }
    }
}

TEST_F(GltfScene, KeepsInstancesAndComposesNodes) {
    Parts parts;
    parts.nodes = R"([{"translation":[1,2,3],"scale":[2,2,2],"children":[1,2]},)"
                  R"({"mesh":0,"translation":[1,0,0]},)"
                  R"({"mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476]}])";
    const std::unique_ptr<Scene> scene = open(parts.text());
    EXPECT_EQ(scene->get_meshes().size(), 1u);
    ASSERT_EQ(scene->get_objects().size(), 2u);
    const Pose pose = scene->compute_pose(0.0);
    EXPECT_EQ(glm::dvec3(pose.object_to_world[0][3]), glm::dvec3(3.0, 2.0, 3.0));
    const glm::dvec3 x_axis(pose.object_to_world[1][0]);
    EXPECT_LT(glm::distance(x_axis, glm::dvec3(0.0, 2.0, 0.0)), 1e-12);
}

TEST_F(GltfScene, TurnsTheWindingOfMirroredInstances) {
    Parts parts;
    parts.nodes = R"([{"mesh":0},{"mesh":0,"scale":[-1,1,1]}])";
    parts.scene_nodes = "[0,1]";
    const std::unique_ptr<Scene> scene = open(parts.text());
    ASSERT_EQ(scene->get_meshes().size(), 2u);
    const Mesh& plain = scene->get_meshes()[0];
    const Mesh& mirrored = scene->get_meshes()[1];
    EXPECT_EQ(plain.indices[1], mirrored.indices[2]);
    EXPECT_EQ(plain.positions, mirrored.positions);
}

TEST_F(GltfScene, ReadsTheBaseColourAsAlbedo) {
    Parts parts;
    parts.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":0})";
    parts.more = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.25,0.5,0.75,1]}}])";
    EXPECT_EQ(open(parts.text())->get_meshes()[0].albedo, glm::vec3(0.25f, 0.5f, 0.75f));
    parts.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":1})";
    expect_error(parts.text(), "material");
}

TEST_F(GltfScene, LooksThroughTheFilesCamerasWithACutBetween) {
    Parts parts;
    parts.nodes = R"([{"mesh":0},{"camera":0,"translation":[0,0,5]},{"camera":0,"scale":[3,3,3],)"
                  R"("translation":[1,0,9]}])";
    parts.scene_nodes = "[0,1,2]";
    parts.more = R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1}}])";
    const std::unique_ptr<Scene> scene = open(parts.text());
    const Walkthrough& walkthrough = scene->get_walkthrough();
    ASSERT_EQ(walkthrough.cameras.size(), 120u);
    EXPECT_EQ(walkthrough.cuts, (std::vector<int>{0, 60}));
    EXPECT_EQ(walkthrough.cameras[59].position, glm::dvec3(0.0, 0.0, 5.0));
    EXPECT_EQ(walkthrough.cameras[60].position, glm::dvec3(1.0, 0.0, 9.0));
    EXPECT_EQ(walkthrough.cameras[60].world_from_view, glm::dmat3(1.0));
    EXPECT_EQ(walkthrough.cameras[0].fov_y_radians, 0.5);
    EXPECT_GT(walkthrough.cameras[0].far_m, 5.0);
}

TEST_F(GltfScene, KeepsFarScenesPreciseByAnOrigin) {
    Parts parts;
    const std::string near_hash = hash_geometry(*open(parts.text()), 0.0);
    parts.nodes = R"([{"mesh":0,"translation":[10000000,0,0]}])";
    const std::unique_ptr<Scene> scene = open(parts.text());
    EXPECT_NEAR(scene->get_origin().x, 1e7, 2.0);
    EXPECT_EQ(glm::dvec3(scene->compute_pose(0.0).object_to_world[0][3]),
              glm::dvec3(1e7, 0.0, 0.0));
    parts.nodes = R"([{"mesh":0,"translation":[1e12,0,0]}])";
    expect_error(parts.text(), "nodes[0]");
}

TEST_F(GltfScene, NamesWhatItIgnores) {
    Parts parts;
    parts.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":0})";
    parts.more = R"(,"extensionsUsed":["KHR_materials_unlit"],"materials":[{"alphaMode":"BLEND",)"
                 R"("emissiveFactor":[1,0,0],"normalTexture":{"index":0}}],)"
                 R"("textures":[{"source":0}],"images":[{"uri":"../../nowhere.png"}])";
    EXPECT_EQ(count_size(*open(parts.text())).triangles, 2u);
    EXPECT_TRUE(has_warning("KHR_materials_unlit"));
    EXPECT_TRUE(has_warning("normal, metallic-roughness"));
    EXPECT_TRUE(has_warning("BLEND"));
    EXPECT_TRUE(has_warning("emission"));
    parts = {};
    parts.primitive += R"(,{"attributes":{"POSITION":0},"mode":0})";
    EXPECT_EQ(count_size(*open(parts.text())).triangles, 2u);
    EXPECT_TRUE(has_warning("points and lines"));
}

TEST_F(GltfScene, RejectsUnknownRequiredExtensions) {
    Parts parts;
    for (const std::string name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "X"}) {
        parts.more = R"(,"extensionsRequired":[")" + name + R"("])";
        expect_error(parts.text(), name);
    }
    parts.more = R"(,"extensionsRequired":["KHR_mesh_quantization"])";
    EXPECT_EQ(count_size(*open(parts.text())).triangles, 2u);
}

TEST_F(GltfScene, RejectsTruncatedFiles) {
    const std::string text = Parts{}.text();
    for (std::size_t size = 0; size < text.size(); size += 7) {
        expect_error(text.substr(0, size), "");
    }
    Parts parts;
    parts.buffers = R"([{"byteLength":60}])";
    const std::string glb = make_glb(parts.text(), make_square());
    for (std::size_t size = 0; size < glb.size(); size += 5) {
        expect_error(glb.substr(0, size), "");
    }
    write("square.bin", make_square().substr(0, 59));
    expect_error(text, "buffers[0]");
    fs::remove(m_folder / "square.bin");
    expect_error(text, "buffers[0]");
}

TEST_F(GltfScene, RejectsLyingContainers) {
    Parts parts;
    parts.buffers = R"([{"byteLength":60}])";
    const std::string good = make_glb(parts.text(), make_square());
    for (const std::size_t field : {4u, 8u, 12u, 16u}) {
        std::string glb = good;
        glb.replace(field, 4, "\xff\xff\xff\xff");
        expect_error(glb, "");
    }
    parts.buffers = R"([{"byteLength":6000}])";
    expect_error(make_glb(parts.text(), make_square()), "");
    parts.buffers = R"([{"byteLength":0}])";
    expect_error(make_glb(parts.text(), make_square()), "buffers[0]");
}

TEST_F(GltfScene, RejectsUrisThatLeaveTheFolder) {
    std::ofstream(m_folder.parent_path() / "square.bin", std::ios::binary) << make_square();
    for (const std::string uri :
         {"../square.bin", "%2e%2e/square.bin", "x/../../square.bin", "/etc/passwd",
          "file:///etc/passwd", "http://localhost/square.bin", "..\\\\square.bin", ""}) {
        Parts parts;
        parts.buffers = R"([{"uri":")" + uri + R"(","byteLength":60}])";
        expect_error(parts.text(), "buffers[0].uri");
    }
    fs::create_symlink(m_folder.parent_path() / "square.bin", m_folder / "link.bin");
    Parts parts;
    parts.buffers = R"([{"uri":"link.bin","byteLength":60}])";
    expect_error(parts.text(), "buffers[0].uri");
}

TEST_F(GltfScene, RejectsNodesThatAreNoTrees) {
    Parts parts;
    parts.nodes = R"([{"mesh":0,"children":[1]},{"children":[0]}])";
    expect_error(parts.text(), "nodes[0]");
    parts.nodes = R"([{"mesh":0,"children":[0]}])";
    expect_error(parts.text(), "nodes[0]");
    parts.nodes = R"([{"children":[1,2]},{"children":[3]},{"children":[3]},{"mesh":0}])";
    expect_error(parts.text(), "nodes[3]");
    parts.nodes = R"([{"mesh":0,"children":[7]}])";
    expect_error(parts.text(), "nodes[7]");
    parts.nodes = R"([{"mesh":0,"children":[-1]}])";
    expect_error(parts.text(), "nodes[-1]");
    parts.nodes = R"([{"mesh":4}])";
    expect_error(parts.text(), "nodes[0].mesh");
    parts.nodes = R"([{"mesh":0}])";
    parts.scene_nodes = "[3]";
    expect_error(parts.text(), "nodes[3]");
    Parts deep;
    deep.nodes = "[";
    for (int i = 0; i < 1000; ++i) {
        deep.nodes += R"({"children":[)" + std::to_string(i + 1) + "]},";
    }
    deep.nodes += R"({"mesh":0}])";
    expect_error(deep.text(), "nested too deeply");
}

TEST_F(GltfScene, RejectsTransformsThatAreNotAffine) {
    Parts parts;
    parts.nodes = R"([{"mesh":0,"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]}])";
    expect_error(parts.text(), "nodes[0]");
    parts.nodes = R"([{"mesh":0,"rotation":[0,0,0,0]}])";
    expect_error(parts.text(), "nodes[0].rotation");
    parts.nodes = R"([{"mesh":0,"scale":[0,0,0]}])";
    expect_error(parts.text(), "no triangles");
}

TEST_F(GltfScene, RejectsIndicesOutOfRange) {
    std::string bytes = make_square();
    bytes[48 + 10] = 4;
    write("square.bin", bytes);
    expect_error(Parts{}.text(), "accessors[1]");
}

TEST_F(GltfScene, RejectsPositionsThatAreNotFinite) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        std::string bytes = make_square();
        std::memcpy(bytes.data() + 16, &bad, sizeof(bad));
        write("square.bin", bytes);
        expect_error(Parts{}.text(), "accessors[0]");
    }
}

TEST_F(GltfScene, RejectsAccessorsOutOfRange) {
    const auto expect = [this](const std::string& from, const std::string& to,
                               const std::string& part) {
        Parts parts;
        for (std::string* text : {&parts.accessors, &parts.views, &parts.primitive}) {
            const std::size_t at = text->find(from);
            if (at != std::string::npos) {
                text->replace(at, from.size(), to);
                expect_error(parts.text(), part);
                return;
            }
        }
        FAIL() << from;
    };
    expect(R"("count":4)", R"("count":5)", "accessors[0]");
    expect(R"("count":4)", R"("count":1537228672809129302)", "accessors[0]");
    expect(R"("count":4)", R"("count":0)", "accessors[0]");
    expect(R"("count":6)", R"("count":5)", "primitives[0]");
    expect(R"("count":6)", R"("count":7)", "accessors[1]");
    expect(R"("count":4,)", R"("byteOffset":4,"count":4,)", "accessors[0]");
    expect(R"("count":4,)", R"("byteOffset":18446744073709551615,"count":4,)", "");
    expect(R"("bufferView":0,"componentType":5126)", R"("bufferView":9,"componentType":5126)",
           "accessors[0]");
    expect(R"("bufferView":0,"componentType":5126)", R"("componentType":5126)", "accessors[0]");
    expect(R"(5126)", "5123", "accessors[0]");
    expect(R"("VEC3")", R"("VEC4")", "accessors[0]");
    expect(R"(5123)", "5126", "accessors[1]");
    expect(R"("byteLength":48)", R"("byteLength":61)", "bufferViews[0]");
    expect(R"("byteLength":48)", R"("byteLength":48,"byteStride":8)", "");
    expect(R"("byteLength":48)", R"("byteLength":48,"byteStride":16)", "accessors[0]");
    expect(R"("buffer":0,"byteLength":48)", R"("buffer":3,"byteLength":48)", "bufferViews[0]");
    expect(R"("POSITION":0)", R"("POSITION":5)", "accessors[5]");
    expect(R"("POSITION":0)", R"("TEXCOORD_0":0)", "POSITION");
    expect(R"("type":"VEC3")",
           R"("sparse":{"count":2,"indices":{"bufferView":1,"byteOffset":2,"componentType":5123},)"
           R"("values":{"bufferView":1}},"type":"VEC3")",
           "sparse.values");
}

TEST_F(GltfScene, RejectsTooManyVertices) {
    // 200,000 nodes a 400 vertices from a file of a few megabytes.
    std::string bytes;
    append<float>(bytes, std::vector<float>(std::size_t{3} * 402, 0.5f));
    write("square.bin", bytes);
    Parts parts;
    parts.buffers = R"([{"uri":"square.bin","byteLength":4824}])";
    parts.views = R"([{"buffer":0,"byteLength":4824}])";
    parts.accessors = R"([{"bufferView":0,"componentType":5126,"count":402,"type":"VEC3"}])";
    parts.primitive = R"({"attributes":{"POSITION":0}})";
    parts.nodes = "[";
    parts.scene_nodes = "[";
    for (int i = 0; i < 200'000; ++i) {
        parts.nodes += i == 0 ? R"({"mesh":0})" : R"(,{"mesh":0})";
        parts.scene_nodes += (i == 0 ? "" : ",") + std::to_string(i);
    }
    parts.nodes += "]";
    parts.scene_nodes += "]";
    expect_error(parts.text(), "too large");
}

TEST_F(GltfScene, RejectsWhatIsNotGltf) {
    expect_error("", "");
    expect_error("[]", "");
    expect_error("{}", "asset");
    expect_error(R"({"asset":{"version":"1.0"}})", "asset");
    expect_error(std::string(100'000, '['), "nested");
    expect_error(R"({"asset":{"version":"2.0","extras":)" + std::string(100'000, '[') + "}}",
                 "nested");
    Parts parts;
    parts.more = R"(,"images":[{"bufferView":7,"mimeType":"image/png"}])";
    expect_error(parts.text(), "images[0]");
    EXPECT_THROW(static_cast<void>(open_gltf_scene(m_folder / "missing.glb")), InputError);
    EXPECT_THROW(static_cast<void>(open_gltf_scene(m_folder)), InputError);
}

} // namespace
} // namespace alcove
