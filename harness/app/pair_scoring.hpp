#pragma once
// The scoring of one pair of image files, for `metric` and `score`: metrics of ours by their
// specifications, and programs of others.

#include "core/base/domain.hpp"
#include "core/contract/metric.hpp"
#include "harness/run/external_metric.hpp"
#include "harness/run/metric_spec.hpp"

#include <memory>
#include <set>

namespace alcove {

/// A metric as it was named: one of ours, or a program.
struct ChosenMetric {
    std::string name;
    std::optional<ResolvedMetric> ours;
    std::optional<ExternalMetric> program;
};

/// Resolves each name. Throws InputError naming `where` on an unknown or repeated one, and on
/// metrics over time: images alone do not say what moved where.
[[nodiscard]] std::vector<ChosenMetric> choose_metrics(const Registry<MetricUnit>& registry,
                                                       const std::vector<std::string>& names,
                                                       std::string_view where);

/// The reported metrics of images: what is measured where none is named.
[[nodiscard]] std::vector<std::string> list_image_metrics(const Registry<MetricUnit>& registry);

struct ScoringOptions {
    std::optional<Domain> domain;                    ///< of the files; nothing: what each says
    std::optional<Image> mask;                       ///< as MetricInput says
    std::optional<Image> depth;                      ///< as MetricInput says
    std::chrono::milliseconds program_time{600'000}; ///< of one call
};

/// What one metric says of one pair. `name` is the specification, or a program's key.
struct PairScore {
    std::string name;
    std::string unit;
    MetricResult result;
};

class PairScorer {
  public:
    /// `registry` must outlive it.
    PairScorer(const Registry<MetricUnit>& registry, std::vector<ChosenMetric> metrics,
               ScoringOptions options);

    /// In the order of the metrics. Files are read only if a metric of ours is among them. Throws
    /// InputError naming the file that is missing, cut, not finite or of another shape, and the
    /// program whose key is a name of ours or of another program; FailureError if a program fails.
    [[nodiscard]] std::vector<PairScore> score(const std::filesystem::path& test,
                                               const std::filesystem::path& reference) const;

  private:
    void score_ours(const std::filesystem::path& test, const std::filesystem::path& reference,
                    std::vector<PairScore>& scores) const;
    void check_key(const std::string& key, const ExternalMetric& program,
                   const std::vector<PairScore>& scores) const;

    std::vector<ChosenMetric> m_metrics;
    std::vector<std::unique_ptr<Metric>> m_instances; ///< one a metric; nothing for programs
    std::set<std::string> m_names;                    ///< of all units
    ScoringOptions m_options;
};

/// Reads a mask: 0 is ignored, anything else counted; of several channels any, alpha left out.
/// Throws InputError on NaN.
[[nodiscard]] Image read_mask(const std::filesystem::path& path);

/// Reads eye-linear depth in metres from a file's first channel; infinite on the background. Throws
/// InputError on NaN and on what is not positive.
[[nodiscard]] Image read_depth(const std::filesystem::path& path);

} // namespace alcove
