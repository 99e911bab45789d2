#include "reports/analysis/reproduction.hpp"

#include <algorithm>
#include <array>

namespace alcove {

std::string_view to_text(Outcome outcome) {
    constexpr std::array<std::string_view, 4> kTexts{"holds", "fails", "inconclusive",
                                                     "not testable here"};
    return kTexts.at(static_cast<std::size_t>(outcome));
}

std::vector<OutcomeCount> count_outcomes(const std::vector<ClaimVerdict>& verdicts) {
    std::vector<OutcomeCount> counts;
    for (const Outcome outcome :
         {Outcome::holds, Outcome::fails, Outcome::inconclusive, Outcome::not_testable}) {
        const auto claims =
            std::count_if(verdicts.begin(), verdicts.end(), [outcome](const ClaimVerdict& verdict) {
                return verdict.outcome == outcome;
            });
        counts.push_back({outcome, static_cast<std::size_t>(claims)});
    }
    return counts;
}

std::string describe_counts(const Reproduction& reproduction) {
    std::string text;
    for (const OutcomeCount& count : count_outcomes(reproduction.verdicts)) {
        text += text.empty() ? "" : ", ";
        text += std::to_string(count.claims) + " " + std::string(to_text(count.outcome));
    }
    return text;
}

} // namespace alcove
