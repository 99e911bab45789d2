#pragma once
// Numbers as text and back, independent of the locale, and the small grammars of the command line.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// Shortest text that reads back as the same double; "inf", "-inf", "nan" for what is not finite.
[[nodiscard]] std::string format_number(double value);
/// `digits` significant digits, without exponent where that is readable: for people, not for files.
[[nodiscard]] std::string format_rounded(double value, int digits = 3);

/// Reads one number that fills the whole text; "inf" is accepted, NaN is not. Throws InputError
/// naming `where`.
[[nodiscard]] double parse_number(std::string_view text, std::string_view where);
/// Same for integers. Throws InputError.
[[nodiscard]] std::int64_t parse_integer(std::string_view text, std::string_view where);

/// Splits at every `separator`; an empty text gives one empty part.
[[nodiscard]] std::vector<std::string> split(std::string_view text, char separator);

struct KeyValue {
    std::string key;
    std::string value;
};
/// Reads "a=1,b=2". Throws InputError naming `where` if a part has no `=` or an empty key.
[[nodiscard]] std::vector<KeyValue> parse_key_values(std::string_view text, std::string_view where);

} // namespace alcove
