#pragma once
// One page over the reproductions of several papers: what each says of its claims, with a link to
// its own page. One file, no script.

#include "reports/analysis/reproduction.hpp"

#include <span>
#include <string>

namespace alcove {

struct IndexedReproduction {
    std::string folder; ///< beside the page, with the reproduction's index.html
    Reproduction reproduction;
};

[[nodiscard]] std::string make_reproduction_index(std::span<const IndexedReproduction> papers);

} // namespace alcove
