#include "metrics/common/planted_sequence.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace alcove {
namespace {

/// Fast enough for 1 to 2 pixels a frame at the edge of a disc of 25 pixels.
constexpr double kTurn = 0.07;

double get_speed(PlantedMotion motion) {
    return motion == PlantedMotion::pan_one_pixel    ? 1.0
           : motion == PlantedMotion::pan_half_pixel ? 0.5
                                                     : 0.0;
}

double get_disc_radius(ImageSize size) {
    return 0.35 * std::min(size.width, size.height);
}

/// Where the point at a position was `frames` frames ago.
PlantedPoint go_back(ImageSize size, PlantedMotion motion, double frames, PlantedPoint from) {
    if (motion != PlantedMotion::rotating_disc) {
        return {from.x + frames * get_speed(motion), from.y};
    }
    const double x = from.x - 0.5 * size.width;
    const double y = from.y - 0.5 * size.height;
    if (std::hypot(x, y) >= get_disc_radius(size)) {
        return from;
    }
    const double cosine = std::cos(kTurn * frames);
    const double sine = std::sin(kTurn * frames);
    return {0.5 * size.width + cosine * x + sine * y, 0.5 * size.height - sine * x + cosine * y};
}

bool is_inside(ImageSize size, PlantedPoint point) {
    return point.x >= 0.5 && point.x <= size.width - 0.5 && point.y >= 0.5 &&
           point.y <= size.height - 0.5;
}

/// Bilinear fetches reach sqrt(2) pixels at most.
bool is_near_edge(ImageSize size, PlantedPoint point) {
    const double distance = std::hypot(point.x - 0.5 * size.width, point.y - 0.5 * size.height);
    return std::abs(distance - get_disc_radius(size)) < 1.5;
}

/// What the contract asks for, of the frames before number `now`.
std::vector<EarlierFrame> collect_earlier(const std::vector<PlantedFrame>& frames,
                                          std::size_t now) {
    std::vector<EarlierFrame> collected;
    Correspondence back = frames[now].to_previous;
    for (std::size_t steps = 1; steps <= std::min(now, std::size_t{kEarlierSteps.back()});
         ++steps) {
        const PlantedFrame& then = frames[now - steps];
        if (std::find(kEarlierSteps.begin(), kEarlierSteps.end(), static_cast<int>(steps)) !=
            kEarlierSteps.end()) {
            EarlierFrame earlier{static_cast<int>(steps), back, warp_image(then.reference, back),
                                 std::nullopt, std::nullopt};
            if (then.reference_a) {
                earlier.reference_a = warp_image(*then.reference_a, back);
                earlier.reference_b = warp_image(*then.reference_b, back);
            }
            collected.push_back(std::move(earlier));
        }
        back = compose_correspondences(back, then.to_previous);
    }
    return collected;
}

} // namespace

PlantedFrame make_planted_frame(ImageSize size, PlantedMotion motion) {
    PlantedFrame frame{Image(size, 1, 0.5f),
                       Image(size, 1, 0.5f),
                       std::nullopt,
                       std::nullopt,
                       make_identity_correspondence(size),
                       Image(size, 1, 1.0f),
                       Image(size, 1),
                       std::nullopt};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const PlantedPoint centre{x + 0.5, y + 0.5};
            const PlantedPoint before = go_back(size, motion, 1.0, centre);
            frame.to_previous.position.at(x, y, 0) = static_cast<float>(before.x);
            frame.to_previous.position.at(x, y, 1) = static_cast<float>(before.y);
            const bool is_disc = motion == PlantedMotion::rotating_disc;
            const bool valid = is_inside(size, before) && !(is_disc && is_near_edge(size, centre));
            frame.to_previous.valid.at(x, y) = valid ? 1.0f : 0.0f;
            frame.to_previous.appeared.at(x, y) = is_inside(size, before) ? 0.0f : 1.0f;
            const double distance =
                std::hypot(centre.x - 0.5 * size.width, centre.y - 0.5 * size.height);
            frame.moves.at(x, y) = is_disc && distance < get_disc_radius(size) ? 1.0f : 0.0f;
        }
    }
    return frame;
}

PlantedPoint find_planted_point(ImageSize size, PlantedMotion motion, int frame, int x, int y) {
    return go_back(size, motion, frame, {x + 0.5, y + 0.5});
}

Image make_planted_noise(ImageSize size, std::uint32_t seed) {
    // The engine's numbers are fixed by the standard, those of its distributions are not.
    std::mt19937 random(seed);
    Image noise(size, 1);
    for (float& value : noise.values()) {
        value = static_cast<float>(std::sqrt(12.0) *
                                   (std::ldexp(static_cast<double>(random()), -32) - 0.5));
    }
    return noise;
}

void add_scaled(Image& image, const Image& other, double scale) {
    ALCOVE_ASSERT(image.size() == other.size() && image.channels() == other.channels(),
                  "images of one shape");
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        image.values()[i] += static_cast<float>(scale) * other.values()[i];
    }
}

std::vector<std::optional<MetricResult>> follow_planted(TemporalMetric& metric,
                                                        const std::vector<PlantedFrame>& frames) {
    metric.reset();
    std::vector<std::optional<MetricResult>> results;
    for (std::size_t t = 0; t < frames.size(); ++t) {
        const PlantedFrame& now = frames[t];
        const std::vector<EarlierFrame> earlier = collect_earlier(frames, t);
        results.push_back(metric.add(
            {now.test, now.reference, now.reference_a ? &*now.reference_a : nullptr,
             now.reference_b ? &*now.reference_b : nullptr, earlier, now.surface, now.moves,
             now.history_state ? &*now.history_state : nullptr, t + 1 == frames.size()}));
    }
    return results;
}

double get_last_planted_value(TemporalMetric& metric, const std::vector<PlantedFrame>& frames) {
    const std::optional<MetricResult> last = follow_planted(metric, frames).back();
    if (!last || !last->value) {
        throw FailureError("planted sequence", "the last frame has no value",
                           last ? last->undefined_reason : "");
    }
    return *last->value;
}

} // namespace alcove
