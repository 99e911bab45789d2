#include "metrics/recovery_frames/recovery_frames.hpp"

#include "metrics/common/planted_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace alcove {
namespace {

struct RecoveryParameters {
    double tolerance = 1.1;
    int longest_age = 32;
    int least_pixels = 64;
};

ParameterTable describe_recovery_parameters() {
    return describe_parameters(
        "recovery_frames",
        {real(&RecoveryParameters::tolerance, "tolerance")
             .range(1.0, 10.0)
             .unit("1")
             .meaning("How many times the steady error counts as recovered.")
             .source("ours"),
         integer(&RecoveryParameters::longest_age, "longest_age")
             .range(1, 1000)
             .log_scale()
             .unit("frames")
             .meaning("Points of this age and older are pooled.")
             .source("ours"),
         integer(&RecoveryParameters::least_pixels, "least_pixels")
             .range(1, 1000000)
             .log_scale()
             .unit("px")
             .meaning("Ages with fewer pixels in the whole sequence are left out, and so is a "
                      "steady state with fewer.")
             .source("ours")});
}

/// Frames since a point came into view, or one of these.
constexpr int kNoSurface = -2;
constexpr int kAlwaysSeen = -1; ///< since the sequence began

struct PooledError {
    std::size_t pixels = 0;
    double square = 0.0;
    double debiased = 0.0; ///< of e_A e_B; without meaning where a frame had no halves
    void add(const PooledError& other) {
        pixels += other.pixels;
        square += other.square;
        debiased += other.debiased;
    }
};

double compute_rms(const PooledError& error, double PooledError::*which) {
    return std::sqrt(std::max(0.0, error.*which) / static_cast<double>(error.pixels));
}

class RecoveryFrames final : public TemporalMetric {
  public:
    explicit RecoveryFrames(const RecoveryParameters& parameters) : m_parameters(parameters) {
        reset();
    }

    void reset() override {
        m_ages.clear();
        m_by_age.assign(static_cast<std::size_t>(m_parameters.longest_age) + 1, {});
        m_steady.clear();
        m_has_halves = true;
    }

    std::optional<MetricResult> add(const TemporalFrame& frame) override {
        check_temporal_frame(frame, "recovery_frames");
        carry_ages(frame);
        pool_errors(frame);
        return frame.is_last ? std::optional(conclude()) : std::nullopt;
    }

  private:
    void carry_ages(const TemporalFrame& frame) {
        const int width = frame.test.width();
        const int height = frame.test.height();
        const float* surface = frame.surface.values().data();
        std::vector<int> ages(frame.test.size().pixel_count(), kNoSurface);
        if (frame.earlier.empty()) {
            for (std::size_t i = 0; i < ages.size(); ++i) {
                ages[i] = surface[i] != 0.0f ? kAlwaysSeen : kNoSurface;
            }
            m_ages = std::move(ages);
            return;
        }
        ALCOVE_ASSERT(m_ages.size() == ages.size() && frame.earlier.front().steps == 1,
                      "the frame before was added too");
        const float* position = frame.earlier.front().correspondence.position.values().data();
        const float* appeared = frame.earlier.front().correspondence.appeared.values().data();
        for (std::size_t i = 0; i < ages.size(); ++i) {
            if (surface[i] == 0.0f) {
                continue;
            }
            ages[i] = 0;
            if (appeared[i] != 0.0f) {
                continue;
            }
            const int x = std::clamp(static_cast<int>(position[2 * i]), 0, width - 1);
            const int y = std::clamp(static_cast<int>(position[2 * i + 1]), 0, height - 1);
            const int before =
                m_ages[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)];
            if (before == kAlwaysSeen) {
                ages[i] = kAlwaysSeen;
            } else if (before != kNoSurface) {
                ages[i] = std::min(before + 1, m_parameters.longest_age);
            }
        }
        m_ages = std::move(ages);
    }

    void pool_errors(const TemporalFrame& frame) {
        const bool halves = frame.reference_a != nullptr;
        const float* test = frame.test.values().data();
        const float* reference = frame.reference.values().data();
        const float* a = halves ? frame.reference_a->values().data() : reference;
        const float* b = halves ? frame.reference_b->values().data() : reference;
        PooledError steady;
        for (std::size_t i = 0; i < m_ages.size(); ++i) {
            if (m_ages[i] == kNoSurface) {
                continue;
            }
            PooledError& pool =
                m_ages[i] == kAlwaysSeen ? steady : m_by_age[static_cast<std::size_t>(m_ages[i])];
            const auto error = static_cast<double>(test[i] - reference[i]);
            ++pool.pixels;
            pool.square += error * error;
            pool.debiased +=
                static_cast<double>(test[i] - a[i]) * static_cast<double>(test[i] - b[i]);
        }
        m_steady.push_back(steady);
        m_has_halves = m_has_halves && halves;
    }

    [[nodiscard]] MetricResult conclude() const {
        // A method that starts without history is no steady state yet: the sequence's first half is
        // left out.
        PooledError steady;
        for (std::size_t t = m_steady.size() / 2; t < m_steady.size(); ++t) {
            steady.add(m_steady[t]);
        }
        MetricResult result;
        result.value = find_recovery(steady, &PooledError::square, result.undefined_reason);
        if (m_has_halves) {
            std::string no_reason;
            result.debiased = find_recovery(steady, &PooledError::debiased, no_reason);
        }
        return result;
    }

    std::optional<double> find_recovery(const PooledError& steady, double PooledError::*which,
                                        std::string& undefined_reason) const {
        const auto least = static_cast<std::size_t>(m_parameters.least_pixels);
        if (steady.pixels < least) {
            undefined_reason = "fewer than " + std::to_string(least) +
                               " pixels were in view all along: no steady error";
            return std::nullopt;
        }
        const double bound = m_parameters.tolerance * compute_rms(steady, which);
        std::vector<std::size_t> ages;
        for (std::size_t age = 0; age < m_by_age.size(); ++age) {
            if (m_by_age[age].pixels >= least) {
                ages.push_back(age);
            }
        }
        if (ages.empty()) {
            undefined_reason =
                "too few points came into view: no age has " + std::to_string(least) + " pixels";
            return std::nullopt;
        }
        const auto is_above = [&](std::size_t age) {
            return compute_rms(m_by_age[age], which) > bound;
        };
        const auto last_above = std::find_if(ages.rbegin(), ages.rend(), is_above);
        if (last_above == ages.rbegin()) {
            undefined_reason = "more than " + std::to_string(ages.back()) +
                               " frames: the oldest points that came into view have not recovered";
            return std::nullopt;
        }
        return static_cast<double>(*std::prev(last_above));
    }

    RecoveryParameters m_parameters;
    std::vector<int> m_ages;           ///< of the last frame's pixels
    std::vector<PooledError> m_by_age; ///< over the sequence; the last holds all older ones
    std::vector<PooledError> m_steady; ///< a frame each: points that were always in view
    bool m_has_halves = true;          ///< all frames so far
};

/// A column of 8 pixels comes into view in frame 8 of 32; there the error falls as
/// 0.1 (1 + 4 keep^age), elsewhere it is 0.1.
double run_decay(TemporalMetric& metric, double keep) {
    constexpr ImageSize kSize{32, 24};
    constexpr int kAppears = 8;
    std::vector<PlantedFrame> frames =
        plant_errors(kSize, PlantedMotion::still, 32, 0.1, [keep](int t) {
            Image error(kSize, 1, 1.0f);
            for (int y = 0; t >= kAppears && y < kSize.height; ++y) {
                for (int x = 0; x < 8; ++x) {
                    error.at(x, y) += static_cast<float>(4.0 * std::pow(keep, t - kAppears));
                }
            }
            return error;
        });
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < 8; ++x) {
            frames[kAppears].to_previous.valid.at(x, y) = 0.0f;
            frames[kAppears].to_previous.appeared.at(x, y) = 1.0f;
        }
    }
    return get_last_planted_value(metric, frames);
}

} // namespace

MetricUnit recovery_frames_unit() {
    MetricUnit unit;
    unit.name = "recovery_frames";
    unit.title = "Frames until a point that came into view has recovered";
    unit.unit = "frames";
    unit.definition =
        "A surface pixel that was not visible one frame ago (first frame apart) has age 0; ages "
        "are carried along the surfaces' motion (nearest pixel) and counted up to `longest_age`. "
        "The smallest age from which on RMS(e) of each age, pooled over the sequence, is at most "
        "`tolerance` x the steady error: RMS(e) over the second half of the sequence of points "
        "that were in view since its first frame. Ages with fewer than `least_pixels` pixels are "
        "left out. Told on the last frame; undefined where the oldest age is still above, where "
        "nothing came into view, and where nothing stayed. With halves of the reference: debiased "
        "= the same of mean e_A e_B.";
    unit.blind_to = "how large the error is while it lasts, and points that leave again before "
                    "they have recovered: the older ages are those that stay.";
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_recovery_parameters();
    unit.temporal_checks = {
        {"error falling by half a frame",
         [](TemporalMetric& metric) { return run_decay(metric, 0.5); }, 6.0, 0.0,
         "by hand: 4 x 0.5^n <= 0.1 first at n = 6"},
        {"error falling to 0.8 a frame",
         [](TemporalMetric& metric) { return run_decay(metric, 0.8); }, 17.0, 0.0,
         "by hand: 4 x 0.8^n <= 0.1 first at n = 17"},
        {"error falling at once", [](TemporalMetric& metric) { return run_decay(metric, 0.0); },
         1.0, 0.0, "by hand: 0^0 = 1 at age 0, then nothing"},
    };
    unit.create_temporal = [table = unit.parameters](const ResolvedParameters& resolved) {
        return std::make_unique<RecoveryFrames>(table.bind<RecoveryParameters>(resolved));
    };
    return unit;
}

} // namespace alcove
