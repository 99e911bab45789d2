#include "metrics/common/error_step.hpp"

#include <cmath>

namespace alcove {
namespace {

constexpr std::size_t kWithHalves = 3; ///< channels of an error image: e, e_A, e_B

/// One image of three channels, so that one warp serves them all.
Image make_errors(const TemporalFrame& frame) {
    const bool halves = frame.reference_a != nullptr;
    Image errors(frame.test.size(), halves ? static_cast<int>(kWithHalves) : 1);
    const std::size_t count = frame.test.values().size();
    const float* test = frame.test.values().data();
    const float* reference = frame.reference.values().data();
    float* out = errors.values().data();
    if (!halves) {
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = test[i] - reference[i];
        }
        return errors;
    }
    const float* a = frame.reference_a->values().data();
    const float* b = frame.reference_b->values().data();
    for (std::size_t i = 0; i < count; ++i) {
        out[kWithHalves * i] = test[i] - reference[i];
        out[kWithHalves * i + 1] = test[i] - a[i];
        out[kWithHalves * i + 2] = test[i] - b[i];
    }
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

void divide(ErrorMeans& sums, double count) {
    sums.change /= count;
    sums.now /= count;
    sums.earlier /= count;
}

ErrorStep compare(const TemporalFrame& frame, const Image& now, const Image& earlier) {
    ErrorStep step;
    step.change_map = Image(frame.test.size(), 1);
    const float* valid = frame.earlier.front().correspondence.valid.values().data();
    const float* surface = frame.surface.values().data();
    const bool halves = now.channels() == static_cast<int>(kWithHalves) &&
                        earlier.channels() == static_cast<int>(kWithHalves);
    const auto now_stride = static_cast<std::size_t>(now.channels());
    const auto earlier_stride = static_cast<std::size_t>(earlier.channels());
    const std::size_t count = frame.test.values().size();
    float* map = step.change_map.values().data();
    ErrorMeans debiased;
    ErrorMeans noise;
    for (std::size_t i = 0; i < count; ++i) {
        if (valid[i] == 0.0f || surface[i] == 0.0f) {
            continue;
        }
        ++step.pixels;
        const float* e = now.values().data() + now_stride * i;
        const float* w = earlier.values().data() + earlier_stride * i;
        map[i] = std::abs(e[0] - w[0]);
        add_products(step.plain, e[0], w[0], e[0], w[0]);
        if (halves) {
            add_products(debiased, e[1], w[1], e[2], w[2]);
            const float e_noise = 0.5f * (e[1] - e[2]);
            const float w_noise = 0.5f * (w[1] - w[2]);
            add_products(noise, e_noise, w_noise, e_noise, w_noise);
        }
    }
    if (step.pixels == 0) {
        return step;
    }
    const auto pixels = static_cast<double>(step.pixels);
    divide(step.plain, pixels);
    if (halves) {
        divide(debiased, pixels);
        divide(noise, pixels);
        step.debiased = debiased;
        step.noise = noise;
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
        step =
            compare(frame, errors, warp_image(*m_previous, frame.earlier.front().correspondence));
    }
    m_previous = std::move(errors);
    return step;
}

} // namespace alcove
