#include "scenes/common/walkthrough_cameras.hpp"

#include "core/base/nearest_name.hpp"
#include "scenes/common/constant_speed.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Keys nearer to each other than this many metres count as one place.
constexpr double kNearestKeys = 1e-6;
/// So do keys nearer than this share of the way before them, which a double could not tell apart.
constexpr double kShortestChord = 1e-12;

/// Frames [begin, end) between two cuts.
struct Run {
    int begin = 0;
    int end = 0;
};

std::vector<Run> list_runs(std::int64_t frames, const std::vector<int>& cuts) {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        runs.push_back({cuts[i], i + 1 < cuts.size() ? cuts[i + 1] : static_cast<int>(frames)});
    }
    return runs;
}

CameraPose read_pose(const JsonPlace& place) {
    CameraPose pose;
    pose.position = place.get("position").read_vector();
    pose.target = place.get("target").read_vector();
    pose.up = place.get("up").read_vector();
    pose.fov_y_degrees = place.get("fov_y_degrees").read_number();
    if (!(pose.fov_y_degrees > 0.0 && pose.fov_y_degrees < 180.0)) {
        place.get("fov_y_degrees").fail("out of range", "more than 0 and less than 180 degrees");
    }
    if (!(glm::length(pose.up) > 1e-6)) {
        place.get("up").fail("has no direction", "a vector of some length");
    }
    return pose;
}

std::vector<CameraPose> read_poses(const JsonPlace& place, std::int64_t frames) {
    if (static_cast<std::int64_t>(place.count()) != frames) {
        place.fail("wrong number of poses", "one a frame: " + std::to_string(frames));
    }
    std::vector<CameraPose> poses;
    for (std::size_t i = 0; i < place.count(); ++i) {
        place.at(i).check_keys({"position", "target", "up", "fov_y_degrees"});
        poses.push_back(read_pose(place.at(i)));
    }
    return poses;
}

/// Keys of frames, interpolated in time.
class KeyedCameras {
  public:
    KeyedCameras(const JsonPlace& root, std::int64_t frames) {
        const JsonPlace place = root.get("keys");
        for (std::size_t i = 0; i < place.count(); ++i) {
            add(place.at(i), frames);
        }
        if (m_keys.empty()) {
            place.fail("has no keys", "at least one");
        }
        if (m_frames.front() != 0) {
            place.at(0).get("frame").fail("the first key must be the first frame", "0");
        }
        if (m_frames.back() != frames - 1) {
            place.at(m_frames.size() - 1)
                .get("frame")
                .fail("the last key must be the last frame", std::to_string(frames - 1));
        }
    }

    void check_cuts(const JsonPlace& cuts) const {
        for (std::size_t i = 0; i < cuts.count(); ++i) {
            const auto frame = cuts.at(i).read_integer(0, m_frames.back());
            if (!has(frame - 1) || !has(frame)) {
                cuts.at(i).fail("a cut needs keys on its frame and on the one before",
                                "keys at " + std::to_string(frame - 1) + " and " +
                                    std::to_string(frame));
            }
        }
    }

    /// Asserts keys on the run's first and last frame.
    [[nodiscard]] std::vector<CameraPose> sample(const Run& run) const {
        const auto first = std::lower_bound(m_frames.begin(), m_frames.end(), run.begin);
        const auto last = std::lower_bound(first, m_frames.end(), run.end);
        const CameraCurve curve({first, last}, {m_keys.begin() + (first - m_frames.begin()),
                                                m_keys.begin() + (last - m_frames.begin())});
        std::vector<CameraPose> poses;
        for (int frame = run.begin; frame < run.end; ++frame) {
            poses.push_back(curve.evaluate(frame));
        }
        return poses;
    }

  private:
    void add(const JsonPlace& place, std::int64_t frames) {
        place.check_keys({"frame", "position", "target", "up", "fov_y_degrees"});
        const auto frame = place.get("frame").read_integer(0, frames - 1);
        if (!m_frames.empty() && frame <= m_frames.back()) {
            place.get("frame").fail("does not ascend",
                                    "more than " + std::to_string(m_frames.back()));
        }
        m_frames.push_back(static_cast<int>(frame));
        m_keys.push_back(read_pose(place));
    }

    [[nodiscard]] bool has(std::int64_t frame) const {
        return std::binary_search(m_frames.begin(), m_frames.end(), frame);
    }

    std::vector<int> m_frames;
    std::vector<CameraPose> m_keys;
};

/// Keys of places: time follows from the way.
class ConstantSpeedCameras {
  public:
    explicit ConstantSpeedCameras(const JsonPlace& root) : m_place(root.get("keys")) {}

    /// Takes the keys of the next run off the list.
    [[nodiscard]] std::vector<CameraPose> sample(const Run& run) {
        std::vector<CameraPose> keys{read_end(run.begin)};
        if (run.begin + 1 == run.end) {
            return keys;
        }
        double way = 0.0;
        bool is_complete = false;
        while (!is_complete) {
            is_complete = m_next < m_place.count() && m_place.at(m_next).has("frame");
            const CameraPose key = is_complete ? read_end(run.end - 1) : read_inner(run.end - 1);
            const double chord = glm::distance(key.position, keys.back().position);
            if (!(chord > std::max(kNearestKeys, kShortestChord * way))) {
                m_place.at(m_next - 1)
                    .get("position")
                    .fail("does not move from the key before", "another position");
            }
            way += chord;
            keys.push_back(key);
        }
        return sample_at_constant_speed(keys, run.end - run.begin);
    }

    void check_end() const {
        if (m_next < m_place.count()) {
            m_place.at(m_next).fail("stands after the last frame", "no further key");
        }
    }

  private:
    [[nodiscard]] CameraPose read_end(int frame) {
        check_count(frame);
        const JsonPlace place = m_place.at(m_next);
        place.check_keys({"frame", "position", "target", "up", "fov_y_degrees"});
        if (place.get("frame").read_integer(0, std::numeric_limits<std::int64_t>::max()) != frame) {
            place.get("frame").fail("only the ends of a run between cuts state their frames",
                                    std::to_string(frame));
        }
        ++m_next;
        return read_pose(place);
    }

    [[nodiscard]] CameraPose read_inner(int last_frame) {
        check_count(last_frame);
        const JsonPlace place = m_place.at(m_next);
        place.check_keys({"position", "target", "up", "fov_y_degrees"});
        ++m_next;
        return read_pose(place);
    }

    void check_count(int frame) const {
        if (m_next >= m_place.count()) {
            m_place.fail("too few keys", "a key at frame " + std::to_string(frame));
        }
    }

    JsonPlace m_place;
    std::size_t m_next = 0;
};

} // namespace

std::vector<CameraPose> read_walkthrough_cameras(const JsonPlace& root, std::int64_t frames,
                                                 const std::vector<int>& cuts) {
    if (root.has("keys") == root.has("poses")) {
        root.fail("needs either keys or poses", "exactly one of them");
    }
    if (root.has("poses")) {
        if (root.has("interpolation")) {
            root.get("interpolation").fail("poses are not interpolated", "no interpolation");
        }
        return read_poses(root.get("poses"), frames);
    }
    const std::array<std::string, 2> kinds{"keyed", "constant_speed"};
    const std::string kind = root.get("interpolation").read_text();
    std::vector<CameraPose> poses;
    const auto add = [&](auto& cameras) {
        for (const Run& run : list_runs(frames, cuts)) {
            const std::vector<CameraPose> more = cameras.sample(run);
            poses.insert(poses.end(), more.begin(), more.end());
        }
    };
    if (kind == kinds[0]) {
        KeyedCameras cameras(root, frames);
        cameras.check_cuts(root.get("cuts"));
        add(cameras);
    } else if (kind == kinds[1]) {
        ConstantSpeedCameras cameras(root);
        add(cameras);
        cameras.check_end();
    } else {
        root.get("interpolation").fail("unknown choice", describe_choices(kind, kinds));
    }
    return poses;
}

} // namespace alcove
