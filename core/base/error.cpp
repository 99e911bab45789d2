#include "core/base/error.hpp"

namespace alcove {
namespace {

std::string compose(std::string_view where, std::string_view what, std::string_view found,
                    std::string_view expected) {
    std::string text{where};
    if (!what.empty()) {
        text += text.empty() ? "" : ": ";
        text += what;
    }
    if (!found.empty()) {
        text += ": found `";
        text += found;
        text += '`';
    }
    if (!expected.empty()) {
        text += found.empty() ? ": expected " : ", expected ";
        text += expected;
    }
    return text;
}

} // namespace

InputError::InputError(std::string_view where, std::string_view what, std::string_view found,
                       std::string_view expected)
    : Error(2, compose(where, what, found, expected)) {}

FailureError::FailureError(std::string_view where, std::string_view what, std::string_view found,
                           std::string_view expected)
    : Error(1, compose(where, what, found, expected)) {}

} // namespace alcove
