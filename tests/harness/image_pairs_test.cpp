// Lists and folders of images; a list is a file from outside.

#include "harness/app/image_pairs.hpp"
#include "tests/harness/expect_error.hpp"
#include "tests/harness/temporary_folder.hpp"

namespace alcove {
namespace {

namespace fs = std::filesystem;

class ImagePairs : public ::testing::Test {
  protected:
    void SetUp() override {
        for (const char* name : {"outside.png", "in/a/1.png", "in/b/1.png", "in/b/2.EXR",
                                 "in/b/notes.txt", "in/c d.hdr"}) {
            folder.write(name, "");
        }
    }
    std::vector<ImagePair> read(const std::string& text) const {
        return read_pair_list(folder.write("in/list.csv", text));
    }
    void expect_refused(const std::string& text, std::initializer_list<const char*> parts) const {
        SCOPED_TRACE(text);
        expect_error([&] { static_cast<void>(read(text)); }, 2, parts);
    }
    TemporaryFolder folder;
};

TEST_F(ImagePairs, PathsOfAListAreRelativeToItsFolder) {
    const std::vector<ImagePair> pairs =
        read("test,reference\r\na/1.png,b/1.png\n\"c d.hdr\",b/2.EXR");
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_TRUE(fs::equivalent(pairs[0].test, folder.path() / "in/a/1.png"));
    EXPECT_TRUE(fs::equivalent(pairs[1].reference, folder.path() / "in/b/2.EXR"));
    EXPECT_EQ(pairs[0].label, "1");
    EXPECT_EQ(pairs[1].label, "c_d");
}

TEST_F(ImagePairs, LabelsOfEqualNamesAreNumbered) {
    const std::vector<ImagePair> pairs = read("test,reference\na/1.png,b/1.png\nb/1.png,a/1.png\n");
    EXPECT_EQ(pairs[0].label, "000001_1");
    EXPECT_EQ(pairs[1].label, "000002_1");
}

TEST_F(ImagePairs, AListThatLeadsElsewhereIsRefusedWithItsLine) {
    fs::create_symlink(folder.path() / "outside.png", folder.path() / "in/link.png");
    for (const char* path : {"../outside.png", "a/../../outside.png", "/etc/passwd", "link.png",
                             "file:///etc/passwd", ""}) {
        expect_refused(std::string("test,reference\na/1.png,b/1.png\n") + path + ",a/1.png\n",
                       {"list.csv:3", path});
    }
    expect_refused("test,reference\na/1.png,missing.png\n", {"list.csv:2", "missing.png"});
    expect_refused("test,reference\na/1.png,b\n", {"list.csv:2", "b"});
    expect_refused("test,reference\na/1.png\n", {"list.csv:2", "1 fields"});
    expect_refused("test,reference\na/1.png,b/1.png,x\n", {"list.csv:2", "3 fields"});
    expect_refused("a/1.png,b/1.png\n", {"list.csv:1", "test,reference"});
    expect_refused("", {"list.csv:1", "test,reference"});
    expect_refused("test,reference\n", {"list.csv", "no pair"});
    expect_refused("test,reference\n\"a/1.png,b/1.png\n", {"list.csv"});
}

TEST_F(ImagePairs, FoldersPairImagesOfAllKindsByName) {
    expect_error(
        [&] { static_cast<void>(pair_images(folder.path() / "in/a", folder.path() / "in/b")); }, 2,
        {"in/a", "in/b", "2.EXR"});
    folder.write("in/a/2.EXR", "");
    const std::vector<ImagePair> pairs =
        pair_images(folder.path() / "in/a", folder.path() / "in/b");
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[1].test.filename(), "2.EXR");
}

} // namespace
} // namespace alcove
