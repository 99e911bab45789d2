#include "harness/run/fetch_count.hpp"

#include <algorithm>

namespace alcove {
namespace {

std::vector<RoundFrame> choose_frames(const RoundStage& stage) {
    std::vector<RoundFrame> chosen = stage.list_singles();
    if (!chosen.empty()) {
        return chosen;
    }
    const std::vector<RoundFrame>& frames = stage.frames();
    for (auto begin = frames.begin(); begin != frames.end();) {
        const auto end = std::find_if(begin, frames.end(), [&](const RoundFrame& frame) {
            return frame.segment != begin->segment;
        });
        chosen.push_back(*(begin + (end - begin) / 2));
        begin = end;
    }
    return chosen;
}

} // namespace

std::vector<FetchRecord> count_fetches(RoundStage& stage) {
    const std::vector<RoundFrame> frames = choose_frames(stage);
    const double pixels = static_cast<double>(stage.size().width) * stage.size().height;
    std::vector<FetchRecord> records;
    gl::FetchCounter counter(stage.context());
    for (const MethodCell& timed : stage.cells()) {
        if (!timed.has_passes()) {
            continue;
        }
        const CellRecord& record = timed.record();
        MethodCell cell(stage.context(), stage.units().methods.find(record.method), record,
                        stage.size(), &counter);
        const std::size_t first = records.size();
        for (const RoundFrame& frame : frames) {
            stage.warm_up(cell, frame.view);
            CellTimes times;
            static_cast<void>(
                cell.render(stage.make_inputs(cell), PassTiming::none, stage.timer(), times));
            for (std::size_t pass = 0; pass < times.passes.size(); ++pass) {
                const auto found = std::find_if(
                    records.begin() + static_cast<std::ptrdiff_t>(first), records.end(),
                    [&](const FetchRecord& known) { return known.pass == times.passes[pass]; });
                FetchRecord& counted =
                    found != records.end()
                        ? *found
                        : records.emplace_back(FetchRecord{record.id, times.passes[pass], 0.0, 0});
                counted.fetches_per_pixel += static_cast<double>(times.fetches[pass]) / pixels;
            }
        }
        for (std::size_t i = first; i < records.size(); ++i) {
            records[i].fetches_per_pixel /= static_cast<double>(frames.size());
            records[i].frames = static_cast<int>(frames.size());
        }
        stage.context().check_errors();
    }
    return records;
}

} // namespace alcove
