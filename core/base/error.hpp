#pragma once
// Errors that are thrown: bad input and failing devices. Only main catches them and turns them into
// an exit code.

#include <stdexcept>
#include <string>
#include <string_view>

namespace alcove {

/// Base of everything Alcove throws. `exit_code()` is what the process ends with (DESIGN 4).
class Error : public std::runtime_error {
  public:
    Error(int exit_code, const std::string& message)
        : std::runtime_error(message), m_exit_code(exit_code) {}
    [[nodiscard]] int exit_code() const noexcept { return m_exit_code; }

  private:
    int m_exit_code;
};

/// Wrong usage or bad input: exit code 2. The message names the place, what is wrong, what was
/// found, what was expected.
class InputError : public Error {
  public:
    explicit InputError(const std::string& message) : Error(2, message) {}
    /// "where: what: found `found`, expected expected"; empty parts are left out.
    InputError(std::string_view where, std::string_view what, std::string_view found = {},
               std::string_view expected = {});
};

/// A device, a file system or a third-party part failed: exit code 1.
class FailureError : public Error {
  public:
    explicit FailureError(const std::string& message) : Error(1, message) {}
    FailureError(std::string_view where, std::string_view what, std::string_view found = {},
                 std::string_view expected = {});
};

} // namespace alcove
