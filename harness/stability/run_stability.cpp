#include "harness/stability/run_stability.hpp"

#include "harness/run/environment.hpp"
#include "harness/stability/stability_cases.hpp"

#include <algorithm>
#include <set>

namespace alcove {
namespace {

/// On the heap, so that references hold.
std::vector<std::unique_ptr<StabilitySubject>> make_subjects(const StabilityPlan& plan,
                                                             gl::Context& context,
                                                             const Registry<MethodUnit>& methods) {
    std::vector<std::unique_ptr<StabilitySubject>> subjects;
    std::set<std::string> labels;
    for (const MethodSpec& spec : plan.methods) {
        if (!labels.insert(spec.label).second) {
            throw InputError("--method", "the label stands twice", spec.label,
                             "labels that differ (METHOD#LABEL)");
        }
        subjects.push_back(
            std::make_unique<StabilitySubject>(context, methods.find(spec.method), spec));
    }
    return subjects;
}

StabilityMethodRecord describe(const StabilitySubject& subject) {
    StabilityMethodRecord record;
    record.label = subject.spec().label;
    record.method = subject.unit().name;
    record.preset = subject.spec().preset;
    record.content_hash = subject.unit().content_hash;
    for (const ParameterOverride& asked : subject.spec().overrides) {
        const ParameterInfo& info = subject.unit().parameters.find(asked.name);
        record.overrides.push_back({asked.name, asked.value, info.unit, info.symbol,
                                    std::string(to_text(asked.provenance))});
    }
    return record;
}

/// Safe as a part of a file's name: methods by their place, since labels are anybody's.
std::string make_picture_path(const std::string& case_name, std::size_t method,
                              std::size_t severity) {
    return "images/" + case_name + "/m" + std::to_string(method + 1) + "_s" +
           std::to_string(severity + 1) + ".png";
}

StabilityCellRecord measure(const StabilityCase& hard, const StabilitySubject& subject,
                            std::size_t method, ImageSize size, const StabilityEvents& events) {
    StabilityCellRecord cell;
    cell.case_name = hard.about.name;
    cell.label = subject.spec().label;
    cell.reason = hard.find_obstacle(subject);
    if (!cell.reason.empty()) {
        cell.outcome = StabilityOutcome::not_applicable;
        return cell;
    }
    std::vector<Image> pictures;
    for (const StabilitySeverityRecord& severity : hard.about.severities) {
        StabilityScore score = hard.measure(subject, size, severity.value);
        cell.scores.push_back({score.score, score.bound, score.fault, ""});
        pictures.push_back(std::move(score.picture));
    }
    const StabilityVerdict verdict = judge(cell.scores);
    cell.outcome = verdict.outcome;
    cell.worst_margin = verdict.worst_margin;
    if (verdict.outcome != StabilityOutcome::holds && events.picture) {
        for (const std::size_t i : std::set<std::size_t>{0, pictures.size() - 1}) {
            cell.scores[i].picture = make_picture_path(cell.case_name, method, i);
            events.picture({cell.scores[i].picture, std::move(pictures[i])});
        }
    }
    return cell;
}

} // namespace

std::vector<MethodSpec> list_default_stability_methods(const Registry<MethodUnit>& methods) {
    std::vector<MethodSpec> specs;
    for (const MethodUnit& unit : methods.units()) {
        if (unit.reported && !unit.is_reference) {
            specs.push_back(parse_method_spec(unit.name));
        }
    }
    for (const char* text : {"hemisphere_ssao@strong_blur", "tssao@paper_table2_vienna",
                             "tssao@paper_stills", "tssao:resolution=half"}) {
        specs.push_back(parse_method_spec(text));
    }
    return specs;
}

std::vector<StabilityCase> choose_cases(std::span<const std::string> names) {
    std::vector<StabilityCase> all = list_stability_cases();
    if (names.empty()) {
        return all;
    }
    std::vector<std::string> known;
    for (const StabilityCase& hard : all) {
        known.push_back(hard.about.name);
    }
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            throw InputError("--case", "unknown case", name, describe_choices(name, known));
        }
    }
    std::erase_if(all, [&](const StabilityCase& hard) {
        return std::find(names.begin(), names.end(), hard.about.name) == names.end();
    });
    return all;
}

StabilityRecord run_stability(const StabilityPlan& plan, gl::Context& context,
                              const Registry<MethodUnit>& methods, const StabilityEvents& events) {
    const auto subjects = make_subjects(plan, context, methods);
    StabilityRecord record;
    record.command_line = plan.command_line;
    record.width = plan.size.width;
    record.height = plan.size.height;
    record.context = describe_environment(context, {});
    for (const auto& subject : subjects) {
        record.methods.push_back(describe(*subject));
    }
    for (const StabilityCase& hard : plan.cases) {
        record.cases.push_back(hard.about);
        for (std::size_t i = 0; i < subjects.size(); ++i) {
            if (events.progress) {
                const auto done = static_cast<double>(record.cells.size());
                events.progress(done / static_cast<double>(plan.cases.size() * subjects.size()),
                                hard.about.name + ", " + subjects[i]->spec().label);
            }
            record.cells.push_back(measure(hard, *subjects[i], i, plan.size, events));
        }
    }
    return record;
}

} // namespace alcove
