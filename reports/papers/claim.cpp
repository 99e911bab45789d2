#include "reports/papers/claim.hpp"

#include "core/base/assert.hpp"
#include "reports/papers/paper_files.hpp"
#include "reports/record/csv.hpp"

#include <functional>

namespace alcove {
namespace {

/// Calls `take` with the fields of every line behind the header.
void read_table(std::string_view name, std::size_t columns,
                const std::function<void(const std::vector<std::string>&)>& take) {
    const std::string_view text = find_paper_file(name);
    CsvReader reader(text, name);
    std::vector<std::string> fields;
    bool is_header = true;
    while (reader.next(fields)) {
        ALCOVE_ASSERT(fields.size() == columns, "the columns of a file of ours");
        if (!is_header) {
            take(fields);
        }
        is_header = false;
    }
}

} // namespace

std::vector<Claim> load_claims(std::string_view paper) {
    std::vector<Claim> claims;
    read_table("reports/papers/claims.csv", 11, [&](const std::vector<std::string>& f) {
        if (f[1] == paper) {
            claims.push_back({f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10]});
        }
    });
    ALCOVE_ASSERT(!claims.empty(), "a paper with claims");
    return claims;
}

std::vector<Erratum> load_errata(std::string_view paper) {
    std::vector<Erratum> errata;
    read_table("reports/papers/errata.csv", 4, [&](const std::vector<std::string>& f) {
        if (f[0] == paper) {
            errata.push_back({f[0], f[1], f[2], f[3]});
        }
    });
    return errata;
}

} // namespace alcove
