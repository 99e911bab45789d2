#pragma once
// How the claims of one paper are joined with what was found: a check a claim, given once by its
// id, and reasons for those that nothing here can test.

#include "reports/papers/verdict.hpp"

#include <map>
#include <string>
#include <vector>

namespace alcove {

/// What a check found.
struct Finding {
    Outcome outcome = Outcome::inconclusive;
    std::string tested;
    std::optional<Estimate> measured;
    std::string why;
};

class Judge {
  public:
    /// Asserts that the id is not given twice.
    void set(const std::string& id, Finding finding);
    /// Not testable here, for this reason.
    void set_untestable(const std::vector<std::string>& ids, const std::string& reason);

    /// One verdict a claim, in their order. Asserts that every claim has one and no other id was
    /// given.
    [[nodiscard]] std::vector<ClaimVerdict> finish(const std::vector<Claim>& claims) const;

  private:
    std::map<std::string, Finding> m_findings;
};

} // namespace alcove
