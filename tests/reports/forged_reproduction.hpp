#pragma once
// Runs of a paper's experiments without a renderer: times and errors are planted by cell.

#include "reports/analysis/reproduction.hpp"
#include "reports/papers/evidence.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <map>
#include <string>
#include <vector>

namespace alcove {

/// Keys are a cell's label, or, before it, "part:round:label".
struct Planted {
    std::map<std::string, double> cost_ms;         ///< in equal passes; 4 ms where not named
    std::map<std::string, double> error;           ///< of every metric; 0.05 where not named
    std::map<std::string, std::string> image_hash; ///< empty where not named
};

/// Evidence of all experiments of `paper`, with the passes of its cells. Times and errors scatter
/// by a tenth of a percent, so that intervals have a width; a base G-buffer takes 10 ms, compose
/// none.
class ForgedRuns {
  public:
    ForgedRuns(const std::string& paper, std::vector<std::string> passes);
    [[nodiscard]] Evidence forge(const Planted& planted);

  private:
    [[nodiscard]] std::vector<SampleRow> forge_samples(const PlanRecord& plan, std::size_t round,
                                                       const Planted& planted) const;

    std::vector<std::string> m_passes;
    std::map<std::string, PlanRecord> m_plans; ///< by part
    TemporaryFolder m_folder;
    int m_runs = 0;
};

/// Records a failure if there is no such claim.
[[nodiscard]] Outcome find_outcome(const Reproduction& reproduction, const std::string& id);

} // namespace alcove
