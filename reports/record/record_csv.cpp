#include "reports/record/record_csv.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "reports/record/csv.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

const std::vector<std::string> kSampleColumns = {"schema", "round",   "cell",  "segment",
                                                 "frame",  "repeat",  "kind",  "state",
                                                 "pass",   "time_ns", "cached"};
const std::vector<std::string> kMetricColumns = {"schema",   "round", "cell",   "segment",
                                                 "frame",    "state", "metric", "value",
                                                 "debiased", "floor", "note",   "image_hash"};

std::string join(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        text += (text.empty() ? "" : ",") + name;
    }
    return text;
}

/// What is not finite is no value; the row's note says why.
std::string format_optional(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? format_number(*value) : std::string();
}

/// One line, read column by column from the left.
class Line {
  public:
    Line(const std::vector<std::string>& fields, const std::vector<std::string>& columns,
         std::string where)
        : m_fields(fields), m_columns(columns), m_where(std::move(where)) {
        if (fields.size() != columns.size()) {
            throw InputError(m_where, "the number of fields is wrong",
                             std::to_string(fields.size()),
                             std::to_string(columns.size()) + " (" + join(columns) + ")");
        }
    }

    const std::string& take() { return m_fields[m_column++]; }

    const std::string& take_filled() {
        const std::string& text = take();
        if (text.empty()) {
            fail("the field is empty", "", "a name");
        }
        return text;
    }

    std::int64_t take_integer(std::int64_t lowest, std::int64_t highest) {
        const std::string& text = take();
        const std::int64_t value = parse_integer(text, place());
        if (value < lowest || value > highest) {
            fail("out of range", text, std::to_string(lowest) + " to " + std::to_string(highest));
        }
        return value;
    }

    std::optional<double> take_optional() {
        const std::string& text = take();
        if (text.empty()) {
            return std::nullopt;
        }
        const double value = parse_number(text, place());
        if (!std::isfinite(value)) {
            fail("not finite", text, "a finite number, or nothing and a note");
        }
        return value;
    }

    /// The enumerator (0 or 1) whose text stands here.
    template <class Enum>
    Enum take_choice() {
        const std::string& text = take();
        for (const Enum value : {Enum(0), Enum(1)}) {
            if (text == to_text(value)) {
                return value;
            }
        }
        fail("unknown name", text,
             std::string(to_text(Enum(0))) + " or " + std::string(to_text(Enum(1))));
    }

    void expect(std::string_view expected, std::string_view what) {
        if (const std::string& text = take(); text != expected) {
            fail(what, text, expected);
        }
    }

    /// Throws about the column taken last.
    [[noreturn]] void fail(std::string_view what, std::string_view found,
                           std::string_view expected) const {
        throw InputError(place(), what, found, expected);
    }

  private:
    [[nodiscard]] std::string place() const {
        return m_where + ": column " + m_columns[m_column - 1];
    }

    const std::vector<std::string>& m_fields;
    const std::vector<std::string>& m_columns;
    std::string m_where;
    std::size_t m_column = 0;
};

/// The columns both tables begin with, from schema to frame.
template <class Row>
void take_place(Line& line, Row& row, const RoundRecord& round) {
    line.expect(std::to_string(kRunSchemaVersion), "another schema version");
    line.expect(round.id, "a row of another round");
    row.round = round.id;
    row.cell = line.take();
    const bool known = row.cell == kHarnessCell ||
                       std::any_of(round.cells.begin(), round.cells.end(),
                                   [&](const CellRecord& cell) { return cell.id == row.cell; });
    if (!known) {
        line.fail("unknown cell", row.cell, "a cell of round " + round.id + " in plan.json");
    }
    row.segment = static_cast<int>(
        line.take_integer(0, static_cast<std::int64_t>(round.segments.size()) - 1));
    const SegmentRecord& segment = round.segments[static_cast<std::size_t>(row.segment)];
    row.frame = static_cast<int>(line.take_integer(segment.begin, segment.end - 1));
}

template <class Row, class Take>
std::vector<Row> parse_rows(std::string_view text, std::string_view file,
                            const std::vector<std::string>& columns, const Take& take) {
    CsvReader reader(text, file);
    std::vector<std::string> fields;
    if (!reader.next(fields) || fields != columns) {
        throw InputError(reader.where(), "the header is wrong", join(fields), join(columns));
    }
    std::vector<Row> rows;
    while (reader.next(fields)) {
        Line line(fields, columns, reader.where());
        rows.push_back(take(line));
    }
    return rows;
}

} // namespace

std::string make_samples_csv(const std::vector<SampleRow>& rows) {
    std::string text;
    append_csv_line(text, kSampleColumns);
    for (const SampleRow& row : rows) {
        append_csv_line(text, {std::to_string(kRunSchemaVersion), row.round, row.cell,
                               std::to_string(row.segment), std::to_string(row.frame),
                               std::to_string(row.repeat), std::string(to_text(row.kind)),
                               std::string(to_text(row.state)), row.pass,
                               std::to_string(row.time_ns), row.cached ? "1" : "0"});
    }
    return text;
}

std::string make_metrics_csv(const std::vector<MetricRow>& rows) {
    std::string text;
    append_csv_line(text, kMetricColumns);
    for (const MetricRow& row : rows) {
        append_csv_line(text, {std::to_string(kRunSchemaVersion), row.round, row.cell,
                               std::to_string(row.segment), std::to_string(row.frame),
                               std::string(to_text(row.state)), row.metric,
                               format_optional(row.value), format_optional(row.debiased),
                               format_optional(row.floor), row.note, row.image_hash});
    }
    return text;
}

std::vector<SampleRow> parse_samples_csv(std::string_view text, std::string_view file,
                                         const RoundRecord& round, int repeats) {
    return parse_rows<SampleRow>(text, file, kSampleColumns, [&](Line& line) {
        SampleRow row;
        take_place(line, row, round);
        row.repeat = static_cast<int>(line.take_integer(0, repeats - 1));
        row.kind = line.take_choice<SampleKind>();
        row.state = line.take_choice<SampleState>();
        row.pass = line.take_filled();
        row.time_ns = line.take_integer(std::numeric_limits<std::int64_t>::min(),
                                        std::numeric_limits<std::int64_t>::max());
        row.cached = line.take_integer(0, 1) == 1;
        return row;
    });
}

std::vector<MetricRow> parse_metrics_csv(std::string_view text, std::string_view file,
                                         const RoundRecord& round) {
    return parse_rows<MetricRow>(text, file, kMetricColumns, [&](Line& line) {
        MetricRow row;
        take_place(line, row, round);
        row.state = line.take_choice<SampleState>();
        row.metric = line.take_filled();
        row.value = line.take_optional();
        row.debiased = line.take_optional();
        row.floor = line.take_optional();
        row.note = line.take();
        row.image_hash = line.take();
        if (!row.image_hash.empty() &&
            (row.image_hash.size() != 16 ||
             row.image_hash.find_first_not_of("0123456789abcdef") != std::string::npos)) {
            line.fail("not a hash", row.image_hash, "16 hexadecimal digits");
        }
        return row;
    });
}

} // namespace alcove
