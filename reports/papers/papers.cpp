#include "reports/papers/papers.hpp"

#include "reports/papers/tssao/tssao.hpp"

#include <array>

namespace alcove {

std::span<const Paper> list_papers() {
    static constexpr std::array kPapers{
        Paper{"tssao", reproduce_tssao},
    };
    return kPapers;
}

} // namespace alcove
