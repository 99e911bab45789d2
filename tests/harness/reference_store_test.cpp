#include "harness/run/reference_store.hpp"

#include "core/base/image_file.hpp"
#include "tests/harness/expect_error.hpp"
#include "tests/harness/temporary_folder.hpp"
#include "tests/test_scenes.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr ImageSize kSize{32, 24};

TraceSettings make_settings() {
    TraceSettings settings;
    settings.target.radius_m = 0.5;
    settings.rays_per_half = 16;
    return settings;
}

FrameView make_view(const Scene& scene, int frame = 0) {
    return make_frame_view(scene.get_walkthrough(), frame, kSize, true);
}

std::vector<fs::path> list_files(const fs::path& folder) {
    std::vector<fs::path> files;
    if (fs::exists(folder)) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.is_regular_file()) {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

class References : public testing::Test {
  protected:
    ReferencePair get(const Scene& scene, const FrameView& view, const TraceSettings& settings,
                      const char* tracer = "tracer-hash") {
        // A store of its own: what it finds, it finds on disk.
        ReferenceStore store(m_folder.path(), tracer);
        return store.get(scene, view, settings, m_was_cached);
    }
    ReferencePair get(const Scene& scene) { return get(scene, make_view(scene), make_settings()); }

    TemporaryFolder m_folder;
    bool m_was_cached = false;
};

void expect_equal(const ReferencePair& a, const ReferencePair& b) {
    EXPECT_EQ(hash_image(a.a), hash_image(b.a));
    EXPECT_EQ(hash_image(a.b), hash_image(b.b));
}

TEST_F(References, AreTracedOnceAndReadBackBitForBit) {
    const TestScene scene = make_box_scene();
    const ReferencePair traced = get(scene);
    EXPECT_FALSE(m_was_cached);
    EXPECT_NE(hash_image(traced.a), hash_image(traced.b));
    const ReferencePair cached = get(scene);
    EXPECT_TRUE(m_was_cached);
    expect_equal(traced, cached);
    EXPECT_EQ(list_files(m_folder.path()).size(), 1u);
}

TEST_F(References, DamagedFilesAreTracedAnew) {
    const TestScene scene = make_box_scene();
    const ReferencePair traced = get(scene);
    const fs::path file = list_files(m_folder.path()).at(0);
    const std::vector<std::function<void()>> damages{
        [&] { fs::resize_file(file, fs::file_size(file) / 2); },
        [&] { fs::resize_file(file, 0); },
        [&] { std::ofstream(file, std::ios::binary | std::ios::trunc) << "not an image"; },
    };
    for (const std::function<void()>& damage : damages) {
        damage();
        const ReferencePair again = get(scene);
        EXPECT_FALSE(m_was_cached);
        expect_equal(traced, again);
        static_cast<void>(get(scene));
        EXPECT_TRUE(m_was_cached) << "the damaged file was not replaced";
    }
}

TEST_F(References, EverythingThatDecidesThePixelsIsInTheKey) {
    const TestScene scene = make_box_scene();
    static_cast<void>(get(scene));
    const auto expect_new = [&](const char* what, const Scene& other, const FrameView& view,
                                const TraceSettings& settings, const char* tracer) {
        static_cast<void>(get(other, view, settings, tracer));
        EXPECT_FALSE(m_was_cached) << what;
        static_cast<void>(get(other, view, settings, tracer));
        EXPECT_TRUE(m_was_cached) << what;
    };
    const char* const kSame = "tracer-hash";
    expect_new("camera", scene, make_view(scene, 1), make_settings(), kSame);
    expect_new("tracer", scene, make_view(scene), make_settings(), "another");
    TraceSettings settings = make_settings();
    settings.target.radius_m = 0.75;
    expect_new("radius", scene, make_view(scene), settings, kSame);
    settings = make_settings();
    settings.target.falloff = Falloff::none;
    expect_new("falloff", scene, make_view(scene), settings, kSame);
    settings = make_settings();
    settings.target.weighting = Weighting::uniform;
    expect_new("weighting", scene, make_view(scene), settings, kSame);
    settings = make_settings();
    settings.target.normals = Normals::geometric;
    expect_new("normals", scene, make_view(scene), settings, kSame);
    settings = make_settings();
    settings.rays_per_half = 32;
    expect_new("rays", scene, make_view(scene), settings, kSame);
    settings = make_settings();
    settings.seed = 1;
    expect_new("seed", scene, make_view(scene), settings, kSame);
    settings = make_settings();
    settings.terminator_safe = false;
    expect_new("terminator", scene, make_view(scene), settings, kSame);
    FrameView view = make_view(scene);
    view.size = {24, 32};
    expect_new("size", scene, view, make_settings(), kSame);
    view = make_view(scene);
    view.camera.fov_y_radians += 1e-9;
    expect_new("field of view", scene, view, make_settings(), kSame);
    view = make_view(scene);
    view.camera.near_m *= 2.0;
    expect_new("near", scene, view, make_settings(), kSame);
    view = make_view(scene);
    view.camera.far_m *= 2.0;
    expect_new("far", scene, view, make_settings(), kSame);
    const TestScene plane = make_plane_scene(0.0);
    expect_new("geometry", plane, make_view(scene), make_settings(), kSame);
}

TEST_F(References, ThreadsAndFrameNumbersAreNotInTheKey) {
    const TestScene scene = make_box_scene();
    const ReferencePair traced = get(scene);
    TraceSettings settings = make_settings();
    settings.threads = 1;
    FrameView view = make_view(scene);
    view.index = 77;
    expect_equal(traced, get(scene, view, settings));
    EXPECT_TRUE(m_was_cached);
}

TEST_F(References, OneStoreTellsItsScenesApart) {
    const TestScene boxes = make_box_scene();
    const TestScene plane = make_plane_scene(0.0);
    ReferenceStore store(m_folder.path(), "tracer-hash");
    const FrameView view = make_view(boxes);
    const ReferencePair first = store.get(boxes, view, make_settings(), m_was_cached);
    static_cast<void>(store.get(plane, view, make_settings(), m_was_cached));
    EXPECT_FALSE(m_was_cached);
    expect_equal(first, store.get(boxes, view, make_settings(), m_was_cached));
    EXPECT_TRUE(m_was_cached);
}

TEST_F(References, AWorldThatMovedAsAWholeKeepsItsReferences) {
    const TestScene here = make_box_scene();
    const ReferencePair traced = get(here);
    // A power of two keeps every bit of the cameras' and objects' places above 2^-29 m; the test
    // scene's cameras stand on decimal fractions, so they are put on binary ones first.
    const TestScene there = make_box_scene(glm::dvec3(8388608.0, 0.0, -8388608.0));
    FrameView view = make_view(here);
    FrameView moved = make_view(there);
    view.camera.position = {1.5, 1.625, 3.625};
    moved.camera.position = view.camera.position + there.get_origin();
    static_cast<void>(get(here, view, make_settings()));
    EXPECT_FALSE(m_was_cached);
    expect_equal(get(here, view, make_settings()), get(there, moved, make_settings()));
    EXPECT_TRUE(m_was_cached);
}

TEST_F(References, PruningKeepsTheLimitAndWhatWasUsedLast) {
    const TestScene scene = make_box_scene();
    TraceSettings settings = make_settings();
    std::vector<fs::path> by_age;
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
        settings.seed = seed;
        static_cast<void>(get(scene, make_view(scene), settings));
        for (const fs::path& file : list_files(m_folder.path())) {
            if (std::find(by_age.begin(), by_age.end(), file) == by_age.end()) {
                by_age.push_back(file);
                fs::last_write_time(file, fs::file_time_type::clock::now() -
                                              std::chrono::hours(10 - static_cast<int>(seed)));
            }
        }
    }
    ASSERT_EQ(by_age.size(), 4u);
    // Reading the oldest makes it the youngest.
    settings.seed = 0;
    static_cast<void>(get(scene, make_view(scene), settings));
    ASSERT_TRUE(m_was_cached);
    const std::uintmax_t limit = fs::file_size(by_age[0]) + fs::file_size(by_age[3]);
    prune_cache(m_folder.path(), limit);
    std::vector<fs::path> kept{by_age[0], by_age[3]};
    std::sort(kept.begin(), kept.end());
    EXPECT_EQ(list_files(m_folder.path()), kept);
    prune_cache(m_folder.path(), 0);
    EXPECT_TRUE(list_files(m_folder.path()).empty());
}

TEST_F(References, AuditTracesAgainAndTellsADifferentBit) {
    const TestScene scene = make_box_scene();
    static_cast<void>(get(scene));
    ReferenceStore auditing(m_folder.path(), "tracer-hash", {1.0, 7});
    static_cast<void>(auditing.get(scene, make_view(scene), make_settings(), m_was_cached));
    EXPECT_TRUE(m_was_cached);
    EXPECT_EQ(auditing.audited(), 1u);
    // A file that is whole and says something else.
    const fs::path file = list_files(m_folder.path()).at(0);
    EXPECT_TRUE(PairCache::is_intact(file));
    const Image other({kSize.width, 2 * kSize.height}, 1);
    write_exr(file, other, Domain::visibility);
    expect_error(
        [&] {
            static_cast<void>(auditing.get(scene, make_view(scene), make_settings(), m_was_cached));
        },
        1, {"audit", "reference"});
}

} // namespace
} // namespace alcove
