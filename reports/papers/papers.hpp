#pragma once
// The papers that can be reproduced: one line each.

#include "reports/analysis/reproduction.hpp"
#include "reports/papers/evidence.hpp"

#include <span>
#include <string>

namespace alcove {

struct Paper {
    const char* name; ///< of the folder with its experiments, and on the command line
    Reproduction (*reproduce)(const Evidence& evidence, const std::string& scale);
};

[[nodiscard]] std::span<const Paper> list_papers();

} // namespace alcove
