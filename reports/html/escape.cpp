#include "reports/html/escape.hpp"

namespace alcove {

std::string escape_html(std::string_view text) {
    std::string escaped;
    escaped.reserve(text.size());
    for (const char c : text) {
        switch (c) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        case '\'':
            escaped += "&#39;";
            break;
        default: {
            const bool is_control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t';
            escaped += is_control || c == 0x7f ? ' ' : c;
        }
        }
    }
    return escaped;
}

std::string escape_inline_json(std::string_view json) {
    std::string escaped;
    escaped.reserve(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (c == '<') {
            escaped += "\\u003c";
        } else if (c == '>') {
            escaped += "\\u003e";
        } else if (c == '&') {
            escaped += "\\u0026";
        } else if (json.substr(i, 3) == "\xe2\x80\xa8" || json.substr(i, 3) == "\xe2\x80\xa9") {
            escaped += json[i + 2] == '\xa8' ? "\\u2028" : "\\u2029";
            i += 2;
        } else {
            escaped += c;
        }
    }
    return escaped;
}

std::string escape_url_path(std::string_view path) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.~/-";
    constexpr std::string_view kHex = "0123456789ABCDEF";
    std::string escaped;
    for (const char c : path) {
        if (kPlain.find(c) != std::string_view::npos) {
            escaped += c;
        } else {
            const auto code = static_cast<unsigned char>(c);
            escaped += '%';
            escaped += kHex[code >> 4];
            escaped += kHex[code & 15];
        }
    }
    return escaped;
}

} // namespace alcove
