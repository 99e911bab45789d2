// Colours, textures, quantised geometry and lights of glTF files.

#include "core/base/image_file.hpp"
#include "scenes/common/texture_codec.hpp"
#include "tests/scenes/common/gltf_fixture.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// Two pixels beside each other: red and a dark blue.
Texture make_picture() {
    return {"picture", {2, 1}, {255, 0, 0, 0, 0, 100}};
}

/// The square with texture coordinates, in the order of its corners, and an image.
class GltfSurface : public GltfTest {
  protected:
    void SetUp() override {
        GltfTest::SetUp();
        write("picture.png", encode_texture(make_picture()));
        std::string bytes = make_square();
        append<float>(bytes, {0, 1, 1, 1, 1, 0, 0, 0});
        append<std::uint8_t>(bytes, {255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 51, 0, 255, 255, 255, 0});
        write("square.bin", bytes);
        m_parts.buffers = R"([{"uri":"square.bin","byteLength":108}])";
        m_parts.views.insert(m_parts.views.size() - 1,
                             R"(,{"buffer":0,"byteOffset":60,"byteLength":32})"
                             R"(,{"buffer":0,"byteOffset":92,"byteLength":16})");
        m_parts.accessors.insert(
            m_parts.accessors.size() - 1,
            R"(,{"bufferView":2,"componentType":5126,"count":4,"type":"VEC2"})"
            R"(,{"bufferView":3,"componentType":5121,"normalized":true,"count":4,"type":"VEC4"})");
        m_parts.primitive = R"({"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,)"
                            R"("material":0})";
    }

    /// `info` stands beside the texture's index.
    void set_texture(const std::string& image, const std::string& info = "") {
        m_parts.more =
            R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0)" + info +
            R"(}}}],"textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071}],)" +
            R"("images":[{)" + image + "}]";
    }

    Parts m_parts;
};

TEST_F(GltfSurface, ReadsTexturesBesideTheFileAndWithin) {
    set_texture(R"("uri":"picture.png")");
    const auto scene = open(m_parts.text());
    ASSERT_EQ(scene->get_textures().size(), 1u);
    EXPECT_EQ(scene->get_textures()[0].size, (ImageSize{2, 1}));
    EXPECT_EQ(scene->get_textures()[0].rgb, make_picture().rgb);
    const Mesh& mesh = scene->get_meshes()[0];
    ASSERT_EQ(mesh.texture, std::optional<std::size_t>(0));
    // A mesh without normals has the corners of its triangles, in their order.
    EXPECT_EQ(mesh.texture_coordinates[1], glm::vec2(1.0f, 1.0f));
    EXPECT_EQ(mesh.texture_coordinates[5], glm::vec2(0.0f, 0.0f));
    EXPECT_FALSE(has_warning("repeat")); // all of [0,1]: clamping would change nothing
    set_texture(
        R"("uri":"data:image/png;base64,)"
        R"(iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNgYGAAAAAEAAH2FzhVAAAAAElF)"
        R"(TkSuQmCC")");
    EXPECT_EQ(open(m_parts.text())->get_textures()[0].rgb, (std::vector<std::uint8_t>{0, 0, 0}));
}

TEST_F(GltfSurface, TransformsTextureCoordinates) {
    set_texture(R"("uri":"picture.png")",
                R"(,"extensions":{"KHR_texture_transform":{"offset":[0.5,0.25],"scale":[2,3],)"
                R"("rotation":1.5707963267948966}})");
    const auto scene = open(m_parts.text());
    // (1, 1) scaled to (2, 3), turned counter-clockwise as seen with v downwards to (3, -2).
    EXPECT_LT(glm::distance(scene->get_meshes()[0].texture_coordinates[1], glm::vec2(3.5f, -1.75f)),
              1e-6f);
    EXPECT_TRUE(has_warning("repeat"));
}

TEST_F(GltfSurface, RefusesImagesOutsideTheFolderAndDamagedOnes) {
    std::ofstream(m_folder.parent_path() / "picture.png", std::ios::binary)
        << encode_texture(make_picture());
    for (const std::string uri : {"../picture.png", "%2e%2e/picture.png", "/etc/passwd",
                                  "file:///etc/passwd", "http://localhost/picture.png"}) {
        set_texture(R"("uri":")" + uri + "\"");
        expect_error(m_parts.text(), "images[0].uri");
    }
    fs::create_symlink(m_folder.parent_path() / "picture.png", m_folder / "link.png");
    set_texture(R"("uri":"link.png")");
    expect_error(m_parts.text(), "images[0].uri");
    const std::string png = encode_texture(make_picture());
    for (std::size_t size = 0; size + 16 < png.size(); size += 5) {
        write("cut.png", png.substr(0, size));
        set_texture(R"("uri":"cut.png")");
        expect_error(m_parts.text(), "images[0]");
    }
    std::string large = png; // the header's width; its checksum may or may not be looked at
    large.replace(16, 4, std::string("\x00\x00\xff\xff", 4));
    write("large.png", large);
    set_texture(R"("uri":"large.png")");
    expect_error(m_parts.text(), "images[0]");
    set_texture(R"("uri":"missing.png")");
    EXPECT_FALSE(open(m_parts.text())->get_meshes()[0].texture);
    EXPECT_TRUE(has_warning("images[0] is missing"));
}

TEST_F(GltfSurface, RefusesReferencesOutOfRange) {
    set_texture(R"("bufferView":0,"mimeType":"image/png")");
    expect_error(m_parts.text(), "images[0]");
    set_texture(R"("uri":"picture.png")", R"(,"texCoord":-1)");
    expect_error(m_parts.text(), "texCoord");
    set_texture(R"("uri":"picture.png")", R"(,"texCoord":3)");
    EXPECT_FALSE(open(m_parts.text())->get_meshes()[0].texture);
    EXPECT_TRUE(has_warning("TEXCOORD_3"));
    m_parts.more = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":4}}}])";
    expect_error(m_parts.text(), "materials[0].baseColorTexture");
    m_parts.more += R"(,"textures":[{},{},{},{},{"source":9}])";
    expect_error(m_parts.text(), "textures[4].source");
}

TEST_F(GltfSurface, RefusesSizesBeforeDecodingThem) {
    // A PNG of 8193x1 white pixels: small as a file.
    Texture wide{"wide", {8193, 1}, std::vector<std::uint8_t>(std::size_t{3} * 8193, 255)};
    const std::string png = encode_texture(wide);
    const auto bytes = std::span(reinterpret_cast<const unsigned char*>(png.data()), png.size());
    EXPECT_THROW(static_cast<void>(decode_texture(bytes, "wide.png")), InputError);
}

TEST_F(GltfSurface, ReadsVertexColours) {
    m_parts.primitive = R"({"attributes":{"POSITION":0,"COLOR_0":3},"indices":1})";
    const auto scene = open(m_parts.text());
    const Mesh& mesh = scene->get_meshes()[0];
    ASSERT_EQ(mesh.colors.size(), 6u);
    EXPECT_EQ(mesh.colors[0], glm::vec3(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(mesh.colors[2], glm::vec3(0.0f, 0.0f, 0.2f));
    m_parts.primitive = R"({"attributes":{"POSITION":0,"COLOR_0":2},"indices":1})";
    expect_error(m_parts.text(), "accessors[2]");
}

TEST_F(GltfSurface, ReadsQuantisedGeometry) {
    std::string bytes;
    append<std::int16_t>(bytes, {0, 0, 0, 0, 32767, 0, 0, 0, 32767, 32767, 0, 0, -32768, 0, 0, 0});
    append<std::uint8_t>(bytes, {0, 0, 0, 0, 2, 0, 0, 0, 2, 3, 0, 0, 0, 3, 0, 0});
    append<std::uint16_t>(bytes, {0, 1, 2, 0, 2, 3});
    write("square.bin", bytes);
    Parts parts;
    parts.buffers = R"([{"uri":"square.bin","byteLength":60}])";
    parts.views = R"([{"buffer":0,"byteLength":32,"byteStride":8},)"
                  R"({"buffer":0,"byteOffset":48,"byteLength":12},)"
                  R"({"buffer":0,"byteOffset":32,"byteLength":16,"byteStride":4}])";
    parts.accessors =
        R"([{"bufferView":0,"componentType":5122,"normalized":true,"count":4,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"},)"
        R"({"bufferView":2,"componentType":5121,"count":4,"type":"VEC3"}])";
    expect_error(parts.text(), "accessors[0]"); // not without the extension
    parts.more = R"(,"extensionsUsed":["KHR_mesh_quantization"])";
    const auto scene = open(parts.text());
    const Mesh& mesh = scene->get_meshes()[0];
    EXPECT_EQ(mesh.positions[1], glm::vec3(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(mesh.positions[5], glm::vec3(-1.0f, 0.0f, 0.0f));
    EXPECT_FALSE(has_warning("extension"));
    parts.primitive = R"({"attributes":{"POSITION":2},"indices":1})";
    EXPECT_EQ(open(parts.text())->get_meshes()[0].positions[2], glm::vec3(2.0f, 3.0f, 0.0f));
}

TEST_F(GltfSurface, LightsFromTheFile) {
    write("square.bin", make_square());
    Parts parts;
    parts.nodes =
        R"([{"mesh":0},{"rotation":[0.7071067811865476,0,0,-0.7071067811865476],"extensions":)"
        R"({"KHR_lights_punctual":{"light":0}}},)"
        R"({"extensions":{"KHR_lights_punctual":{"light":1}}}])";
    parts.scene_nodes = "[0,1,2]";
    const std::string lights =
        R"(,"extensionsUsed":["KHR_lights_punctual"],"extensions":)"
        R"({"KHR_lights_punctual":{"lights":[{"type":"directional",)"
        R"("color":[1,0.5,0],"intensity":INTENSITY},{"type":"KIND","spot":{}}]}})";
    std::string kind = "point";
    const auto set_intensity = [&](const std::string& value) {
        parts.more = lights;
        parts.more.replace(parts.more.find("INTENSITY"), 9, value);
        parts.more.replace(parts.more.find("KIND"), 4, kind);
    };
    set_intensity("2");
    const auto scene = open(parts.text());
    ASSERT_EQ(scene->get_lights().directional.size(), 1u);
    const DirectionalLight& light = scene->get_lights().directional[0];
    EXPECT_LT(glm::distance(light.to_light, glm::dvec3(0.0, 1.0, 0.0)), 1e-9);
    EXPECT_EQ(light.irradiance, glm::vec3(2.0f, 1.0f, 0.0f));
    ASSERT_EQ(scene->get_lights().points.size(), 1u);
    EXPECT_FALSE(scene->get_lights().points[0].cone.has_value());
    EXPECT_EQ(scene->get_lights().points[0].position, glm::dvec3(0.0));
    kind = "spot";
    set_intensity("2");
    const auto spot = open(parts.text());
    ASSERT_TRUE(spot->get_lights().points.at(0).cone.has_value());
    EXPECT_EQ(spot->get_lights().points[0].cone->direction, glm::dvec3(0.0, 0.0, -1.0));
    EXPECT_NEAR(spot->get_lights().points[0].cone->outer_radians, 0.7853981634, 1e-9);
    kind = "lamp";
    set_intensity("2");
    expect_error(parts.text(), "lights[1]");
    kind = "point";
    set_intensity("100000");
    EXPECT_EQ(open(parts.text())->get_lights().directional[0].irradiance,
              glm::vec3(1.0f, 0.5f, 0.0f));
    EXPECT_TRUE(has_warning("scaled"));
    set_intensity("-1");
    expect_error(parts.text(), "lights[0]");
    set_intensity("2");
    parts.nodes.replace(parts.nodes.find(R"("light":1)"), 9, R"("light":7)");
    expect_error(parts.text(), "nodes[2]");
}

TEST_F(GltfSurface, RefusesToUnfoldSmallFilesIntoGigabytes) {
    write("square.bin", make_square());
    Parts parts;
    parts.accessors = R"([{"componentType":5126,"count":1000000000,"type":"VEC3","sparse":)"
                      R"({"count":1,"indices":{"bufferView":1,"componentType":5123},)"
                      R"("values":{"bufferView":0}}},)"
                      R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}])";
    expect_error(parts.text(), "accessors[0]");
    // Many meshes of a few bytes each: every one is allowed, all together are not.
    parts.accessors.replace(parts.accessors.find("1000000000"), 10, "4000000");
    std::string primitives = R"({"attributes":{"POSITION":0},"indices":1})";
    for (int i = 0; i < 30; ++i) {
        parts.primitive += "," + primitives;
    }
    expect_error(parts.text(), "unfolds");
}

} // namespace
} // namespace alcove
