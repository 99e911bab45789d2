#pragma once
// What the runs of a reproduction say, by part (the experiment's name), round (in the plan's order)
// and cell (its label).

#include "core/base/statistics.hpp"
#include "reports/analysis/cell_series.hpp"
#include "reports/record/record.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

/// Addresses one cell. Rounds count as in the experiment: scenes, then targets, sizes, precisions.
struct CellAddress {
    std::string part;
    std::size_t round = 0;
    std::string label;
};

class Evidence {
  public:
    /// Reads a finished run; throws InputError as RunFolder's readers do.
    void add(const std::string& part, const RunFolder& run);

    [[nodiscard]] const ContextRecord& context() const { return m_context.value(); }
    [[nodiscard]] const RoundRecord& get_round(const std::string& part, std::size_t round) const;
    [[nodiscard]] const CellRecord& get_cell(const CellAddress& address) const;
    [[nodiscard]] std::string find_parameter(const CellAddress& address,
                                             const std::string& parameter) const;

    /// By repeat, medians over frames in milliseconds: passes and what their inputs cost; that and
    /// base G-buffer and compose, the whole frame.
    [[nodiscard]] std::map<int, double> get_cost_ms(const CellAddress& address) const;
    [[nodiscard]] std::map<int, double> get_frame_ms(const CellAddress& address) const;
    /// By repeat, the sum of some passes' medians over frames, in milliseconds. Throws InputError
    /// if the cell has no such pass.
    [[nodiscard]] std::map<int, double> get_passes_ms(const CellAddress& address,
                                                      const std::vector<std::string>& passes) const;
    /// What a pass fetches a pixel; nothing unless the part's run counted it.
    [[nodiscard]] std::optional<double> find_fetches(const CellAddress& address,
                                                     const std::string& pass) const;
    /// By frame, the median over repeats of passes and input.
    [[nodiscard]] std::vector<double> get_frame_costs_ms(const CellAddress& address) const;

    /// a / b repeat by repeat; both of one round, so that drift falls on both.
    [[nodiscard]] Estimate compare_costs(const CellAddress& a, const CellAddress& b) const;
    [[nodiscard]] Estimate compare_frames(const CellAddress& a, const CellAddress& b) const;
    /// Of some passes alone.
    [[nodiscard]] Estimate compare_passes(const CellAddress& a,
                                          const std::vector<std::string>& passes_of_a,
                                          const CellAddress& b,
                                          const std::vector<std::string>& passes_of_b) const;
    /// Passes of converged frames over the other's passes of the same frames.
    [[nodiscard]] Estimate compare_converged(const CellAddress& a, const CellAddress& b) const;
    /// The compare functions also take cells of two rounds: by their milliseconds then, in runs one
    /// after the other.

    /// Values of a metric by frame, debiased where that exists.
    [[nodiscard]] std::vector<double>
    get_values(const CellAddress& address, const std::string& metric, SampleState state) const;
    /// a - b frame by frame, and its mean over frames.
    [[nodiscard]] Estimate compare_metric(const CellAddress& a, const CellAddress& b,
                                          const std::string& metric, SampleState state) const;
    /// Of the cell's visibility in a frame that any metric was measured on.
    [[nodiscard]] std::string find_image_hash(const CellAddress& address, int frame) const;
    /// Mean over frames.
    [[nodiscard]] Estimate estimate_metric(const CellAddress& address, const std::string& metric,
                                           SampleState state) const;

  private:
    struct Part {
        PlanRecord plan;
        std::vector<RoundSeries> series;               ///< in the plan's order
        std::vector<std::vector<FetchRecord>> fetches; ///< likewise
        std::vector<MetricRow> metrics;
    };

    [[nodiscard]] const Part& get_part(const std::string& part) const;
    [[nodiscard]] const CellSeries* find_series(const CellAddress& address) const;

    std::map<std::string, Part> m_parts;
    std::optional<ContextRecord> m_context;
};

} // namespace alcove
