#pragma once
// Metrics over several pairs of images: means, and why there is none.

#include "harness/app/pair_scoring.hpp"

#include <optional>
#include <string>
#include <vector>

namespace alcove {

struct MetricMean {
    std::string name; ///< a metric's, or `metric.extra`
    std::string unit;
    bool is_extra = false;
    std::size_t pairs = 0;  ///< that there are
    std::size_t values = 0; ///< that have one
    double sum = 0.0;
    double smallest = 0.0;
    double largest = 0.0;
    std::string reason; ///< of the last pair without a value

    /// Nothing where a pair has no value.
    [[nodiscard]] std::optional<double> mean() const;
    /// Of all pairs without a value: why, and how many they are where there are several pairs.
    [[nodiscard]] std::string describe_lack() const;
};

class MetricMeans {
  public:
    /// `pair` names the pair in reasons.
    void add(const std::vector<PairScore>& scores, const std::string& pair);
    /// In the order of the first pair, each metric's extras behind it.
    [[nodiscard]] std::vector<MetricMean> list() const;
    /// Nothing where no pair gave that name.
    [[nodiscard]] std::optional<MetricMean> find(const std::string& name) const;

  private:
    void add_value(const std::string& name, const std::string& unit, bool is_extra,
                   std::optional<double> value, const std::string& reason);

    std::vector<MetricMean> m_means;
    std::size_t m_pairs = 0;
};

} // namespace alcove
