#include "metrics/common/error_step.hpp"

#include "metrics/common/row_bands.hpp"

#include <cmath>
#include <vector>

namespace alcove {
namespace {

constexpr std::size_t kWithHalves = 3; ///< channels of an error image: e, e_A, e_B

/// One image of three channels, so that one warp serves them all.
Image make_errors(const TemporalFrame& frame) {
    const bool halves = frame.reference_a != nullptr;
    Image errors(frame.test.size(), halves ? static_cast<int>(kWithHalves) : 1);
    const auto width = static_cast<std::size_t>(frame.test.width());
    const float* test = frame.test.values().data();
    const float* reference = frame.reference.values().data();
    const float* a = halves ? frame.reference_a->values().data() : nullptr;
    const float* b = halves ? frame.reference_b->values().data() : nullptr;
    float* out = errors.values().data();
    for_row_bands(frame.test.height(), [&](int begin, int end) {
        for (std::size_t i = static_cast<std::size_t>(begin) * width;
             i < static_cast<std::size_t>(end) * width; ++i) {
            if (!halves) {
                out[i] = test[i] - reference[i];
                continue;
            }
            out[kWithHalves * i] = test[i] - reference[i];
            out[kWithHalves * i + 1] = test[i] - a[i];
            out[kWithHalves * i + 2] = test[i] - b[i];
        }
    });
    return errors;
}

double multiply(float a, float b) {
    return static_cast<double>(a) * static_cast<double>(b);
}

void add_products(ErrorMeans& sums, float now_a, float earlier_a, float now_b, float earlier_b) {
    sums.change += multiply(now_a - earlier_a, now_b - earlier_b);
    sums.now += multiply(now_a, now_b);
    sums.earlier += multiply(earlier_a, earlier_b);
}

/// What one row, or all of them, add to a step.
struct Sums {
    std::size_t pixels = 0;
    ErrorMeans plain;
    ErrorMeans debiased;
    ErrorMeans noise;
};

void add(ErrorMeans& sum, const ErrorMeans& part) {
    sum.change += part.change;
    sum.now += part.now;
    sum.earlier += part.earlier;
}

ErrorMeans divide(const ErrorMeans& sums, double count) {
    return {sums.change / count, sums.now / count, sums.earlier / count};
}

/// `now` and `earlier` are rows with that many channels; `map` receives |D|.
Sums compare_rows(std::span<const float> valid, std::span<const float> surface, const float* now,
                  std::size_t now_channels, const float* earlier, std::size_t earlier_channels,
                  float* map) {
    const bool halves = now_channels == kWithHalves && earlier_channels == kWithHalves;
    Sums sums;
    for (std::size_t x = 0; x < valid.size(); ++x) {
        if (valid[x] == 0.0f || surface[x] == 0.0f) {
            continue;
        }
        ++sums.pixels;
        const float* e = now + now_channels * x;
        const float* w = earlier + earlier_channels * x;
        map[x] = std::abs(e[0] - w[0]);
        add_products(sums.plain, e[0], w[0], e[0], w[0]);
        if (halves) {
            add_products(sums.debiased, e[1], w[1], e[2], w[2]);
            const float e_noise = 0.5f * (e[1] - e[2]);
            const float w_noise = 0.5f * (w[1] - w[2]);
            add_products(sums.noise, e_noise, w_noise, e_noise, w_noise);
        }
    }
    return sums;
}

ErrorStep compare(const TemporalFrame& frame, const Image& now, const Image& previous) {
    ErrorStep step;
    step.change_map = Image(frame.test.size(), 1);
    const Correspondence& to_previous = frame.earlier.front().correspondence;
    const auto width = static_cast<std::size_t>(frame.test.width());
    const auto now_channels = static_cast<std::size_t>(now.channels());
    const auto earlier_channels = static_cast<std::size_t>(previous.channels());
    std::vector<Sums> rows(static_cast<std::size_t>(frame.test.height()));
    for_row_bands(frame.test.height(), [&](int begin, int end) {
        std::vector<float> earlier(width * earlier_channels);
        for (int y = begin; y < end; ++y) {
            warp_row(previous, to_previous, y, earlier);
            const std::size_t first = static_cast<std::size_t>(y) * width;
            rows[static_cast<std::size_t>(y)] = compare_rows(
                to_previous.valid.values().subspan(first, width),
                frame.surface.values().subspan(first, width),
                now.values().data() + first * now_channels, now_channels, earlier.data(),
                earlier_channels, step.change_map.values().data() + first);
        }
    });
    Sums sums;
    for (const Sums& row : rows) {
        sums.pixels += row.pixels;
        add(sums.plain, row.plain);
        add(sums.debiased, row.debiased);
        add(sums.noise, row.noise);
    }
    step.pixels = sums.pixels;
    if (step.pixels == 0) {
        return step;
    }
    const auto pixels = static_cast<double>(step.pixels);
    step.plain = divide(sums.plain, pixels);
    if (now_channels == kWithHalves && earlier_channels == kWithHalves) {
        step.debiased = divide(sums.debiased, pixels);
        step.noise = divide(sums.noise, pixels);
    }
    return step;
}

} // namespace

std::optional<ErrorStep> ErrorSteps::add(const TemporalFrame& frame) {
    Image errors = make_errors(frame);
    std::optional<ErrorStep> step;
    if (!frame.earlier.empty()) {
        ALCOVE_ASSERT(m_previous.has_value() && frame.earlier.front().steps == 1,
                      "the frame before was added too");
        step = compare(frame, errors, *m_previous);
    }
    m_previous = std::move(errors);
    return step;
}

} // namespace alcove
