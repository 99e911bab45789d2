#include "tests/reports/forged_store.hpp"

#include "reports/analysis/history_night.hpp"

#include <cmath>
#include <stdexcept>

#include <sqlite3.h>

namespace alcove::forged {
namespace {

constexpr double kSlowDown = 1.05;

std::string format_day(int index) {
    // Months of 28 days: every day exists.
    constexpr int kDays = 28;
    constexpr int kMonths = 12;
    const auto two = [](int number) { return (number < 10 ? "0" : "") + std::to_string(number); };
    return std::to_string(2026 + index / (kDays * kMonths)) + "-" +
           two(index / kDays % kMonths + 1) + "-" + two(index % kDays + 1) + "T02:00:00Z";
}

} // namespace

StoredRun make_run(int index) {
    StoredRun run;
    run.utc = format_day(index);
    run.build = "0011223344556677";
    run.commit = "commit " + std::to_string(index);
    run.device = kDevice;
    run.device_class = "software";
    run.timer_mode = "timestamp_finish";
    run.suite = "nightly";
    run.folder = "night" + std::to_string(index) + "/run";
    return run;
}

SeriesName make_name(const std::string& method, const std::string& state, const std::string& pass,
                     const std::string& metric) {
    SeriesName name;
    name.device = kDevice;
    name.suite = "nightly";
    name.scene = "bunny";
    name.walkthrough = "orbit";
    name.frames = "0:16";
    name.target = "radius=0.5 m";
    name.size = "256x192";
    name.precision = "raster_depth=32F,eye_depth=32F";
    name.method = method;
    name.effects = "all";
    name.state = state;
    name.pass = pass;
    name.metric = metric;
    return name;
}

NightPoint make_point(SeriesKind kind, SeriesName name, double value, double half_width) {
    NightPoint point;
    point.name = std::move(name);
    point.kind = kind;
    point.segment = {0, "llvmpipe (LLVM 15), Mesa 22", "1", "geometry", ""};
    point.value = value;
    point.n = 6;
    point.round = "r001-bunny";
    if (half_width > 0.0) {
        point.interval = Interval{value - half_width, value + half_width};
    }
    return point;
}

NightPoint make_images(const std::string& method, const std::string& hash) {
    NightPoint point = make_point(SeriesKind::images, make_name(method, "all", "", "images"), 16.0);
    point.image_hash = hash;
    return point;
}

double Noise::draw(double value, double sigma) {
    return value * std::exp(std::normal_distribution<double>(0.0, sigma)(m_engine));
}

std::vector<NightPoint> make_night(const Scenario& scenario, int index, Noise& noise) {
    std::vector<NightPoint> points;
    for (int method = 0; method < scenario.methods; ++method) {
        const std::string label = "method_" + std::to_string(method) + scenario.text;
        const bool is_slow =
            method == 0 && scenario.slower_from >= 0 && index >= scenario.slower_from;
        const bool is_other =
            method == 1 && scenario.image_from >= 0 && index >= scenario.image_from;
        const double scale = 1.0 + method;
        const double first = noise.draw(scale * (is_slow ? kSlowDown : 1.0), scenario.sigma);
        const double second = noise.draw(0.5 * scale, scenario.sigma);
        const auto add = [&](SeriesKind kind, const char* pass, const char* metric, double value,
                             double half_width) {
            points.push_back(
                make_point(kind, make_name(label, "cold", pass, metric), value, half_width));
        };
        add(SeriesKind::time, "envelope", "x anchor", first + second, scenario.sigma * scale);
        add(SeriesKind::pass, "forged/occlusion", "x anchor", first, scenario.sigma * scale);
        add(SeriesKind::pass, "forged/blur", "x anchor", second, scenario.sigma * scale);
        add(SeriesKind::input, "input/motion", "x anchor",
            0.02 + 0.01 * (noise.draw(1.0, scenario.sigma) - 1.0), 0.01);
        add(SeriesKind::milliseconds, "envelope", "ms", 4.0 * (first + second), 0.1);
        add(SeriesKind::quality, "", "rmse", (is_other ? 0.041 : 0.04) * scale, 0.0);
        add(SeriesKind::quality, "", "ssim", is_other ? 0.97 : 0.975, 0.0);
        points.back().lower_is_better = false;
        points.push_back(make_images(label, is_other ? "00000000000000b2" : "00000000000000a1"));
    }
    for (NightPoint& point : points) {
        if (scenario.new_driver_from >= 0 && index >= scenario.new_driver_from) {
            point.segment.device = "llvmpipe (LLVM 19), Mesa 25";
        }
    }
    return points;
}

void execute_sql(const std::filesystem::path& path, const std::string& sql) {
    sqlite3* database = nullptr;
    if (sqlite3_open(path.c_str(), &database) != SQLITE_OK ||
        sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
        const std::string reason = sqlite3_errmsg(database);
        sqlite3_close(database);
        throw std::runtime_error(reason);
    }
    sqlite3_close(database);
}

void append_nights(Store& store, const Scenario& scenario) {
    Noise noise(scenario.seed);
    for (int index = 0; index < scenario.nights; ++index) {
        Night night =
            judge_night(store.read(), make_run(index), make_night(scenario, index, noise));
        if (!list_suspect_rounds(night).empty()) {
            confirm_times(night, make_night(scenario, index, noise));
        }
        store.append(night.run, make_rows(night));
    }
}

} // namespace alcove::forged
