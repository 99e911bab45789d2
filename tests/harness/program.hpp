#pragma once
// `alcove` as people call it, in a folder and with a cache of the test's own; and what its runs
// leave behind.

#include "tests/harness/child_process.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace alcove {

class ProgramTest : public testing::Test {
  protected:
    /// Runs `alcove ARGUMENTS` in folder(). Environment over a cache of this test suite's own.
    static ChildResult run(const std::vector<std::string>& arguments, ChildOptions options = {});
    static ChildOptions with_cache(ChildOptions options);
    static std::filesystem::path program();

    /// The exit code, every part on standard error in one line behind warnings, nothing on
    /// standard output.
    static void expect_refused(const std::vector<std::string>& arguments, int exit_code,
                               std::initializer_list<const char*> parts);

    static void SetUpTestSuite();
    static void TearDownTestSuite();
    static const std::filesystem::path& folder() { return s_folder->path(); }
    /// Writes a file into folder() and returns its path.
    static std::string write(const std::string& name, const std::string& bytes);

    static std::unique_ptr<TemporaryFolder> s_folder;
};

/// "round cell segment frame state" -> image hash, for every row of a run's metrics.csv.
[[nodiscard]] std::map<std::string, std::string>
read_image_hashes(const std::filesystem::path& run);
[[nodiscard]] std::size_t count_lines(const std::filesystem::path& file);

/// A box of 1 m on a floor of 6 m as glTF with its buffer inside; `turn` in radians about the
/// upright axis.
[[nodiscard]] std::string make_box_gltf(double turn = 0.0);

} // namespace alcove
