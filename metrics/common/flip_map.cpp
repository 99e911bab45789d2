// This work is based on: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild. FLIP: A
// Difference Evaluator for Alternating Images. 2020.
#include "metrics/common/flip_map.hpp"

#include "metrics/common/clones.hpp"
#include "metrics/common/fast_pow.hpp"
#include "metrics/common/filter_row.hpp"
#include "metrics/common/flip_colour.hpp"
#include "metrics/common/row_bands.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace alcove {
namespace {

/// What is kept of the latest rows, filtered along x.
enum Plane : std::size_t {
    kAchromatic,
    kGaussian,
    kFirst,
    kSecond,
    kGreyPlanes,
    kRedGreen = kGreyPlanes,
    kBlueYellowWide,
    kBlueYellowNarrow,
    kColourPlanes
};

/// The latest rows of a plane, as many as the widest vertical filter needs, which reaches `radius`
/// rows to each side.
class RowRing {
  public:
    RowRing(int radius, std::size_t width)
        : m_slots(2 * radius + 1), m_width(width),
          m_values(static_cast<std::size_t>(m_slots) * width), m_taps(as_size(m_slots)) {}
    [[nodiscard]] float* slot(int row) {
        return m_values.data() + as_size(row % m_slots) * m_width;
    }
    /// Rows y - radius .. y + radius, those outside of the image being its outermost ones; points
    /// to row y.
    [[nodiscard]] const float* const* find_taps(int y, int height, int radius) {
        for (int k = -radius; k <= radius; ++k) {
            m_taps[as_size(k + radius)] = slot(std::clamp(y + k, 0, height - 1));
        }
        return m_taps.data() + radius;
    }

  private:
    static std::size_t as_size(int value) { return static_cast<std::size_t>(value); }
    int m_slots;
    std::size_t m_width;
    std::vector<float> m_values;
    std::vector<const float*> m_taps;
};

/// The filtered rows of one image of the pair.
class FilteredImage {
  public:
    FilteredImage(const Image& image, const FlipFilters& filters, const ToLinear& to_linear)
        : m_image(image), m_filters(filters), m_to_linear(to_linear),
          m_planes(image.channels() == 3 ? 3 : 1),
          m_width((static_cast<std::size_t>(image.width()) + kFilterBlock - 1) / kFilterBlock *
                  kFilterBlock),
          m_pad(std::max(filters.blue_yellow_wide.radius(), filters.gaussian.radius())) {
        const std::size_t padded = m_width + 2 * static_cast<std::size_t>(m_pad);
        for (std::size_t p = 0; p < m_planes; ++p) {
            m_source[p].resize(padded);
        }
        const std::size_t count = m_planes == 3 ? kColourPlanes : kGreyPlanes;
        for (std::size_t p = 0; p < count; ++p) {
            m_rings.emplace_back(m_pad, m_width);
        }
        m_taps.resize(2 * static_cast<std::size_t>(m_pad) + 1);
        for (std::vector<float>* row :
             {&m_lab[0], &m_lab[1], &m_lab[2], &m_edge, &m_point, &m_x, &m_y}) {
            row->resize(m_width);
        }
    }

    [[nodiscard]] std::size_t width() const { return m_width; }
    /// Rows to each side that a row needs.
    [[nodiscard]] int reach() const { return m_pad; }
    [[nodiscard]] int planes() const { return static_cast<int>(m_planes); }

    /// Filters a row along x into the rings.
    void take_row(int row) {
        load_row(row);
        filter_x(FilterKind::even, m_filters.achromatic, 0, kAchromatic, row);
        filter_x(FilterKind::even, m_filters.gaussian, 0, kGaussian, row);
        filter_x(FilterKind::odd, m_filters.first_derivative, 0, kFirst, row);
        filter_x(FilterKind::even, m_filters.second_derivative, 0, kSecond, row);
        if (m_planes == 3) {
            filter_x(FilterKind::even, m_filters.red_green, 1, kRedGreen, row);
            filter_x(FilterKind::even, m_filters.blue_yellow_wide, 2, kBlueYellowWide, row);
            filter_x(FilterKind::even, m_filters.blue_yellow_narrow, 2, kBlueYellowNarrow, row);
        }
    }

    /// Filters row y along y: fills lab, edge and point.
    void compute_row(int y) {
        const std::array<float*, 3> lab{m_lab[0].data(), m_lab[1].data(), m_lab[2].data()};
        filter_y(FilterKind::even, m_filters.achromatic, kAchromatic, y, m_lab[0]);
        if (m_planes == 3) {
            filter_y(FilterKind::even, m_filters.red_green, kRedGreen, y, m_lab[1]);
            filter_y(FilterKind::even, m_filters.blue_yellow_wide, kBlueYellowWide, y, m_lab[2]);
            filter_y(FilterKind::even, m_filters.blue_yellow_narrow, kBlueYellowNarrow, y, m_lab[2],
                     true);
            convert_to_hunt_lab(lab, m_width);
        } else {
            convert_to_lightness(lab[0], m_width);
        }
        filter_y(FilterKind::even, m_filters.gaussian, kFirst, y, m_x);
        filter_y(FilterKind::odd, m_filters.first_derivative, kGaussian, y, m_y);
        compute_length(m_x.data(), m_y.data(), m_width, m_edge.data());
        filter_y(FilterKind::even, m_filters.gaussian, kSecond, y, m_x);
        filter_y(FilterKind::even, m_filters.second_derivative, kGaussian, y, m_y);
        compute_length(m_x.data(), m_y.data(), m_width, m_point.data());
    }

    [[nodiscard]] std::array<float*, 3> lab() {
        return {m_lab[0].data(), m_lab[1].data(), m_lab[2].data()};
    }
    [[nodiscard]] const float* edge() const { return m_edge.data(); }
    [[nodiscard]] const float* point() const { return m_point.data(); }

  private:
    ALCOVE_CLONES static void compute_length(const float* a, const float* b, std::size_t count,
                                             float* __restrict out) {
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = std::sqrt(a[i] * a[i] + b[i] * b[i]);
        }
    }

    /// The row as opponent channels (grey: luminance alone), with its outermost pixels repeated.
    void load_row(int row) {
        const auto width = static_cast<std::size_t>(m_image.width());
        const auto channels = static_cast<std::size_t>(m_image.channels());
        const float* pixels =
            m_image.values().data() + static_cast<std::size_t>(row) * width * channels;
        std::array<float*, 3> planes{};
        for (std::size_t p = 0; p < m_planes; ++p) {
            planes[p] = m_source[p].data() + m_pad;
            for (std::size_t x = 0; x < width; ++x) {
                planes[p][x] = pixels[x * channels + p];
            }
        }
        m_to_linear(planes, width);
        if (m_planes == 3) {
            convert_to_opponent(planes, width);
        }
        for (std::size_t p = 0; p < m_planes; ++p) {
            std::fill(m_source[p].begin(), m_source[p].begin() + m_pad, planes[p][0]);
            std::fill(m_source[p].begin() + m_pad + static_cast<std::ptrdiff_t>(width),
                      m_source[p].end(), planes[p][width - 1]);
        }
    }

    void filter_x(FilterKind kind, const HalfFilter& filter, std::size_t source, Plane plane,
                  int row) {
        const float* centre = m_source[source].data() + m_pad;
        for (int k = -filter.radius(); k <= filter.radius(); ++k) {
            m_taps[static_cast<std::size_t>(k + m_pad)] = centre + k;
        }
        filter_row(kind, filter, m_taps.data() + m_pad, m_width, false, m_rings[plane].slot(row));
    }

    void filter_y(FilterKind kind, const HalfFilter& filter, Plane plane, int y,
                  std::vector<float>& out, bool add = false) {
        filter_row(kind, filter, m_rings[plane].find_taps(y, m_image.height(), filter.radius()),
                   m_width, add, out.data());
    }

    const Image& m_image;
    const FlipFilters& m_filters;
    const ToLinear& m_to_linear;
    std::size_t m_planes;
    std::size_t m_width; ///< whole blocks
    int m_pad;
    std::array<std::vector<float>, 3> m_source;
    std::vector<RowRing> m_rings;
    std::vector<const float*> m_taps;
    std::array<std::vector<float>, 3> m_lab;
    std::vector<float> m_edge;
    std::vector<float> m_point;
    std::vector<float> m_x;
    std::vector<float> m_y;
};

/// The colour error raised to 1 - the feature error (equations 7 and 8; q_f = 0.5).
ALCOVE_CLONES void combine(const float* colour, const float* edge_a, const float* edge_b,
                           const float* point_a, const float* point_b, std::size_t count,
                           float* __restrict out) {
    constexpr float kHalfRoot = 0.70710678f; // 1 / sqrt(2)
    for (std::size_t i = 0; i < count; ++i) {
        const float edge = std::abs(edge_a[i] - edge_b[i]);
        const float point = std::abs(point_a[i] - point_b[i]);
        const float feature = std::sqrt(kHalfRoot * (edge > point ? edge : point));
        const float left = feature > 1.0f ? 0.0f : 1.0f - feature;
        const float error = compute_pow(colour[i], left);
        out[i] = error > 1.0f ? 1.0f : error;
    }
}

} // namespace

Image compute_flip_map(const Image& test, const Image& reference, double pixels_per_degree,
                       const ToLinear& to_linear) {
    ALCOVE_ASSERT(test.size() == reference.size() && test.channels() == reference.channels(),
                  "a pair");
    const FlipFilters filters = make_flip_filters(pixels_per_degree);
    Image map(test.size(), 1);
    for_row_bands(test.height(), [&](int begin, int end) {
        FilteredImage a(test, filters, to_linear);
        FilteredImage b(reference, filters, to_linear);
        std::vector<float> colour(a.width());
        std::vector<float> error(a.width());
        int taken = std::max(0, begin - a.reach());
        for (int y = begin; y < end; ++y) {
            for (; taken <= std::min(y + a.reach(), test.height() - 1); ++taken) {
                a.take_row(taken);
                b.take_row(taken);
            }
            a.compute_row(y);
            b.compute_row(y);
            compute_colour_error(a.lab(), b.lab(), a.planes(), a.width(), colour.data());
            combine(colour.data(), a.edge(), b.edge(), a.point(), b.point(), a.width(),
                    error.data());
            std::copy_n(error.begin(), test.width(),
                        map.values().begin() + static_cast<std::ptrdiff_t>(y) * test.width());
        }
    });
    return map;
}

} // namespace alcove
