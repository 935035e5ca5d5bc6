// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comments, tools and stock of SINUMERIK programs, and listings.
#include "ncsim/gcode/sinumerik.h"

#include "ncsim/gcode/dialect.h"

#include "language/notes.h"
#include "sinumerik/line_reader.h"
#include "sinumerik/sinumerik_runner.h"
#include "text/code_scanner.h"
#include "text/message.h"
#include "text/number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {
namespace {

using sinumerik::Line;
using sinumerik::name_at;

/// A field of WORKPIECE: a number, a text, or empty.
struct Field {
    std::optional<double> number;
    std::string text;
};

/// Returns the fields of WORKPIECE(…); empty for other code, or if a value is no number.
std::vector<Field> workpiece_fields(std::string_view code) {
    CodeScanner scan(code);
    std::vector<Field> fields;
    if (!scan.take_word("WORKPIECE") || !scan.take('(')) return fields;
    do {
        Field& field = fields.emplace_back();
        if (const auto text = scan.quoted()) {
            field.text = upper_of(*text);
            continue;
        }
        scan.skip_blanks();
        const std::string_view rest = scan.remaining();
        const PlainNumber number = read_plain_number(rest.data(), rest.data() + rest.size());
        if (number.end) {
            field.number = number.value;
            scan.move_to(scan.at() + static_cast<std::size_t>(number.end - rest.data()));
        }
    } while (scan.take(',') && fields.size() < 20);
    if (!scan.take(')')) fields.clear();
    return fields;
}

/// Lower and upper end of the blank along Z. Bit 64 of the mode: the end is absolute.
std::optional<std::array<double, 2>> heights_of(const std::vector<Field>& fields) {
    if (fields.size() < 7 || !fields[5].number || !fields[6].number) return std::nullopt;
    const auto mode = static_cast<long>(std::clamp(fields[4].number.value_or(0.0), 0.0, 1e6));
    const double first = *fields[5].number;
    const double second = (mode & 64) != 0 ? *fields[6].number : first + *fields[6].number;
    if (!(first != second)) return std::nullopt;
    return std::array{std::min(first, second), std::max(first, second)};
}

}  // namespace

bool is_sinumerik(const SourceFile& program) {
    constexpr std::size_t kHead = 256'000;
    constexpr auto kSigns = std::to_array<std::string_view>(
        {"=", "\"", "(", "_", "SUPA", "TRA", "ROT", "SCALE", "MIRROR", "PROC", "DEF", "GOTO",
         "CASE", "MCALL", "FNORM", "STOPRE", "G70", "G71", "G500"});
    const std::string_view head = std::string_view(program.text).substr(0, kHead);
    const std::string ending =
        program.name.size() < 4 ? "" : upper_of(program.name.substr(program.name.size() - 4));
    const bool is_named = ending == ".MPF" || ending == ".SPF";
    const bool is_possible = is_named || std::ranges::any_of(kSigns, [head](std::string_view sign) {
                                 return head.find(sign) != std::string_view::npos;
                             });
    if (!is_possible) return false;
    if (program.text.size() <= kHead) return detect_dialect(program).kind == Kind::Siemens;
    return detect_dialect({program.name, std::string(head)}).kind == Kind::Siemens;
}

struct SinumerikNotes::State : language::NoteWriter {
    explicit State(const SourceFile& program)
        : NoteWriter(sinumerik::tool_names(program)), reader(program) {}

    void blank(Block& block);
    void words(Block& block);
    std::size_t word(Block& block, std::size_t at);

    sinumerik::Reader reader;
    Line line;
};

/// WORKPIECE(,,,"BOX",mode,ZA,ZI,ZB,X0,Y0,X1,Y1). Bits 16 and 32: X1 and Y1 are absolute.
void SinumerikNotes::State::blank(Block& block) {
    const std::vector<Field> fields = workpiece_fields(line.code);
    if (fields.size() < 12 || fields[3].text != "BOX") return;
    const auto heights = heights_of(fields);
    if (!heights) return;
    const auto mode = static_cast<long>(std::clamp(fields[4].number.value_or(0.0), 0.0, 1e6));
    std::array<double, 3> least{0.0, 0.0, (*heights)[0]};
    std::array<double, 3> most{0.0, 0.0, (*heights)[1]};
    for (std::size_t i = 0; i < 2; ++i) {
        if (!fields[8 + i].number || !fields[10 + i].number) return;
        const double first = *fields[8 + i].number;
        const bool is_absolute = (mode & (i == 0 ? 16 : 32)) != 0;
        const double second = is_absolute ? *fields[10 + i].number : first + *fields[10 + i].number;
        least[i] = std::min(first, second);
        most[i] = std::max(first, second);
    }
    add_corner(block, "BLK FORM 0.1 Z", least, line.whole());
    add_corner(block, "BLK FORM 0.2", most, line.whole());
}

/// Reads the word at `at`, if any. Returns the offset behind it.
std::size_t SinumerikNotes::State::word(Block& block, std::size_t at) {
    const char letter = upper(line.code[at]);
    CodeScanner scan(line.code, at + 1);
    const bool has_sign = scan.take('=');
    const SourceSpan span = line.span(at, 1);
    if (letter == 'T' && has_sign) {
        if (const auto name = scan.quoted()) {
            add_tool(block, *name, span);
            return scan.at();
        }
    }
    scan.skip_blanks();
    const std::string_view rest = scan.remaining();
    const PlainNumber number = read_plain_number(rest.data(), rest.data() + rest.size());
    const bool is_axis = letter >= 'X' && letter <= 'Z';
    if (!number.end) {
        if (is_axis && has_sign) add(block, letter, 0.0, span);
        return at + 1;
    }
    const double value = number.value;
    if (is_axis || (letter == 'T' && value >= 1.0)) add(block, letter, value, span);
    if (letter == 'F' || letter == 'S') add(block, letter, value, span);
    if (letter == 'G') {
        if (value == 70.0 || value == 700.0) add(block, 'G', 20.0, span);
        if (value == 71.0 || value == 710.0) add(block, 'G', 21.0, span);
        const bool is_same = (value >= 0.0 && value <= 3.0) || value == 53.0 || value == 90.0 ||
                             value == 91.0 || (value >= 54.0 && value <= 57.0);
        if (is_same) add(block, 'G', value, span);
    }
    if (letter == 'M') add(block, 'M', value, span);
    return scan.at() + static_cast<std::size_t>(number.end - rest.data());
}

void SinumerikNotes::State::words(Block& block) {
    const std::string_view code = line.code;
    std::size_t at = 0;
    while (at < code.size()) {
        if (!is_letter(code[at]) && code[at] != '_' && code[at] != '$') {
            if (code[at] == '"') at = std::min(code.find('"', at + 1), code.size() - 1);
            ++at;
            continue;
        }
        const std::string_view name = name_at(code.substr(at));
        if (name.size() == 4 && upper_of(name) == "SUPA")
            add(block, 'G', 53.0, line.span(at, name.size()));
        const bool is_word = name.size() == 1 || is_digit(name[1]);
        at = is_word ? std::max(word(block, at), at + 1) : at + name.size();
    }
}

SinumerikNotes::SinumerikNotes(const SourceFile& program)
    : state_(std::make_unique<State>(program)) {}
SinumerikNotes::~SinumerikNotes() = default;

bool SinumerikNotes::next(Block& block) {
    State& s = *state_;
    if (!s.reader.next(s.line)) return false;
    s.begin_block(block);
    block.line = s.line.line;
    block.text = s.line.code;
    block.block_delete = s.line.block_delete;
    block.comments = s.line.comments;
    const std::string_view name = name_at(s.line.code);
    const std::string first = name.size() > 2 ? upper_of(name) : std::string();
    if (s.line.is_head || first == "DEF" || first == "PROC" || first == "EXTERN") return true;
    if (first == "WORKPIECE") {
        s.blank(block);
    } else if (s.line.code.find('(') == std::string_view::npos ||
               s.line.code.find('=') != std::string_view::npos) {
        s.words(block);
    }
    return true;
}

std::optional<RoundBlank> sinumerik_cylinder(const SourceFile& program) {
    sinumerik::Reader reader(program);
    Line line;
    double unit = 1.0;
    while (reader.next(line)) {
        const std::string code = upper_of(line.code);
        if (code.find("G70") != std::string::npos) unit = 25.4;  // G70, G700
        const std::vector<Field> fields = workpiece_fields(line.code);
        if (fields.size() < 9 || fields[3].text != "CYLINDER" || !fields[8].number) continue;
        const auto heights = heights_of(fields);
        const double diameter = *fields[8].number;
        if (!heights || !(diameter > 0.0)) continue;
        RoundBlank found;
        found.span = line.whole();
        found.text = std::string(line.code);
        found.radius = Length::from_mm(diameter / 2.0 * unit);
        found.length = Length::from_mm(((*heights)[1] - (*heights)[0]) * unit);
        found.top = Length::from_mm((*heights)[1] * unit);
        return found;
    }
    return std::nullopt;
}

struct SinumerikListing::State {
    explicit State(const SourceFile& program) : reader(program) {}
    sinumerik::Reader reader;
    Line line;
};

SinumerikListing::SinumerikListing(const SourceFile& program)
    : state_(std::make_unique<State>(program)) {}
SinumerikListing::~SinumerikListing() = default;

bool SinumerikListing::next(ListedBlock& block, DiagnosticLog& log) {
    (void)log;  // Only execution reads the code.
    State& s = *state_;
    do {
        if (!s.reader.next(s.line)) return false;
    } while (s.line.code.empty() && s.line.label.empty());
    block.line = s.line.line;
    block.is_readable = true;
    block.text.clear();
    if (!s.line.label.empty())
        block.text.append(s.line.label).append(s.line.code.empty() ? ":" : ": ");
    language::append_with_single_blanks(block.text, s.line.code);
    return true;
}

}  // namespace ncsim::gcode
