#pragma once
// An error taken apart (DESIGN 3.7).

#include "core/base/image.hpp"
#include "reports/record/record.hpp"

namespace alcove {

/// Two independent randomisations of one image.
struct ImageHalves {
    Image a;
    Image b;
    /// What both are a randomisation of; its noise is half that of their difference.
    [[nodiscard]] Image compute_mean() const;
    /// Squared standard error of the mean: mean (a - b)^2 / 4.
    [[nodiscard]] double compute_noise() const;
};

/// What the steps go over. All of one size and one channel.
struct StepImages {
    const Image& method;
    const Image* converged_form = nullptr; ///< nothing: there is no d1
    const Image& march;
    const Image& truth;
};

/// All moments of d1, d2, d3, in double; names, thickness and noise are the caller's. Asserts equal
/// sizes.
[[nodiscard]] StepRecord compute_steps(const StepImages& images);

} // namespace alcove
