#include "reports/analysis/cell_series.hpp"

#include "reports/record/record_csv.hpp"

namespace alcove {
namespace {

constexpr const char* kBasePass = "input/base";
constexpr const char* kComposePass = "harness/compose";

void add_row(CellSeries& cell, const SampleRow& row) {
    const FrameKey frame{row.segment, row.frame};
    const auto add = [&](Series& series) { series.add(frame, row.repeat, row.time_ns); };
    if (row.state == SampleState::converged) {
        // Its times are envelopes, their passes are not tabled.
        if (row.kind == SampleKind::envelope) {
            const int rendering = cell.held[{row.segment, row.repeat}]++;
            cell.converged.add({row.segment, rendering}, row.repeat, row.time_ns);
        }
        return;
    }
    if (row.kind == SampleKind::envelope) {
        add(cell.envelope);
        return;
    }
    if (row.pass == kComposePass) {
        add(cell.compose);
        return;
    }
    add(is_input_pass(row.pass) ? cell.inputs : cell.divided);
    if (!cell.passes.contains(row.pass)) {
        cell.pass_order.push_back(row.pass);
    }
    add(cell.passes[row.pass]);
    cell.cached[row.pass] = cell.cached[row.pass] || row.cached;
}

} // namespace

bool is_input_pass(const std::string& pass) {
    return pass.starts_with("input/");
}

RoundSeries sort_samples(const std::vector<SampleRow>& samples) {
    RoundSeries series;
    for (const SampleRow& row : samples) {
        if (row.cell != kHarnessCell) {
            add_row(series.cells[row.cell], row);
        } else if (row.pass == kBasePass) {
            series.base.add({row.segment, row.frame}, row.repeat, row.time_ns);
        }
    }
    return series;
}

} // namespace alcove
