#include "core/base/parameters_markdown.hpp"

#include "core/base/text.hpp"

namespace alcove {

std::string make_markdown_table(const ParameterTable& table) {
    std::string text = "| parameter | symbol | default | range | unit | meaning | source |\n"
                       "| --- | --- | --- | --- | --- | --- | --- |\n";
    for (const ParameterTable::Entry& entry : table.entries()) {
        const ParameterInfo& info = entry.info;
        std::string range;
        switch (info.kind) {
        case ParameterKind::boolean:
            range = "true, false";
            break;
        case ParameterKind::enumeration:
            for (const std::string& name : info.choices) {
                range += (range.empty() ? "" : ", ") + name;
            }
            break;
        case ParameterKind::integer:
        case ParameterKind::real:
            range = format_number(info.minimum) + " .. " + format_number(info.maximum) +
                    (info.may_be_infinite ? ", inf" : "") +
                    (info.scale == ParameterScale::log ? " (log)" : "");
            break;
        }
        const std::string default_text = info.default_expression.empty()
                                             ? to_text(info.default_value)
                                             : "= " + info.default_expression;
        text += "| `" + info.name + "` | " + info.symbol + " | " + default_text + " | " + range +
                " | " + info.unit + " | " + info.meaning +
                (info.inert_reason.empty() ? "" : " Inert: " + info.inert_reason) + " | " +
                info.source + " |\n";
    }
    return text;
}

} // namespace alcove
