#include "reports/csv/csv_table.hpp"

#include "core/base/text.hpp"
#include "reports/record/csv.hpp"

namespace alcove {

void CsvTable::begin_line() {
    m_has_columns = !m_columns.empty();
    m_lines.emplace_back();
}

void CsvTable::add(std::string column, std::string field) {
    if (!m_has_columns) {
        m_columns.push_back(std::move(column));
    }
    m_lines.back().push_back(std::move(field));
}

void CsvTable::add(std::string column, std::optional<double> value) {
    add(std::move(column), value ? format_number(*value) : std::string());
}

void CsvTable::add_count(std::string column, std::size_t value) {
    add(std::move(column), std::to_string(value));
}

void CsvTable::add_flag(std::string column, bool value) {
    add(std::move(column), std::string(value ? "1" : "0"));
}

void CsvTable::add_estimate(const std::string& name, const std::optional<Estimate>& estimate) {
    const auto format = [&](double Estimate::*field) {
        return estimate ? format_number((*estimate).*field) : std::string();
    };
    const auto format_end = [&](double Interval::*end) {
        return estimate && estimate->interval ? format_number((*estimate->interval).*end)
                                              : std::string();
    };
    add(name, format(&Estimate::value));
    add(name + "_lower95", format_end(&Interval::lower));
    add(name + "_upper95", format_end(&Interval::upper));
    add(name + "_min", format(&Estimate::minimum));
    add(name + "_max", format(&Estimate::maximum));
    add_count(name + "_n", estimate ? estimate->n : 0);
}

void CsvTable::clear_lines() {
    m_lines.clear();
}

std::string CsvTable::make_text() const {
    std::string text;
    append_csv_line(text, m_columns);
    for (const std::vector<std::string>& line : m_lines) {
        append_csv_line(text, line);
    }
    return text;
}

} // namespace alcove
