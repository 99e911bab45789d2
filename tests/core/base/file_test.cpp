#include "core/base/file.hpp"

#include "core/base/error.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <cstdlib>
#include <fstream>
#include <string>

#include <csignal>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

class FileTest : public testing::Test {
  protected:
    TemporaryFolder m_own;
    const fs::path& m_folder = m_own.path();
};

TEST_F(FileTest, WritesAndReadsBack) {
    write_file_atomically(m_folder / "a" / "b.txt", "hello");
    EXPECT_EQ(read_file(m_folder / "a" / "b.txt"), "hello");
    EXPECT_FALSE(fs::exists(m_folder / "a" / "b.txt.tmp"));
}

TEST_F(FileTest, MissingTooLargeAndFoldersAreErrors) {
    write_file_atomically(m_folder / "x", "12345");
    EXPECT_THROW(static_cast<void>(read_file(m_folder / "y")), InputError);
    EXPECT_THROW(static_cast<void>(read_file(m_folder / "x", 4)), InputError);
    EXPECT_THROW(static_cast<void>(read_file(m_folder)), InputError);
}

TEST_F(FileTest, APathBelowARegularFileCannotBeWritten) {
    write_file_atomically(m_folder / "file", "x");
    EXPECT_THROW(create_output_folder(m_folder / "file" / "below"), InputError);
    EXPECT_THROW(write_file_atomically(m_folder / "file" / "below", "x"), FailureError);
}

TEST_F(FileTest, AFullDiskLeavesTheOldFileWhole) {
    const fs::path disk = m_folder / "disk";
    fs::create_directory(disk);
    const bool mounted = ::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64m") == 0;
    const fs::path path = disk / "table.csv";
    write_file_atomically(path, "old");
    const std::string large(65u << 20, 'x');
    if (mounted) {
        RecordProperty("full_disk", "64 MiB tmpfs");
        EXPECT_THROW(write_file_atomically(path, large), FailureError);
    } else {
        // Where mounting is refused the limit on file sizes stands in for the full disk.
        RecordProperty("full_disk", "RLIMIT_FSIZE, since mounting was refused");
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{1u << 20, RLIM_INFINITY};
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
        EXPECT_THROW(write_file_atomically(path, large), FailureError);
        const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &none);
    }
    EXPECT_EQ(read_file(path), "old");
    EXPECT_FALSE(fs::exists(path.string() + ".tmp"));
    if (mounted) {
        ::umount(disk.c_str());
    }
}

TEST_F(FileTest, ReferencesStayInsideTheirFolder) {
    write_file_atomically(m_folder / "in" / "mesh.bin", "x");
    write_file_atomically(m_folder / "secret", "x");
    fs::create_symlink(m_folder / "secret", m_folder / "in" / "link");
    EXPECT_EQ(read_file(resolve_inside(m_folder / "in", "mesh.bin")), "x");
    for (const char* outside : {"../secret", "a/../../secret", "/etc/passwd", "file:///etc/passwd",
                                "link", "", "..", "a\\..\\b"}) {
        EXPECT_THROW(static_cast<void>(resolve_inside(m_folder / "in", outside)), InputError)
            << outside;
    }
}

} // namespace
} // namespace alcove
