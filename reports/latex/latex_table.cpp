#include "reports/latex/latex_table.hpp"

namespace alcove {
namespace {

std::string make_row(const std::vector<std::string>& fields) {
    std::string text;
    for (const std::string& field : fields) {
        text += text.empty() ? "  " : " & ";
        text += escape_latex(field);
    }
    return text + " \\\\\n";
}

} // namespace

std::string escape_latex(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
        case '&':
        case '%':
        case '$':
        case '#':
        case '_':
        case '{':
        case '}':
            escaped += '\\';
            escaped += c;
            break;
        case '~':
            escaped += "\\textasciitilde{}";
            break;
        case '^':
            escaped += "\\textasciicircum{}";
            break;
        case '\\':
            escaped += "\\textbackslash{}";
            break;
        case '<':
            escaped += "\\textless{}";
            break;
        case '>':
            escaped += "\\textgreater{}";
            break;
        case '|':
            escaped += "\\textbar{}";
            break;
        default:
            escaped += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
        }
    }
    return escaped;
}

std::string make_latex_table(const PaperTable& table) {
    std::string columns = "l";
    columns.append(table.columns.size() - 1, 'r');
    std::string text =
        "% needs \\usepackage{booktabs}\n\\begin{table}\n  \\centering\n  \\caption{" +
        escape_latex(table.title) + ". " + escape_latex(table.note) +
        ".}\n  \\label{tab:" + table.id + "}\n  \\begin{tabular}{" + columns + "}\n  \\toprule\n";
    text += make_row(table.columns) + "  \\midrule\n";
    for (const std::vector<std::string>& row : table.rows) {
        text += make_row(row);
    }
    return text + "  \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

} // namespace alcove
