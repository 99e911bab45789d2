#include "reports/papers/judge.hpp"

#include "core/base/assert.hpp"

namespace alcove {

void Judge::set(const std::string& id, Finding finding) {
    const bool is_new = m_findings.emplace(id, std::move(finding)).second;
    ALCOVE_ASSERT(is_new, "one finding a claim");
}

void Judge::set_untestable(const std::vector<std::string>& ids, const std::string& reason) {
    for (const std::string& id : ids) {
        set(id, {Outcome::not_testable, "", std::nullopt, reason});
    }
}

std::vector<ClaimVerdict> Judge::finish(const std::vector<Claim>& claims) const {
    std::vector<ClaimVerdict> verdicts;
    for (const Claim& claim : claims) {
        const auto found = m_findings.find(claim.id);
        ALCOVE_ASSERT(found != m_findings.end(), "a finding for every claim");
        const Finding& finding = found->second;
        verdicts.push_back({claim, finding.outcome, finding.tested, finding.measured, finding.why});
    }
    ALCOVE_ASSERT(verdicts.size() == m_findings.size(), "findings of known claims alone");
    return verdicts;
}

} // namespace alcove
