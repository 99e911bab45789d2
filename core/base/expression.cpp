#include "core/base/expression.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

namespace alcove {
namespace {

/// Recursive descent over: sum = product {(+|-) product}; product = factor {(*|/) factor};
/// factor = number | name | (min|max)(sum, sum) | (sum) | -factor.
class Parser {
  public:
    Parser(std::string_view text, const std::function<double(std::string_view)>& lookup)
        : m_text(text), m_lookup(lookup) {}

    double parse() {
        const double value = parse_sum();
        if (peek() != '\0') {
            fail("end of the expression");
        }
        return value;
    }

  private:
    [[noreturn]] void fail(std::string_view expected) const {
        throw InputError("default expression `" + std::string(m_text) + "`, character " +
                             std::to_string(m_position + 1),
                         "cannot be read", m_text.substr(m_position), expected);
    }

    char peek() {
        while (m_position < m_text.size() && m_text[m_position] == ' ') {
            ++m_position;
        }
        return m_position < m_text.size() ? m_text[m_position] : '\0';
    }

    bool accept(char character) {
        if (peek() != character) {
            return false;
        }
        ++m_position;
        return true;
    }

    void expect(char character) {
        if (!accept(character)) {
            fail(std::string(1, character));
        }
    }

    double parse_sum() {
        double value = parse_product();
        for (;;) {
            if (accept('+')) {
                value += parse_product();
            } else if (accept('-')) {
                value -= parse_product();
            } else {
                return value;
            }
        }
    }

    double parse_product() {
        double value = parse_factor();
        for (;;) {
            if (accept('*')) {
                value *= parse_factor();
            } else if (accept('/')) {
                value /= parse_factor();
            } else {
                return value;
            }
        }
    }

    double parse_factor() {
        if (accept('-')) {
            return -parse_factor();
        }
        if (accept('(')) {
            const double value = parse_sum();
            expect(')');
            return value;
        }
        const char first = peek();
        const std::size_t start = m_position;
        if (std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '.') {
            double value = 0.0;
            const auto [end, error] =
                std::from_chars(m_text.data() + start, m_text.data() + m_text.size(), value);
            if (error != std::errc{}) {
                fail("a number");
            }
            m_position = static_cast<std::size_t>(end - m_text.data());
            return value;
        }
        if (std::isalpha(static_cast<unsigned char>(first)) == 0) {
            fail("a number or a name");
        }
        while (m_position < m_text.size() &&
               (std::isalnum(static_cast<unsigned char>(m_text[m_position])) != 0 ||
                m_text[m_position] == '_')) {
            ++m_position;
        }
        const std::string_view name = m_text.substr(start, m_position - start);
        if ((name == "min" || name == "max") && accept('(')) {
            const double a = parse_sum();
            expect(',');
            const double b = parse_sum();
            expect(')');
            return name == "min" ? std::min(a, b) : std::max(a, b);
        }
        return m_lookup(name);
    }

    std::string_view m_text;
    const std::function<double(std::string_view)>& m_lookup;
    std::size_t m_position = 0;
};

} // namespace

double evaluate_expression(std::string_view text,
                           const std::function<double(std::string_view)>& lookup) {
    return Parser{text, lookup}.parse();
}

} // namespace alcove
