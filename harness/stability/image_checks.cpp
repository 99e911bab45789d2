#include "harness/stability/image_checks.hpp"

#include "core/base/text.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace alcove {
namespace {

constexpr double kCodes = 1.0 / kOneCode;

} // namespace

std::string find_fault(const Image& visibility, const Image& depth) {
    ALCOVE_ASSERT(visibility.size() == depth.size(), "images of one size");
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            const float value = visibility.at(x, y);
            const char* what = nullptr;
            if (!std::isfinite(value)) {
                what = "not finite";
            } else if (value < 0.0f || value > 1.0f) {
                what = "outside [0,1]";
            } else if (std::isinf(depth.at(x, y)) && value != 1.0f) {
                what = "background that is not 1";
            }
            if (what != nullptr) {
                return std::string(what) + ": " + format_number(static_cast<double>(value)) +
                       " at pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")";
            }
        }
    }
    return {};
}

double compute_rms_codes(const Image& a, const Image& b) {
    ALCOVE_ASSERT(a.size() == b.size(), "images of one size");
    double sum = 0.0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        const double difference = static_cast<double>(a.values()[i]) - b.values()[i];
        sum += difference * difference;
    }
    return kCodes * std::sqrt(sum / static_cast<double>(a.values().size()));
}

double compute_mean_codes(const Image& a, const Image& b, const Image& mask) {
    ALCOVE_ASSERT(a.size() == b.size() && a.size() == mask.size(), "images of one size");
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        if (mask.values()[i] != 0.0f) {
            sum += static_cast<double>(a.values()[i]) - b.values()[i];
            ++count;
        }
    }
    return count == 0 ? 0.0 : kCodes * sum / static_cast<double>(count);
}

double compute_worst_block_codes(const Image& a, const Image& b, const Image& mask,
                                 ImageSize grid) {
    ALCOVE_ASSERT(a.size() == b.size() && a.size() == mask.size(), "images of one size");
    std::vector<double> sums(grid.pixel_count());
    std::vector<int> counts(grid.pixel_count());
    std::vector<int> sizes(grid.pixel_count());
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const auto block = static_cast<std::size_t>(
                (y * grid.height / a.height()) * grid.width + x * grid.width / a.width());
            ++sizes[block];
            if (mask.at(x, y) != 0.0f) {
                sums[block] += static_cast<double>(a.at(x, y)) - b.at(x, y);
                ++counts[block];
            }
        }
    }
    double worst = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (counts[i] > 0 && 2 * counts[i] >= sizes[i]) {
            // A sum that is not finite must not slip through a comparison.
            const double mean = std::abs(sums[i]) / counts[i];
            worst = mean <= worst ? worst : mean;
        }
    }
    return kCodes * worst;
}

Image make_surface_mask(const Image& depth) {
    Image mask(depth.size(), 1);
    for (std::size_t i = 0; i < depth.values().size(); ++i) {
        mask.values()[i] = std::isinf(depth.values()[i]) ? 0.0f : 1.0f;
    }
    return mask;
}

void MeanImage::add(const Image& image) {
    if (m_count == 0) {
        m_sum = Image(image.size(), 1);
    }
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        m_sum.values()[i] += image.values()[i];
    }
    ++m_count;
}

Image MeanImage::compute() const {
    ALCOVE_ASSERT(m_count > 0, "an image");
    Image mean = m_sum;
    for (float& value : mean.values()) {
        value /= static_cast<float>(m_count);
    }
    return mean;
}

void WorstScore::add(double score, double bound) {
    const auto margin = [](const StabilityScore& s) {
        return compute_margin({s.score, s.bound, "", ""});
    };
    const StabilityScore candidate{score, bound, "", {}};
    if (m_is_empty || margin(candidate) < margin(m_worst)) {
        m_worst.score = score;
        m_worst.bound = bound;
    }
    m_is_empty = false;
}

void WorstScore::check(const Image& visibility, const Image& depth) {
    if (m_worst.fault.empty()) {
        m_worst.fault = find_fault(visibility, depth);
    }
}

StabilityScore WorstScore::finish(Image picture) const {
    ALCOVE_ASSERT(!m_is_empty, "a score");
    StabilityScore score = m_worst;
    score.picture = std::move(picture);
    return score;
}

} // namespace alcove
