#pragma once
// Arithmetic in parameter defaults: numbers, names, + - * /, parentheses, min(a,b), max(a,b).

#include <functional>
#include <string_view>

namespace alcove {

/// Evaluates `text`; `lookup` gives the value of a name or throws. Throws InputError with the
/// offending position.
[[nodiscard]] double evaluate_expression(std::string_view text,
                                         const std::function<double(std::string_view)>& lookup);

} // namespace alcove
