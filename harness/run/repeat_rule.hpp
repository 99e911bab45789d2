#pragma once
// When the timing replays of a round end: after a number that was planned, or once every interval
// is narrow enough.
//
// An interval that is looked at after every repeat, until it is narrow, is narrow by luck too
// often: it holds the truth in 93 % of cases where 95 % is said. So it is looked at after 12
// repeats (or more, if more are asked for) and then only when their number has doubled, which costs
// about 1 % (tests/core/base/coverage_test.cpp; reports/README.md has the table).

#include "reports/record/record.hpp"

#include <vector>

namespace alcove {

/// The first look of a round that stops by width.
inline constexpr int kFirstLook = 12;
/// What most_repeats is unless asked for.
inline constexpr int kDefaultMostRepeats = 192;

/// What a round knows when a repeat has ended.
class RepeatRule {
  public:
    /// Both must outlive the rule.
    RepeatRule(const PlanRecord& plan, const RoundRecord& round) : m_plan(plan), m_round(round) {}

    /// How many repeats there will be for sure or until the next look, whichever is less far:
    /// `taken` of them are done.
    [[nodiscard]] int find_next_look(int taken) const;
    /// Whether the round has enough repeats, with the reason in `record`. `timed_s` is the wall
    /// time of its timing replays so far.
    [[nodiscard]] bool is_enough(int taken, double timed_s, const std::vector<SampleRow>& samples,
                                 RepeatsRecord& record) const;

  private:
    const PlanRecord& m_plan;
    const RoundRecord& m_round;
};

/// The largest relative half-width of any cell's ratio to the anchor, cold envelopes, and whose it
/// is; leaves both empty where a cell has fewer than 5 repeats. The second anchor counts as a cell.
void find_widest(const RoundRecord& round, const std::vector<SampleRow>& samples,
                 RepeatsRecord& record);

} // namespace alcove
