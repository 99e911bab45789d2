// This work is based on: CIE. Colorimetry, 4th edition. CIE 15, 2018, section 8.2.1 (CIELAB 1976).
#include "metrics/chroma_error/chroma_error.hpp"

#include "metrics/common/flip_colour.hpp"
#include "metrics/common/pooled_region.hpp"
#include "metrics/common/row_bands.hpp"
#include "metrics/common/test_images.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

/// a* and b* of a row of sRGB codes.
class ChromaRow {
  public:
    explicit ChromaRow(int width) {
        for (std::vector<float>& plane : m_planes) {
            plane.resize(static_cast<std::size_t>(width));
        }
    }

    void load(const Image& codes, int y) {
        const std::array<float*, 3> planes{m_planes[0].data(), m_planes[1].data(),
                                           m_planes[2].data()};
        for (int x = 0; x < codes.width(); ++x) {
            for (std::size_t c = 0; c < planes.size(); ++c) {
                planes.at(c)[x] = codes.at(x, y, static_cast<int>(c));
            }
        }
        for (float* plane : planes) {
            decode_codes(plane, m_planes[0].size());
        }
        convert_to_lab(planes, m_planes[0].size());
    }
    [[nodiscard]] float a(std::size_t x) const { return m_planes[1][x]; }
    [[nodiscard]] float b(std::size_t x) const { return m_planes[2][x]; }

  private:
    std::array<std::vector<float>, 3> m_planes;
};

Image map_distances(const Image& test, const Image& reference) {
    Image map(test.size(), 1);
    for_row_bands(test.height(), [&](int begin, int end) {
        ChromaRow first(test.width());
        ChromaRow second(test.width());
        for (int y = begin; y < end; ++y) {
            first.load(test, y);
            second.load(reference, y);
            for (int x = 0; x < test.width(); ++x) {
                const auto i = static_cast<std::size_t>(x);
                map.at(x, y) = std::hypot(first.a(i) - second.a(i), first.b(i) - second.b(i));
            }
        }
    });
    return map;
}

class ChromaError final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "chroma_error");
        const PooledRegion region(input.mask, input.test.size());
        MetricResult result;
        region.report(result);
        if (input.test.channels() < 3) {
            result.undefined_reason = "images of one channel have no chroma";
            return result;
        }
        result.map = map_distances(input.test, input.reference);
        if (region.count() == 0) {
            return result;
        }
        result.value = region.compute_mean(*result.map);
        if (input.reference_a != nullptr) {
            result.floor =
                0.5 * region.compute_mean(map_distances(*input.reference_a, *input.reference_b));
        }
        return result;
    }
};

/// Patches of colours whose linear channels lie between 0.2 and 0.6.
Image make_patches(ImageSize size) {
    Image image(size, 3);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                image.at(x, y, c) =
                    0.2f + 0.1f * static_cast<float>((x / 4 + (c + 1) * (y / 4)) % 5);
            }
        }
    }
    return image;
}

/// Redder by `amount` and less blue by as much.
Image turn_red(const Image& reference, float amount) {
    Image image = reference;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            image.at(x, y, 0) += amount;
            image.at(x, y, 2) -= amount;
        }
    }
    return image;
}

} // namespace

MetricUnit chroma_error_unit() {
    MetricUnit unit;
    unit.name = "chroma_error";
    unit.title = "Chroma error (CIELAB a*, b*)";
    unit.unit = "CIELAB";
    unit.definition =
        "Mean over pixels of sqrt(da^2 + db^2), the distance from the reference in the chroma "
        "plane "
        "of CIELAB under D65 (CIE 15), of the encoded view, decoded to light: 2.3 is a difference "
        "that is just seen side by side. With two halves A, B of the reference: floor = the same "
        "between A and B, halved. Undefined of one channel.";
    unit.blind_to =
        "lightness: any grey against any other scores 0. And where colours are wrong. Chroma "
        "shrinks with light, so that what is too dark is also less colourful.";
    unit.domain = MetricDomain::view;
    unit.on_demand = true;
    unit.is_of_pictures = true;
    unit.needs_colour = true;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("chroma_error", {});
    unit.canary = MetricCanary{make_patches, turn_red};
    // By hand: a* = 500 (f(X / Xn) - f(Y)), b* = 200 (f(Y) - f(Z / Zn)), f the cube root; of
    // primaries that are the column sums of the matrix from linear sRGB.
    unit.checks = {
        {"red against grey", [] { return make_colour(255, 0, 0); },
         [] { return make_colour(119, 119, 119); }, 104.5508, 0.01,
         "by hand: red is (80.09, 67.20)"},
        {"green against blue", [] { return make_colour(0, 255, 0); },
         [] { return make_colour(0, 0, 255); }, 252.6752, 0.02,
         "by hand: green is (-86.18, 83.18), blue (79.19, -107.86)"},
        {"black against white", [] { return make_colour(0, 0, 0); },
         [] { return make_colour(255, 255, 255); }, 0.0, 1e-3, "by definition: both are grey"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<ChromaError>(); };
    return unit;
}

} // namespace alcove
