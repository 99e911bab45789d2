#pragma once
// A CSV table of which names and fields are made by the same calls, so that they cannot come apart.

#include "core/base/statistics.hpp"

#include <optional>
#include <string>
#include <vector>

namespace alcove {

/// The first line names the columns; every other must add the same ones in the same order.
class CsvTable {
  public:
    void begin_line();
    void add(std::string column, std::string field);
    void add(std::string column, std::optional<double> value); ///< empty for no value
    void add_count(std::string column, std::size_t value);
    void add_flag(std::string column, bool value); ///< 0 or 1
    /// Six columns: `name`, `name`_lower95, _upper95, _min, _max and _n; n is 0 for no estimate.
    void add_estimate(const std::string& name, const std::optional<Estimate>& estimate);

    /// Drops the lines and keeps their columns' names.
    void clear_lines();
    /// Header and lines.
    [[nodiscard]] std::string make_text() const;

  private:
    bool m_has_columns = false;
    std::vector<std::string> m_columns;
    std::vector<std::vector<std::string>> m_lines;
};

} // namespace alcove
