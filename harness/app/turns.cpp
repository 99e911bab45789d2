#include "harness/app/turns.hpp"

#include "core/base/error.hpp"

#include <cstdio>
#include <iostream>

namespace alcove {

void Turns::take(const std::string& what) const {
    if (!m_is_on) {
        return;
    }
    std::printf("%s%s\n", std::string(kTurnPrefix).c_str(), what.c_str());
    std::fflush(stdout);
    std::string answer;
    if (!std::getline(std::cin, answer)) {
        throw FailureError("--turns", "standard input ended before the turn", what, "a line `go`");
    }
    if (answer + "\n" != kGoLine) {
        throw FailureError("--turns", "unknown answer", answer, "`go`");
    }
}

} // namespace alcove
