#include "reports/markdown/night_markdown.hpp"

#include "reports/analysis/history_wording.hpp"
#include "reports/markdown/escape.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

std::string make_row(const NightLine& line, const std::string& device_class) {
    const SeriesName& name = line.judged->point.name;
    const std::string verdict(to_text(line.judged->verdict));
    const bool is_time = has_logarithm(line.judged->point.kind);
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                       is_failure(line.judged->verdict) ? "**" + verdict + "**" : verdict,
                       escape_markdown(name.method), escape_markdown(describe_place(name)),
                       escape_markdown(line.what),
                       escape_markdown(line.tonight + (is_time ? " (" + device_class + ")" : "")),
                       escape_markdown(line.baseline), escape_markdown(line.change),
                       escape_markdown(line.fence), escape_markdown(line.note));
}

} // namespace

std::string make_night_markdown(const Night& night) {
    std::string text =
        fmt::format("### Alcove, {}: {}\n\n{}, build {}{}, {} earlier nights of this device and "
                    "suite\n\n{}\n\n",
                    escape_markdown(night.run.suite), summarize_night(night),
                    escape_markdown(night.run.utc), escape_markdown(night.run.build),
                    night.run.commit.empty() ? "" : ", commit " + escape_markdown(night.run.commit),
                    night.past_nights, escape_markdown(describe_device(night.run)));
    const std::vector<NightLine> lines = list_findings(night);
    if (lines.empty()) {
        text += "Nothing left its fence.\n";
    } else {
        text += "| verdict | method | where | what | tonight | baseline | change | fence | |\n"
                "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
        for (const NightLine& line : lines) {
            text += make_row(line, night.run.device_class);
        }
    }
    text += "\n<details><summary>how this was judged</summary>\n\n";
    for (const std::string& line : describe_rules()) {
        text += "- " + escape_markdown(line) + "\n";
    }
    return text + "\n</details>\n";
}

} // namespace alcove
