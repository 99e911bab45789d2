#include "reports/record/tune_record.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "reports/record/record_json.hpp"

namespace alcove {
namespace {

constexpr const char* kFile = "tune.json";

} // namespace

std::optional<double> find_generalisation_gap(const TunedMethodRecord& method,
                                              const TuneJudgementRecord& judged) {
    for (const TuneJudgementRecord& training : method.judgements) {
        const double gained = training.before - training.after;
        if (training.set == kTrainingSet && training.metric == judged.metric &&
            judged.set != kTrainingSet && gained != 0.0) {
            // The sign of an improvement cancels.
            return (gained - (judged.before - judged.after)) / gained;
        }
    }
    return std::nullopt;
}

void write_tune(const std::filesystem::path& folder, const TuneRecord& record) {
    write_file_atomically(folder / kFile, make_json(record));
}

TuneRecord read_tune(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / kFile;
    TuneRecord record = parse_tune_json(read_file(path), path.string());
    for (std::size_t i = 0; i < record.methods.size(); ++i) {
        const TunedMethodRecord& method = record.methods[i];
        const std::string where = path.string() + ": methods[" + std::to_string(i) + "]";
        if (!is_safe_id(method.id)) {
            throw InputError(where + ".id", "not a safe folder name", method.id, "[a-z0-9_.-]");
        }
        static_cast<void>(resolve_inside(folder, method.calibration));
        for (const TuneEvaluationRecord& evaluation : method.history) {
            if (evaluation.values.size() != method.parameters.size()) {
                throw InputError(where + ".history", "wrong length",
                                 std::to_string(evaluation.values.size()),
                                 std::to_string(method.parameters.size()) + ", one a parameter");
            }
        }
    }
    return record;
}

} // namespace alcove
