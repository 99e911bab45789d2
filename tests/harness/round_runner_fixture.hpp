#pragma once
// A tiny round over the template scene, with a cut inside its burst and a method that counts.

#include "harness/run/round_runner.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/harness/history_method.hpp"
#include "tests/harness/light_method.hpp"
#include "tests/harness/parts_method.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

/// Frame 2 is a cut; frames 0 to 3 are a burst, 10, 20 and 30 singles.
inline constexpr int kCutFrame = 2;
inline constexpr int kRoundFrames = 7;

class RoundRunnerTest : public GlTest {
  protected:
    RoundRunnerTest();

    /// Plans and runs one round. The log is that of this run alone.
    void run(const std::vector<std::string>& methods, int repeats = 2, std::uint64_t seed = 1,
             const RoundEvents& events = {});

    [[nodiscard]] const RoundRecord& round() const { return m_plan.rounds.at(0); }
    /// The i-th method's cell, behind the two anchors.
    [[nodiscard]] const CellRecord& cell(std::size_t method) const {
        return round().cells.at(2 + method);
    }
    [[nodiscard]] std::vector<SampleRow> find_samples(const std::string& cell_id,
                                                      SampleState state) const;
    [[nodiscard]] const std::vector<HistoryEntry>& log() const { return m_log->entries; }
    [[nodiscard]] const PartsLog& parts_log() const { return *m_parts; }
    [[nodiscard]] const LightLog& light_log() const { return *m_light; }

    /// Set before run(): over the scene's default target.
    std::string m_target;
    /// Set before run(): objects that are strata of their own.
    std::vector<std::string> m_regions;
    /// Set before run(): what is measured against, instead of traced rays.
    std::string m_reference;
    /// Set before run(): what an earlier run of the test left in the cache is there. Otherwise only
    /// references are.
    bool m_keeps_cache = false;
    /// Set before run(): of what the cache gives, made again and compared.
    double m_audit_share = 0.0;
    /// Set before run(): errors of the singles are taken apart.
    bool m_explains_errors = false;
    /// Set before run(): fetches of every pass are counted.
    bool m_counts_fetches = false;
    /// Set before run(): image metrics also over strata.
    bool m_measures_strata = false;
    /// Set before run(): repeats go on until every interval is this narrow.
    std::optional<double> m_until_width;
    /// Set before run(): the burst is kept as a film.
    bool m_films_burst = false;

    TemporaryFolder m_folder;
    ScopedVariable m_cache;
    std::shared_ptr<HistoryLog> m_log;
    std::shared_ptr<PartsLog> m_parts = std::make_shared<PartsLog>();
    std::shared_ptr<LightLog> m_light = std::make_shared<LightLog>();
    std::unique_ptr<Scene> m_scene;
    PlanRecord m_plan;
    RoundResult m_result;
};

} // namespace alcove
