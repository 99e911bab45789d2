#include "methods/common/kernels.hpp"

#include "methods/common/sequence.hpp"

#include <cmath>
#include <numbers>

namespace alcove {

std::vector<glm::vec4> make_hemisphere_kernel(int samples, KernelDirections directions) {
    std::vector<glm::vec4> kernel;
    for (int i = 1; i <= samples; ++i) {
        const auto index = static_cast<std::uint32_t>(i);
        const double u = compute_radical_inverse(index, 2);
        const double azimuth = 2.0 * std::numbers::pi * compute_radical_inverse(index, 3);
        const double z = directions == KernelDirections::uniform ? u : std::sqrt(u);
        const double horizontal = std::sqrt(1.0 - z * z);
        kernel.emplace_back(horizontal * std::cos(azimuth), horizontal * std::sin(azimuth), z,
                            compute_radical_inverse(index, 5));
    }
    return kernel;
}

std::vector<glm::vec4> make_ball_kernel(int samples, bool is_whole_ball) {
    std::vector<glm::vec4> kernel = make_hemisphere_kernel(samples, KernelDirections::uniform);
    for (glm::vec4& point : kernel) {
        if (is_whole_ball) {
            const float z = 2.0f * point.z - 1.0f;
            const float scale = std::sqrt((1.0f - z * z) / (1.0f - point.z * point.z));
            point = {point.x * scale, point.y * scale, z, point.w};
        }
        point.w = std::cbrt(point.w);
    }
    return kernel;
}

std::vector<glm::vec4> make_disc_kernel(int samples) {
    std::vector<glm::vec4> kernel;
    for (int i = 1; i <= samples; ++i) {
        const auto index = static_cast<std::uint32_t>(i);
        const double radius = std::sqrt(compute_radical_inverse(index, 2));
        const double azimuth = 2.0 * std::numbers::pi * compute_radical_inverse(index, 3);
        kernel.emplace_back(radius * std::cos(azimuth), radius * std::sin(azimuth), 0.0, 0.0);
    }
    return kernel;
}

std::vector<glm::vec4> make_paired_disc_kernel(int samples) {
    std::vector<glm::vec4> kernel;
    for (const glm::vec4& point : make_disc_kernel((samples + 1) / 2)) {
        kernel.push_back(point);
        kernel.push_back(-point);
    }
    kernel.resize(static_cast<std::size_t>(samples));
    return kernel;
}

} // namespace alcove
