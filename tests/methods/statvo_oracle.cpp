#include "tests/methods/statvo_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Positions of f x f pixels added up, their number, and the layer they lie in.
struct Sample {
    int x = 0;
    int y = 0;
    glm::dvec3 sum{0.0};
    double count = 0.0;
    int layer = 0;
    bool is_near = false;
    [[nodiscard]] double depth() const { return -sum.z / count; }
};

struct Rectangle {
    glm::dvec2 low; ///< full-resolution pixels from the bottom left
    glm::dvec2 high;
    bool is_near = false;
};

struct LayerSum {
    glm::dvec3 sum{0.0};
    double count = 0.0;
    bool is_near = false; ///< to being empty
};

struct Layers {
    std::vector<LayerSum> sums;
    double flagged = 0.0; ///< samples that might lie in another layer
};

class Evaluator {
  public:
    Evaluator(const Image& depth, const Image& normal, const Image& hidden, const Camera& camera,
              const StatvoParams& params)
        : m_depth(depth), m_normal(normal), m_params(params),
          m_tangents(compute_tangents(camera, depth.size())), m_size(depth.width(), depth.height()),
          m_columns_and_rows(glm::ceil(m_size / double(params.downsample))) {
        add_samples(depth);
        if (params.source == StatvoSource::peeled) {
            add_samples(hidden);
        }
        if (params.layering == StatvoLayering::uniform) {
            assign_slices();
        } else {
            for (int level = 0; level < params.levels; ++level) {
                split_layers();
            }
        }
    }

    [[nodiscard]] StatvoPixel evaluate(int x, int row) const {
        StatvoPixel pixel;
        const double depth = static_cast<double>(m_depth.at(x, row));
        if (std::isinf(depth)) {
            return pixel;
        }
        const int y = m_depth.height() - 1 - row;
        const glm::dvec2 center(x + 0.5, y + 0.5);
        const glm::dvec3 p = reconstruct(center, depth);
        const glm::dvec3 n(m_normal.at(x, row, 0), m_normal.at(x, row, 1), m_normal.at(x, row, 2));
        const Rectangle box = make_box(center, depth);
        pixel.is_near = box.is_near;
        std::vector<Rectangle> regions{box};
        if (m_params.regions == StatvoRegions::four) {
            const glm::dvec2 middle(x, y);
            regions = {{box.low, middle},
                       {{middle.x, box.low.y}, {box.high.x, middle.y}},
                       {{box.low.x, middle.y}, {middle.x, box.high.y}},
                       {middle, box.high}};
        }
        double obscurance = 0.0;
        for (const Rectangle& region : regions) {
            obscurance += evaluate_region(p, n, region, pixel) / double(regions.size());
        }
        pixel.flagged_share /= double(regions.size());
        pixel.visibility = std::clamp(1.0 - m_params.strength * obscurance, 0.0, 1.0);
        return pixel;
    }

  private:
    [[nodiscard]] glm::dvec3 reconstruct(const glm::dvec2& pixel, double depth) const {
        return {(2.0 * pixel / m_size - 1.0) * m_tangents * depth, -depth};
    }

    void add_samples(const Image& depths) {
        const int f = m_params.downsample;
        for (int y = 0; y * f < depths.height(); ++y) {
            for (int x = 0; x * f < depths.width(); ++x) {
                Sample sample{x, y};
                for (int j = y * f; j < std::min((y + 1) * f, depths.height()); ++j) {
                    for (int i = x * f; i < std::min((x + 1) * f, depths.width()); ++i) {
                        const auto depth =
                            static_cast<double>(depths.at(i, depths.height() - 1 - j));
                        if (!std::isinf(depth)) {
                            sample.sum += reconstruct({i + 0.5, j + 0.5}, depth);
                            sample.count += 1.0;
                        }
                    }
                }
                m_samples.push_back(sample);
            }
        }
    }

    /// The pixels of a sample: the last of a row may hold fewer than f.
    [[nodiscard]] Rectangle get_extent(const Sample& sample) const {
        const glm::dvec2 low = glm::dvec2(sample.x, sample.y) * double(m_params.downsample);
        return {low, glm::min(low + double(m_params.downsample), m_size)};
    }

    [[nodiscard]] Rectangle make_box(const glm::dvec2& center, double depth) const {
        const glm::dvec2 pixels = m_params.radius * m_size / (2.0 * m_tangents * depth);
        Rectangle box{center, center};
        for (int axis = 0; axis < 2; ++axis) {
            const double whole = std::floor(pixels[axis] + 0.5);
            const double share = pixels[axis] + 0.5 - whole;
            box.is_near = box.is_near || share < kStatvoMargin || share > 1.0 - kStatvoMargin;
            const double half = std::max(1.0, whole) + 0.5;
            box.low[axis] = std::max(center[axis] - half, 0.0);
            box.high[axis] = std::min(center[axis] + half, m_size[axis]);
        }
        return box;
    }

    /// Those that the rectangle touches, of each depth layer of the frame.
    template <class Visit>
    void for_each_sample(const Rectangle& region, Visit visit) const {
        const glm::ivec2 first = glm::floor(region.low / double(m_params.downsample));
        const glm::ivec2 end = glm::min(
            glm::ivec2(glm::ceil(region.high / double(m_params.downsample))), m_columns_and_rows);
        const std::size_t plane =
            std::size_t(m_columns_and_rows.x) * std::size_t(m_columns_and_rows.y);
        for (std::size_t base = 0; base < m_samples.size(); base += plane) {
            for (int y = first.y; y < end.y; ++y) {
                for (int x = first.x; x < end.x; ++x) {
                    const Sample& sample =
                        m_samples[base + std::size_t(y * m_columns_and_rows.x + x)];
                    if (sample.count > 0.0) {
                        visit(sample);
                    }
                }
            }
        }
    }

    /// Samples that the rectangle's edges cut count by their share of area.
    [[nodiscard]] Layers add_layers(const Rectangle& region) const {
        const int count =
            m_params.layering == StatvoLayering::uniform ? m_params.slices : 1 << m_params.levels;
        Layers layers;
        layers.sums.resize(static_cast<std::size_t>(count));
        for_each_sample(region, [&](const Sample& sample) {
            const Rectangle extent = get_extent(sample);
            const glm::dvec2 common = glm::max(
                glm::min(extent.high, region.high) - glm::max(extent.low, region.low), 0.0);
            const glm::dvec2 whole = extent.high - extent.low;
            const double share = common.x * common.y / (whole.x * whole.y);
            LayerSum& layer = layers.sums.at(static_cast<std::size_t>(sample.layer));
            layer.sum += share * sample.sum;
            layer.count += share * sample.count;
            layers.flagged += sample.is_near ? share * sample.count : 0.0;
        });
        for (LayerSum& layer : layers.sums) {
            layer.is_near = std::abs(layer.count - 0.5) < kStatvoMargin;
        }
        return layers;
    }

    void split_layers() {
        std::vector<Sample> split = m_samples;
        for (Sample& sample : split) {
            if (sample.count == 0.0) {
                continue;
            }
            const Rectangle extent = get_extent(sample);
            const Rectangle box = make_box(0.5 * (extent.low + extent.high), sample.depth());
            const Layers layers = add_layers(box);
            const LayerSum& parent = layers.sums.at(static_cast<std::size_t>(sample.layer));
            const double mean = -parent.sum.z / parent.count;
            // Samples that might lie in another layer shift the mean: the margin grows by half
            // a metre for all of its share.
            const double margin = (kStatvoSumError + 0.5 * layers.flagged) / parent.count;
            sample.is_near = sample.is_near || parent.is_near || box.is_near ||
                             std::abs(sample.depth() - mean) < margin;
            const bool is_upper = parent.count >= 0.5 && sample.depth() < mean;
            sample.layer = 2 * sample.layer + (is_upper ? 0 : 1);
        }
        m_samples = std::move(split);
    }

    void assign_slices() {
        double nearest = INFINITY;
        double farthest = 0.0;
        std::vector<Sample*> filled;
        for (Sample& sample : m_samples) {
            if (sample.count > 0.0) {
                filled.push_back(&sample);
                nearest = std::min(nearest, sample.depth());
                farthest = std::max(farthest, sample.depth());
            }
        }
        for (Sample* const each : filled) {
            Sample& sample = *each;
            const double place =
                (sample.depth() - nearest) / (farthest - nearest) * m_params.slices;
            sample.layer = std::clamp(static_cast<int>(place), 0, m_params.slices - 1);
            const bool is_end = sample.depth() == nearest || sample.depth() == farthest;
            sample.is_near = !is_end && std::abs(place - std::round(place)) < kStatvoMargin;
        }
    }

    double evaluate_region(const glm::dvec3& p, const glm::dvec3& n, const Rectangle& region,
                           StatvoPixel& pixel) const {
        double occlusion = 0.0;
        double samples = 0.0;
        const Layers layers = add_layers(region);
        for (const LayerSum& layer : layers.sums) {
            pixel.is_near = pixel.is_near || layer.is_near;
            if (layer.count < 0.5) {
                continue;
            }
            const glm::dvec3 above = layer.sum / layer.count - p;
            const double lift = m_params.box == StatvoBox::centre ? 0.5 * m_params.height : 0.0;
            const double height = m_params.projection == StatvoProjection::normal
                                      ? glm::dot(above, n)
                                      : above.z + lift;
            occlusion += layer.count * compute_oracle_psi(height / m_params.height, m_params.drop);
            samples += layer.count;
        }
        pixel.flagged_share += samples > 0.0 ? layers.flagged / samples : 0.0;
        return samples > 0.0 ? occlusion / samples : 0.0;
    }

    const Image& m_depth;
    const Image& m_normal;
    StatvoParams m_params;
    glm::dvec2 m_tangents;
    glm::dvec2 m_size;
    glm::ivec2 m_columns_and_rows; ///< of samples
    std::vector<Sample> m_samples; ///< row by row, of the visible surfaces, then of the hidden
};

} // namespace

double compute_oracle_psi(double t, double drop) {
    if (t < 0.0) {
        return 0.0;
    }
    return t <= 1.0 ? t : std::max(0.0, 1.0 - drop * (t - 1.0));
}

std::vector<StatvoPixel> evaluate_statvo_oracle(const Image& depth, const Image& normal,
                                                const Image& hidden, const Camera& camera,
                                                const StatvoParams& params) {
    const Evaluator evaluator(depth, normal, hidden, camera, params);
    std::vector<StatvoPixel> pixels;
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            pixels.push_back(evaluator.evaluate(x, y));
        }
    }
    return pixels;
}

} // namespace alcove
