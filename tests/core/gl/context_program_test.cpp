// Contexts as people ask for them: --context, --allow-software and what `doctor` says. Every run
// validates its timers first, so they are few and shared.

#include "core/base/file.hpp"
#include "core/gl/context_survey.hpp"
#include "reports/record/record.hpp"
#include "tests/harness/program.hpp"

#include <cstdlib>
#include <sstream>

namespace alcove {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> make_run_arguments(const std::string& out,
                                            const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "run",    "--scene", "template_scene", "--method", "hemisphere_ssao", "--method", "tssao",
        "--size", "96x72",   "--frames",       "0:3",      "--repeat",        "1",        "--out",
        out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

/// Files in place of libOSMesa that no loader opens: a system that no longer has it.
ChildOptions without_osmesa(const TemporaryFolder& libraries) {
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
        libraries.write(name, "not a library");
    }
    ChildOptions options;
    options.environment["LD_LIBRARY_PATH"] = libraries.path().string();
    return options;
}

/// Where the shell would find it; empty if nowhere.
fs::path find_on_path(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string one; std::getline(folders, one, ':');) {
        if (fs::exists(fs::path(one) / name)) {
            return fs::path(one) / name;
        }
    }
    return {};
}

class ContextProgram : public ProgramTest {
  protected:
    static void SetUpTestSuite() {
        ProgramTest::SetUpTestSuite();
        const ChildResult result = run(make_run_arguments("osmesa", {"--context", "osmesa"}));
        ASSERT_EQ(result.exit_code, 0) << result.err;
        s_hashes = read_image_hashes(folder() / "osmesa");
        ASSERT_EQ(s_hashes.size(), 2u * 3u);
    }
    /// The same program under an X server without a screen.
    static ChildResult run_under_xvfb(const std::vector<std::string>& arguments) {
        std::vector<std::string> words{"-a", program().string()};
        words.insert(words.end(), arguments.begin(), arguments.end());
        ChildOptions options;
        // Mesa's GLX leaves 5 KB of its options behind in libexpat, which GLFW has unmapped by the
        // time LeakSanitizer looks, so that no suppression by name would match (Mesa 22.3.6).
        options.environment["ASAN_OPTIONS"] = "detect_leaks=0";
        return run_child(find_on_path("xvfb-run"), words, with_cache(options));
    }
    /// The run drew with that context, on software, what OSMesa draws.
    static void expect_same_images(const std::string& out, const std::string& context) {
        const ContextRecord record = RunFolder::open(folder() / out).context();
        EXPECT_EQ(record.context_kind, context);
        EXPECT_EQ(record.device_class, "software") << record.gl_renderer;
        EXPECT_EQ(read_image_hashes(folder() / out), s_hashes);
    }
    static std::map<std::string, std::string> s_hashes;
};

std::map<std::string, std::string> ContextProgram::s_hashes;

TEST_F(ContextProgram, AutoWithoutOsmesaIsSurfacelessAndSaysSo) {
    const TemporaryFolder libraries;
    const ChildResult result =
        run(make_run_arguments("surfaceless", {}), without_osmesa(libraries));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("egl-surfaceless on llvmpipe"), std::string::npos) << result.err;
    expect_same_images("surfaceless", "egl-surfaceless");
    const ChildResult refused =
        run(make_run_arguments("none", {"--context", "osmesa"}), without_osmesa(libraries));
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.err.find("libosmesa6"), std::string::npos) << refused.err;
    EXPECT_FALSE(fs::exists(folder() / "none"));
}

TEST_F(ContextProgram, GlfwUnderXvfbDrawsWhatOsmesaDraws) {
    if (find_on_path("xvfb-run").empty()) {
        GTEST_SKIP() << "no xvfb-run: the package xvfb";
    }
    const ChildResult result =
        run_under_xvfb(make_run_arguments("glfw", {"--context", "glfw", "--allow-software"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    expect_same_images("glfw", "glfw");
    const ChildResult refused =
        run_under_xvfb(make_run_arguments("refused", {"--context", "glfw"}));
    EXPECT_EQ(refused.exit_code, 2) << refused.err;
    for (const char* part : {"--context glfw", "llvmpipe", "--allow-software"}) {
        EXPECT_NE(refused.err.find(part), std::string::npos) << refused.err;
    }
    EXPECT_FALSE(fs::exists(folder() / "refused")) << "left behind by what was refused";
}

TEST_F(ContextProgram, ASurveyNamesEveryContextAndLeavesNoLibraryBehind) {
    const std::vector<gl::ContextFinding> findings = gl::survey_contexts();
    std::vector<std::string> names;
    for (const gl::ContextFinding& finding : findings) {
        names.push_back(finding.context);
        // Something was found, or a reason why not.
        EXPECT_NE(finding.renderer.empty(), finding.failure.empty()) << finding.context;
        EXPECT_EQ(finding.device_class.empty(), finding.renderer.empty()) << finding.context;
    }
    EXPECT_EQ(names, (std::vector<std::string>{"osmesa", "egl-device", "egl-surfaceless", "glfw"}));
    EXPECT_EQ(findings.front().device_class, "software");
    EXPECT_NE(findings.front().renderer.find("llvmpipe"), std::string::npos);
    EXPECT_EQ(read_file("/proc/self/maps").find("libOSMesa"), std::string::npos);
}

TEST_F(ContextProgram, DoctorListsContextsBeforeItRefusesOne) {
    ChildOptions no_display;
    no_display.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
    const ChildResult result = run({"doctor", "--context", "glfw"}, no_display);
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_NE(result.err.find("xvfb-run"), std::string::npos) << result.err;
    for (const char* part : {"osmesa", "egl-device", "egl-surfaceless", "glfw", "software"}) {
        EXPECT_NE(result.out.find(part), std::string::npos) << result.out;
    }
    expect_refused({"doctor", "--context", "elg"}, 2, {"elg", "nearest: egl"});
}

} // namespace
} // namespace alcove
