#pragma once
// Shared libraries that are opened at run time, so that one binary starts where one is missing.

#include <span>
#include <string>

namespace alcove::gl {

/// A library for as long as this object lives. It stays mapped until the process ends, because
/// worker threads and thread-local destructors of GL drivers do not survive an unload.
class Library {
  public:
    /// Opens the first of `names` that the system's loader can open. Throws FailureError("`part`")
    /// with the loader's words about the first name and `package`, the Debian package that has it.
    Library(std::string part, std::span<const char* const> names, const char* package);
    ~Library();
    Library(Library&& other) noexcept;
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    Library& operator=(Library&&) = delete;

    /// Throws FailureError if the library lacks the function.
    template <class Function>
    [[nodiscard]] Function find(const char* name) const {
        return reinterpret_cast<Function>(find_address(name));
    }

  private:
    [[nodiscard]] void* find_address(const char* name) const;
    std::string m_part;
    void* m_handle = nullptr;
};

/// Whether a Library of these names can be opened.
[[nodiscard]] bool can_open_library(std::span<const char* const> names);

} // namespace alcove::gl
