#include "reports/markdown/escape.hpp"

namespace alcove {

std::string escape_markdown(std::string_view text) {
    // Entities for what HTML or a mention would read, backslashes for what Markdown would.
    constexpr std::string_view kMarks = "\\`*_{}[]()#|~!";
    std::string escaped;
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            escaped += ' ';
        } else if (c == '<') {
            escaped += "&lt;";
        } else if (c == '>') {
            escaped += "&gt;";
        } else if (c == '&') {
            escaped += "&amp;";
        } else if (c == '@') {
            escaped += "&#64;";
        } else {
            if (kMarks.find(c) != std::string_view::npos) {
                escaped += '\\';
            }
            escaped += c;
        }
    }
    return escaped;
}

} // namespace alcove
