#include "reports/csv/reproduction_csv.hpp"

#include "core/base/text.hpp"
#include "reports/record/csv.hpp"

namespace alcove {

std::string make_verdicts_csv(const Reproduction& reproduction) {
    std::string text;
    append_csv_line(text, {"id", "location", "published", "unit", "shape_claim", "outcome",
                           "tested", "measured", "lower", "upper", "n", "why"});
    for (const ClaimVerdict& verdict : reproduction.verdicts) {
        const Claim& claim = verdict.claim;
        std::vector<std::string> numbers(4);
        if (verdict.measured) {
            numbers[0] = format_number(verdict.measured->value);
            if (verdict.measured->interval) {
                numbers[1] = format_number(verdict.measured->interval->lower);
                numbers[2] = format_number(verdict.measured->interval->upper);
            }
            numbers[3] = std::to_string(verdict.measured->n);
        }
        append_csv_line(text, {claim.id, claim.location, claim.value, claim.unit, claim.shape,
                               std::string(to_text(verdict.outcome)), verdict.tested, numbers[0],
                               numbers[1], numbers[2], numbers[3], verdict.why});
    }
    return text;
}

std::string make_table_csv(const PaperTable& table) {
    std::string text;
    append_csv_line(text, table.columns);
    for (const std::vector<std::string>& row : table.rows) {
        append_csv_line(text, row);
    }
    return text;
}

} // namespace alcove
