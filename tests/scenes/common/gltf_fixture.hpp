#pragma once
// Tiny glTF files as text, and what opening them says.

#include "core/base/error.hpp"
#include "scenes/common/gltf_scene.hpp"

#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace alcove {

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
    const std::size_t at = bytes.size();
    bytes.resize(at + values.size() * sizeof(T));
    std::memcpy(bytes.data() + at, values.data(), values.size() * sizeof(T));
}

/// Four corners of a unit square in the plane z = 0 as 48 bytes, then the indices of its two
/// triangles as u16.
inline std::string make_square() {
    std::string bytes;
    append<float>(bytes, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    append<std::uint16_t>(bytes, {0, 1, 2, 0, 2, 3});
    return bytes;
}

/// The parts of a file that tests replace.
struct Parts {
    std::string buffers = R"([{"uri":"square.bin","byteLength":60}])";
    std::string views =
        R"([{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}])";
    std::string accessors =
        R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
        R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}])";
    std::string primitive = R"({"attributes":{"POSITION":0},"indices":1})";
    std::string nodes = R"([{"mesh":0}])";
    std::string scene_nodes = "[0]";
    std::string more; ///< further top-level members, each with a leading comma

    [[nodiscard]] std::string text() const {
        return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":)" + scene_nodes +
               R"(}],"nodes":)" + nodes + R"(,"meshes":[{"primitives":[)" + primitive +
               R"(]}],"accessors":)" + accessors + R"(,"bufferViews":)" + views + R"(,"buffers":)" +
               buffers + more + "}";
    }
};

inline void append_u32(std::string& bytes, std::size_t value) {
    append<std::uint32_t>(bytes, {static_cast<std::uint32_t>(value)});
}

inline std::string make_glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    std::string glb = "glTF";
    append_u32(glb, 2);
    append_u32(glb, 12 + 8 + json.size() + 8 + binary.size());
    append_u32(glb, json.size());
    append_u32(glb, 0x4E4F534A);
    glb += json;
    append_u32(glb, binary.size());
    append_u32(glb, 0x004E4942);
    return glb + binary;
}

class GltfTest : public testing::Test {
  protected:
    void SetUp() override {
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        m_folder = std::filesystem::temp_directory_path() /
                   ("alcove-gltf-" + test + "-" + std::to_string(::getpid())) / "inner";
        std::filesystem::create_directories(m_folder);
        write("square.bin", make_square());
    }
    void TearDown() override { std::filesystem::remove_all(m_folder.parent_path()); }

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(m_folder / name, std::ios::binary) << bytes;
    }

    std::unique_ptr<Scene> open(const std::string& bytes, const GltfOptions& options = {}) {
        write("scene.gltf", bytes);
        m_warnings.clear();
        std::unique_ptr<Scene> scene =
            open_gltf_scene(m_folder / "scene.gltf", options, &m_warnings);
        check_scene(*scene, "scene.gltf");
        return scene;
    }

    /// The error names the file and `part`.
    void expect_error(const std::string& bytes, const std::string& part) {
        try {
            static_cast<void>(open(bytes));
            FAIL() << "accepted: " << bytes.substr(0, 400);
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("scene.gltf"), std::string::npos)
                << error.what();
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }

    [[nodiscard]] bool has_warning(const std::string& part) const {
        for (const std::string& warning : m_warnings) {
            if (warning.find(part) != std::string::npos) {
                return true;
            }
        }
        return false;
    }

    std::filesystem::path m_folder;
    std::vector<std::string> m_warnings;
};

} // namespace alcove
