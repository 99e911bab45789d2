#pragma once
// Somebody else's metric: a program that gets two paths and writes one JSON object.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// `exec:COMMAND`. The words of COMMAND, split at spaces, are the program and its first arguments;
/// no shell reads them.
struct ExternalMetric {
    std::string text; ///< as it was given
    std::filesystem::path program;
    std::vector<std::string> arguments;
};

/// A key of the program's object.
struct ExternalValue {
    std::string name;            ///< 1 to 64 of [A-Za-z0-9_.-]
    std::optional<double> value; ///< nothing for null
};

/// The most that a program may write: on its standard output, and on standard error.
inline constexpr std::size_t kLongestAnswer = std::size_t{1} << 20;
inline constexpr std::size_t kLongestComplaint = std::size_t{16} << 20;

[[nodiscard]] bool is_external_metric(std::string_view spec);

/// A program without a slash is looked for along PATH. Throws InputError naming `where` if there is
/// no program, or none that can be executed.
[[nodiscard]] ExternalMetric parse_external_metric(std::string_view spec, std::string_view where);

/// Calls `program arguments... TEST REFERENCE` (absolute paths, standard input closed) and reads
/// its object: one key or more, each a number, or null where it is infinite or undefined. Throws
/// FailureError naming the program if it takes longer than `time` (it is ended with all that it
/// started), ends with another code than 0 (quoting the end of its standard error), writes too
/// much, or writes anything else.
[[nodiscard]] std::vector<ExternalValue> run_external_metric(const ExternalMetric& metric,
                                                             const std::filesystem::path& test,
                                                             const std::filesystem::path& reference,
                                                             std::chrono::milliseconds time);

} // namespace alcove
