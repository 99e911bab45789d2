#pragma once
// Which cells of a round need a capture replay, and which an earlier run has captured already.

#include "harness/run/capture_store.hpp"
#include "harness/run/round_stage.hpp"

#include <filesystem>
#include <vector>

namespace alcove {

class RoundReuse {
  public:
    /// Looks every cell of the round up, and the reference's pictures. Everything passed by
    /// reference must outlive this.
    RoundReuse(RoundStage& stage, std::filesystem::path run_folder);

    /// Does the capture replay take this cell's images? Asked with a cell's id, or "reference".
    [[nodiscard]] bool is_wanted(const std::string& cell) const;
    [[nodiscard]] bool is_anything_wanted() const;

    /// After the capture: compares what the audit drew, leaves what was made in the cache, puts the
    /// rows and pictures of the rest into the run, and writes down why. Throws FailureError if an
    /// audited capture differs.
    void finish(std::vector<MetricRow>& rows, RoundDone& done);

  private:
    enum class Outcome { reused, made, audited };
    struct Item {
        std::string cell;
        CaptureIngredients ingredients;
        Outcome outcome = Outcome::made;
        std::string reason;
        std::vector<MetricRow> restored;
    };

    void add(const std::string& cell, CaptureIngredients ingredients);
    [[nodiscard]] CaptureIngredients describe_round() const;
    [[nodiscard]] CaptureIngredients describe_cell(const CellRecord& cell) const;
    [[nodiscard]] std::filesystem::path get_pictures(const std::string& cell) const;
    /// As a replay of all cells leaves them, whatever came from the cache.
    void sort_rows(std::vector<MetricRow>& rows) const;
    [[nodiscard]] std::string explain(const CaptureIngredients& ingredients) const;

    RoundStage& m_stage;
    std::filesystem::path m_run_folder;
    CaptureStore m_store;
    Audit m_audit;
    std::vector<Item> m_items;
};

} // namespace alcove
