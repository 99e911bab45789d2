#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/cache_check.hpp"

#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

struct CacheFlags {
    std::string what;
    std::string limit;
};

/// "8GiB", "500MiB", "0": bytes. Throws InputError.
std::uintmax_t parse_bytes(const std::string& text) {
    static const std::map<std::string, int> kShifts{{"", 0}, {"KiB", 10}, {"MiB", 20}, {"GiB", 30}};
    const std::size_t digits = text.find_first_not_of("0123456789");
    const std::string unit = digits == std::string::npos ? "" : text.substr(digits);
    constexpr std::int64_t kMost = std::int64_t{1} << 33; // 8 EiB in GiB
    if (!kShifts.contains(unit) || digits == 0 || text.empty()) {
        throw InputError("--limit", "not a size", text, "a whole number of bytes, KiB, MiB or GiB");
    }
    const std::int64_t number = parse_integer(text.substr(0, digits), "--limit");
    if (number >= kMost) {
        throw InputError("--limit", "out of range", text, "less than 8 EiB");
    }
    return static_cast<std::uintmax_t>(number) << kShifts.at(unit);
}

std::string describe_bytes(std::uintmax_t bytes) {
    return bytes < (1u << 20) ? fmt::format("{:.1f} KiB", static_cast<double>(bytes) / (1u << 10))
                              : fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1u << 20));
}

void print_size(const std::filesystem::path& folder) {
    std::map<std::string, std::pair<std::size_t, std::uintmax_t>> kinds;
    std::uintmax_t total = 0;
    for (const CacheEntry& entry : list_cache(folder)) {
        auto& [count, bytes] = kinds[entry.kind];
        ++count;
        bytes += entry.bytes;
        total += entry.bytes;
    }
    for (const std::string& kind : list_cache_kinds()) {
        const auto& [count, bytes] = kinds[kind];
        fmt::print("{:<12} {:>8} entries {:>14}\n", kind, count, describe_bytes(bytes));
    }
    fmt::print("{:<12} {:>25} of {}\n", "all", describe_bytes(total),
               describe_bytes(kCacheLimitBytes));
}

int verify(const std::filesystem::path& folder) {
    const CacheCheck check = check_cache(folder);
    for (const std::filesystem::path& path : check.damaged) {
        fmt::print("damaged, removed: {}\n", path.string());
    }
    fmt::print("{} entries are as they were written, {} were damaged\n", check.intact,
               check.damaged.size());
    return check.damaged.empty() ? 0 : 1;
}

int run_cache(const CacheFlags& flags) {
    const std::filesystem::path folder = get_cache_folder();
    const std::vector<std::string> choices{"path", "size", "verify", "prune"};
    if (!flags.limit.empty() && flags.what != "prune") {
        throw InputError("--limit", "belongs to `cache prune`");
    }
    if (flags.what == "path") {
        fmt::print("{}\n", folder.string());
        return 0;
    }
    if (flags.what == "size") {
        print_size(folder);
        return 0;
    }
    if (flags.what == "verify") {
        return verify(folder);
    }
    if (flags.what == "prune") {
        const std::uintmax_t limit =
            flags.limit.empty() ? kCacheLimitBytes : parse_bytes(flags.limit);
        fmt::print("removed {}\n", describe_bytes(prune_cache(folder, limit)));
        return 0;
    }
    throw InputError("cache", "unknown choice", flags.what, describe_choices(flags.what, choices));
}

} // namespace

Action add_cache_verb(CLI::App& app) {
    auto flags = std::make_shared<CacheFlags>();
    app.add_option("what", flags->what, "path | size | verify (removes what is damaged) | prune")
        ->required();
    app.add_option("--limit", flags->limit, "prune: to this size, e.g. 2GiB; default 8GiB");
    return [flags] { return run_cache(*flags); };
}

} // namespace alcove
