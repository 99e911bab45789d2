#pragma once
// Assertions for programmer errors. They stay on in Release, because a benchmark that goes on after
// a broken invariant prints numbers that mean nothing. Bad input and failing devices throw instead
// (error.hpp).

#include <string_view>

namespace alcove {

/// Prints "file:line: assertion `expression` failed: message" on standard error and aborts.
[[noreturn]] void fail_assertion(std::string_view expression, std::string_view message,
                                 std::string_view file, int line) noexcept;

} // namespace alcove

/// Checks an invariant in every build type. Not for code between two timer marks: see
/// ALCOVE_ASSERT_TIMED.
#define ALCOVE_ASSERT(condition, message)                                                          \
    (static_cast<bool>(condition)                                                                  \
         ? static_cast<void>(0)                                                                    \
         : ::alcove::fail_assertion(#condition, (message), __FILE__, __LINE__))

/// For code that runs inside timed passes: on in debug builds only, so that checks are never part
/// of a measured time.
#ifdef NDEBUG
#define ALCOVE_ASSERT_TIMED(condition, message) static_cast<void>(sizeof(!(condition)))
#else
#define ALCOVE_ASSERT_TIMED(condition, message) ALCOVE_ASSERT(condition, message)
#endif
