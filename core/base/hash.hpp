#pragma once
// Content hashes (XXH3, by Y. Collet): cache keys and image hashes. Not for security.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace alcove {

/// Streams values into one hash. Strings are hashed with their length, so that ("ab","c") !=
/// ("a","bc").
class Hasher {
  public:
    Hasher();
    ~Hasher();
    Hasher(const Hasher&) = delete;
    Hasher& operator=(const Hasher&) = delete;

    Hasher& add_bytes(std::span<const std::byte> bytes);
    Hasher& add(std::string_view text);
    /// Numbers by their bits. Padding-free types only.
    template <class T>
    requires std::is_arithmetic_v<T> Hasher& add(T value) {
        return add_bytes(std::as_bytes(std::span<const T, 1>(&value, 1)));
    }

    [[nodiscard]] std::uint64_t finish64() const;
    /// 128 bits as 32 lower-case hexadecimal digits: the form of a cache key.
    [[nodiscard]] std::string finish_hex() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// 16 lower-case hexadecimal digits.
[[nodiscard]] std::string to_hex(std::uint64_t value);

} // namespace alcove
