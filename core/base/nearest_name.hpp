#pragma once
// "Did you mean": the known name nearest to a mistyped one.

#include <span>
#include <string>
#include <string_view>

namespace alcove {

/// Smallest number of insertions, deletions, substitutions and swaps of neighbours that turns `a`
/// into `b` (optimal string alignment distance). This work is based on: Damerau. A technique for
/// computer detection and correction of spelling errors. 1964.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate with the smallest edit distance (the first of equals); empty if there is no
/// candidate.
[[nodiscard]] std::string nearest_name(std::string_view name,
                                       std::span<const std::string> candidates);

/// "one of a, b, c (nearest: b)": the `expected` part of an error about an unknown name.
[[nodiscard]] std::string describe_choices(std::string_view name,
                                           std::span<const std::string> candidates);

} // namespace alcove
