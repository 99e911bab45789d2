// Several hundred damaged files of every kind that scenes are read from: each is refused with a
// message, or opens as a scene that holds what the contract promises. None crashes, none takes a
// gigabyte, none reads beside its folder.
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "scenes/common/gltf_export.hpp"
#include "scenes/common/gltf_scene.hpp"
#include "scenes/common/off_file.hpp"
#include "scenes/common/walkthrough_file.hpp"
#include "scenes/registry.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <cctype>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// The process's largest resident memory so far in KiB.
long read_peak_kib() {
    std::ifstream status("/proc/self/status");
    std::string word;
    long kib = 0;
    while (status >> word) {
        if (word == "VmHWM:") {
            status >> kib;
        }
    }
    return kib;
}

/// Two triangles with a skin, a clip and a buffer in the text: something of everything.
std::string make_gltf() {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,2]}],
"nodes":[{"mesh":0,"skin":0,"children":[1]},{"translation":[0,1,0]},{"camera":0,"translation":[0,0,5]}],
"cameras":[{"type":"perspective","perspective":{"yfov":1.0,"znear":0.1,"zfar":50}}],
"skins":[{"joints":[1],"inverseBindMatrices":6}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1}]}],
"animations":[{"samplers":[{"input":4,"output":5}],
  "channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}]}],
"buffers":[{"byteLength":212,"uri":"data.bin"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6},
 {"buffer":0,"byteOffset":44,"byteLength":12},{"buffer":0,"byteOffset":56,"byteLength":48},
 {"buffer":0,"byteOffset":104,"byteLength":8},{"buffer":0,"byteOffset":112,"byteLength":24},
 {"buffer":0,"byteOffset":148,"byteLength":64}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
 {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},
 {"bufferView":2,"componentType":5121,"count":3,"type":"VEC4"},
 {"bufferView":3,"componentType":5126,"count":3,"type":"VEC4"},
 {"bufferView":4,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[1]},
 {"bufferView":5,"componentType":5126,"count":2,"type":"VEC3"},
 {"bufferView":6,"componentType":5126,"count":1,"type":"MAT4"}]})";
}

std::string make_buffer() {
    std::string bytes;
    const auto add = [&bytes](float value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) {
        add(value);
    }
    bytes += std::string("\0\0\1\0\2\0\0\0", 8);
    bytes += std::string(12, '\0');
    for (int vertex = 0; vertex < 3; ++vertex) {
        for (const float value : {1.f, 0.f, 0.f, 0.f}) {
            add(value);
        }
    }
    for (const float value : {0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 2.f, 0.f}) {
        add(value);
    }
    bytes.resize(148);
    for (int i = 0; i < 16; ++i) {
        add(i % 5 == 0 ? 1.f : 0.f);
    }
    return bytes;
}

constexpr const char* kOff = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n"
                             "3 1 2 3\n";
constexpr const char* kWalkthrough =
    R"({"version": 2, "name": "own", "step_seconds": 0.03, "frames": 3, "near": 0.05, "far": 100,
"cuts": [2], "poses": [
{"position": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_y_degrees": 60},
{"position": [0, 1, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_y_degrees": 60},
{"position": [1, 1, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_y_degrees": 60}],
"events": [{"frame": 1, "label": "now"}],
"tracks": [{"object": "model", "pivot": [0, 0, 0], "axis": [0, 1, 0],
"keys": [{"frame": 0, "translation": [0, 0, 0], "degrees": 0},
{"frame": 2, "translation": [1, 0, 0], "degrees": 90}]}]})";

/// Cuts, flips bits, and puts numbers that no file should hold in the place of numbers.
std::vector<std::string> damage(const std::string& whole, int count, unsigned seed) {
    const std::vector<std::string> numbers{"-1",   "4294967295", "99999999999", "1e400",
                                           "-0.5", "NaN",        "1e308",       "0",
                                           "null", "[]",         "\"x\"",       "2147483647"};
    std::mt19937 random(seed);
    std::vector<std::string> damaged;
    for (int i = 0; i < count; ++i) {
        std::string text = whole;
        const std::size_t at = random() % text.size();
        if (i % 4 == 0) {
            text.resize(at);
        } else if (i % 4 == 1) {
            for (int flips = 0; flips < 3; ++flips) {
                text[random() % text.size()] ^= static_cast<char>(1u << random() % 8);
            }
        } else {
            const std::size_t begin = text.find_first_of("0123456789", at);
            if (begin == std::string::npos) {
                continue;
            }
            std::size_t end = begin;
            while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 ||
                                         text[end] == '.' || text[end] == '-')) {
                ++end;
            }
            text.replace(begin, end - begin, numbers[random() % numbers.size()]);
        }
        damaged.push_back(std::move(text));
    }
    return damaged;
}

class HostileFilesTest : public testing::Test {
  protected:
    /// Opens all; returns how many were refused.
    int open_all(const std::vector<std::string>& texts, const char* name,
                 const std::function<std::unique_ptr<Scene>(const fs::path&)>& open) {
        int refused = 0;
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const fs::path file = m_folder.path() / name;
            std::ofstream(file, std::ios::binary | std::ios::trunc) << texts[i];
            try {
                const std::unique_ptr<Scene> scene = open(file);
                check_scene(*scene, name);
                for (std::size_t k = 0; k < scene->get_objects().size(); ++k) {
                    if (scene->get_objects()[k].motion == ObjectMotion::deforming) {
                        static_cast<void>(scene->deform(k, 0.1));
                    }
                }
                static_cast<void>(scene->compute_pose(0.1));
            } catch (const InputError& error) {
                EXPECT_FALSE(std::string(error.what()).empty());
                m_last_refusal = error.what();
                ++refused;
            }
        }
        return refused;
    }
    void TearDown() override { EXPECT_LT(read_peak_kib(), 1024 * 1024); }

    TemporaryFolder m_folder;
    std::string m_last_refusal;
};

TEST_F(HostileFilesTest, DamagedGltfTexts) {
    write_file_atomically(m_folder.path() / "data.bin", make_buffer());
    const auto open = [](const fs::path& file) { return open_gltf_scene(file); };
    EXPECT_EQ(open_all({make_gltf()}, "whole.gltf", open), 0) << m_last_refusal;
    EXPECT_GT(open_all(damage(make_gltf(), 160, 1), "damaged.gltf", open), 60);
}

TEST_F(HostileFilesTest, DamagedBuffersBesideAGltfFile) {
    const std::string gltf = make_gltf();
    const auto open = [&](const fs::path& file) {
        fs::rename(file, m_folder.path() / "data.bin");
        const fs::path text = m_folder.path() / "whole.gltf";
        write_file_atomically(text, gltf);
        return open_gltf_scene(text);
    };
    EXPECT_GT(open_all(damage(make_buffer(), 60, 2), "buffer", open), 10);
}

TEST_F(HostileFilesTest, DamagedBinaryGltfFiles) {
    const Registry<SceneUnit> scenes = scenes_registry();
    const SceneUnit& unit = scenes.find("lifted_box");
    const fs::path whole = m_folder.path() / "whole.glb";
    static_cast<void>(export_gltf(*unit.open(unit.parameters.resolve({}, {})), whole));
    const std::string bytes = read_file(whole);
    const auto open = [](const fs::path& file) { return open_gltf_scene(file); };
    EXPECT_EQ(open_all({bytes}, "same.glb", open), 0) << m_last_refusal;
    EXPECT_GT(open_all(damage(bytes, 120, 3), "damaged.glb", open), 30);
    // The JSON chunk alone is damaged; lengths stay.
    std::vector<std::string> texts;
    std::mt19937 random(4);
    for (int i = 0; i < 80; ++i) {
        std::string text = bytes;
        const std::size_t begin = text.find_first_of("0123456789", 20 + random() % 3000);
        text[begin] = static_cast<char>('0' + random() % 10);
        texts.push_back(std::move(text));
    }
    open_all(texts, "number.glb", open);
}

TEST_F(HostileFilesTest, DamagedOffFiles) {
    const auto open = [](const fs::path& file) { return open_off_scene(file); };
    EXPECT_EQ(open_all({kOff}, "whole.off", open), 0) << m_last_refusal;
    EXPECT_GT(open_all(damage(kOff, 120, 5), "damaged.off", open), 60);
}

TEST_F(HostileFilesTest, DamagedWalkthroughs) {
    const fs::path model = m_folder.path() / "model.off";
    write_file_atomically(model, kOff);
    const auto open = [&](const fs::path& file) {
        return open_off_scene(model, {std::nullopt, file});
    };
    EXPECT_EQ(open_all({kWalkthrough}, "whole.json", open), 0) << m_last_refusal;
    EXPECT_GT(open_all(damage(kWalkthrough, 120, 6), "damaged.json", open), 60);
}

TEST_F(HostileFilesTest, NothingOutsideTheFolderIsRead) {
    const fs::path inside = m_folder.path() / "inside";
    fs::create_directory(inside);
    write_file_atomically(m_folder.path() / "data.bin", make_buffer());
    fs::create_symlink(m_folder.path() / "data.bin", inside / "link.bin");
    fs::create_directory_symlink(m_folder.path(), inside / "out");
    int refused = 0;
    for (const std::string& uri :
         {std::string("../data.bin"), std::string("./../data.bin"), std::string("%2e%2e/data.bin"),
          std::string("link.bin"), std::string("out/data.bin"),
          (m_folder.path() / "data.bin").string(), std::string("file:///etc/passwd"),
          std::string("http://localhost/data.bin"), std::string("\\\\host\\data.bin")}) {
        std::string text = make_gltf();
        text.replace(text.find("data.bin"), 8, uri);
        const fs::path file = inside / "model.gltf";
        write_file_atomically(file, text);
        try {
            static_cast<void>(open_gltf_scene(file));
            ADD_FAILURE() << uri << " was read";
        } catch (const InputError&) {
            ++refused;
        }
    }
    EXPECT_EQ(refused, 9);
}

TEST_F(HostileFilesTest, NodesThatReachThemselvesAreRefused) {
    write_file_atomically(m_folder.path() / "data.bin", make_buffer());
    std::string text = make_gltf();
    text.replace(text.find("\"children\":[1]"), 14, "\"children\":[0]");
    const fs::path file = m_folder.path() / "cycle.gltf";
    write_file_atomically(file, text);
    EXPECT_THROW(static_cast<void>(open_gltf_scene(file)), InputError);
}

} // namespace
} // namespace alcove
