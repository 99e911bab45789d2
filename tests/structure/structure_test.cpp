// The house rules that a compiler does not know (DESIGN 2): who may include whom, what stays in
// .cpp files, which folders are units, and which rooms have no OpenGL.

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#ifndef ALCOVE_SOURCE_DIR
#error "tests/structure/CMakeLists.txt defines ALCOVE_SOURCE_DIR for this file"
#endif

namespace alcove {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = ALCOVE_SOURCE_DIR;
constexpr std::array kRooms{"core", "methods", "metrics", "scenes", "reports", "harness", "tests"};

struct SourceFile {
    std::string name; ///< relative to the root
    std::vector<std::string> lines;
};

std::vector<std::string> read_lines(const fs::path& path) {
    std::ifstream stream(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

std::vector<SourceFile> list_sources(std::initializer_list<std::string_view> extensions) {
    std::vector<SourceFile> files;
    for (const char* room : kRooms) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / room)) {
            const std::string extension = entry.path().extension().string();
            if (entry.is_regular_file() &&
                std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) {
                files.push_back(
                    {fs::relative(entry.path(), kRoot).generic_string(), read_lines(entry.path())});
            }
        }
    }
    EXPECT_GT(files.size(), 50u);
    return files;
}

/// The name in `#include "name"` or `#include <name>`; empty on other lines.
std::string read_include(const std::string& line) {
    constexpr std::string_view kDirective = "#include ";
    if (!line.starts_with(kDirective) || line.size() < kDirective.size() + 3) {
        return {};
    }
    const char close = line[kDirective.size()] == '<' ? '>' : '"';
    const std::size_t end = line.find(close, kDirective.size() + 1);
    return line.substr(kDirective.size() + 1, end - kDirective.size() - 1);
}

bool is_below(std::string_view name, std::string_view folder) {
    return name.starts_with(folder) && name.size() > folder.size() && name[folder.size()] == '/';
}

std::string folder_of(const std::string& name, int depth) {
    std::size_t at = 0;
    for (int i = 0; i < depth; ++i) {
        at = name.find('/', at + 1);
        if (at == std::string::npos) {
            return name.substr(0, name.rfind('/'));
        }
    }
    return name.substr(0, at);
}

/// A folder (or one contract) and all of our own that its files may include, beside itself.
struct Rule {
    const char* who;
    std::vector<std::string> may_include;
};

/// The table of DESIGN 2, from the most special rule to the most general.
const std::vector<Rule>& get_rules() {
    static const std::vector<Rule> kRules{
        {"core/base", {}},
        {"core/contract/metric", {"core/base"}},
        // The same target: metrics over a sequence.
        {"core/contract/temporal_metric", {"core/base", "core/contract/metric"}},
        {"core/contract/scene", {"core/base"}},
        {"core/contract/method", {"core/base", "core/gl", "core/frame", "core/contract/scene"}},
        {"core/contract/method_gbuffers",
         {"core/base", "core/gl", "core/frame", "core/contract/scene", "core/contract/method"}},
        {"core/gl", {"core/base"}},
        {"core/frame", {"core/base", "core/gl", "core/contract/scene"}},
        {"metrics", {"core/base", "core/contract/metric", "core/contract/temporal_metric"}},
        {"scenes", {"core/base", "core/contract/scene"}},
        {"methods",
         {"core/base", "core/gl", "core/frame", "core/contract/scene", "core/contract/method"}},
        {"reports/record", {"core/base"}},
        {"reports/analysis", {"core/base", "reports/record"}},
        {"reports", {"core/base", "reports/record", "reports/analysis"}},
        {"harness/run", {"core", "methods", "metrics", "scenes", "reports/record"}},
        {"harness/stability",
         {"core", "methods", "metrics", "scenes", "reports/record", "harness/run"}},
        {"harness/tune", {"core", "methods", "metrics", "scenes", "reports/record", "harness/run"}},
        {"harness/app", {"core", "methods", "metrics", "scenes", "reports", "harness"}},
    };
    return kRules;
}

/// core/contract/metric.hpp is one contract, not part of a folder.
bool belongs_to(std::string_view name, std::string_view who) {
    return is_below(name, who) ||
           (name.starts_with(who) && name.substr(who.size()).starts_with('.'));
}

const Rule* find_rule(const std::string& name) {
    for (const Rule& rule : get_rules()) {
        if (belongs_to(name, rule.who)) {
            return &rule;
        }
    }
    return nullptr;
}

bool is_ours(const std::string& include) {
    return std::any_of(kRooms.begin(), kRooms.end(),
                       [&](const char* room) { return is_below(include, room); });
}

TEST(Structure, IncludesFollowTheTableOfRooms) {
    int checked = 0;
    for (const SourceFile& file : list_sources({".hpp", ".cpp"})) {
        if (is_below(file.name, "tests")) {
            continue;
        }
        const Rule* rule = find_rule(file.name);
        ASSERT_NE(rule, nullptr) << file.name << " lies in no room of the table";
        for (const std::string& line : file.lines) {
            const std::string include = read_include(line);
            if (!is_ours(include)) {
                continue;
            }
            ++checked;
            const bool allowed =
                belongs_to(include, rule->who) ||
                std::any_of(rule->may_include.begin(), rule->may_include.end(),
                            [&](const std::string& who) { return belongs_to(include, who); });
            EXPECT_TRUE(allowed) << file.name << " includes " << include;
        }
    }
    EXPECT_GT(checked, 100);
}

TEST(Structure, IncludesOfOursAreWrittenFromTheRootInQuotes) {
    for (const SourceFile& file : list_sources({".hpp", ".cpp"})) {
        for (const std::string& line : file.lines) {
            const std::string include = read_include(line);
            if (include.empty()) {
                continue;
            }
            const bool quoted = line.find('"') != std::string::npos;
            EXPECT_EQ(quoted, is_ours(include)) << file.name << ": " << line;
            EXPECT_TRUE(!quoted || fs::exists(kRoot / include)) << file.name << ": " << line;
        }
    }
}

TEST(Structure, AUnitIncludesItsOwnFolderAndWhatItsRoomShares) {
    for (const SourceFile& file : list_sources({".hpp", ".cpp", ".glsl"})) {
        for (const char* room : {"methods", "metrics", "scenes", "reports"}) {
            const std::string unit = folder_of(file.name, 2);
            if (!is_below(file.name, room) || unit == room) {
                continue;
            }
            for (const std::string& line : file.lines) {
                const std::string include = read_include(line);
                if (is_below(include, room)) {
                    const bool shared = is_below(include, std::string(room) + "/common") ||
                                        // Functions, not a unit.
                                        is_below(include, "scenes/hard_cases") ||
                                        is_below(include, "reports/record") ||
                                        is_below(include, "reports/analysis");
                    EXPECT_TRUE(shared || is_below(include, unit))
                        << file.name << " includes " << include;
                }
            }
        }
    }
}

TEST(Structure, TheProgramIsIncludedByItselfAndByTests) {
    for (const SourceFile& file : list_sources({".hpp", ".cpp"})) {
        for (const std::string& line : file.lines) {
            if (is_below(read_include(line), "harness/app")) {
                EXPECT_TRUE(is_below(file.name, "harness/app") || is_below(file.name, "tests"))
                    << file.name;
            }
            if (is_below(read_include(line), "tests")) {
                EXPECT_TRUE(is_below(file.name, "tests")) << file.name;
            }
        }
    }
}

TEST(Structure, HeavyHeadersStayInCppFiles) {
    constexpr std::array kHeavy{"opencv2/", "CLI/",     "nlohmann/", "tiny_gltf", "OpenImageIO/",
                                "embree3/", "embree4/", "boost/",    "fmt/",      "spdlog/",
                                "toml++/",  "sqlite3",  "lz4"};
    for (const SourceFile& file : list_sources({".hpp"})) {
        for (const std::string& line : file.lines) {
            const std::string include = read_include(line);
            if (include == "nlohmann/json_fwd.hpp") { // names alone, made for headers
                continue;
            }
            for (const char* heavy : kHeavy) {
                EXPECT_FALSE(include.starts_with(heavy)) << file.name << " includes " << include;
            }
        }
    }
}

TEST(Structure, RoomsWithoutOpenGlIncludeNoHeaderOfIt) {
    for (const SourceFile& file : list_sources({".hpp", ".cpp"})) {
        for (const char* room : {"core/base", "metrics", "scenes", "reports"}) {
            if (!is_below(file.name, room)) {
                continue;
            }
            for (const std::string& line : file.lines) {
                const std::string include = read_include(line);
                for (const char* header : {"GL/", "EGL/", "GLES", "GLFW/", "epoxy/"}) {
                    EXPECT_FALSE(include.starts_with(header)) << file.name << ": " << line;
                }
            }
        }
    }
}

TEST(Structure, HeadersAreGuardedOnce) {
    for (const SourceFile& file : list_sources({".hpp"})) {
        ASSERT_FALSE(file.lines.empty()) << file.name;
        EXPECT_EQ(file.lines.front(), "#pragma once") << file.name;
    }
}

TEST(Structure, FilesStayReadable) {
    // The shape of the house: a file does one thing. 700 lines is where it surely does two.
    for (const SourceFile& file :
         list_sources({".hpp", ".cpp", ".glsl", ".ts", ".mjs", ".css", ".txt"})) {
        EXPECT_LE(file.lines.size(), 700u) << file.name;
    }
}

/// The names in `set(<room> ...)` of the room's CMakeLists.txt.
std::set<std::string> read_list(const std::string& room) {
    std::set<std::string> names;
    bool inside = false;
    for (const std::string& line : read_lines(kRoot / room / "CMakeLists.txt")) {
        if (line == "set(" + room) {
            inside = true;
        } else if (inside && line.starts_with(")")) {
            break;
        } else if (inside) {
            std::istringstream words(line);
            for (std::string word; words >> word && !word.starts_with("#");) {
                names.insert(word);
            }
        }
    }
    return names;
}

TEST(Structure, FoldersAndListsAgreeAndEveryUnitExplainsItself) {
    for (const char* room : {"methods", "metrics", "scenes"}) {
        std::set<std::string> folders;
        for (const fs::directory_entry& entry : fs::directory_iterator(kRoot / room)) {
            const std::string name = entry.path().filename().string();
            if (entry.is_directory() && fs::exists(entry.path() / (name + ".hpp"))) {
                folders.insert(name);
                EXPECT_TRUE(fs::exists(entry.path() / "README.md")) << room << "/" << name;
                EXPECT_TRUE(fs::exists(entry.path() / (name + ".cpp"))) << room << "/" << name;
            }
        }
        EXPECT_GE(folders.size(), 3u) << room;
        EXPECT_EQ(read_list(room), folders) << room;
    }
}

/// Names that the objects of a static library use and none of them defines.
std::set<std::string> list_undefined(const std::string& library) {
    const std::string command = "nm -P '" + library + "'";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    if (!pipe) {
        throw std::runtime_error("cannot run nm");
    }
    std::set<std::string> undefined;
    std::set<std::string> defined;
    std::array<char, 65536> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) != nullptr) {
        std::istringstream words(line.data());
        std::string name;
        std::string kind;
        if (words >> name >> kind && kind.size() == 1) {
            (kind == "U" ? undefined : defined).insert(name);
        }
    }
    EXPECT_GT(defined.size(), 10u) << library;
    for (const std::string& name : defined) {
        undefined.erase(name);
    }
    return undefined;
}

bool is_opengl(const std::string& name) {
    const auto follows = [&name](std::string_view prefix) {
        return name.starts_with(prefix) && name.size() > prefix.size() &&
               name[prefix.size()] >= 'A' && name[prefix.size()] <= 'Z';
    };
    return follows("gl") || name.starts_with("glX") || follows("egl") || name.starts_with("OSMesa");
}

TEST(Structure, SymbolsOfOpenGlAreToldFromOthers) {
    for (const char* name :
         {"glClear", "glXGetProcAddress", "eglInitialize", "OSMesaMakeCurrent"}) {
        EXPECT_TRUE(is_opengl(name)) << name;
    }
    for (const char* name : {"glob", "globfree", "gl", "eglantine", "_ZN3glm3dotE"}) {
        EXPECT_FALSE(is_opengl(name)) << name;
    }
}

TEST(Structure, RoomsWithoutOpenGlUseNoSymbolOfIt) {
    for (const char* library : {ALCOVE_LIBRARIES_WITHOUT_GL}) {
        for (const std::string& name : list_undefined(library)) {
            EXPECT_FALSE(is_opengl(name)) << library << " uses " << name;
        }
    }
}

} // namespace
} // namespace alcove
