// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads tool tables as CSV.
#include "tools/csv_tools.h"

#include "tools/comment_text.h"
#include "tools/tool_messages.h"
#include "tools/tool_words.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::toolpath {

namespace {

enum class Column : std::uint8_t {
    Number,
    Diameter,
    CornerRadius,
    FluteLength,
    ShankDiameter,
    TipDiameter,
    StickOut,
    Height,
    Pitch,
    Angle,
    Kind,
    Name,
    IsMetric,
    UnitName
};

// Names in upper case, without all but letters and digits.
constexpr std::pair<std::string_view, Column> kColumns[] = {
    {"NUMBER", Column::Number},
    {"NO", Column::Number},
    {"NR", Column::Number},
    {"T", Column::Number},
    {"TOOL", Column::Number},
    {"TOOLNO", Column::Number},
    {"TOOLNUMBER", Column::Number},
    {"TOOLNUM", Column::Number},
    {"DIAMETER", Column::Diameter},
    {"DIA", Column::Diameter},
    {"D", Column::Diameter},
    {"TOOLDIAMETER", Column::Diameter},
    {"CUTTERDIAMETER", Column::Diameter},
    {"CUTTINGDIAMETER", Column::Diameter},
    {"CORNERRADIUS", Column::CornerRadius},
    {"FLUTELENGTH", Column::FluteLength},
    {"CUTTINGLENGTH", Column::FluteLength},
    {"LENGTHOFCUT", Column::FluteLength},
    {"SHAFTDIAMETER", Column::ShankDiameter},
    {"SHANKDIAMETER", Column::ShankDiameter},
    {"TIPDIAMETER", Column::TipDiameter},
    {"STICKOUT", Column::StickOut},
    {"HEIGHT", Column::Height},
    {"HEIGHTOFFSET", Column::Height},
    {"LENGTHOFFSET", Column::Height},
    {"H", Column::Height},
    {"PITCH", Column::Pitch},
    {"ANGLE", Column::Angle},
    {"TIPANGLE", Column::Angle},
    {"INCLUDEDANGLE", Column::Angle},
    {"TYPE", Column::Kind},
    {"TOOLTYPE", Column::Kind},
    {"KIND", Column::Kind},
    {"SHAPE", Column::Kind},
    {"NAME", Column::Name},
    {"DESCRIPTION", Column::Name},
    {"DESC", Column::Name},
    {"COMMENT", Column::Name},
    {"TOOLNAME", Column::Name},
    {"METRIC", Column::IsMetric},
    {"UNIT", Column::UnitName},
    {"UNITS", Column::UnitName}};

// A column that is read.
struct Header {
    std::size_t place = 0;  // in the line, from 0
    Column column = Column::Number;
    std::optional<double> unit;  // mm, from the name: Diameter (in)
};

std::optional<double> unit_named(std::string_view upper) {
    if (upper == "\"" || upper == "IN." || upper == "ZOLL" || upper == "ENGLISH") return 25.4;
    if (upper == "MM" || upper == "METRIC" || upper == "MILLIMETER" || upper == "MILLIMETERS" ||
        upper == "MILLIMETRE" || upper == "MILLIMETRES")
        return 1.0;
    if (upper == "IN" || upper == "INCH" || upper == "INCHES" || upper == "IMPERIAL") return 25.4;
    return std::nullopt;
}

std::string letters_and_digits(std::string_view text) {
    std::string kept;
    for (const char c : text) {
        if ((c >= 'A' && c <= 'Z') || is_digit(c)) kept += c;
    }
    return kept;
}

// Returns the column of a name such as `Diameter (mm)`, `flute_length_in` or `Ø`.
std::optional<Header> header_of(std::string_view field) {
    const std::string upper = words::plain_upper(trimmed(field));
    Header header;
    std::string name = letters_and_digits(upper);
    // The last word may be a unit.
    const std::string_view words =
        std::string_view(upper).substr(0, upper.find_last_not_of(" )]}.") + 1);  // npos + 1 is 0
    const std::size_t cut = words.find_last_of(" ([{_-/");
    if (cut != std::string_view::npos) {
        header.unit = unit_named(letters_and_digits(words.substr(cut + 1)));
        if (header.unit) name = letters_and_digits(words.substr(0, cut));
    }
    const auto* const found = std::ranges::find(kColumns, std::string_view(name),
                                                [](const auto& row) { return row.first; });
    if (found == std::end(kColumns)) return std::nullopt;
    header.column = found->second;
    return header;
}

// A line of a table: its fields, and the number of its first line of text.
struct Row {
    std::vector<std::string> fields;
    std::uint32_t line = 1;
    bool is_empty() const {
        return std::ranges::all_of(fields, [](const std::string& f) { return trimmed(f).empty(); });
    }
    bool begins_with_hash() const { return trimmed(fields.front()).starts_with('#'); }
};

// Rows of a text, one at a time. A field in quotes may contain separators and ends of lines. A line
// ends with a line feed, a carriage return, or both.
class Rows {
public:
    Rows(std::string_view text, char separator) : text_(text), separator_(separator) {
        if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    }

    std::optional<Row> next() {
        if (text_.empty()) return std::nullopt;
        Row row;
        row.line = line_;
        for (bool goes_on = true; goes_on;) {
            row.fields.push_back(field());
            goes_on = text_.starts_with(separator_);
            if (goes_on) text_.remove_prefix(1);
        }
        end_line();
        return row;
    }

private:
    static constexpr std::string_view kLineEnds = "\r\n";

    // Removes an end of line, if there is one, and counts a line.
    void end_line() {
        ++line_;
        if (text_.starts_with(kLineEnds)) text_.remove_prefix(1);
        if (!text_.empty()) text_.remove_prefix(1);
    }

    // Removes and returns the text before the first of the characters `ends`.
    std::string_view taken(std::string_view ends) {
        const std::size_t end = std::min(text_.find_first_of(ends), text_.size());
        const std::string_view before = text_.substr(0, end);
        text_.remove_prefix(end);
        return before;
    }

    std::string field() {
        const std::string ends = std::string(kLineEnds) + separator_;
        if (!text_.starts_with('"')) return std::string(taken(ends));
        std::string quoted;
        text_.remove_prefix(1);
        while (!text_.empty()) {
            const char c = text_.front();
            text_.remove_prefix(1);
            if (c == '"' && !text_.starts_with('"')) break;
            if (c == '"') text_.remove_prefix(1);
            if (c == '\n' || (c == '\r' && !text_.starts_with('\n'))) ++line_;
            quoted += c;
        }
        quoted += trimmed(taken(ends));
        return quoted;
    }

    std::string_view text_;
    char separator_;
    std::uint32_t line_ = 1;
};

// Columns that are read, each once; empty unless there are a number and a diameter.
std::vector<Header> columns_of(const Row& row) {
    std::vector<Header> columns;
    const auto has = [&](Column c) { return std::ranges::count(columns, c, &Header::column) > 0; };
    for (std::size_t i = 0; i < row.fields.size(); ++i) {
        auto header = header_of(row.fields[i]);
        if (!header || has(header->column)) continue;
        header->place = i;
        columns.push_back(*header);
    }
    if (!has(Column::Number) || !has(Column::Diameter)) columns.clear();
    return columns;
}

// The columns of a text, and the rows behind the names.
struct Table {
    std::vector<Header> columns;
    char separator = ',';
    Rows rows;
};

// True for the line "sep=;" of spreadsheets. The line is read with the separator that is named.
bool names_separator(const Row& row) {
    return row.line == 1 && row.fields.size() == 2 && row.fields[1].empty() &&
           uppercase(trimmed(row.fields[0])) == "SEP=";
}

// True for a line that begins with # and names no columns.
bool is_comment(const Row& row) {
    return row.begins_with_hash() && columns_of(row).empty();
}

std::optional<Table> table_of(std::string_view text) {
    if (trimmed(text).starts_with(';')) return std::nullopt;  // LinuxCNC's comment
    for (const char separator : {',', ';', '\t'}) {
        Rows rows(text, separator);
        auto row = rows.next();
        while (row && (row->is_empty() || names_separator(*row) || is_comment(*row)))
            row = rows.next();
        if (!row) return std::nullopt;
        auto columns = columns_of(*row);
        if (!columns.empty()) return Table{std::move(columns), separator, rows};
    }
    return std::nullopt;
}

// A row by names of columns.
class Line {
public:
    Line(const Row& row, const Table& table, double unit) : row_(row), table_(table), unit_(unit) {
        const std::string metric = uppercase(text_of(Column::IsMetric));
        if (metric == "0" || metric == "0.0" || metric == "FALSE" || metric == "NO" ||
            metric == "N")
            unit_ = 25.4;
        else if (metric == "1" || metric == "1.0" || metric == "TRUE" || metric == "YES" ||
                 metric == "Y")
            unit_ = 1.0;
        else
            broken_ = text_of(Column::IsMetric);
        const std::string_view name = text_of(Column::UnitName);
        if (name.empty()) return;
        if (const auto named = unit_named(uppercase(name)))
            unit_ = *named;
        else
            broken_ = name;
    }

    std::string_view text_of(Column column) const {
        const Header* const header = header_of(column);
        return header && header->place < row_.fields.size() ? trimmed(row_.fields[header->place])
                                                            : std::string_view();
    }

    // Returns a number that fills its field, as written. Empty for an empty field, and for another
    // text, which broken() then returns.
    std::optional<text::Quantity> number_of(Column column) {
        std::string written = uppercase(text_of(column));
        if (written.empty()) return std::nullopt;
        if (table_.separator != ',') std::ranges::replace(written, ',', '.');
        const auto value = text::quantity_at(written, 0);
        if (value && value->end == written.size()) return value;
        if (broken_.empty()) broken_ = text_of(column);
        return std::nullopt;
    }

    // In mm; empty for zero.
    std::optional<double> length_of(Column column) {
        const auto value = number_of(column);
        if (!value || value->value == 0.0) return std::nullopt;
        double unit = header_of(column)->unit.value_or(unit_);
        if (value->unit == text::Unit::Millimetre) unit = 1.0;
        if (value->unit == text::Unit::Inch || value->is_fraction) unit = 25.4;
        const double mm = unit * value->value;
        if (!text::is_sane_length(mm) && broken_.empty()) broken_ = text_of(column);
        return text::is_sane_length(mm) ? std::optional(mm) : std::nullopt;
    }

    // A field that is no number, or no possible length.
    const std::string& broken() const { return broken_; }

private:
    const Header* header_of(Column column) const {
        const auto found = std::ranges::find(table_.columns, column, &Header::column);
        return found == table_.columns.end() ? nullptr : &*found;
    }

    const Row& row_;
    const Table& table_;
    double unit_;
    std::string broken_;
};

// Sets the kind from its column, or from the name of the tool.
void set_kind(const Line& line, ToolSpec& spec) {
    const std::string type(line.text_of(Column::Kind));
    spec.description = std::string(line.text_of(Column::Name));
    if (uppercase(type) == "CHAMFER") spec.kind = ToolKind::ChamferMill;
    if (!spec.kind) spec.kind = words::kind_named(type);
    // "end" is an end mill; "foo mill" is no kind.
    if (!spec.kind && !type.empty() && type.find(' ') == std::string::npos)
        spec.kind = words::kind_named(type + " MILL");
    if (!spec.kind) take_kind(spec.description, spec);
}

void read_row(const Row& row, const Table& table, double unit, Collector& out) {
    Line line(row, table, unit);
    const gcode::SourceSpan span{row.line, 1, 0};
    std::string written = uppercase(line.text_of(Column::Number));
    if (written.size() > 1 && written[0] == 'T' && is_digit(written[1])) written.erase(0, 1);
    const auto number = text::quantity_at(written, 0);
    constexpr double kMostTools = 1e8;
    if (written.empty() || written == "0") return;
    const bool is_number =
        number && number->end == written.size() && number->value >= 1 && number->value < kMostTools;
    if (!is_number && row.begins_with_hash()) return;  // A comment; "#201" may also be a name.
    if (!is_number) return out.add_remark(Message::CsvNumber, span, {text::quoted(written)});
    ToolSpec spec;
    spec.number = static_cast<int>(number->value);
    spec.diameter = line.length_of(Column::Diameter);
    set_kind(line, spec);
    if (const std::string_view type = line.text_of(Column::Kind); !spec.kind && !type.empty())
        return out.add_remark(Message::TypeUnknown, span,
                              {std::to_string(spec.number), text::quoted(type)});
    const auto set = [&](std::optional<double>& value, Column column) {
        if (const auto read = line.length_of(column)) value = read;
    };
    set(spec.length, Column::FluteLength);
    set(spec.shank_diameter, Column::ShankDiameter);
    set(spec.stick_out, Column::StickOut);
    set(spec.pitch, Column::Pitch);
    if (is_conical(spec.kind)) set(spec.tip_diameter, Column::TipDiameter);
    set(spec.corner_radius, Column::CornerRadius);
    if (const auto angle = line.number_of(Column::Angle); angle && angle->value > 0)
        (spec.kind == ToolKind::TaperedEndMill ? spec.taper : spec.angle) = angle->value;
    const double height = line.length_of(Column::Height).value_or(0.0);
    if (!line.broken().empty()) {
        return out.add_remark(Message::CsvValue, span,
                              {std::to_string(spec.number), text::quoted(line.broken())});
    }
    std::string text = spec.description;
    out.keep(std::move(spec), {0.0, 0.0, height}, span, std::move(text));
}

}  // namespace

bool is_csv_table(std::string_view text) {
    return table_of(text).has_value();
}

void read_csv_table(const gcode::SourceFile& file, double unit, Collector& out) {
    auto table = table_of(file.text);
    while (const auto row = table ? table->rows.next() : std::nullopt)
        read_row(*row, *table, unit, out);
}

}  // namespace ncsim::toolpath
