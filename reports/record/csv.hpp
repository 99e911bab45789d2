#pragma once
// CSV as of RFC 4180, the one place where Alcove quotes and unquotes it.

#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// Appends one line, ended by "\n". A field that holds a comma, a quote or a line break is quoted.
void append_csv_line(std::string& text, const std::vector<std::string>& fields);

/// Reads line by line what append_csv_line wrote. Also takes CRLF line ends.
class CsvReader {
  public:
    /// `file` names the text in errors. Both must outlive the reader.
    CsvReader(std::string_view text, std::string_view file) : m_text(text), m_file(file) {}

    /// Reads the next record into `fields`; false at the end. Throws InputError, naming file and
    /// line, on an open quote at the end of the file (a truncated file), text behind a closing
    /// quote, a last line without its line end, and more than 1024 fields or 1 MiB in a record.
    [[nodiscard]] bool next(std::vector<std::string>& fields);

    /// "file:line" of the record read last; lines count from 1, the header is line 1.
    [[nodiscard]] std::string where() const;

  private:
    std::string_view m_text;
    std::string_view m_file;
    std::size_t m_position = 0;
    std::size_t m_line = 0; ///< of the record read last
    std::size_t m_next_line = 1;
};

} // namespace alcove
