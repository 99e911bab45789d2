#include "harness/run/error_steps.hpp"

#include "core/base/assert.hpp"

namespace alcove {

Image ImageHalves::compute_mean() const {
    ALCOVE_ASSERT(a.size() == b.size(), "halves of one image");
    Image mean = a;
    for (std::size_t i = 0; i < mean.values().size(); ++i) {
        mean.values()[i] = 0.5f * (a.values()[i] + b.values()[i]);
    }
    return mean;
}

double ImageHalves::compute_noise() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        const double difference =
            static_cast<double>(a.values()[i]) - static_cast<double>(b.values()[i]);
        sum += difference * difference;
    }
    return 0.25 * sum / static_cast<double>(a.values().size());
}

StepRecord compute_steps(const StepImages& images) {
    const Image& form = images.converged_form != nullptr ? *images.converged_form : images.method;
    const std::size_t count = images.method.values().size();
    ALCOVE_ASSERT(form.values().size() == count && images.march.values().size() == count &&
                      images.truth.values().size() == count,
                  "images of one size");
    StepRecord steps;
    steps.has_converged_form = images.converged_form != nullptr;
    for (std::size_t i = 0; i < count; ++i) {
        const double method = images.method.values()[i];
        const double converged = form.values()[i];
        const double march = images.march.values()[i];
        const double truth = images.truth.values()[i];
        const double d1 = method - converged;
        const double d2 = converged - march;
        const double d3 = march - truth;
        const double total = method - truth;
        steps.total += total * total;
        steps.d1 += d1 * d1;
        steps.d2 += d2 * d2;
        steps.d3 += d3 * d3;
        steps.d1_d2 += d1 * d2;
        steps.d1_d3 += d1 * d3;
        steps.d2_d3 += d2 * d3;
    }
    for (double* sum : {&steps.total, &steps.d1, &steps.d2, &steps.d3, &steps.d1_d2, &steps.d1_d3,
                        &steps.d2_d3}) {
        *sum /= static_cast<double>(count);
    }
    return steps;
}

} // namespace alcove
