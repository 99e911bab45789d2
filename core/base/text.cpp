#include "core/base/text.hpp"

#include "core/base/error.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace alcove {

std::string format_number(double value) {
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string format_rounded(double value, int digits) {
    std::array<char, 64> buffer{};
    const double magnitude = std::abs(value);
    if (magnitude != 0.0 && std::isfinite(value) && magnitude < 1e6 && magnitude >= 1e-4) {
        const int exponent = static_cast<int>(std::floor(std::log10(magnitude)));
        const int decimals = std::max(0, digits - 1 - exponent);
        std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
    } else {
        std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
    }
    return buffer.data();
}

double parse_number(std::string_view text, std::string_view where) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || std::isnan(value)) {
        throw InputError(where, "not a number", text, "a number");
    }
    return value;
}

std::int64_t parse_integer(std::string_view text, std::string_view where) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
        throw InputError(where, "not an integer", text, "an integer");
    }
    return value;
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t position = text.find(separator);
        parts.emplace_back(text.substr(0, position));
        if (position == std::string_view::npos) {
            return parts;
        }
        text.remove_prefix(position + 1);
    }
}

std::vector<KeyValue> parse_key_values(std::string_view text, std::string_view where) {
    std::vector<KeyValue> entries;
    for (const std::string& part : split(text, ',')) {
        const std::size_t position = part.find('=');
        if (position == std::string::npos || position == 0) {
            throw InputError(where, "not a key and a value", part, "key=value");
        }
        entries.push_back({part.substr(0, position), part.substr(position + 1)});
    }
    return entries;
}

} // namespace alcove
