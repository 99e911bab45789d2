#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "harness/app/verbs.hpp"
#include "reports/record/record.hpp"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// RUN[/ROUND[/CELL]]
struct CellPath {
    fs::path run;
    std::string round;
    std::string cell;
};

CellPath parse_cell_path(const std::string& text) {
    fs::path path = fs::path(text).lexically_normal();
    if (!path.has_filename()) { // RUN/
        path = path.parent_path();
    }
    CellPath result;
    std::vector<std::string> tail;
    while (!fs::is_regular_file(path / "plan.json")) {
        tail.push_back(path.filename().string());
        path = path.parent_path();
        if (tail.size() > 2 || path.empty()) {
            throw InputError("why", "no run", text,
                             "RUN[/ROUND[/CELL]], for example "
                             "runs/20260101T000000Z-quick/r001-bunny/c2-tssao");
        }
    }
    result.run = path;
    if (!tail.empty()) {
        result.round = tail.back();
        result.cell = tail.size() > 1 ? tail.front() : "";
    }
    return result;
}

void print_item(const std::string& round, const ReuseRecord& item, bool with_ingredients) {
    fmt::print("{}/{}: {}: {}\n", round, item.what, item.outcome, item.reason);
    if (!with_ingredients) {
        return;
    }
    for (const IngredientRecord& name : item.names) {
        fmt::print("  {:<32}{}\n", name.name, name.value);
    }
    for (const IngredientRecord& content : item.contents) {
        fmt::print("  {:<32}{}\n", content.name, content.value);
    }
}

bool print_round(const RoundRecord& round, const RoundDone& done, const std::string& cell) {
    bool is_found = false;
    for (const ReuseRecord& item : done.reuse) {
        if (cell.empty() || item.what == cell) {
            print_item(round.id, item, !cell.empty());
            is_found = true;
        }
    }
    if (cell.empty()) {
        fmt::print("{}: G-buffers {} drawn, {} loaded; references {} made, {} reused; {} audited; "
                   "passes are timed in every run\n",
                   round.id, done.gbuffers_drawn, done.gbuffers_loaded, done.references_made,
                   done.references_reused, done.audited);
    }
    return is_found;
}

int explain(const std::string& text) {
    const CellPath path = parse_cell_path(text);
    const RunFolder run = RunFolder::open(path.run);
    std::vector<std::string> rounds;
    std::vector<std::string> cells;
    bool is_found = false;
    for (const RoundRecord& round : run.plan().rounds) {
        rounds.push_back(round.id);
        if (!path.round.empty() && round.id != path.round) {
            continue;
        }
        const std::optional<RoundDone> done = run.read_done(round.id);
        if (!done) {
            fmt::print("{}: not finished\n", round.id);
            is_found = true;
            continue;
        }
        for (const ReuseRecord& item : done->reuse) {
            cells.push_back(item.what);
        }
        is_found = print_round(round, *done, path.cell) || is_found || path.cell.empty();
    }
    if (!is_found) {
        throw path.cell.empty()
            ? InputError("why", "no such round", path.round, describe_choices(path.round, rounds))
            : InputError("why", "no such cell", path.cell, describe_choices(path.cell, cells));
    }
    return 0;
}

} // namespace

Action add_why_verb(CLI::App& app) {
    auto cell = std::make_shared<std::string>();
    app.add_option("cell", *cell, "RUN[/ROUND[/CELL]]: which ingredient made it run or be reused")
        ->required();
    return [cell] { return explain(*cell); };
}

} // namespace alcove
