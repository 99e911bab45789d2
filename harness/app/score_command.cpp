#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "harness/app/kept_pictures.hpp"
#include "harness/app/metric_flags.hpp"
#include "harness/app/metric_means.hpp"
#include "harness/app/progress.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/units.hpp"
#include "reports/csv/csv_table.hpp"
#include "reports/terminal/text_table.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFileName = "scores.csv";

struct ScoreFlags {
    std::string run;
    std::vector<std::string> metrics;
    std::string out;
    double exec_timeout_s = kDefaultProgramTime;
};

/// The kept pictures of one kind of one cell: a row of the table.
struct ScoredGroup {
    KeptPicture first;
    MetricMeans means;
};

/// Finished parts of a run are never written over.
fs::path choose_output(const ScoreFlags& flags) {
    if (flags.out.empty()) {
        return fs::path(flags.run) / kFileName;
    }
    const fs::path out = fs::weakly_canonical(flags.out);
    const fs::path inside = out.lexically_relative(fs::weakly_canonical(flags.run));
    const bool is_inside = !inside.empty() && *inside.begin() != "..";
    if (is_inside && inside != kFileName) {
        throw InputError("--out", "lies in the run folder, which is finished", flags.out,
                         std::string(kFileName) + " in it, or a file elsewhere");
    }
    return out;
}

void append_lines(CsvTable& table, const KeptPicture& kept, const std::vector<PairScore>& scores) {
    for (const PairScore& score : scores) {
        table.begin_line();
        table.add("round", kept.round);
        table.add("scene", kept.scene);
        table.add("cell", kept.cell);
        table.add("label", kept.label);
        table.add_count("frame", static_cast<std::size_t>(kept.frame));
        table.add("picture", kept.picture);
        table.add("metric", score.name);
        table.add("value", score.result.value);
        table.add("note", score.result.undefined_reason);
    }
}

/// Groups in the order of the pictures; a line of the table for each score.
std::vector<ScoredGroup> measure(const std::vector<KeptPicture>& pictures, const PairScorer& scorer,
                                 CsvTable& table) {
    Progress progress;
    std::vector<ScoredGroup> groups;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const KeptPicture& picture = pictures[i];
        progress.show(static_cast<double>(i) / static_cast<double>(pictures.size()), picture.label);
        if (groups.empty() || groups.back().first.round != picture.round ||
            groups.back().first.cell != picture.cell ||
            groups.back().first.picture != picture.picture) {
            groups.push_back({picture, {}});
        }
        const std::vector<PairScore> scores = scorer.score(picture.test, picture.reference);
        append_lines(table, picture, scores);
        groups.back().means.add(scores, fmt::format("frame {}", picture.frame));
    }
    return groups;
}

void print_groups(const std::vector<ScoredGroup>& groups) {
    TextLines lines{{"round", "cell", "picture", "metric", "mean", "min..max", "n"}};
    for (const ScoredGroup& group : groups) {
        for (const MetricMean& mean : group.means.list()) {
            if (mean.is_extra) {
                continue;
            }
            const std::optional<double> value = mean.mean();
            lines.push_back(
                {clean_text(group.first.round), clean_text(group.first.label), group.first.picture,
                 mean.name, value ? format_rounded(*value, 5) : "-",
                 mean.values > 0
                     ? format_rounded(mean.smallest, 5) + ".." + format_rounded(mean.largest, 5)
                     : "-",
                 std::to_string(mean.values)});
            if (!value) {
                lines.back().push_back(clean_text(mean.describe_lack()));
            }
        }
    }
    fmt::print("{}", align_columns(lines));
}

void print_remarks(const KeptPictures& kept) {
    fmt::print("Kept pictures are 8-bit views: a stored value is off by up to 1/510, and scores "
               "carry that. Means over n frames.\n");
    if (kept.missing > 0) {
        fmt::print("{} pictures of the plan are not there and not scored.\n", kept.missing);
    }
    if (kept.unfinished_rounds > 0) {
        fmt::print("{} rounds are not finished and not scored.\n", kept.unfinished_rounds);
    }
}

int score(const ScoreFlags& flags) {
    const Registry<MetricUnit> registry = get_units().metrics;
    ScoringOptions options;
    options.program_time = read_program_time(flags.exec_timeout_s);
    const PairScorer scorer(registry, choose_metrics(registry, flags.metrics, "--metric"),
                            std::move(options));
    const RunFolder run = RunFolder::open(flags.run);
    const fs::path out = choose_output(flags);
    const KeptPictures kept = list_kept_pictures(run);
    if (kept.pictures.empty()) {
        throw InputError(flags.run, "keeps no pictures of finished rounds");
    }
    CsvTable table;
    const std::vector<ScoredGroup> groups = measure(kept.pictures, scorer, table);
    write_file_atomically(out, table.make_text());
    print_groups(groups);
    print_remarks(kept);
    fmt::print("scores: {}\n", out.string());
    return 0;
}

} // namespace

Action add_score_verb(CLI::App& app) {
    auto flags = std::make_shared<ScoreFlags>();
    app.add_option("run", flags->run, "run folder")->required();
    add_metric_option(app, flags->metrics, "of images: no motion is kept")->required();
    app.add_option("--out", flags->out, "file; default RUN/scores.csv, written anew");
    add_program_time_option(app, flags->exec_timeout_s);
    return [flags] { return score(*flags); };
}

} // namespace alcove
