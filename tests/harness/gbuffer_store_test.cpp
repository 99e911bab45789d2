#include "harness/run/gbuffer_store.hpp"

#include "tests/harness/temporary_folder.hpp"
#include "tests/test_scenes.hpp"

#include <fstream>

#include <gtest/gtest.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// Bytes that compress in part: half noise, half nothing.
std::vector<std::byte> make_texels(std::size_t bytes) {
    std::vector<std::byte> texels(bytes);
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < bytes / 2; ++i) {
        state = state * 1664525u + 1013904223u;
        texels[i] = static_cast<std::byte>(state >> 24);
    }
    return texels;
}

TEST(GBufferStore, TexelsComeBackBitForBitAlsoOverSeveralBlocks) {
    const TemporaryFolder folder;
    const GBufferStore store(folder.path(), "driver");
    for (const std::size_t bytes :
         {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{9} << 20}) {
        SCOPED_TRACE(bytes);
        const std::vector<std::byte> texels = make_texels(bytes);
        const std::string key = "ab" + std::to_string(bytes);
        EXPECT_FALSE(store.has(key));
        EXPECT_FALSE(store.read(key, bytes));
        store.write(key, texels);
        EXPECT_TRUE(store.has(key));
        EXPECT_EQ(store.read(key, bytes), texels);
        EXPECT_FALSE(store.read(key, bytes + 1)) << "a texture of another size";
    }
    EXPECT_LT(fs::file_size(folder.path() / "gbuffers" / "ab" /
                            ("ab" + std::to_string(std::size_t{9} << 20) + ".texels")),
              std::uintmax_t{6} << 20);
}

TEST(GBufferStore, EveryDamagedByteIsSeen) {
    const TemporaryFolder folder;
    const GBufferStore store(folder.path(), "driver");
    store.write("abc", make_texels(200));
    const fs::path file = folder.path() / "gbuffers" / "ab" / "abc.texels";
    std::string whole;
    {
        std::ifstream stream(file, std::ios::binary);
        whole.assign(std::istreambuf_iterator<char>(stream), {});
    }
    const auto write = [&](const std::string& text) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
    };
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x40);
        write(damaged);
        EXPECT_FALSE(store.read("abc", 200)) << "byte " << i;
        EXPECT_FALSE(GBufferStore::is_intact(file)) << "byte " << i;
    }
    for (const std::size_t length : {std::size_t{0}, std::size_t{7}, whole.size() - 1}) {
        write(whole.substr(0, length));
        EXPECT_FALSE(store.read("abc", 200)) << length;
    }
    write(whole + "x");
    EXPECT_FALSE(store.read("abc", 200));
    write(whole);
    EXPECT_TRUE(GBufferStore::is_intact(file));
}

TEST(GBufferStore, ASizeThatNobodyCanTrustIsNotAllocated) {
    const TemporaryFolder folder;
    const GBufferStore store(folder.path(), "driver");
    const fs::path file = folder.path() / "gbuffers" / "ab" / "abc.texels";
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << "ALCVGBF1" << std::string(16, '\x7f');
    EXPECT_FALSE(store.read("abc", 200));
}

TEST(GBufferStore, WhatDecidesAChannelIsInItsKey) {
    const TestScene scene = make_box_scene();
    const TestScene plane = make_plane_scene(0.0);
    const FrameView view = make_frame_view(scene.get_walkthrough(), 0, {32, 24}, true);
    GBufferStore store("unused", "driver");
    const Precision precision;
    const std::string key = store.make_key(scene, view, precision, Channel::normal, {});
    EXPECT_EQ(store.make_key(scene, view, precision, Channel::normal, {}), key);
    EXPECT_NE(store.make_key(scene, view, precision, Channel::albedo, {}), key);
    EXPECT_NE(store.make_key(scene, view, precision, Channel::normal, {PartKind::layer, 2, {}}),
              key);
    EXPECT_NE(store.make_key(plane, view, precision, Channel::normal, {}), key);
    EXPECT_NE(store.make_key(scene, view, parse_precision("eye_depth=16F"), Channel::normal, {}),
              key);
    FrameView other = view;
    other.camera.fov_y_radians += 1e-9;
    EXPECT_NE(store.make_key(scene, other, precision, Channel::normal, {}), key);
    other = view;
    other.size = {24, 32};
    EXPECT_NE(store.make_key(scene, other, precision, Channel::normal, {}), key);
    EXPECT_NE(
        GBufferStore("unused", "another").make_key(scene, view, precision, Channel::normal, {}),
        key);
    // Neither the index nor a camera of the past is drawn.
    other = view;
    other.index = 7;
    other.previous_camera.position.x += 1.0;
    EXPECT_EQ(store.make_key(scene, other, precision, Channel::normal, {}), key);
}

TEST(GBufferStore, MotionAlsoDependsOnThePoseBefore) {
    const TestScene scene = make_box_scene();
    FrameView view = make_frame_view(scene.get_walkthrough(), 1, {32, 24}, false);
    GBufferStore store("unused", "driver");
    const std::string depth = store.make_key(scene, view, {}, Channel::eye_depth, {});
    const std::string motion = store.make_key(scene, view, {}, Channel::motion, {});
    view.previous_time_s = view.time_s;
    EXPECT_EQ(store.make_key(scene, view, {}, Channel::eye_depth, {}), depth);
    EXPECT_NE(store.make_key(scene, view, {}, Channel::motion, {}), motion);
}

TEST(GBufferStore, TimesComeBackAndBelongToTheirTimerAndChannels) {
    const TemporaryFolder folder;
    const TestScene scene = make_box_scene();
    const FrameView view = make_frame_view(scene.get_walkthrough(), 0, {32, 24}, true);
    GBufferStore store(folder.path(), "driver");
    const std::string key = store.make_times_key(scene, view, {}, kBaseChannels, {}, "finish");
    EXPECT_NE(store.make_times_key(scene, view, {}, kBaseChannels, {}, "wall"), key);
    EXPECT_NE(store.make_times_key(scene, view, {}, {Channel::normal}, {}, "finish"), key);
    EXPECT_FALSE(store.read_times(key));
    store.write_times(key, std::vector<std::int64_t>{5, -3, 1000000000000});
    EXPECT_EQ(store.read_times(key), (std::vector<std::int64_t>{5, -3, 1000000000000}));
    std::ofstream(folder.path() / "gbuffers" / key.substr(0, 2) / (key + ".times")) << "5\nlots\n";
    EXPECT_FALSE(store.read_times(key));
}

} // namespace
} // namespace alcove
