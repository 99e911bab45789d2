#include "core/base/nearest_name.hpp"

#include <algorithm>
#include <vector>

namespace alcove {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    const std::size_t columns = b.size() + 1;
    std::vector<std::size_t> before_last(columns);
    std::vector<std::size_t> last(columns);
    std::vector<std::size_t> row(columns);
    for (std::size_t j = 0; j < columns; ++j) {
        last[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j < columns; ++j) {
            const std::size_t substitution = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, substitution});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
    const auto nearest = std::min_element(
        candidates.begin(), candidates.end(), [name](const std::string& a, const std::string& b) {
            return edit_distance(name, a) < edit_distance(name, b);
        });
    return nearest == candidates.end() ? std::string{} : *nearest;
}

std::string describe_choices(std::string_view name, std::span<const std::string> candidates) {
    std::string text = "one of ";
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        text += i == 0 ? "" : ", ";
        text += candidates[i];
    }
    return text + " (nearest: " + nearest_name(name, candidates) + ")";
}

} // namespace alcove
