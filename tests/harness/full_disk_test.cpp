// A disk that fills up while a run writes to it: a clear message, exit code 1, and nothing finished
// is lost.

#include "core/base/error.hpp"
#include "core/base/image_file.hpp"
#include "reports/record/record.hpp"
#include "tests/harness/program.hpp"

#include <cstdio>
#include <fcntl.h>
#include <sys/mount.h>
#include <unistd.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// 64 MiB in memory, where this process may mount.
class SmallDisk {
  public:
    explicit SmallDisk(fs::path place) : m_place(std::move(place)) {
        fs::create_directory(m_place);
        m_mounted = ::mount("alcove-test", m_place.c_str(), "tmpfs", 0, "size=64m") == 0;
    }
    ~SmallDisk() {
        if (m_mounted) {
            ::umount2(m_place.c_str(), MNT_DETACH);
        }
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    [[nodiscard]] bool is_mounted() const { return m_mounted; }
    /// Writes until no byte is left, then gives back `free` bytes.
    void fill(std::uintmax_t free = 0) const {
        const int file = ::open((m_place / "ballast").c_str(), O_WRONLY | O_CREAT, 0600);
        ASSERT_GE(file, 0);
        const std::string block(1 << 16, 'x');
        std::size_t size = block.size();
        while (size > 0) {
            if (::write(file, block.data(), size) < 0) {
                size /= 2;
            }
        }
        ::close(file);
        fs::resize_file(m_place / "ballast", fs::file_size(m_place / "ballast") - free);
    }
    void empty() const { fs::remove(m_place / "ballast"); }

  private:
    fs::path m_place;
    bool m_mounted = false;
};

class FullDisk : public ProgramTest {};

TEST_F(FullDisk, EndsTheRunAndKeepsWhatIsFinished) {
    const SmallDisk disk(folder() / "disk");
    std::printf("full disk by %s\n",
                disk.is_mounted() ? "a tmpfs of 64 MiB" : "RLIMIT_FSIZE: mounting is refused here");
    RecordProperty("full_disk_by", disk.is_mounted() ? "tmpfs" : "RLIMIT_FSIZE");
    // Two rounds; the second is long enough to be met by the full disk.
    const std::string first = write("a.gltf", make_box_gltf(0.0));
    const std::string second = write("b.gltf", make_box_gltf(0.5));
    const fs::path out = folder() / "disk" / "run";
    ChildProcess child(program(),
                       {"run", "--scene", first, "--scene", second, "--method", "hemisphere_ssao",
                        "--size", "160x120", "--frames", "0:24", "--repeat", "4", "--out",
                        out.string()},
                       with_cache({}));
    const fs::path finished = out / "rounds" / "r001-a" / "done.json";
    while (!fs::exists(finished)) {
        ASSERT_FALSE(child.wait_for(std::chrono::milliseconds(2))) << child.finish().err;
    }
    if (disk.is_mounted()) {
        disk.fill();
    } else {
        child.limit_file_size(16);
    }
    const ChildResult result = child.finish();
    EXPECT_EQ(result.exit_code, 1) << result.err << "signal " << result.signal;
    EXPECT_NE(result.err.find(disk.is_mounted() ? "No space left on device" : "File too large"),
              std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find(out.string()), std::string::npos) << result.err;
    {
        const RunFolder run = RunFolder::open(out);
        EXPECT_TRUE(run.is_finished("r001-a"));
        EXPECT_FALSE(run.is_finished("r002-b"));
        EXPECT_FALSE(run.read_samples().empty());
        EXPECT_FALSE(run.read_metrics().empty());
    }
    if (disk.is_mounted()) {
        disk.empty();
    }
    const ChildResult resumed = run({"run", "--resume", out.string()});
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_TRUE(RunFolder::open(out).is_complete());
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(out / "images")) {
        EXPECT_NE(file.path().filename().string().substr(0, 5), ".tmp-") << file.path();
    }
}

TEST_F(FullDisk, ImagesAreWholeOrNotThere) {
    const SmallDisk disk(folder() / "images");
    if (!disk.is_mounted()) {
        GTEST_SKIP() << "mounting is refused here";
    }
    Image image({160, 120}, 3);
    std::uint32_t state = 1;
    for (float& value : image.values()) { // noise, so that no file is small
        state = 1664525u * state + 1013904223u;
        value = static_cast<float>(state >> 8) * 0x1p-24f;
    }
    for (const std::uintmax_t free : {0u, 4096u, 16384u, 32768u}) {
        disk.fill(free);
        const auto expect_failure = [&](const char* name, const auto& write_image) {
            const fs::path file = folder() / "images" / name;
            try {
                write_image(file);
                ADD_FAILURE() << name << " was written into " << free << " bytes";
            } catch (const FailureError& error) {
                EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
            }
            EXPECT_FALSE(fs::exists(file)) << name;
        };
        expect_failure("a.png",
                       [&](const fs::path& file) { write_png(file, image, Domain::view); });
        expect_failure("a.exr",
                       [&](const fs::path& file) { write_exr(file, image, Domain::linear); });
        disk.empty();
    }
    write_png(folder() / "images" / "a.png", image, Domain::view);
    EXPECT_EQ(read_image_file(folder() / "images" / "a.png").image.size(), image.size());
}

} // namespace
} // namespace alcove
