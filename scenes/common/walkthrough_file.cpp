#include "scenes/common/walkthrough_file.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "scenes/common/embedded_scene_files.hpp"
#include "scenes/common/strict_json.hpp"
#include "scenes/common/walkthrough_cameras.hpp"
#include "scenes/common/walkthrough_tracks.hpp"

#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

constexpr std::int64_t kMostFrames = 100'000;
constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

void check_version(const JsonPlace& place) {
    using Limits = std::numeric_limits<std::int64_t>;
    if (place.read_integer(Limits::min(), Limits::max()) != kWalkthroughVersion) {
        place.fail("unknown version", std::to_string(kWalkthroughVersion));
    }
}

/// Frame 0 and the file's.
std::vector<int> read_cuts(const JsonPlace& place, std::int64_t frames) {
    std::vector<int> cuts{0};
    for (std::size_t i = 0; i < place.count(); ++i) {
        const JsonPlace cut = place.at(i);
        const int frame = static_cast<int>(cut.read_integer(1, frames - 1));
        if (frame <= cuts.back()) {
            cut.fail("does not ascend", "more than " + std::to_string(cuts.back()));
        }
        cuts.push_back(frame);
    }
    return cuts;
}

/// Two things may happen at one frame.
std::vector<WalkthroughEvent> read_events(const JsonPlace& place, std::int64_t frames) {
    std::vector<WalkthroughEvent> events;
    for (std::size_t i = 0; i < place.count(); ++i) {
        const JsonPlace event = place.at(i);
        event.check_keys({"frame", "label"});
        const int frame = static_cast<int>(event.get("frame").read_integer(0, frames - 1));
        if (!events.empty() && frame < events.back().frame) {
            event.get("frame").fail("does not ascend",
                                    std::to_string(events.back().frame) + " or more");
        }
        events.push_back({frame, event.get("label").read_text()});
        if (events.back().label.empty()) {
            event.get("label").fail("is empty", "what happens");
        }
    }
    return events;
}

std::vector<Camera> make_cameras(const JsonPlace& root, const std::vector<CameraPose>& poses) {
    const double near_m = root.get("near").read_number();
    const double far_m = root.get("far").read_number();
    if (!(near_m > 0.0)) {
        root.get("near").fail("out of range", "more than 0");
    }
    if (!(far_m > near_m)) {
        root.get("far").fail("out of range", "more than near");
    }
    std::vector<Camera> cameras;
    for (const CameraPose& pose : poses) {
        try {
            cameras.push_back(make_look_at_camera(pose.position, pose.target, pose.up,
                                                  pose.fov_y_degrees * kRadiansPerDegree, near_m,
                                                  far_m));
        } catch (const InputError& error) {
            throw InputError(root.where() + ": frame " + std::to_string(cameras.size()),
                             error.what());
        }
    }
    return cameras;
}

} // namespace

Walkthrough parse_walkthrough(std::string_view text, std::string_view file) {
    const nlohmann::json json = parse_strict_json(text, file);
    const JsonPlace root(json, std::string(file));
    check_version(root.get("version"));
    root.check_keys({"version", "name", "step_seconds", "frames", "near", "far", "cuts"},
                    {"interpolation", "keys", "poses", "events", "tracks"});
    Walkthrough walkthrough;
    walkthrough.name = root.get("name").read_text();
    if (walkthrough.name.empty()) {
        root.get("name").fail("is empty", "a name");
    }
    walkthrough.step_s = root.get("step_seconds").read_number();
    if (!(walkthrough.step_s > 0.0)) {
        root.get("step_seconds").fail("out of range", "more than 0");
    }
    const std::int64_t frames = root.get("frames").read_integer(1, kMostFrames);
    walkthrough.cuts = read_cuts(root.get("cuts"), frames);
    walkthrough.cameras =
        make_cameras(root, read_walkthrough_cameras(root, frames, walkthrough.cuts));
    if (root.has("events")) {
        walkthrough.events = read_events(root.get("events"), frames);
    }
    if (root.has("tracks")) {
        walkthrough.tracks = read_walkthrough_tracks(root.get("tracks"), frames);
    }
    return walkthrough;
}

Walkthrough read_walkthrough_file(const std::filesystem::path& path) {
    return parse_walkthrough(read_file(path, std::uintmax_t{1} << 24), path.string());
}

Walkthrough get_embedded_walkthrough(std::string_view name) {
    for (const EmbeddedFile& file : embedded_scene_files()) {
        if (file.name == name) {
            return parse_walkthrough(file.text, file.name);
        }
    }
    ALCOVE_ASSERT(false, "a walkthrough that was compiled in");
    return {};
}

} // namespace alcove
