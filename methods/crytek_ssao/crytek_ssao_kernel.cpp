// This work is based on: "Know your SSAO artifacts", 2013 (least cosine baked into the hemisphere's
// points, direction and length indexed apart).
#include "methods/common/sequence.hpp"
#include "methods/crytek_ssao/crytek_ssao.hpp"

#include <cmath>
#include <numbers>

namespace alcove {
namespace {

bool is_sphere(CrytekKernel kernel) {
    return kernel == CrytekKernel::sphere || kernel == CrytekKernel::sphere_reflected;
}

int count_points(const CrytekSsaoParams& params) {
    if (params.indexing != CrytekIndexing::constant) {
        return params.kernel_size;
    }
    return params.kernel == CrytekKernel::sphere ? (params.samples + 1) / 2 : params.samples;
}

/// Cosine to the normal (of the sphere: to z) of a number that is uniform in [0, 1).
double compute_cosine(const CrytekSsaoParams& params, double u) {
    if (is_sphere(params.kernel)) {
        return 2.0 * u - 1.0;
    }
    const double least = params.min_cosine;
    return params.weighting == CrytekWeighting::cosine
               ? std::sqrt(least * least + (1.0 - least * least) * u)
               : least + (1.0 - least) * u;
}

} // namespace

std::vector<glm::vec4> make_crytek_kernel(const CrytekSsaoParams& params) {
    std::vector<glm::vec4> kernel;
    for (int i = 1; i <= count_points(params); ++i) {
        const auto index = static_cast<std::uint32_t>(i);
        const double z = compute_cosine(params, compute_radical_inverse(index, 2));
        const double azimuth = 2.0 * std::numbers::pi * compute_radical_inverse(index, 3);
        const double horizontal = std::sqrt(std::max(0.0, 1.0 - z * z));
        kernel.emplace_back(horizontal * std::cos(azimuth), horizontal * std::sin(azimuth), z,
                            compute_radical_inverse(index, 5));
    }
    return kernel;
}

CrytekIndices compute_crytek_indices(int sample, int direction_offset, int length_offset,
                                     const CrytekSsaoParams& params) {
    const int size = params.kernel_size;
    if (params.indexing == CrytekIndexing::decoupled_literal) {
        ALCOVE_ASSERT(direction_offset == length_offset, "the literal form has one offset");
        return {(sample + direction_offset) * params.direction_multiplier % size,
                (sample + direction_offset) * params.length_multiplier % size};
    }
    return {(sample * params.direction_multiplier + direction_offset) % size,
            (sample * params.length_multiplier + length_offset) % size};
}

} // namespace alcove
