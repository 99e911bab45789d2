#include "reports/record/csv.hpp"

#include "core/base/error.hpp"

namespace alcove {
namespace {

constexpr std::size_t kMaximumFields = 1024;
constexpr std::size_t kMaximumRecordBytes = 1u << 20;

void append_field(std::string& text, std::string_view field) {
    if (field.find_first_of(",\"\r\n") == std::string_view::npos) {
        text += field;
        return;
    }
    text += '"';
    for (const char c : field) {
        if (c == '"') {
            text += '"';
        }
        text += c;
    }
    text += '"';
}

} // namespace

void append_csv_line(std::string& text, const std::vector<std::string>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (i > 0) {
            text += ',';
        }
        append_field(text, fields[i]);
    }
    text += '\n';
}

std::string CsvReader::where() const {
    return std::string(m_file) + ":" + std::to_string(m_line);
}

bool CsvReader::next(std::vector<std::string>& fields) {
    fields.clear();
    m_line = m_next_line;
    if (m_position == m_text.size()) {
        return false;
    }
    enum class State { start, plain, quoted, closed };
    State state = State::start;
    std::string field;
    const std::size_t begin = m_position;
    while (m_position < m_text.size()) {
        const char c = m_text[m_position++];
        if (c == '\n') {
            ++m_next_line;
        }
        if (m_position - begin > kMaximumRecordBytes) {
            throw InputError(where(), "the record is too long", "",
                             "at most " + std::to_string(kMaximumRecordBytes) + " bytes");
        }
        if (state == State::quoted) {
            if (c == '"') {
                state = State::closed;
            } else {
                field += c;
            }
            continue;
        }
        if (state == State::closed && c == '"') {
            field += '"';
            state = State::quoted;
            continue;
        }
        if (c == '\r' && m_position < m_text.size() && m_text[m_position] == '\n') {
            continue;
        }
        if (c == ',' || c == '\n') {
            fields.push_back(std::move(field));
            field.clear();
            state = State::start;
            if (c == '\n') {
                return true;
            }
            if (fields.size() >= kMaximumFields) {
                throw InputError(where(), "too many fields", "",
                                 "at most " + std::to_string(kMaximumFields));
            }
            continue;
        }
        if (c == '"' && state == State::start) {
            state = State::quoted;
            continue;
        }
        if (c == '"' || state == State::closed) {
            throw InputError(where(), "a quote inside a field", std::string(1, c),
                             "a comma or a line end");
        }
        field += c;
        state = State::plain;
    }
    throw InputError(where(), "the file is cut off", "the end of the file", "a line end");
}

} // namespace alcove
