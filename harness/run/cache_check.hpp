#pragma once
// Reads the whole cache and says what is not as it was written.

#include "harness/run/cache.hpp"

namespace alcove {

struct CacheCheck {
    std::size_t intact = 0;
    std::vector<std::filesystem::path> damaged; ///< removed
};

/// Builds of `ab` are taken as they are. What is damaged is removed: it would be made anew anyway.
[[nodiscard]] CacheCheck check_cache(const std::filesystem::path& folder);

} // namespace alcove
