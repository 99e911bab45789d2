#include "reports/papers/papers.hpp"

#include "reports/papers/artifacts/artifacts.hpp"
#include "reports/papers/shanmugam_arikan/shanmugam_arikan.hpp"
#include "reports/papers/ssdo/ssdo.hpp"
#include "reports/papers/statvo/statvo.hpp"
#include "reports/papers/tssao/tssao.hpp"

#include <array>

namespace alcove {

std::span<const Paper> list_papers() {
    static constexpr std::array kPapers{
        Paper{"tssao", reproduce_tssao},
        Paper{"statvo", reproduce_statvo},
        Paper{"shanmugam_arikan", reproduce_shanmugam_arikan},
        Paper{"ssdo", reproduce_ssdo},
        Paper{"artifacts", reproduce_artifacts},
    };
    return kPapers;
}

} // namespace alcove
