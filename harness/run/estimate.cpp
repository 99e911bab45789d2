#include "harness/run/estimate.hpp"

#include "harness/run/round_runner.hpp"
#include "harness/run/scene_source.hpp"

#include <algorithm>
#include <filesystem>
#include <random>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr int kPilotFrames = 2;

/// Pictures of the pilot go here and vanish with it.
class PilotFolder {
  public:
    PilotFolder() {
        std::random_device random;
        m_path = fs::temp_directory_path() / ("alcove-pilot-" + std::to_string(random()));
        fs::create_directories(m_path);
    }
    ~PilotFolder() {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }
    PilotFolder(const PilotFolder&) = delete;
    PilotFolder& operator=(const PilotFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return m_path; }

  private:
    fs::path m_path;
};

std::size_t count_frames(const RoundRecord& round) {
    std::size_t frames = 0;
    for (const SegmentRecord& segment : round.segments) {
        frames += static_cast<std::size_t>(segment.end - segment.begin);
    }
    return frames;
}

/// Frames that cells render only so that histories converge: at every single in the capture, at the
/// first and last before times are taken.
std::size_t count_warm_frames(const RoundRecord& round) {
    const auto singles = static_cast<std::size_t>(
        std::count_if(round.segments.begin(), round.segments.end(),
                      [](const SegmentRecord& segment) { return segment.is_single(); }));
    std::size_t frames = 0;
    for (const CellRecord& cell : round.cells) {
        frames += static_cast<std::size_t>(cell.warm_frames) *
                  (singles + std::min<std::size_t>(singles, 2));
    }
    return frames;
}

} // namespace

RoundEstimate estimate_round(gl::Context& context, const Units& units, const PlanRecord& plan,
                             const RoundRecord& round) {
    std::vector<std::string> warnings; // said when the plan was made
    const std::unique_ptr<Scene> scene = open_scene(units.scenes, round.scene, warnings);
    PlanRecord pilot_plan = plan;
    pilot_plan.repeats = 1;
    pilot_plan.until_width = 0.0;
    RoundRecord pilot = round;
    const SegmentRecord& first = round.segments.front();
    pilot.segments = {{first.begin, std::min(first.end, first.begin + kPilotFrames)}};
    pilot.warm = false;
    pilot.film = {};
    pilot.image_frames.clear();
    const PilotFolder folder;
    const RoundResult result = run_round(context, gl::TimerMode::fenced_wall, units, pilot_plan,
                                         pilot, *scene, folder.path(), {});
    const RoundDone& done = result.done;
    const auto pilot_frames = static_cast<double>(count_frames(pilot));
    RoundEstimate estimate;
    estimate.frames = count_frames(round);
    const double replayed = static_cast<double>(estimate.frames) / pilot_frames;
    // One repeat and one capture of the pilot: two replays.
    const double replay_s = (done.gbuffer_s + done.passes_s) / 2.0;
    const double once_s = done.metrics_s + done.temporal_s + done.reference_s;
    const double cell_frame_s =
        done.passes_s / (2.0 * pilot_frames * static_cast<double>(round.cells.size()));
    const double opening_s = std::max(0.0, done.wall_s - 2.0 * replay_s - once_s);
    double timing_s = replayed * replay_s * plan.limit_repeats();
    if (plan.time_limit_s > 0.0) {
        timing_s = std::min(timing_s, plan.time_limit_s);
    }
    estimate.total_s = opening_s + timing_s + replayed * (replay_s + once_s) +
                       cell_frame_s * static_cast<double>(count_warm_frames(round));
    return estimate;
}

} // namespace alcove
