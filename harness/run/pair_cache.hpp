#pragma once
// Traced pairs of halves on disk, under keys that their makers hash.

#include "core/base/domain.hpp"
#include "harness/run/cache.hpp"
#include "methods/common/reference_pair.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace alcove {

class PairCache {
  public:
    /// `folder` is the cache.
    PairCache(std::filesystem::path folder, Audit audit)
        : m_folder(std::move(folder)), m_audit(audit) {}

    /// What the halves of a key are.
    struct Shape {
        ImageSize size;
        int channels = 1;
        Domain domain = Domain::visibility;
    };
    /// From the cache, or traced and put there. A cached file that cannot be read is traced anew.
    /// `was_cached` says which. What the audit draws is traced as well; throws FailureError naming
    /// the file if a bit differs. `trace` gives halves of that shape.
    [[nodiscard]] ReferencePair get(const std::string& key, const Shape& shape,
                                    const std::function<ReferencePair()>& trace, bool& was_cached);

    /// Can the file be read as a pair? Throws InputError if it is no image. For `cache verify`.
    [[nodiscard]] static bool is_intact(const std::filesystem::path& file);

    /// Pairs that the audit has traced and found equal.
    [[nodiscard]] std::size_t audited() const noexcept { return m_audited; }

  private:
    std::filesystem::path m_folder;
    Audit m_audit;
    std::size_t m_audited = 0;
};

} // namespace alcove
