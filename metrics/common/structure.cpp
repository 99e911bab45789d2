// This work is based on: Wang, Bovik, Sheikh, Simoncelli. Image quality assessment: from error
// visibility to structural similarity. 2004.
#include "metrics/common/structure.hpp"

#include "metrics/common/clones.hpp"
#include "metrics/common/row_bands.hpp"

#include <array>
#include <cmath>

namespace alcove {
namespace {

constexpr int kRadius = kStructureRadius;
constexpr double kC1 = 0.01 * 0.01; // (K1 L)^2 with L = 1
constexpr double kC2 = 0.03 * 0.03; // (K2 L)^2

constexpr std::size_t kTaps = 2 * kRadius + 1;
/// Half of the symmetric window: weight of the centre, then of both taps at distance 1..5.
using Window = std::array<double, kRadius + 1>;

/// Normalised in double: a kernel rounded to six digits biases the variances by 4e-6 mu^2.
Window make_window() {
    constexpr double kSigma = 1.5;
    Window window{};
    double sum = 0.0;
    for (int i = 0; i <= kRadius; ++i) {
        window[static_cast<std::size_t>(i)] = std::exp(-0.5 * i * i / (kSigma * kSigma));
        sum += (i == 0 ? 1.0 : 2.0) * window[static_cast<std::size_t>(i)];
    }
    for (double& weight : window) {
        weight /= sum;
    }
    return window;
}

/// What is averaged over the window: x, y, x^2 + y^2 and x y. The two variances are needed in their
/// sum alone.
constexpr std::size_t kMoments = 4;
using Moments = std::array<std::vector<double>, kMoments>;

Moments make_moments(std::size_t width) {
    Moments moments;
    moments.fill(std::vector<double>(width));
    return moments;
}

/// The window's sum over 11 rows of numbers: of neighbouring columns or of neighbouring rows. `out`
/// overlaps none of them.
ALCOVE_CLONES void sum_taps(const std::array<const double*, kTaps>& taps, const Window& window,
                            std::size_t count, double* __restrict out) {
    const auto [a5, a4, a3, a2, a1, c, b1, b2, b3, b4, b5] = taps;
    const auto [w0, w1, w2, w3, w4, w5] = window;
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = w0 * c[i] + w1 * (a1[i] + b1[i]) + w2 * (a2[i] + b2[i]) + w3 * (a3[i] + b3[i]) +
                 w4 * (a4[i] + b4[i]) + w5 * (a5[i] + b5[i]);
    }
}

ALCOVE_CLONES void multiply_row(const float* test, const float* reference, std::size_t count,
                                double* __restrict xs, double* __restrict ys,
                                double* __restrict squares, double* __restrict crosses) {
    for (std::size_t i = 0; i < count; ++i) {
        const double x = static_cast<double>(test[i]);
        const double y = static_cast<double>(reference[i]);
        xs[i] = x;
        ys[i] = y;
        squares[i] = x * x + y * y;
        crosses[i] = x * y;
    }
}

/// l c s of each pixel of one row from its four windowed means.
ALCOVE_CLONES void compute_whole(const double* xs, const double* ys, const double* squares,
                                 const double* crosses, std::size_t count, double* __restrict out) {
    for (std::size_t i = 0; i < count; ++i) {
        const double product = xs[i] * ys[i];
        const double sum = xs[i] * xs[i] + ys[i] * ys[i];
        out[i] = (2.0 * product + kC1) * (2.0 * (crosses[i] - product) + kC2) /
                 ((sum + kC1) * (squares[i] - sum + kC2));
    }
}

ALCOVE_CLONES void compute_contrast(const double* xs, const double* ys, const double* squares,
                                    const double* crosses, std::size_t count,
                                    double* __restrict out) {
    for (std::size_t i = 0; i < count; ++i) {
        const double product = xs[i] * ys[i];
        const double sum = xs[i] * xs[i] + ys[i] * ys[i];
        out[i] = (2.0 * (crosses[i] - product) + kC2) / (squares[i] - sum + kC2);
    }
}

/// Goes down the rows of a band: keeps the last 11 rows of moments, summed over columns.
class StructureBand {
  public:
    StructureBand(const Image& test, const Image& reference, StructureTerm term)
        : m_test(test), m_reference(reference), m_term(term),
          m_width(static_cast<std::size_t>(test.width() - 2 * kRadius)),
          m_products(make_moments(static_cast<std::size_t>(test.width()))),
          m_means(make_moments(m_width)), m_values(m_width) {
        m_rows.fill(make_moments(m_width));
    }

    void take_row(int row) {
        const auto width = static_cast<std::size_t>(m_test.width());
        const std::size_t begin = static_cast<std::size_t>(row) * width;
        multiply_row(m_test.values().data() + begin, m_reference.values().data() + begin, width,
                     m_products[0].data(), m_products[1].data(), m_products[2].data(),
                     m_products[3].data());
        for (std::size_t m = 0; m < kMoments; ++m) {
            std::array<const double*, kTaps> taps{};
            for (std::size_t k = 0; k < kTaps; ++k) {
                taps.at(k) = m_products.at(m).data() + k;
            }
            sum_taps(taps, m_window, m_width,
                     m_rows.at(static_cast<std::size_t>(row) % kTaps).at(m).data());
        }
    }

    /// The term along the row of windows whose last row was taken last.
    const std::vector<double>& compute_row(int last) {
        for (std::size_t m = 0; m < kMoments; ++m) {
            std::array<const double*, kTaps> taps{};
            for (std::size_t k = 0; k < kTaps; ++k) {
                taps.at(k) =
                    m_rows.at((static_cast<std::size_t>(last) + 1 + k) % kTaps).at(m).data();
            }
            sum_taps(taps, m_window, m_width, m_means.at(m).data());
        }
        const auto compute = m_term == StructureTerm::whole ? compute_whole : compute_contrast;
        compute(m_means[0].data(), m_means[1].data(), m_means[2].data(), m_means[3].data(), m_width,
                m_values.data());
        return m_values;
    }

  private:
    const Image& m_test;
    const Image& m_reference;
    StructureTerm m_term;
    std::size_t m_width;
    Window m_window = make_window();
    Moments m_products;
    std::array<Moments, kTaps> m_rows; ///< row y in place y mod 11
    Moments m_means;
    std::vector<double> m_values;
};

} // namespace

PooledRegion make_structure_region(const Image* mask, ImageSize size) {
    ALCOVE_ASSERT(size.width > 2 * kRadius && size.height > 2 * kRadius, "a whole window");
    return {mask, {size.width - 2 * kRadius, size.height - 2 * kRadius}, kRadius};
}

double compute_structure(const Image& test, const Image& reference, StructureTerm term,
                         const PooledRegion& region, Image* map) {
    ALCOVE_ASSERT(test.channels() == 1 && reference.size() == test.size(), "luma of one size");
    if (map != nullptr) {
        *map = Image(region.size(), 1);
    }
    std::vector<double> sums(static_cast<std::size_t>(region.size().height));
    for_row_bands(region.size().height, [&](int begin, int end) {
        StructureBand band(test, reference, term);
        for (int row = begin; row < begin + 2 * kRadius; ++row) {
            band.take_row(row);
        }
        for (int y = begin; y < end; ++y) {
            band.take_row(y + 2 * kRadius);
            const std::vector<double>& values = band.compute_row(y + 2 * kRadius);
            sums[static_cast<std::size_t>(y)] = region.sum_row(y, values.data());
            for (int x = 0; map != nullptr && x < map->width(); ++x) {
                map->at(x, y) = static_cast<float>(values[static_cast<std::size_t>(x)]);
            }
        }
    });
    return region.compute_mean(sums);
}

} // namespace alcove
