#pragma once
// Strict reading of small JSON files that people write: every error names file and place, nothing
// is guessed.

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>

namespace alcove {

/// Numbers beyond this many metres, degrees, ... are taken for nonsense: 1e9.
inline constexpr double kLargestNumber = 1e9;

/// Parses a whole text. Throws InputError, naming `file`, on bad syntax, numbers that no double
/// holds, more than 64 levels of nesting and keys that stand twice in one object.
[[nodiscard]] nlohmann::json parse_strict_json(std::string_view text, std::string_view file);

/// A value and where it stands, e.g. "path.json: keys[2].position".
class JsonPlace {
  public:
    JsonPlace(const nlohmann::json& value, std::string file)
        : m_value(value), m_file(std::move(file)) {}

    /// Throws InputError unless it is an object with these keys, some of the optional ones and no
    /// others.
    void check_keys(std::initializer_list<std::string_view> keys,
                    std::initializer_list<std::string_view> optional = {}) const;
    /// True for an object with such a member.
    [[nodiscard]] bool has(std::string_view key) const;
    /// Throws InputError if it has no such member.
    [[nodiscard]] JsonPlace get(std::string_view key) const;
    /// Number of elements. Throws InputError unless it is an array.
    [[nodiscard]] std::size_t count() const;
    [[nodiscard]] JsonPlace at(std::size_t index) const;

    /// A number within +-kLargestNumber. Throws InputError.
    [[nodiscard]] double read_number() const;
    /// Throws InputError unless it is a whole number in the range.
    [[nodiscard]] std::int64_t read_integer(std::int64_t minimum, std::int64_t maximum) const;
    [[nodiscard]] std::string read_text() const;
    [[nodiscard]] bool read_truth() const;
    /// [x, y, z]
    [[nodiscard]] glm::dvec3 read_vector() const;

    /// "file: place"
    [[nodiscard]] std::string where() const;
    [[noreturn]] void fail(std::string_view what, std::string_view expected) const;

  private:
    JsonPlace(const nlohmann::json& value, std::string file, std::string path)
        : m_value(value), m_file(std::move(file)), m_path(std::move(path)) {}

    const nlohmann::json& m_value;
    std::string m_file;
    std::string m_path;
};

} // namespace alcove
