#include "core/base/monotone_curve.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {

double MonotoneCurve::evaluate(double at) const {
    ALCOVE_ASSERT(!x.empty() && x.size() == y.size(), "a curve with points");
    const auto above = std::upper_bound(x.begin(), x.end(), at);
    if (above == x.begin()) {
        return y.front();
    }
    if (above == x.end()) {
        return y.back();
    }
    const auto i = static_cast<std::size_t>(above - x.begin());
    const double share = (at - x[i - 1]) / (x[i] - x[i - 1]);
    return y[i - 1] + share * (y[i] - y[i - 1]);
}

std::vector<double> fit_isotonic(std::span<const double> values, std::span<const double> weights) {
    ALCOVE_ASSERT(values.size() == weights.size(), "a weight for each value");
    struct Block {
        double mean;
        double weight;
        std::size_t size;
    };
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < values.size(); ++i) {
        ALCOVE_ASSERT(weights[i] > 0.0, "weights above 0");
        blocks.push_back({values[i], weights[i], 1});
        while (blocks.size() > 1 && blocks[blocks.size() - 2].mean >= blocks.back().mean) {
            const Block last = blocks.back();
            blocks.pop_back();
            Block& pool = blocks.back();
            const double weight = pool.weight + last.weight;
            pool.mean = (pool.mean * pool.weight + last.mean * last.weight) / weight;
            pool.weight = weight;
            pool.size += last.size;
        }
    }
    std::vector<double> fitted;
    for (const Block& block : blocks) {
        fitted.insert(fitted.end(), block.size, block.mean);
    }
    return fitted;
}

CurveMoments::CurveMoments() : m_bins(static_cast<std::size_t>(kBins)) {}

void CurveMoments::add(std::span<const float> x, std::span<const float> y) {
    ALCOVE_ASSERT(x.size() == y.size(), "pairs");
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double from = std::clamp(static_cast<double>(x[i]), 0.0, 1.0);
        const double to = y[i];
        const auto index =
            static_cast<std::size_t>(std::min(static_cast<int>(from * kBins), kBins - 1));
        Bin& bin = m_bins[index];
        bin.count += 1.0;
        bin.x += from;
        bin.y += to;
        bin.y_squared += to * to;
        m_squares += (to - from) * (to - from);
    }
    m_count += static_cast<double>(x.size());
}

void CurveMoments::add(const CurveMoments& other) {
    for (std::size_t i = 0; i < m_bins.size(); ++i) {
        m_bins[i].count += other.m_bins[i].count;
        m_bins[i].x += other.m_bins[i].x;
        m_bins[i].y += other.m_bins[i].y;
        m_bins[i].y_squared += other.m_bins[i].y_squared;
    }
    m_count += other.m_count;
    m_squares += other.m_squares;
}

MonotoneCurve CurveMoments::fit() const {
    ALCOVE_ASSERT(m_count > 0.0, "pairs to fit");
    MonotoneCurve curve;
    std::vector<double> means;
    std::vector<double> weights;
    for (const Bin& bin : m_bins) {
        if (bin.count > 0.0) {
            curve.x.push_back(bin.x / bin.count);
            means.push_back(bin.y / bin.count);
            weights.push_back(bin.count);
        }
    }
    curve.y = fit_isotonic(means, weights);
    return curve;
}

double CurveMoments::compute_mse(const MonotoneCurve& curve) const {
    ALCOVE_ASSERT(m_count > 0.0, "pairs to judge");
    double sum = 0.0;
    for (const Bin& bin : m_bins) {
        if (bin.count > 0.0) {
            const double value = curve.evaluate(bin.x / bin.count);
            sum += bin.y_squared - 2.0 * value * bin.y + bin.count * value * value;
        }
    }
    return std::max(0.0, sum / m_count);
}

double CurveMoments::compute_mse() const {
    ALCOVE_ASSERT(m_count > 0.0, "pairs to judge");
    return m_squares / m_count;
}

} // namespace alcove
