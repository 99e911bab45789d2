#pragma once
// TOML read strictly: every key is asked for or refused, every error names file and line. For
// experiment_file.cpp and others that read TOML from people; the library stays behind it.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// One table of a document. Getters mark their key as known and return nothing where it is missing.
/// A value of another type is an InputError "file:line: key: found a string, expected an integer".
class TomlTable {
  public:
    /// Parses a whole document. Throws InputError with the line of what cannot be read.
    [[nodiscard]] static TomlTable parse(std::string_view text, const std::string& file);

    [[nodiscard]] std::optional<std::string> get_string(const std::string& key);
    [[nodiscard]] std::optional<std::int64_t> get_integer(const std::string& key);
    /// Integers are numbers, too; `inf` is, `nan` is not.
    [[nodiscard]] std::optional<double> get_number(const std::string& key);
    [[nodiscard]] std::optional<bool> get_boolean(const std::string& key);
    /// A string, or an array of strings.
    [[nodiscard]] std::optional<std::vector<std::string>> get_strings(const std::string& key);
    [[nodiscard]] std::optional<TomlTable> get_table(const std::string& key);
    /// [[key]]: an array of tables; empty where it is missing.
    [[nodiscard]] std::vector<TomlTable> get_tables(const std::string& key);
    /// A scalar (string, number, switch), or an array of them, as text that parameters read.
    [[nodiscard]] std::optional<std::vector<std::string>> get_values(const std::string& key);

    [[nodiscard]] bool is_table(const std::string& key) const;
    [[nodiscard]] std::vector<std::string> list_keys() const;

    /// "file:line" of a key, or of the table itself.
    [[nodiscard]] std::string where(const std::string& key = {}) const;
    /// Throws InputError if a key was never asked for, with the nearest that was.
    void check_all_known() const;
    /// Runs `read`; an InputError gets the key's place in front.
    void with_place(const std::string& key, const std::function<void()>& read) const;

  private:
    struct Document;
    struct Node;
    TomlTable(std::shared_ptr<const Document> document, const void* table);
    [[nodiscard]] const void* find(const std::string& key) const;
    const void* take(const std::string& key);
    [[noreturn]] void throw_type(const std::string& key, const std::string& expected) const;

    std::shared_ptr<const Document> m_document;
    const void* m_table; ///< a toml::table of the document
    std::set<std::string> m_known;
};

} // namespace alcove
