#include "reports/junit/junit.hpp"

#include "reports/analysis/history_wording.hpp"
#include "reports/junit/escape.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

std::string describe_line(const NightLine& line) {
    std::string text = line.tonight;
    if (!line.baseline.empty()) {
        text += fmt::format(" against {}: {}", line.baseline, line.change);
    }
    if (!line.fence.empty()) {
        text += ", fence " + line.fence;
    }
    return line.note.empty() ? text : text + "; " + line.note;
}

std::string make_outcome(const NightLine& line) {
    const NightVerdict verdict = line.judged->verdict;
    const std::string text = escape_xml(describe_line(line));
    if (is_failure(verdict)) {
        return fmt::format("<failure message=\"{0}: {1}\" type=\"{0}\">{1}</failure>",
                           to_text(verdict), text);
    }
    if (verdict == NightVerdict::too_little_history) {
        return fmt::format("<skipped message=\"{}: {}\"/>", to_text(verdict), text);
    }
    return fmt::format("<system-out>{}: {}</system-out>", to_text(verdict), text);
}

std::string make_testcase(const Night& night, const JudgedPoint& judged) {
    const SeriesName& name = judged.point.name;
    const NightLine line = describe_point(night, judged);
    return fmt::format("    <testcase classname=\"{}\" name=\"{}\">{}</testcase>\n",
                       escape_xml(fmt::format("{}.{}", name.suite, describe_place(name))),
                       escape_xml(name.method + ": " + line.what), make_outcome(line));
}

} // namespace

std::string make_junit_xml(const Night& night) {
    std::string cases;
    std::size_t tests = 0;
    std::size_t failures = 0;
    for (const JudgedPoint& judged : night.points) {
        if (judged.verdict != NightVerdict::not_gated) {
            ++tests;
            failures += is_failure(judged.verdict) ? 1 : 0;
            cases += make_testcase(night, judged);
        }
    }
    const std::string counts =
        fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"", tests, failures,
                    night.count(NightVerdict::too_little_history));
    std::string properties;
    const auto add = [&](const char* property, const std::string& value) {
        properties += fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", property,
                                  escape_xml(value));
    };
    add("device", night.run.device);
    add("device_class", night.run.device_class);
    add("clock", night.run.timer_mode);
    add("build", night.run.build);
    add("commit", night.run.commit);
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n"
                       "  <testsuite name=\"{1}\" {0} timestamp=\"{2}\">\n"
                       "    <properties>\n{3}    </properties>\n{4}  </testsuite>\n</testsuites>\n",
                       counts, escape_xml("alcove " + night.run.suite), escape_xml(night.run.utc),
                       properties, cases);
}

} // namespace alcove
