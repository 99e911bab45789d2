#include "tests/harness/program.hpp"

#include "core/base/file.hpp"
#include "reports/record/record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#ifndef ALCOVE_PROGRAM
#error "tests/harness/CMakeLists.txt defines ALCOVE_PROGRAM for this file"
#endif

namespace alcove {
namespace {

namespace fs = std::filesystem;

std::string encode_base64(const std::string& bytes) {
    constexpr const char* kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const unsigned char byte =
                i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0;
            word = word << 8 | byte;
        }
        for (int k = 0; k < 4; ++k) {
            const bool padding = i + static_cast<std::size_t>(k) > bytes.size();
            text += padding ? '=' : kDigits[word >> (18 - 6 * k) & 63];
        }
    }
    return text;
}

template <class T>
void append(std::string& bytes, T value) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof(T));
    std::memcpy(bytes.data() + at, &value, sizeof(T));
}

} // namespace

std::unique_ptr<TemporaryFolder> ProgramTest::s_folder;

void ProgramTest::SetUpTestSuite() {
    s_folder = std::make_unique<TemporaryFolder>();
}

void ProgramTest::TearDownTestSuite() {
    s_folder.reset();
}

fs::path ProgramTest::program() {
    return ALCOVE_PROGRAM;
}

ChildOptions ProgramTest::with_cache(ChildOptions options) {
    options.environment.emplace("ALCOVE_CACHE", (folder() / "cache").string());
    if (options.folder.empty()) {
        options.folder = folder();
    }
    return options;
}

ChildResult ProgramTest::run(const std::vector<std::string>& arguments, ChildOptions options) {
    return run_child(program(), arguments, with_cache(std::move(options)));
}

void ProgramTest::expect_refused(const std::vector<std::string>& arguments, int exit_code,
                                 std::initializer_list<const char*> parts) {
    std::string line = "alcove";
    for (const std::string& argument : arguments) {
        line += " " + argument;
    }
    SCOPED_TRACE(line);
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << result.err << "signal " << result.signal;
    EXPECT_EQ(result.out, "");
    std::string error = result.err;
    while (error.starts_with("alcove: warning: ")) {
        error.erase(0, error.find('\n') + 1);
    }
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(error.starts_with("alcove: ")) << result.err;
    for (const char* part : parts) {
        EXPECT_NE(result.err.find(part), std::string::npos)
            << "`" << part << "` is missing in: " << result.err;
    }
}

std::string ProgramTest::write(const std::string& name, const std::string& bytes) {
    return s_folder->write(name, bytes).string();
}

std::map<std::string, std::string> read_image_hashes(const fs::path& run) {
    std::map<std::string, std::string> hashes;
    for (const MetricRow& row : RunFolder::open(run).read_metrics()) {
        hashes[row.round + " " + row.cell + " " + std::to_string(row.segment) + " " +
               std::to_string(row.frame) + " " + std::string(to_text(row.state))] = row.image_hash;
    }
    return hashes;
}

std::size_t count_lines(const fs::path& file) {
    const std::string text = read_file(file);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::string make_box_gltf(double turn) {
    std::string bytes;
    const auto corner = [&bytes](double x, double y, double z) {
        append(bytes, static_cast<float>(x));
        append(bytes, static_cast<float>(y));
        append(bytes, static_cast<float>(z));
    };
    for (const double y : {-0.1, 1.0}) {
        for (const double z : {-0.5, 0.5}) {
            for (const double x : {-0.5, 0.5}) {
                corner(x, y, z);
            }
        }
    }
    for (const double z : {-3.0, 3.0}) {
        for (const double x : {-3.0, 3.0}) {
            corner(x, 0.0, z);
        }
    }
    const std::size_t positions = bytes.size();
    constexpr std::array<std::uint16_t, 42> kIndices{2, 3, 7, 2, 7, 6, 1, 0, 4,  1,  4, 5,  3, 1,
                                                     5, 3, 5, 7, 0, 2, 6, 0, 6,  4,  6, 7,  5, 6,
                                                     5, 4, 0, 1, 3, 0, 3, 2, 10, 11, 9, 10, 9, 8};
    for (const std::uint16_t index : kIndices) {
        append(bytes, index);
    }
    const std::string half_sine = std::to_string(std::sin(0.5 * turn));
    const std::string half_cosine = std::to_string(std::cos(0.5 * turn));
    const auto text = [](std::size_t number) { return std::to_string(number); };
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"rotation":[0,)" +
           half_sine + ",0," + half_cosine +
           R"(]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)" +
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":12,"type":"VEC3","min":[-3,-0.1,-3],"max":[3,1,3]},)" +
           R"({"bufferView":1,"componentType":5123,"count":42,"type":"SCALAR"}],)" +
           R"("bufferViews":[{"buffer":0,"byteLength":)" + text(positions) +
           R"(},{"buffer":0,"byteOffset":)" + text(positions) + R"(,"byteLength":)" +
           text(bytes.size() - positions) + R"(}],"buffers":[{"byteLength":)" + text(bytes.size()) +
           R"(,"uri":"data:application/octet-stream;base64,)" + encode_base64(bytes) + R"("}]})";
}

} // namespace alcove
