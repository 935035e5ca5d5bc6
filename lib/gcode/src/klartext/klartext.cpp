// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comments, tools and stock of Klartext programs, and listings.
#include "ncsim/gcode/klartext.h"

#include "ncsim/gcode/dialect.h"
#include "ncsim/gcode/print.h"

#include "klartext/control.h"
#include "klartext/reader.h"
#include "klartext/scanner.h"
#include "language/notes.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

bool is_klartext(const SourceFile& program) {
    constexpr std::array<std::string_view, 7> kSigns{"BEGIN PGM", "TOOL CALL", "FMAX", "F MAX",
                                                     "CYCL DEF",  "LBL ",      "DR+"};
    const std::string_view text = program.text;
    const bool is_possible = std::ranges::any_of(kSigns, [text](std::string_view sign) {
        return text.find(sign) != std::string_view::npos;
    });
    return is_possible && detect_dialect(program).kind == Kind::Heidenhain;
}

/// A corner of BLK FORM, "X+0 Y-10 Z5", with numbers.
struct KlartextCorner {
    std::array<std::optional<double>, 3> value;
    std::array<bool, 3> is_incremental{};
    bool is_complete() const { return value[0] && value[1] && value[2]; }
    std::array<double, 3> values() const { return {*value[0], *value[1], *value[2]}; }
};

namespace {

std::optional<KlartextCorner> read_corner(klartext::Scanner& scan) {
    KlartextCorner corner;
    while (!scan.is_at_end()) {
        std::string name = upper_of(scan.letters());
        const bool increment = name.size() == 2 && name[0] == 'I';
        if (increment) name.erase(0, 1);
        if (name.size() != 1 || name[0] < 'X' || name[0] > 'Z') return std::nullopt;
        const klartext::Value value = scan.value();
        const auto axis = static_cast<std::size_t>(name[0] - 'X');
        if (value.kind == klartext::Value::Kind::Number) corner.value[axis] = value.number;
        if (value.kind == klartext::Value::Kind::Parameter) return std::nullopt;
        corner.is_incremental[axis] = increment;
    }
    return corner;
}

}  // namespace

struct KlartextNotes::State : language::NoteWriter {
    explicit State(const SourceFile& program)
        : NoteWriter(klartext::tool_names(program)), reader(program) {}

    void tool_call(Block& block);
    void tool_def(Block& block);
    void blk_form(Block& block);
    void path(Block& block);

    klartext::Reader reader;
    klartext::Block read;
    std::optional<KlartextCorner> least;
};

void KlartextNotes::State::tool_call(Block& block) {
    klartext::Scanner scan(read.code, read.rest);
    const SourceSpan span = read.whole();
    if (const auto name = scan.quoted()) return add_tool(block, *name, span);
    const klartext::Value number = scan.value();
    if (number.kind == klartext::Value::Kind::Number && number.number >= 1.0)
        add(block, 'T', number.number, span);
}

/// TOOL DEF 5 L+30 R+4: the radius of an old control.
void KlartextNotes::State::tool_def(Block& block) {
    klartext::Scanner scan(read.code, read.rest);
    const klartext::Value number = scan.value();
    if (number.kind != klartext::Value::Kind::Number || !(number.number >= 1.0)) return;
    while (!scan.is_at_end()) {
        const std::string name = upper_of(scan.letters());
        const klartext::Value value = scan.value();
        if (name.empty() || value.kind != klartext::Value::Kind::Number) return;
        if (name != "R" || !(value.number > 0.0)) continue;
        std::string text = "T";
        print_number(text, number.number);
        text += " D=";
        print_number(text, 2.0 * value.number);
        text += " CR=0 - flat end mill";
        add(block, std::move(text), read.whole());
    }
}

/// BLK FORM 0.1 Z X Y Z: the corner with the smallest coordinates; BLK FORM 0.2: the largest.
void KlartextNotes::State::blk_form(Block& block) {
    klartext::Scanner scan(read.code, read.rest);
    const auto part = scan.value();
    if (part.kind != klartext::Value::Kind::Number) return;
    const bool is_least = part.number == 0.1;
    if (!is_least && part.number != 0.2) return;
    if (is_least) {
        scan.skip_blanks();
        const std::size_t at = scan.at();
        const std::string axis = upper_of(scan.letters());
        const bool is_axis = axis.size() == 1 && is_blank(scan.peek());
        if (!is_axis) scan.move_to(at);
    }
    std::optional<KlartextCorner> corner = read_corner(scan);
    if (!corner || !corner->is_complete()) return;
    if (is_least) {
        least = corner;
        return add_corner(block, "BLK FORM 0.1 Z", corner->values(), read.whole());
    }
    for (std::size_t i = 0; i < 3 && least; ++i) {
        if (corner->is_incremental[i]) *corner->value[i] += *least->value[i];
    }
    add_corner(block, "BLK FORM 0.2", corner->values(), read.whole());
}

void KlartextNotes::State::path(Block& block) {
    const bool is_of_machine = std::ranges::any_of(read.words, [](const klartext::Word& word) {
        return word.address == klartext::Address::M &&
               (word.value.number == 91.0 || word.value.number == 92.0);
    });
    const bool is_rapid = std::ranges::any_of(read.words, [](const klartext::Word& word) {
        return word.address == klartext::Address::FMax;
    });
    if (is_of_machine) add(block, 'G', 53.0, read.whole());
    if (is_rapid) add(block, 'G', 0.0, read.whole());
    for (const klartext::Word& word : read.words) {
        if (word.address > klartext::Address::Z) continue;
        const bool is_number = word.value.kind == klartext::Value::Kind::Number;
        add(block, "XYZ"[static_cast<std::size_t>(word.address)],
            is_number ? word.value.number : 0.0, word.span);
    }
}

KlartextNotes::KlartextNotes(const SourceFile& program)
    : state_(std::make_unique<State>(program)) {}
KlartextNotes::~KlartextNotes() = default;

bool KlartextNotes::next(Block& block) {
    using klartext::Verb;
    State& s = *state_;
    if (!s.reader.next(s.read, nullptr)) return false;
    s.begin_block(block);
    block.line = s.read.line;
    block.text = s.read.code;
    block.block_delete = s.read.block_delete;
    for (const Comment& comment : s.read.comments) {
        const std::size_t first = comment.text.find_first_not_of(" \t");
        const bool has_number = first != std::string_view::npos && comment.text[first] == '#' &&
                                first + 1 < comment.text.size() &&
                                is_digit(comment.text[first + 1]);
        if (has_number) {
            // "#3 D=10 - flat end mill"
            s.add(block, "T" + std::string(comment.text.substr(first + 1)), comment.span);
        } else {
            block.comments.push_back(comment);
        }
    }
    switch (s.read.verb) {
        case Verb::BeginPgm: {
            const std::string text = upper_of(s.read.code);
            const bool inches = text.ends_with(" INCH") || text.ends_with(" IN");
            s.add(block, 'G', inches ? 20.0 : 21.0, s.read.whole());
            break;
        }
        case Verb::ToolCall: s.tool_call(block); break;
        case Verb::ToolDef: s.tool_def(block); break;
        case Verb::BlkForm: s.blk_form(block); break;
        case Verb::Empty:
        case Verb::EndPgm:
        case Verb::Lbl: break;
        default:
            if (s.read.verb >= Verb::Straight && s.read.verb <= Verb::ArcTangentPolar) {
                s.path(block);
            }
            break;
    }
    return true;
}

std::optional<RoundBlank> klartext_cylinder(const SourceFile& program) {
    klartext::Reader reader(program);
    klartext::Block block;
    double unit = 1.0;
    while (reader.next_verb(block)) {
        const std::string text = upper_of(block.code);
        if (block.verb == klartext::Verb::BeginPgm &&
            (text.ends_with(" INCH") || text.ends_with(" IN")))
            unit = 25.4;
        if (block.verb != klartext::Verb::BlkForm) continue;
        klartext::Scanner scan(block.code, block.rest);
        if (!scan.take_word("CYLINDER")) continue;
        scan.skip_blanks();
        const std::string axis = upper_of(scan.letters());
        if (axis.size() != 1 || axis[0] < 'X' || axis[0] > 'Z') continue;
        RoundBlank found;
        found.axis = axis[0] - 'X';
        found.span = block.whole();
        found.text = std::string(block.code);
        double diameter = 0.0;
        double length = 0.0;
        double distance = 0.0;
        bool is_readable = true;
        while (is_readable && !scan.is_at_end()) {
            const std::string name = upper_of(scan.letters());
            const klartext::Value value = scan.value();
            is_readable = value.kind == klartext::Value::Kind::Number;
            if (name == "R") diameter = 2.0 * value.number;
            if (name == "D") diameter = value.number;
            if (name == "L") length = value.number;
            if (name == "DIST") distance = value.number;
        }
        if (!is_readable || !(diameter > 0.0) || !(length > 0.0)) continue;
        found.radius = Length::from_mm(diameter / 2.0 * unit);
        found.length = Length::from_mm(length * unit);
        found.top = Length::from_mm(distance * unit);
        return found;
    }
    return std::nullopt;
}

struct KlartextListing::State {
    explicit State(const SourceFile& program) : reader(program) {}
    klartext::Reader reader;
    klartext::Block block;
    bool has_begun = false;
};

KlartextListing::KlartextListing(const SourceFile& program)
    : state_(std::make_unique<State>(program)) {}
KlartextListing::~KlartextListing() = default;

bool KlartextListing::next(ListedBlock& line, DiagnosticLog& log) {
    State& s = *state_;
    do {
        const std::size_t faults = log.errors();
        if (!s.reader.next(s.block, &log)) return false;
        if (s.block.verb == klartext::Verb::Unreadable && log.errors() == faults) {
            constexpr std::size_t kMost = 40;
            log.add(Message::KlartextText, s.block.whole(), {s.block.code.substr(0, kMost)});
        }
    } while (s.block.code.empty());
    line.line = s.block.line;
    line.is_readable = s.block.verb != klartext::Verb::Unreadable;
    line.text.clear();
    language::append_with_single_blanks(line.text, s.block.code);
    return true;
}

}  // namespace ncsim::gcode
