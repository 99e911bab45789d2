#include "reports/record/record.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "reports/record/record_csv.hpp"
#include "reports/record/record_json.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <signal.h>
#include <unistd.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTemporaryMark = ".tmp-";

fs::path round_folder(const fs::path& run, const std::string& round_id) {
    return run / "rounds" / round_id;
}

/// Folders under a temporary name end with the id of the process that fills them, so that reading a
/// run never takes away what a live run is writing.
bool is_written_by_another(const std::string& name) {
    const std::size_t mark = name.rfind(kTemporaryMark);
    if (mark == std::string::npos) {
        return false;
    }
    const char* end = name.data() + name.size();
    int process = 0;
    const auto [parsed, error] =
        std::from_chars(name.data() + mark + kTemporaryMark.size(), end, process);
    return error == std::errc{} && parsed == end && process > 0 && process != ::getpid() &&
           (::kill(process, 0) == 0 || errno == EPERM);
}

void remove_stray_folders(const fs::path& run) {
    std::error_code error;
    std::vector<fs::path> strays;
    for (const fs::directory_entry& entry : fs::directory_iterator(run / "rounds", error)) {
        const std::string name = entry.path().filename().string();
        if (name.find(".tmp") != std::string::npos && !is_written_by_another(name)) {
            strays.push_back(entry.path());
        }
    }
    for (const fs::path& stray : strays) {
        fs::remove_all(stray, error); // on a read-only medium they stay, and are ignored
    }
}

const RoundRecord& find_round(const PlanRecord& plan, const std::string& round_id) {
    const auto found = std::find_if(plan.rounds.begin(), plan.rounds.end(),
                                    [&](const RoundRecord& round) { return round.id == round_id; });
    ALCOVE_ASSERT(found != plan.rounds.end(), "a round of the plan");
    return *found;
}

/// Joins the rounds' copies of one table under one header.
std::string join_tables(const fs::path& run, const PlanRecord& plan, const RunFolder& folder,
                        std::string_view name, const std::string& header) {
    std::string text = header;
    for (const RoundRecord& round : plan.rounds) {
        if (folder.is_finished(round.id)) {
            const fs::path file = round_folder(run, round.id) / name;
            const std::string part = read_file(file);
            if (!part.starts_with(header)) {
                throw InputError(file.string() + ":1", "the header is wrong", "", header);
            }
            text.append(part, header.size());
        }
    }
    return text;
}

} // namespace

bool measures_pictures(const RoundRecord& round) {
    const std::vector<std::string> entries = split(round.target, ',');
    return std::find(entries.begin(), entries.end(), "output=radiance") != entries.end();
}

std::string_view to_text(SampleKind kind) {
    return kind == SampleKind::divided ? "divided" : "envelope";
}

std::string_view to_text(SampleState state) {
    return state == SampleState::cold ? "cold" : "converged";
}

std::string_view to_text(StopReason reason) {
    switch (reason) {
    case StopReason::width:
        return "width";
    case StopReason::time:
        return "time";
    case StopReason::most:
        return "most";
    case StopReason::planned:
        break;
    }
    return "planned";
}

int PlanRecord::limit_repeats() const {
    return until_width > 0.0 ? std::max(repeats, most_repeats) : repeats;
}

RunFolder::RunFolder(fs::path path, ContextRecord context, PlanRecord plan)
    : m_path(std::move(path)), m_context(std::move(context)), m_plan(std::move(plan)) {}

RunFolder RunFolder::create(const fs::path& path, const ContextRecord& context,
                            const PlanRecord& plan) {
    create_output_folder(path);
    if (fs::exists(path / "context.json")) {
        throw InputError(path.string(), "the folder already holds a run", "context.json",
                         "an empty or new folder, or --resume");
    }
    // Checked as a reader would, so that a run is never found unreadable after hours.
    const std::string plan_text = make_json(plan);
    static_cast<void>(parse_plan_json(plan_text, "plan.json"));
    create_output_folder(path / "rounds");
    write_file_atomically(path / "plan.json", plan_text);
    // Last: its presence says that the folder is whole.
    write_file_atomically(path / "context.json", make_json(context));
    return {path, context, plan};
}

RunFolder RunFolder::open(const fs::path& path) {
    const fs::path context_file = path / "context.json";
    const fs::path plan_file = path / "plan.json";
    if (!fs::is_regular_file(context_file)) {
        throw InputError(path.string(), "not a run folder", "no context.json",
                         "a folder made by `alcove run`");
    }
    RunFolder folder(path, parse_context_json(read_file(context_file), context_file.string()),
                     parse_plan_json(read_file(plan_file), plan_file.string()));
    remove_stray_folders(path);
    return folder;
}

bool RunFolder::is_finished(const std::string& round_id) const {
    return is_safe_id(round_id) &&
           fs::is_regular_file(round_folder(m_path, round_id) / "done.json");
}

bool RunFolder::is_complete() const {
    return std::all_of(m_plan.rounds.begin(), m_plan.rounds.end(),
                       [&](const RoundRecord& round) { return is_finished(round.id); });
}

void RunFolder::finish_round(const std::string& round_id, const std::vector<SampleRow>& samples,
                             const std::vector<MetricRow>& metrics, const RoundDone& done) {
    const RoundRecord& round = find_round(m_plan, round_id);
    ALCOVE_ASSERT(!is_finished(round_id), "a round finishes once");
    const fs::path folder = round_folder(m_path, round_id);
    const std::string samples_text = make_samples_csv(samples);
    const std::string metrics_text = make_metrics_csv(metrics);
    // A row that no reader would take must not be published.
    static_cast<void>(
        parse_samples_csv(samples_text, "samples.csv", round, m_plan.limit_repeats()));
    static_cast<void>(parse_metrics_csv(metrics_text, "metrics.csv", round));

    remove_stray_folders(m_path);
    const fs::path temporary =
        folder.string() + std::string(kTemporaryMark) + std::to_string(::getpid());
    write_file_atomically(temporary / "samples.csv", samples_text);
    write_file_atomically(temporary / "metrics.csv", metrics_text);
    write_file_atomically(temporary / "done.json", make_json(done));
    publish_folder(temporary, folder);
    rebuild_tables();
}

void RunFolder::rebuild_tables() const {
    write_file_atomically(m_path / "samples.csv",
                          join_tables(m_path, m_plan, *this, "samples.csv", make_samples_csv({})));
    write_file_atomically(m_path / "metrics.csv",
                          join_tables(m_path, m_plan, *this, "metrics.csv", make_metrics_csv({})));
}

std::vector<SampleRow> RunFolder::read_samples() const {
    std::vector<SampleRow> rows;
    for (const RoundRecord& round : m_plan.rounds) {
        if (is_finished(round.id)) {
            const fs::path file = round_folder(m_path, round.id) / "samples.csv";
            std::vector<SampleRow> part =
                parse_samples_csv(read_file(file), file.string(), round, m_plan.limit_repeats());
            std::move(part.begin(), part.end(), std::back_inserter(rows));
        }
    }
    return rows;
}

std::vector<MetricRow> RunFolder::read_metrics() const {
    std::vector<MetricRow> rows;
    for (const RoundRecord& round : m_plan.rounds) {
        if (is_finished(round.id)) {
            const fs::path file = round_folder(m_path, round.id) / "metrics.csv";
            std::vector<MetricRow> part = parse_metrics_csv(read_file(file), file.string(), round);
            std::move(part.begin(), part.end(), std::back_inserter(rows));
        }
    }
    return rows;
}

std::optional<RoundDone> RunFolder::read_done(const std::string& round_id) const {
    if (!is_finished(round_id)) {
        return std::nullopt;
    }
    const fs::path file = round_folder(m_path, round_id) / "done.json";
    return parse_done_json(read_file(file), file.string());
}

std::string RunFolder::make_image_path(const std::string& round_id, const std::string& cell_id,
                                       int frame, std::string_view picture) {
    ALCOVE_ASSERT(is_safe_id(round_id) && is_safe_id(cell_id) && is_safe_id(picture) && frame >= 0,
                  "names that are safe in a path");
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), "%04d", frame);
    return "images/" + round_id + "/" + cell_id + "/" + number.data() + "_" + std::string(picture) +
           ".png";
}

} // namespace alcove
