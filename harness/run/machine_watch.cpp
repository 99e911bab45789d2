#include "harness/run/machine_watch.hpp"

#include "core/base/statistics.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

namespace alcove {
namespace {

double to_seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

} // namespace

MachineWatch::MachineWatch(std::filesystem::path root) : m_root(std::move(root)) {}

std::optional<MachineWatch::ProcessorTimes> MachineWatch::read_processor_times() const {
    std::ifstream file(m_root / "proc/stat");
    std::string line;
    if (!std::getline(file, line) || !line.starts_with("cpu ")) {
        return std::nullopt;
    }
    // user nice system idle iowait irq softirq steal; guests' time behind them is in user already
    constexpr std::size_t kIdle = 3;
    constexpr std::size_t kWaiting = 4;
    constexpr std::size_t kStolen = 7;
    std::istringstream text(line.substr(4));
    const std::vector<double> ticks{std::istream_iterator<double>(text), {}};
    if (ticks.size() <= kIdle) {
        return std::nullopt;
    }
    ProcessorTimes times;
    for (std::size_t i = 0; i < std::min(ticks.size(), kStolen + 1); ++i) {
        times.all += ticks[i];
        times.busy += i == kIdle || i == kWaiting || i == kStolen ? 0.0 : ticks[i];
    }
    if (ticks.size() > kStolen) {
        times.stolen = ticks[kStolen];
    }
    return times;
}

std::optional<double> MachineWatch::read_load() const {
    std::ifstream file(m_root / "proc/loadavg");
    double load = 0.0;
    return file >> load ? std::optional(load) : std::nullopt;
}

std::optional<double> MachineWatch::read_clock_mhz() const {
    std::vector<double> clocks;
    for (int cpu = 0;; ++cpu) {
        std::ifstream file(m_root / ("sys/devices/system/cpu/cpu" + std::to_string(cpu)) /
                           "cpufreq/scaling_cur_freq");
        double kilohertz = 0.0;
        if (!(file >> kilohertz)) {
            break;
        }
        clocks.push_back(1e-3 * kilohertz);
    }
    if (clocks.empty()) {
        std::ifstream file(m_root / "proc/cpuinfo");
        for (std::string line; std::getline(file, line);) {
            const std::size_t colon = line.find(':');
            double megahertz = 0.0;
            if (line.starts_with("cpu MHz") && colon != std::string::npos &&
                std::istringstream(line.substr(colon + 1)) >> megahertz) {
                clocks.push_back(megahertz);
            }
        }
    }
    return clocks.empty() ? std::nullopt : std::optional(compute_mean(clocks));
}

MachineWatch::OwnTimes MachineWatch::read_own_times() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return {to_seconds(usage.ru_utime) + to_seconds(usage.ru_stime),
            static_cast<double>(usage.ru_nivcsw)};
}

MachineRecord MachineWatch::read() const {
    MachineRecord record;
    record.wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count();
    record.load = read_load();
    record.clock_mhz = read_clock_mhz();
    const OwnTimes own = read_own_times();
    if (record.wall_s > 0.0) {
        record.switches_per_s = (own.switches - m_own.switches) / record.wall_s;
    }
    const std::optional<ProcessorTimes> processors = read_processor_times();
    if (!processors || !m_processors || processors->all <= m_processors->all) {
        return record;
    }
    const double all = processors->all - m_processors->all;
    const double own_ticks =
        (own.busy_s - m_own.busy_s) * static_cast<double>(::sysconf(_SC_CLK_TCK));
    // Both are rounded to ticks, at different moments: a little less than nothing is nothing.
    record.others_share =
        std::clamp((processors->busy - m_processors->busy - own_ticks) / all, 0.0, 1.0);
    if (processors->stolen && m_processors->stolen) {
        record.steal_share =
            std::clamp((*processors->stolen - *m_processors->stolen) / all, 0.0, 1.0);
    }
    return record;
}

} // namespace alcove
