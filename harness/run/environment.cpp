#include "harness/run/environment.hpp"

#include "core/base/error.hpp"
#include "harness/run/build_info.hpp"
#include "methods/anchor/anchor.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <thread>

namespace alcove {
namespace {

std::string format_utc(const char* format) {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), format, &utc);
    return text.data();
}

/// The value of the first line "key : value" of /proc/cpuinfo; empty where there is no such file.
std::string read_cpu_line(std::string_view key) {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with(key) && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return {};
}

/// Those of the CPU's features that a software rasteriser compiles for.
std::string read_cpu_features() {
    std::istringstream flags(read_cpu_line("flags"));
    const std::set<std::string> all{std::istream_iterator<std::string>(flags), {}};
    std::string text;
    for (const char* feature : {"sse4_1", "avx", "f16c", "fma", "avx2", "avx512f"}) {
        if (all.contains(feature)) {
            text += text.empty() ? "" : " ";
            text += feature;
        }
    }
    return text;
}

int read_driver_threads(int cores) {
    const char* text = std::getenv("LP_NUM_THREADS");
    return text == nullptr ? cores : std::atoi(text);
}

} // namespace

std::string make_utc_stamp() {
    return format_utc("%Y%m%dT%H%M%SZ");
}

ContextRecord describe_environment(const gl::Context& context, const gl::TimerReport& timers) {
    const BuildInfo build = get_build_info();
    const gl::DeviceInfo& device = context.device();
    ContextRecord record;
    record.started_utc = format_utc("%Y-%m-%dT%H:%M:%SZ");
    record.build_id = build.id;
    record.build_type = build.type;
    record.compiler = std::string(build.compiler) + " " + build.flags;
    record.device_class = device.device_class;
    record.gl_vendor = device.vendor;
    record.gl_renderer = device.renderer;
    record.gl_version = device.version;
    record.context_kind = device.context;
    record.cpu = read_cpu_line("model name");
    record.cpu_features = read_cpu_features();
    record.cpu_threads = static_cast<int>(std::thread::hardware_concurrency());
    record.driver_threads = read_driver_threads(record.cpu_threads);
    record.timer_mode = gl::to_text(timers.chosen());
    record.timer_tick_ns = timers.tick_ns;
    for (const gl::TimerTrial& trial : timers.trials) {
        for (std::size_t pass = 0; pass < trial.ratios.size(); ++pass) {
            record.timer_trials.push_back({std::string(gl::to_text(trial.mode)), trial.sequence,
                                           static_cast<int>(pass), trial.attempt,
                                           trial.ratios[pass], trial.accepted});
        }
    }
    record.anchor_version = kAnchorVersion;
    return record;
}

std::string describe_drawing(const gl::Context& context) {
    const BuildInfo build = get_build_info();
    const gl::DeviceInfo& device = context.device();
    return std::string(build.frame_id) + "|" + build.compiler + "|" + build.flags + "|" +
           device.renderer + "|" + device.version + "|" + read_cpu_features();
}

std::string describe_timing(const gl::Context& context) {
    const auto threads = static_cast<int>(std::thread::hardware_concurrency());
    return describe_drawing(context) + "|" + read_cpu_line("model name") + "|" +
           std::to_string(threads) + "|" + std::to_string(read_driver_threads(threads));
}

void check_same_environment(const ContextRecord& recorded, const ContextRecord& here) {
    const auto check = [](const char* what, const std::string& then, const std::string& now) {
        if (then != now) {
            throw InputError("--resume", std::string("the run was made with another ") + what, now,
                             then);
        }
    };
    check("build", recorded.build_id, here.build_id);
    check("renderer", recorded.gl_renderer, here.gl_renderer);
    check("driver", recorded.gl_version, here.gl_version);
    // The driver compiles for them: images hash alike only between equal ones.
    check("set of CPU features", recorded.cpu_features, here.cpu_features);
    check("timer", recorded.timer_mode, here.timer_mode);
}

} // namespace alcove
