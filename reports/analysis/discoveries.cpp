#include "reports/analysis/discoveries.hpp"

#include "core/base/hypothesis.hpp"

namespace alcove {

void find_discoveries(Comparison& comparison) {
    std::vector<double> p_values;
    std::vector<std::optional<double>*> adjusted;
    const auto add = [&](auto& compared) {
        if (compared.p_value) {
            p_values.push_back(*compared.p_value);
            adjusted.push_back(&compared.discovery_p_value);
        }
    };
    for (CellComparison& cell : comparison.cells) {
        if (cell.time) {
            add(*cell.time);
        }
        for (QualityComparison& quality : cell.quality) {
            add(quality);
        }
    }
    const std::vector<double> values = adjust_benjamini_hochberg(p_values);
    for (std::size_t i = 0; i < values.size(); ++i) {
        *adjusted[i] = values[i];
    }
}

Discoveries Comparison::count_discoveries() const {
    Discoveries result;
    const auto add = [](const std::optional<double>& p_value, std::size_t& found,
                        std::size_t& all) {
        if (p_value) {
            ++all;
            found += *p_value <= kFalseDiscoveryRate ? 1 : 0;
        }
    };
    for (const CellComparison& cell : cells) {
        if (cell.time) {
            add(cell.time->discovery_p_value, result.times, result.all_times);
        }
        for (const QualityComparison& quality : cell.quality) {
            if (quality.is_by_segment) {
                add(quality.discovery_p_value, result.by_segment, result.all_by_segment);
            } else {
                add(quality.discovery_p_value, result.by_frame, result.all_by_frame);
            }
        }
    }
    return result;
}

} // namespace alcove
