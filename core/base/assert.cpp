#include "core/base/assert.hpp"

#include <cstdio>
#include <cstdlib>

namespace alcove {

void fail_assertion(std::string_view expression, std::string_view message, std::string_view file,
                    int line) noexcept {
    std::fprintf(stderr, "%.*s:%d: assertion `%.*s` failed: %.*s\n", static_cast<int>(file.size()),
                 file.data(), line, static_cast<int>(expression.size()), expression.data(),
                 static_cast<int>(message.size()), message.data());
    std::abort();
}

} // namespace alcove
