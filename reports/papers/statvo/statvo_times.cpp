#include "reports/papers/statvo/statvo_parts.hpp"

namespace alcove {
namespace {

const CellAddress kFull{"tables", 0, "full"};
const CellAddress kHalf{"tables", 0, "half"};
const CellAddress kQuarter{"tables", 0, "quarter"};
const CellAddress kAllTables{"tables", 0, "all tables"};
const CellAddress kFourRegions{"tables", 0, "four regions"};

/// Why the evaluation weighs more on a processor, and gains little from smaller tables.
constexpr const char* kEvaluation = "; the evaluation reads four corners of four tables, 256 "
                                    "filtered floats a pixel, at any size of "
                                    "tables: a software device computes what texture units hide";

std::vector<std::string> list_all_passes() {
    std::vector<std::string> passes;
    for (const StatvoRow& row : list_statvo_rows()) {
        passes.insert(passes.end(), row.passes.begin(), row.passes.end());
    }
    return passes;
}

/// A share of a time says how a device weighs work; half to twice the paper's is alike.
void judge_shares(const Evidence& evidence, Judge& judge) {
    constexpr double kFullTotalMs = 8.76; // the rows' sum; the printed total is 8.86
    constexpr double kHalfTotalMs = 2.14;
    const std::vector<std::string> all = list_all_passes();
    const std::string views = describe_views(evidence, "tables");
    for (const StatvoRow& row : list_statvo_rows()) {
        const auto judge_share = [&](const char* claim, const CellAddress& cell, double share) {
            const Estimate measured = evidence.compare_passes(cell, row.passes, cell, all);
            judge.set(claim, {judge_within(measured, 0.5 * share, 2.0 * share),
                              "the row's share of the total is half to twice the paper's", measured,
                              views + kEvaluation});
        };
        judge_share(row.claims[0], kFull, row.full_ms / kFullTotalMs);
        judge_share(row.claims[1], kHalf, row.half_ms / kHalfTotalMs);
        const double published = row.full_ms / row.half_ms;
        const Estimate faster = evidence.compare_passes(kFull, row.passes, kHalf, row.passes);
        judge.set(row.claims[2],
                  {judge_within(faster, published / 1.33, published * 1.33),
                   "full / half within a third of the paper's", faster, views + kEvaluation});
    }
    const Estimate total = evidence.compare_passes(kFull, all, kHalf, all);
    const Finding total_speed_up{judge_within(total, 4.14 / 1.33, 4.14 * 1.33),
                                 "total full / half within a third of 4.1", total,
                                 views + kEvaluation};
    judge.set("STATVO-018", total_speed_up);
    judge.set_untestable({"STATVO-016", "STATVO-017"},
                         "milliseconds of another device; their ratio is STATVO-018");
}

void judge_ratios(const Evidence& evidence, Judge& judge) {
    const std::string views = describe_views(evidence, "tables");
    const std::vector<std::string> root{"statvo/root"};
    const std::vector<std::string> first{"statvo/level1"};
    const std::vector<std::string> second{"statvo/level2"};
    const Estimate twice = evidence.compare_passes(kFull, second, kFull, first);
    judge.set("STATVO-019",
              {judge_within(twice, 1.6, 2.4),
               "two tables of the second level cost twice the first's (1.6 to 2.4)", twice, views});
    const Estimate partition = evidence.compare_passes(kFull, first, kFull, root);
    judge.set(
        "STATVO-020",
        {judge_within(partition, 1.1, 1.6),
         "first level / root, its partition included, between 1.1 and 1.6", partition,
         views + "; the partition reads four corners of a table at every sample, the scan none"});
    const std::vector<std::string>& tables = list_statvo_table_passes();
    const Estimate share = evidence.compare_passes(kFull, tables, kFull, list_all_passes());
    judge.set("STATVO-021", {judge_above(share, 0.5),
                             "building tables is more than half of the total at full resolution",
                             share, views + kEvaluation});
    const Estimate half = evidence.compare_passes(kFull, tables, kHalf, tables);
    const Estimate quarter = evidence.compare_passes(kFull, tables, kQuarter, tables);
    const Outcome by_four = judge_within(half, 3.0, 5.3);
    judge.set("STATVO-036",
              {combine({by_four, judge_within(quarter, 12.0, 21.3)}),
               "tables of half and of quarter size cost a quarter and a sixteenth (within a third)",
               quarter, views});
    judge.set("STATVO-037",
              {combine({judge_within(half, 3.0, 5.3), judge_above(quarter, 4.0)}),
               "downsampling by 2 to 4 saves a factor 4 to 16 of the tables' time", half, views});
    judge.set("STATVO-045",
              {by_four, "a quarter of the area costs a quarter (3 to 5.3)", half, views});
    const Estimate saved = evidence.compare_passes(kAllTables, tables, kFull, tables);
    judge.set("STATVO-040",
              {judge_above(saved, 1.0), "seven tables cost more than four differential ones", saved,
               views + "; methods_statvo_test counts 4 of 7 and 8 of 15"});
    const Estimate without = evidence.compare_costs(kAllTables, kFull);
    judge.set(
        "STATVO-059",
        {judge_within(without, 2.0, 3.2),
         "without differential tables the whole costs 2.0 to 3.2 times as much (23 / 8.86)",
         without,
         views +
             "; 7 builds in place of 4 cannot make it 2.6 times: the paper's two times differ by "
             "more than section 7.2"});
    const Estimate regions = evidence.compare_costs(kFourRegions, kFull);
    judge.set("STATVO-033", {judge_within(regions, 1.25, 1.4),
                             "four regions / one, whole cost, between 1.25 and 1.40", regions,
                             views + "; only the evaluation reads more, 9 corners in place of 4"});
}

void judge_layer_times(const Evidence& evidence, Judge& judge) {
    const auto at = [](const char* label) { return CellAddress{"layers", 0, label}; };
    const std::string views = describe_views(evidence, "layers");
    const Estimate uniform = evidence.compare_costs(at("64 uniform"), at("1 layer"));
    judge.set("STATVO-027",
              {judge_within(uniform, 27.5, 110.0),
               "64 uniform layers / 1 layer within a factor 2 of 55", uniform, views});
    const Estimate adaptive = evidence.compare_costs(at("64 uniform"), at("4 adaptive"));
    judge.set("STATVO-028",
              {judge_within(adaptive, 1.2, 4.8),
               "64 uniform / 4 adaptive layers within a factor 2 of 2.39", adaptive,
               views + "; 64 tables are built in place of 7, and 64 read in place of 4"});
    std::vector<std::map<int, double>> times;
    for (const char* label : {"4 uniform", "16 uniform", "32 uniform", "64 uniform"}) {
        times.push_back(evidence.get_cost_ms(at(label)));
    }
    const Estimate fit = estimate_linearity({4.0, 16.0, 32.0, 64.0}, times);
    judge.set("STATVO-029",
              {judge_above(fit, 0.98), "cost is linear in 4, 16, 32, 64 uniform layers: r^2 > 0.98",
               fit, views});
}

} // namespace

const std::vector<StatvoRow>& list_statvo_rows() {
    static const std::vector<StatvoRow> kRows{
        {"Downsample depth buffer",
         {"statvo/downsample"},
         0.13,
         0.05,
         {"STATVO-001", "STATVO-002", "STATVO-003"}},
        {"Compute root SAT",
         {"statvo/root"},
         1.40,
         0.32,
         {"STATVO-004", "STATVO-005", "STATVO-006"}},
        {"Compute first level SAT",
         {"statvo/level1"},
         1.86,
         0.43,
         {"STATVO-007", "STATVO-008", "STATVO-009"}},
        {"Compute second level SATs",
         {"statvo/level2"},
         3.72,
         0.84,
         {"STATVO-010", "STATVO-011", "STATVO-012"}},
        {"Evaluate StatVO",
         {"statvo/evaluate"},
         1.65,
         0.50,
         {"STATVO-013", "STATVO-014", "STATVO-015"}},
    };
    return kRows;
}

const std::vector<std::string>& list_statvo_table_passes() {
    static const std::vector<std::string> kPasses{"statvo/root", "statvo/level1", "statvo/level2"};
    return kPasses;
}

void judge_statvo_times(const Evidence& evidence, Judge& judge) {
    judge_shares(evidence, judge);
    judge_ratios(evidence, judge);
    judge_layer_times(evidence, judge);
    // Corner lattice of a quarter of 1920x1080, four tables of four floats.
    const double bytes = 4.0 * (480.0 + 1.0) * (270.0 + 1.0) * 4.0 * 4.0;
    judge.set("STATVO-046", {judge_within(make_single(bytes * 1e-6), 7.5, 8.5),
                             "four tables of a quarter of 1920x1080 take 8 MB (7.5 to 8.5)",
                             make_single(bytes * 1e-6), "arithmetic, with our corner lattice"});
}

} // namespace alcove
