// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads blocks.
#include "klartext/reader.h"

#include "klartext/scanner.h"
#include "text/line_end.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace ncsim::gcode::klartext {
namespace {

std::string_view trimmed_end(std::string_view text) {
    while (!text.empty() && (is_blank(text.back()) || text.back() == '\x1a' || text.back() == '\f'))
        text.remove_suffix(1);
    return text;
}

/// A line, split into code and comment.
struct SplitLine {
    std::string_view code;
    std::size_t code_at = 0;  ///< Offset of `code` in the line.
    std::string_view comment;
    std::size_t comment_at = 0;
    bool has_comment = false;
    bool goes_on = false;        ///< The line ends with '~'.
    bool is_in_comment = false;  ///< The '~' is in the comment.
};

SplitLine split(std::string_view line) {
    SplitLine out;
    std::string_view text = trimmed_end(line);
    if (!text.empty() && text.back() == '~') {
        out.goes_on = true;
        text = trimmed_end(text.substr(0, text.size() - 1));
    }
    std::size_t semicolon = text.find(';');
    // A semicolon between quotes is part of the text.
    if (semicolon != std::string_view::npos && text.find('"') < semicolon) {
        bool is_quoted = false;
        for (semicolon = 0; semicolon < text.size(); ++semicolon) {
            if (text[semicolon] == '"') is_quoted = !is_quoted;
            if (text[semicolon] == ';' && !is_quoted) break;
        }
        if (semicolon == text.size()) semicolon = std::string_view::npos;
    }
    out.has_comment = semicolon != std::string_view::npos;
    out.is_in_comment = out.goes_on && out.has_comment;
    std::string_view code = text.substr(0, std::min(semicolon, text.size()));
    while (out.code_at < code.size() && (is_blank(code[out.code_at]) || code[out.code_at] == '\f'))
        ++out.code_at;
    out.code = trimmed_end(code.substr(out.code_at));
    if (out.has_comment) {
        out.comment_at = semicolon;
        out.comment = text.substr(semicolon + 1);
    }
    return out;
}

void add_comment(Block& block, const SplitLine& line, std::uint32_t number) {
    if (!line.has_comment) return;
    Comment comment;
    comment.text = line.comment;
    comment.span = {number, static_cast<std::uint32_t>(line.comment_at + 1),
                    static_cast<std::uint32_t>(line.comment.size() + 1)};
    comment.semicolon = true;
    block.comments.push_back(comment);
}

struct VerbName {
    std::string_view first, second;
    Verb verb;
};
// Verbs of two words come before a verb that is the first of the two words.
constexpr auto kVerbs = std::to_array<VerbName>({
    {"BEGIN", "PGM", Verb::BeginPgm},
    {"END", "PGM", Verb::EndPgm},
    {"BLK", "FORM", Verb::BlkForm},
    {"TOOL", "CALL", Verb::ToolCall},
    {"TOOL", "DEF", Verb::ToolDef},
    {"CYCL", "DEF", Verb::CyclDef},
    {"CYCL", "CALL", Verb::CyclCall},
    {"CYCL", "END", Verb::CyclEnd},
    {"CALL", "LBL", Verb::CallLbl},
    {"CALL", "PGM", Verb::CallPgm},
    {"CALL", "SELECTED PGM", Verb::Other},
    {"LBL", "", Verb::Lbl},
    {"FN", "", Verb::Fn},
    {"IF", "", Verb::If},
    {"PLANE", "", Verb::Plane},
    {"FUNCTION", "", Verb::Function},
    {"STOP", "", Verb::Stop},
    {"ERROR", "", Verb::Error},
    {"L", "", Verb::Straight},
    {"LP", "", Verb::StraightPolar},
    {"CC", "", Verb::Centre},
    {"C", "", Verb::Arc},
    {"CP", "", Verb::ArcPolar},
    {"CR", "", Verb::ArcByRadius},
    {"CT", "", Verb::ArcTangent},
    {"CTP", "", Verb::ArcTangentPolar},
    {"RND", "", Verb::Rounding},
    {"CHF", "", Verb::Chamfer},
    {"TCH", "PROBE", Verb::Other},
    {"PATTERN", "DEF", Verb::PatternDef},
    {"CONTOUR", "DEF", Verb::Other},
    {"GLOBAL", "DEF", Verb::Other},
    {"SEL", "PGM", Verb::Other},
    {"SEL", "TABLE", Verb::Other},
    {"SEL", "PATTERN", Verb::Other},
    {"SEL", "CONTOUR", Verb::Other},
    {"SEL", "CORR-TABLE", Verb::Other},
    {"TRANS", "DATUM", Verb::Other},
    {"TRANS", "MIRROR", Verb::Other},
    {"TRANS", "ROTATION", Verb::Other},
    {"TRANS", "SCALE", Verb::Other},
    {"DECLARE", "STRING", Verb::Other},
    {"DECLARE", "CONTOUR", Verb::Other},
    {"TABDATA", "", Verb::Other},
    {"POLARKIN", "", Verb::Other},
    {"SECTION", "MONITORING", Verb::Other},
    {"PRESET", "", Verb::Other},
    {"APPR", "LT", Verb::Approach},
    {"APPR", "LN", Verb::Approach},
    {"APPR", "CT", Verb::Approach},
    {"APPR", "LCT", Verb::Approach},
    {"APPR", "PLT", Verb::Approach},
    {"APPR", "PLN", Verb::Approach},
    {"APPR", "PCT", Verb::Approach},
    {"APPR", "PLCT", Verb::Approach},
    {"DEP", "LT", Verb::Depart},
    {"DEP", "LN", Verb::Depart},
    {"DEP", "CT", Verb::Depart},
    {"DEP", "LCT", Verb::Depart},
    {"DEP", "PLCT", Verb::Depart},
    {"APPR", "", Verb::Other},
    {"DEP", "", Verb::Other},
    {"LN", "", Verb::Other},
    {"SPL", "", Verb::Other},
    {"FL", "", Verb::Other},
    {"FLT", "", Verb::Other},
    {"FC", "", Verb::Other},
    {"FCT", "", Verb::Other},
    {"FPOL", "", Verb::Other},
    {"FSELECT", "", Verb::Other},
    {"LBLS", "", Verb::Other},
});

bool is_axis_letter(char c) {
    c = upper(c);
    return (c >= 'X' && c <= 'Z') || (c >= 'A' && c <= 'C') || (c >= 'U' && c <= 'W');
}

bool starts_number(char c) {
    return is_digit(c) || c == '+' || c == '-' || c == '.' || c == ',' || c == 'Q' || c == 'q';
}

/// True for code that begins with an axis, M, S, F or R and a value: a block without a verb.
bool is_block_of_words(std::string_view code) {
    std::size_t at = 0;
    if (code.size() > 2 && upper(code[0]) == 'I' && is_axis_letter(code[1])) at = 1;
    if (at >= code.size()) return false;
    const char c = upper(code[at]);
    const bool is_name = is_axis_letter(c) || c == 'M' || c == 'S' || c == 'F';
    std::size_t next = at + 1;
    // "FMAX", "F MAX", "R0" begin blocks without axes.
    const std::string head = upper_of(code.substr(0, 5));
    if (head.starts_with("FMAX") || head.starts_with("F MAX") || head.starts_with("R0") ||
        head == "RL" || head == "RR" || head.starts_with("RL ") || head.starts_with("RR "))
        return true;
    while (next < code.size() && is_blank(code[next]) && c != 'C')
        ++next;
    return is_name && next < code.size() && starts_number(code[next]);
}

/// Sets the verb of `block` from its code.
void find_verb(Block& block) {
    const std::string_view code = block.code;
    block.rest = 0;
    block.name = {};
    if (code.empty()) {
        block.verb = Verb::Empty;
        return;
    }
    const char first = upper(code[0]);
    // The most frequent block.
    if (first == 'L' && code.size() > 1 && is_blank(code[1])) {
        block.verb = Verb::Straight;
        block.rest = 1;
        return;
    }
    if (first == 'Q') {
        Scanner scan(code);
        const bool is_text = upper(scan.peek(1)) == 'S' && is_digit(scan.peek(2));
        if (is_text) scan.move_to(2), (void)scan.whole();
        if ((is_text || scan.parameter()) && scan.take('=')) {
            block.verb = Verb::Assignment;
            return;
        }
    }
    Scanner scan(code);
    const std::string name = upper_of(scan.letters());
    const std::size_t after_name = scan.at();
    if (first == 'C' && name == "C" && starts_number(scan.peek())) {
        block.verb = Verb::Straight;  // A position of the axis C.
        return;
    }
    for (const VerbName& entry : kVerbs) {
        if (name != entry.first) continue;
        scan.move_to(after_name);
        scan.skip_blanks();
        const std::size_t second = scan.at();
        const std::string_view there = code.substr(second, entry.second.size());
        if (!entry.second.empty() && upper_of(there) != entry.second) continue;
        block.verb = entry.verb;
        block.rest = entry.second.empty() ? after_name : second + entry.second.size();
        block.name = code.substr(0, block.rest);
        return;
    }
    block.verb = is_block_of_words(code) ? Verb::Straight : Verb::Unreadable;
}

struct AddressName {
    std::string_view name;
    Address address;
    bool takes_value;
};
constexpr auto kAddresses = std::to_array<AddressName>({
    {"X", Address::X, true},        {"Y", Address::Y, true},          {"Z", Address::Z, true},
    {"A", Address::A, true},        {"B", Address::B, true},          {"C", Address::C, true},
    {"U", Address::U, true},        {"V", Address::V, true},          {"W", Address::W, true},
    {"PR", Address::PR, true},      {"PA", Address::PA, true},        {"R", Address::Radius, true},
    {"RL", Address::RL, false},     {"RR", Address::RR, false},       {"F", Address::F, true},
    {"FMAX", Address::FMax, false}, {"FAUTO", Address::FAuto, false}, {"FU", Address::FU, true},
    {"FZ", Address::FZ, true},      {"S", Address::S, true},          {"M", Address::M, true},
    {"DR", Address::DrPlus, false}, {"MB", Address::MB, true},        {"LA", Address::LA, true},
    {"LEN", Address::Len, true},    {"CCA", Address::Cca, true},
});

const AddressName* find_address(std::string_view name) {
    // X, Y and Z are the first rows, and the most frequent names.
    if (name.size() == 1 && name[0] >= 'X' && name[0] <= 'Z')
        return &kAddresses[static_cast<std::size_t>(name[0] - 'X')];
    const auto* const found = std::ranges::find(kAddresses, name, &AddressName::name);
    return found == kAddresses.end() ? nullptr : found;
}

bool is_path_verb(Verb verb) {
    return verb >= Verb::Straight && verb <= Verb::Chamfer;
}

/// True if a block with `verb` (`name`: with its second word) takes a word `address`.
bool takes(Verb verb, std::string_view name, Address address) {
    const bool is_axis = address <= Address::W;
    const bool approaches = verb == Verb::Approach || verb == Verb::Depart;
    const bool is_corner = verb == Verb::Rounding || verb == Verb::Chamfer;
    switch (address) {
        case Address::PR:
            return verb == Verb::StraightPolar || verb == Verb::ArcTangentPolar || approaches;
        case Address::PA: return takes(verb, name, Address::PR) || verb == Verb::ArcPolar;
        case Address::Radius: return verb == Verb::ArcByRadius || is_corner || approaches;
        case Address::DrPlus:
        case Address::DrMinus:
            return verb == Verb::Arc || verb == Verb::ArcPolar || verb == Verb::ArcByRadius;
        case Address::Len: {
            const std::string way = approaches ? upper_of(name) : std::string();
            return way.ends_with("LT") || way.ends_with("LN");
        }
        case Address::Cca: {
            const std::string way = approaches ? upper_of(name) : std::string();
            return way.ends_with("CT") && !way.ends_with("LCT");
        }
        default: return !is_axis || !is_corner;
    }
}

/// Returns an address for all that exclude each other: R0, RL and RR; DR+ and DR-.
Address without_value(Address address) {
    switch (address) {
        case Address::RL:
        case Address::RR: return Address::R0;
        case Address::DrMinus: return Address::DrPlus;
        default: return address;
    }
}

/// Reads the words of a path block.
class WordReader {
public:
    WordReader(Block& block, DiagnosticLog* log) : block_(block), log_(log), scan_(block.code) {
        scan_.move_to(block.rest);
    }

    bool read() {
        while (!scan_.is_at_end()) {
            // "(M89 MODAL)": text without effect.
            if (scan_.peek() == '(') {
                const std::size_t end = block_.code.find(')', scan_.at());
                if (end == std::string_view::npos) break;
                scan_.move_to(end + 1);
                continue;
            }
            if (!word()) return false;
        }
        return true;
    }

private:
    bool fail(std::size_t begin) {
        std::size_t end = begin;
        while (end < block_.code.size() && !is_blank(block_.code[end]))
            ++end;
        if (log_)
            log_->add(Message::KlartextWord, block_.span(begin, end - begin),
                      {block_.code.substr(begin, end - begin)});
        block_.verb = Verb::Unreadable;
        return false;
    }

    /// Adds a word, unless the block does not take the word, or takes it once and has it already.
    bool add(Address address, bool is_incremental, const Value& value, std::size_t begin) {
        // X, Y and Z of M118 are no positions, and F of M103 and M128 is no feed of the path.
        const bool is_of_path = address <= Address::RR || address >= Address::DrPlus;
        const bool may_repeat = !is_of_path || has_m118_;
        const bool is_known = std::ranges::any_of(block_.words, [address](const Word& word) {
            return without_value(word.address) == without_value(address);
        });
        if (!takes(block_.verb, block_.name, address) || (is_known && !may_repeat))
            return fail(begin);
        has_m118_ = has_m118_ || (address == Address::M && value.number == 118.0);
        block_.words.push_back(
            {address, is_incremental, value, block_.span(begin, scan_.at() - begin)});
        return true;
    }

    /// "RND 4", "RND4", "CHF 10": a number without a name.
    bool lone_value(std::size_t begin) {
        const bool takes_it = block_.verb == Verb::Rounding || block_.verb == Verb::Chamfer;
        const Value value = takes_it ? scan_.value() : Value{};
        if (value.kind == Value::Kind::None) return fail(begin);
        return add(Address::Radius, false, value, begin);
    }

    bool word() {
        const std::size_t begin = scan_.at();
        const std::string_view letters = scan_.letters();
        if (letters.empty()) return lone_value(begin);
        std::array<char, 8> buffer{};
        if (letters.size() > buffer.size()) return fail(begin);
        for (std::size_t i = 0; i < letters.size(); ++i)
            buffer[i] = upper(letters[i]);
        std::string_view name(buffer.data(), letters.size());
        // "FMAXM3"
        if (name.size() > 4 && name.starts_with("FMAX")) {
            scan_.move_to(begin + 4);
            name = name.substr(0, 4);
        }
        bool is_incremental = false;
        const AddressName* entry = find_address(name);
        if (!entry && name.size() > 1 && name[0] == 'I') {
            entry = find_address(name.substr(1));
            if (entry && entry->address > Address::PA) return fail(begin);
            is_incremental = entry != nullptr;
        }
        // "FQ50", "XQL3", "IXQ1": the letters of the parameter follow without a sign.
        for (const std::string_view set : {"Q", "QL", "QR"}) {
            if (entry || !name.ends_with(set)) continue;
            std::string_view address = name.substr(0, name.size() - set.size());
            entry = find_address(address);
            if (!entry && address.starts_with('I')) {
                entry = find_address(address.substr(1));
                is_incremental = entry != nullptr;
            }
            if (entry && !entry->takes_value) return fail(begin);
            if (entry) scan_.move_to(begin + address.size());
        }
        if (!entry) return fail(begin);
        switch (entry->address) {
            case Address::DrPlus: return direction(begin);
            case Address::F: return feed(begin);
            case Address::Radius: return radius(begin);
            case Address::MB:
                if (scan_.take_word("MAX")) return add(Address::MBMax, false, {}, begin);
                break;
            default: break;
        }
        Value value;
        if (entry->takes_value) value = scan_.value();
        if (entry->takes_value && value.kind == Value::Kind::None) {
            if (entry->address == Address::M) return true;  // "L X10 M": an M that was left empty.
            // "CC X Y", "L X": the programming mode left the value open.
            return fail(begin);
        }
        return add(entry->address, is_incremental, value, begin);
    }

    bool direction(std::size_t begin) {
        scan_.skip_blanks();
        const char sign = scan_.peek();
        if (sign != '+' && sign != '-') return fail(begin);
        scan_.move_to(scan_.at() + 1);
        if (is_digit(scan_.peek()) || scan_.peek() == '.') return fail(begin);
        return add(sign == '+' ? Address::DrPlus : Address::DrMinus, false, {}, begin);
    }

    bool feed(std::size_t begin) {
        if (scan_.take_word("MAX")) return add(Address::FMax, false, {}, begin);
        if (scan_.take_word("AUTO")) return add(Address::FAuto, false, {}, begin);
        const Value value = scan_.value();
        // "L X10 F": a feed that was left empty.
        const bool is_alone = begin + 1 >= block_.code.size() || is_blank(block_.code[begin + 1]);
        if (value.kind == Value::Kind::None) return is_alone || fail(begin);
        return add(Address::F, false, value, begin);
    }

    /// R0, the radius R5 of arcs and roundings, or R without a value, which changes nothing.
    bool radius(std::size_t begin) {
        const bool approaches = block_.verb == Verb::Approach || block_.verb == Verb::Depart;
        const bool is_radius = approaches || block_.verb == Verb::ArcByRadius ||
                               block_.verb == Verb::Rounding || block_.verb == Verb::Chamfer;
        const bool has_radius =
            is_radius &&
            std::ranges::find(block_.words, Address::Radius, &Word::address) != block_.words.end();
        const bool is_zero = scan_.peek() == '0' && !is_digit(scan_.peek(1)) &&
                             scan_.peek(1) != '.' && scan_.peek(1) != ',';
        if (is_zero && (!is_radius || has_radius || approaches)) {
            scan_.move_to(scan_.at() + 1);
            return add(Address::R0, false, {}, begin);
        }
        const Value value = scan_.value();
        if (value.kind == Value::Kind::None) {
            if (scan_.peek() == '+' || scan_.peek() == '-') return fail(begin);  // R+, R-
            return !is_radius || has_radius || fail(begin);
        }
        if (!is_radius) return fail(begin);
        return add(Address::Radius, false, value, begin);
    }

    Block& block_;
    DiagnosticLog* log_;
    Scanner scan_;
    bool has_m118_ = false;
};

/// Removes the number and the '/' at the beginning of a line. Returns the offset of the rest.
std::size_t skip_number(std::string_view code, bool& block_delete, bool& has_number) {
    std::size_t at = 0;
    const auto skip_blanks = [&] {
        while (at < code.size() && is_blank(code[at]))
            ++at;
    };
    const auto slash = [&] {
        if (at < code.size() && code[at] == '/') block_delete = true, ++at, skip_blanks();
    };
    slash();
    const std::size_t begin = at;
    while (at < code.size() && is_digit(code[at]))
        ++at;
    has_number = at > begin;
    // "1.5": no number of a block.
    if (has_number && at < code.size() && (code[at] == '.' || code[at] == ',')) {
        has_number = false;
        at = begin;
    }
    skip_blanks();
    slash();
    return at;
}

/// True for code that is a block of its own.
bool begins_block(std::string_view code) {
    bool block_delete = false;
    bool has_number = false;
    Block block;
    block.code = code.substr(skip_number(code, block_delete, has_number));
    find_verb(block);
    return has_number || (block.verb != Verb::Empty && block.verb != Verb::Unreadable);
}

/// True for "Q200 = 2": a parameter of the cycle in the lines before.
bool is_cycle_parameter(std::string_view code) {
    Scanner scan(code);
    const std::optional<Value> value = scan.parameter();
    return value && value->set == 'Q' && value->index >= 200 && value->index < 600 &&
           scan.take('=');
}

}  // namespace

Reader::Reader(const SourceFile& file) : file_(&file) {
    if (std::string_view(file.text).starts_with("\xEF\xBB\xBF")) place_.offset = 3;
}

std::string_view Reader::take_line() {
    const std::string_view rest = std::string_view(file_->text).substr(place_.offset);
    const LineEnd end = find_line_end(rest);
    place_.offset += end.next;
    ++place_.line;
    return rest.substr(0, end.length);
}

/// Adds the next lines to `block` as long as a line ends with '~'. Text after a '~' in a comment is
/// part of the comment, unless the block is a cycle.
void Reader::continue_block(Block& block, bool is_in_comment) {
    constexpr std::size_t kMostLines = 200;
    bool goes_on = true;
    for (std::size_t i = 0; goes_on && i < kMostLines && place_.offset < file_->text.size(); ++i) {
        const Place before = place_;
        const SplitLine line = split(take_line());
        const bool is_parameter = is_cycle_parameter(line.code);
        if (is_in_comment && !is_parameter && begins_block(line.code)) {
            place_ = before;
            return;
        }
        if (!is_in_comment || is_parameter) {
            block.joined += ' ';
            block.parts.push_back(
                {block.joined.size(), place_.line, static_cast<std::uint32_t>(line.code_at + 1)});
            block.joined += line.code;
            add_comment(block, line, place_.line);
            is_in_comment = line.is_in_comment;
        }
        goes_on = line.goes_on;
    }
}

/// Adds parameters of a cycle in lines of their own without '~'. Blank lines may be between them.
void Reader::take_parameters(Block& block) {
    constexpr std::size_t kMostLines = 200;
    Place behind = place_;
    for (std::size_t i = 0; i < kMostLines && place_.offset < file_->text.size(); ++i) {
        const std::string_view text = take_line();
        if (trimmed_end(text).empty()) continue;
        const SplitLine line = split(text);
        if (!is_cycle_parameter(line.code)) break;
        behind = place_;
        block.joined += ' ';
        block.parts.push_back(
            {block.joined.size(), place_.line, static_cast<std::uint32_t>(line.code_at + 1)});
        block.joined += line.code;
        add_comment(block, line, place_.line);
    }
    place_ = behind;
}

bool Reader::take_block(Block& block) {
    if (place_.offset >= file_->text.size()) return false;
    block.words.clear();
    block.comments.clear();
    block.parts.clear();
    block.block_delete = false;
    const SplitLine line = split(take_line());
    block.line = place_.line;
    bool has_number = false;
    const std::size_t begin = skip_number(line.code, block.block_delete, has_number);
    block.code = line.code.substr(begin);
    block.parts.push_back({0, place_.line, static_cast<std::uint32_t>(line.code_at + begin + 1)});
    // Headings "* - TEXT" and text in parentheses.
    if (block.code.starts_with('*') || block.code.starts_with('(')) {
        Comment comment;
        comment.text = block.code.substr(1);
        while (!comment.text.empty() && (is_blank(comment.text[0]) || comment.text[0] == '-'))
            comment.text.remove_prefix(1);
        if (block.code.starts_with('(') && comment.text.ends_with(')'))
            comment.text.remove_suffix(1);
        comment.span = block.whole();
        block.comments.push_back(comment);
        block.code = {};
    }
    add_comment(block, line, place_.line);
    if (line.goes_on && !block.code.empty()) {
        block.joined = block.code;
        continue_block(block, line.is_in_comment);
        block.code = block.joined;
    }
    find_verb(block);
    if (block.verb == Verb::CyclDef) {
        if (!line.goes_on) block.joined = block.code;
        const std::size_t parts = block.parts.size();
        take_parameters(block);
        if (block.parts.size() > parts) {
            block.code = block.joined;
            find_verb(block);
        }
    }
    return true;
}

bool Reader::is_corner_next() const {
    const std::string_view text = file_->text;
    std::size_t at = place_.offset;
    while (at < text.size()) {
        const char c = text[at];
        if (is_blank(c) || is_digit(c) || c == '\n' || c == '\r' || c == '/') {
            ++at;
        } else if (c == ';' || c == '*' || c == '(') {
            at += find_line_end(text.substr(at)).next;
        } else {
            break;
        }
    }
    const std::string head = upper_of(text.substr(at, 3));
    return head == "RND" || head == "CHF";
}

bool Reader::next_verb(Block& block) {
    return take_block(block);
}

bool Reader::next(Block& block, DiagnosticLog* log) {
    if (!take_block(block)) return false;
    if (is_path_verb(block.verb)) WordReader(block, log).read();
    return true;
}

}  // namespace ncsim::gcode::klartext
