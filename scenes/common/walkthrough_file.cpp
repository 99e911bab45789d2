#include "scenes/common/walkthrough_file.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "scenes/common/embedded_scene_files.hpp"
#include "scenes/common/strict_json.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

namespace alcove {
namespace {

constexpr std::int64_t kMostFrames = 100'000;
constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

struct Key {
    int frame = 0;
    glm::dvec3 position{0.0};
    glm::dvec3 target{0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    double fov_y_degrees = 60.0;
};

Key read_key(const JsonPlace& place, std::int64_t frames) {
    place.check_keys({"frame", "position", "target", "up", "fov_y_degrees"});
    Key key;
    key.frame = static_cast<int>(place.get("frame").read_integer(0, frames - 1));
    key.position = place.get("position").read_vector();
    key.target = place.get("target").read_vector();
    key.up = place.get("up").read_vector();
    key.fov_y_degrees = place.get("fov_y_degrees").read_number();
    if (!(key.fov_y_degrees > 0.0 && key.fov_y_degrees < 180.0)) {
        place.get("fov_y_degrees").fail("out of range", "more than 0 and less than 180 degrees");
    }
    if (!(glm::length(key.up) > 1e-6)) {
        place.get("up").fail("has no direction", "a vector of some length");
    }
    return key;
}

std::vector<Key> read_keys(const JsonPlace& place, std::int64_t frames) {
    std::vector<Key> keys;
    for (std::size_t i = 0; i < place.count(); ++i) {
        keys.push_back(read_key(place.at(i), frames));
        if (i > 0 && keys[i].frame <= keys[i - 1].frame) {
            place.at(i).get("frame").fail("does not ascend",
                                          "more than " + std::to_string(keys[i - 1].frame));
        }
    }
    if (keys.empty()) {
        place.fail("has no keys", "at least one");
    }
    if (keys.front().frame != 0) {
        place.at(0).get("frame").fail("the first key must be the first frame", "0");
    }
    if (keys.back().frame != frames - 1) {
        place.at(keys.size() - 1)
            .get("frame")
            .fail("the last key must be the last frame", std::to_string(frames - 1));
    }
    return keys;
}

std::vector<int> read_cuts(const JsonPlace& place, std::int64_t frames,
                           const std::vector<Key>& keys) {
    const auto has_key = [&keys](int frame) {
        return std::any_of(keys.begin(), keys.end(),
                           [frame](const Key& key) { return key.frame == frame; });
    };
    std::vector<int> cuts{0};
    for (std::size_t i = 0; i < place.count(); ++i) {
        const JsonPlace cut = place.at(i);
        const int frame = static_cast<int>(cut.read_integer(1, frames - 1));
        if (frame <= cuts.back()) {
            cut.fail("does not ascend", "more than " + std::to_string(cuts.back()));
        }
        if (!has_key(frame - 1) || !has_key(frame)) {
            cut.fail("a cut needs keys on its frame and on the one before",
                     "keys at " + std::to_string(frame - 1) + " and " + std::to_string(frame));
        }
        cuts.push_back(frame);
    }
    return cuts;
}

/// Slope at knot 1 of the parabola through three knots at times 0, h0 and h0 + h1, of slopes d0 and
/// d1.
template <class T>
T parabola_slope(const T& d0, const T& d1, double h0, double h1) {
    return (d0 * h1 + d1 * h0) / (h0 + h1);
}

/// Slope that keeps a cubic between its knots (F. N. Fritsch, J. Butland. A Method for Constructing
/// Local Monotone Piecewise Cubic Interpolants. 1984): the weighted harmonic mean, 0 at a turning
/// point.
double monotone_slope(double d0, double d1, double h0, double h1) {
    if (!(d0 * d1 > 0.0)) {
        return 0.0;
    }
    return 3.0 * (h0 + h1) / ((2.0 * h1 + h0) / d0 + (h1 + 2.0 * h0) / d1);
}

template <class T>
T hermite(const T& a, const T& b, const T& slope_a, const T& slope_b, double span, double s) {
    const double s2 = s * s;
    const double s3 = s2 * s;
    return a * (2.0 * s3 - 3.0 * s2 + 1.0) + slope_a * (span * (s3 - 2.0 * s2 + s)) +
           b * (3.0 * s2 - 2.0 * s3) + slope_b * (span * (s3 - s2));
}

/// Keys [first, last] between two cuts.
class Run {
  public:
    Run(const std::vector<Key>& keys, std::size_t first, std::size_t last)
        : m_keys(keys), m_first(first), m_last(last) {}

    [[nodiscard]] Key interpolate(int frame) const {
        std::size_t i = m_first;
        while (i < m_last && m_keys[i + 1].frame <= frame) {
            ++i;
        }
        if (m_keys[i].frame == frame) {
            return m_keys[i];
        }
        const Key& a = m_keys[i];
        const Key& b = m_keys[i + 1];
        const double span = b.frame - a.frame;
        const double s = (frame - a.frame) / span;
        const auto curve = [&](auto field) {
            return hermite(a.*field, b.*field, slope(i, field), slope(i + 1, field), span, s);
        };
        Key key;
        key.frame = frame;
        key.position = curve(&Key::position);
        key.target = curve(&Key::target);
        key.fov_y_degrees = curve(&Key::fov_y_degrees);
        key.up = glm::mix(glm::normalize(a.up), glm::normalize(b.up), s);
        return key;
    }

  private:
    template <class T>
    [[nodiscard]] T difference(std::size_t i, T Key::*field) const {
        return (m_keys[i + 1].*field - m_keys[i].*field) /
               static_cast<double>(m_keys[i + 1].frame - m_keys[i].frame);
    }

    template <class T>
    [[nodiscard]] T slope(std::size_t i, T Key::*field) const {
        if (i == m_first) {
            return difference(i, field);
        }
        if (i == m_last) {
            return difference(i - 1, field);
        }
        const double h0 = m_keys[i].frame - m_keys[i - 1].frame;
        const double h1 = m_keys[i + 1].frame - m_keys[i].frame;
        const T d0 = difference(i - 1, field);
        const T d1 = difference(i, field);
        if constexpr (std::is_same_v<T, double>) {
            return monotone_slope(d0, d1, h0, h1);
        } else {
            return parabola_slope(d0, d1, h0, h1);
        }
    }

    const std::vector<Key>& m_keys;
    std::size_t m_first;
    std::size_t m_last;
};

} // namespace

Walkthrough parse_walkthrough(std::string_view text, std::string_view file) {
    const nlohmann::json json = parse_strict_json(text, file);
    const JsonPlace root(json, std::string(file));
    root.check_keys({"version", "name", "step_seconds", "frames", "near", "far", "cuts", "keys"});
    static_cast<void>(root.get("version").read_integer(1, 1));
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
    const double near_m = root.get("near").read_number();
    const double far_m = root.get("far").read_number();
    if (!(near_m > 0.0)) {
        root.get("near").fail("out of range", "more than 0");
    }
    if (!(far_m > near_m)) {
        root.get("far").fail("out of range", "more than near");
    }
    const std::vector<Key> keys = read_keys(root.get("keys"), frames);
    walkthrough.cuts = read_cuts(root.get("cuts"), frames, keys);

    std::size_t first = 0;
    for (std::size_t cut = 0; cut < walkthrough.cuts.size(); ++cut) {
        const bool is_last = cut + 1 == walkthrough.cuts.size();
        const int end = is_last ? static_cast<int>(frames) : walkthrough.cuts[cut + 1];
        std::size_t last = first;
        while (last + 1 < keys.size() && keys[last + 1].frame < end) {
            ++last;
        }
        const Run run(keys, first, last);
        for (int frame = walkthrough.cuts[cut]; frame < end; ++frame) {
            const Key key = run.interpolate(frame);
            try {
                walkthrough.cameras.push_back(
                    make_look_at_camera(key.position, key.target, key.up,
                                        key.fov_y_degrees * kRadiansPerDegree, near_m, far_m));
            } catch (const InputError& error) {
                throw InputError(std::string(file) + ": frame " + std::to_string(frame),
                                 error.what());
            }
        }
        first = last + 1;
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
