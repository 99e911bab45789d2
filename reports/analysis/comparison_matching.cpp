#include "reports/analysis/comparison_matching.hpp"

#include <algorithm>
#include <array>

#include <fmt/core.h>

namespace alcove {
namespace {

struct Field {
    const char* name;
    std::string value;
    friend bool operator==(const Field&, const Field&) = default;
};

/// What makes rounds of two runs the same question.
std::array<Field, 8> make_key(const RoundRecord& round) {
    return {{{"scene", round.scene},
             {"walkthrough", round.walkthrough},
             {"target", round.target},
             {"size", fmt::format("{}x{}", round.width, round.height)},
             {"precision", round.precision},
             {"segments", describe_segments(round)},
             {"warm", round.warm ? "yes" : "no"},
             {"reference", describe_configuration(round.reference)}}};
}

struct OpenCell {
    PlacedCell place;
    bool is_taken = false;
};

/// Methods of finished rounds.
std::vector<OpenCell> list_cells(const RunFolder& run) {
    std::vector<OpenCell> cells;
    for (const RoundRecord& round : run.plan().rounds) {
        if (!run.is_finished(round.id)) {
            continue;
        }
        for (const CellRecord& cell : round.cells) {
            if (cell.role == CellRole::method) {
                cells.push_back({{&round, &cell}});
            }
        }
    }
    return cells;
}

bool are_partners(const PlacedCell& a, const PlacedCell& b) {
    return a.cell->label == b.cell->label && a.cell->method == b.cell->method &&
           a.cell->effects == b.cell->effects && make_key(*a.round) == make_key(*b.round);
}

/// What the closest round of the other run has otherwise; empty if a round there is the same.
std::string explain_round(const RoundRecord& round, const RunFolder& other) {
    const auto key = make_key(round);
    std::string closest;
    std::size_t fewest = key.size() + 1;
    for (const RoundRecord& candidate : other.plan().rounds) {
        const auto there = make_key(candidate);
        std::string text;
        std::size_t different = 0;
        for (std::size_t i = 0; i < key.size(); ++i) {
            if (key[i] != there[i]) {
                ++different;
                text += fmt::format("{}{} {} there", text.empty() ? "" : ", ", there[i].name,
                                    there[i].value);
            }
        }
        const bool is_other_scene = candidate.scene != round.scene;
        if (different == 0 || (different < fewest && !is_other_scene)) {
            fewest = different;
            closest = text;
        }
        if (different == 0) {
            break;
        }
    }
    return fewest > key.size() ? "the other run does not have the scene" : closest;
}

std::string explain_cell(const PlacedCell& place, const RunFolder& other) {
    const std::string round = explain_round(*place.round, other);
    if (!round.empty()) {
        return round;
    }
    const auto key = make_key(*place.round);
    for (const RoundRecord& candidate : other.plan().rounds) {
        for (const CellRecord& cell : candidate.cells) {
            if (make_key(candidate) != key || cell.label != place.cell->label) {
                continue;
            }
            if (!other.is_finished(candidate.id)) {
                return "its round is not finished in the other run";
            }
            if (cell.method != place.cell->method) {
                return "method " + cell.method + " there";
            }
            if (cell.effects != place.cell->effects) {
                return "effects " + cell.effects + " there";
            }
        }
    }
    return "the other run does not have it";
}

void add_unpaired(std::vector<Unpaired>& unpaired, const std::vector<OpenCell>& cells,
                  const RunFolder& run, const RunFolder& other, bool is_base) {
    for (const OpenCell& cell : cells) {
        if (!cell.is_taken) {
            unpaired.push_back({is_base,
                                cell.place.cell->label + " in " + describe_place(*cell.place.round),
                                explain_cell(cell.place, other)});
        }
    }
    for (const RoundRecord& round : run.plan().rounds) {
        if (!run.is_finished(round.id)) {
            unpaired.push_back({is_base, "all of " + describe_place(round),
                                "the round is not finished: continue with --resume"});
        }
    }
}

} // namespace

std::string describe_segments(const RoundRecord& round) {
    std::string text;
    for (const SegmentRecord& segment : round.segments) {
        text += fmt::format("{}{}:{}", text.empty() ? "" : ",", segment.begin, segment.end);
    }
    return text;
}

std::string describe_configuration(const CellRecord& cell) {
    std::string text = cell.label;
    for (const ParameterRecord& parameter : cell.parameters) {
        text += fmt::format(" {}={}", parameter.name, parameter.value);
    }
    return text;
}

std::string describe_place(const RoundRecord& round) {
    return fmt::format("{} {}x{}, {}", round.scene, round.width, round.height, round.target);
}

MatchedCells match_cells(const RunFolder& base, const RunFolder& next) {
    MatchedCells matched;
    std::vector<OpenCell> base_cells = list_cells(base);
    std::vector<OpenCell> next_cells = list_cells(next);
    for (OpenCell& cell : base_cells) {
        const auto partner =
            std::find_if(next_cells.begin(), next_cells.end(), [&](const OpenCell& other) {
                return !other.is_taken && are_partners(cell.place, other.place);
            });
        if (partner != next_cells.end()) {
            cell.is_taken = true;
            partner->is_taken = true;
            matched.pairs.emplace_back(cell.place, partner->place);
        }
    }
    add_unpaired(matched.unpaired, base_cells, base, next, true);
    add_unpaired(matched.unpaired, next_cells, next, base, false);
    return matched;
}

std::vector<ParameterChange> list_parameter_changes(const CellRecord& base,
                                                    const CellRecord& next) {
    std::vector<ParameterChange> changes;
    const auto find = [](const CellRecord& cell, const std::string& name) {
        const auto found =
            std::find_if(cell.parameters.begin(), cell.parameters.end(),
                         [&](const ParameterRecord& parameter) { return parameter.name == name; });
        return found == cell.parameters.end() ? std::nullopt : std::optional(found->value);
    };
    for (const ParameterRecord& parameter : base.parameters) {
        const auto there = find(next, parameter.name);
        if (there != parameter.value) {
            changes.push_back({parameter.name, parameter.value, there});
        }
    }
    for (const ParameterRecord& parameter : next.parameters) {
        if (!find(base, parameter.name)) {
            changes.push_back({parameter.name, std::nullopt, parameter.value});
        }
    }
    return changes;
}

} // namespace alcove
