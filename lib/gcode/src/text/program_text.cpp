// SPDX-License-Identifier: GPL-3.0-or-later
//
// Classifies a text by counting lines that are blocks of some control.
#include "ncsim/gcode/program_text.h"

#include "ncsim/base/ascii.h"
#include "ncsim/gcode/parser.h"

#include "text/line_end.h"

#include <algorithm>
#include <array>
#include <string>

namespace ncsim::gcode {
namespace {

using Names = std::string_view;

constexpr std::array kProgramEndings = {".ngc", ".nc",  ".tap", ".cnc", ".gcode",
                                        ".ncc", ".eia", ".mpf", ".spf"};

/// Names of more than one letter in blocks of some control.
constexpr std::array kBlockNames = {
    // Macro B, LinuxCNC
    Names("IF"), Names("THEN"), Names("GOTO"), Names("WHILE"), Names("DO"), Names("END"),
    Names("EQ"), Names("NE"), Names("GT"), Names("GE"), Names("LT"), Names("LE"), Names("AND"),
    Names("OR"), Names("XOR"), Names("MOD"), Names("NOT"), Names("ABS"), Names("ACOS"),
    Names("ASIN"), Names("ATAN"), Names("COS"), Names("SIN"), Names("TAN"), Names("SQRT"),
    Names("EXP"), Names("LN"), Names("FIX"), Names("FUP"), Names("ROUND"), Names("EXISTS"),
    Names("POW"), Names("BIN"), Names("BCD"), Names("SUB"), Names("ENDSUB"), Names("CALL"),
    Names("RETURN"), Names("ELSE"), Names("ELSEIF"), Names("ENDIF"), Names("ENDWHILE"),
    Names("REPEAT"), Names("ENDREPEAT"), Names("BREAK"), Names("CONTINUE"), Names("POPEN"),
    Names("PCLOS"), Names("DPRNT"), Names("BPRNT"), Names("SETVN"),
    // SINUMERIK
    Names("AC"), Names("IC"), Names("DC"), Names("ACP"), Names("ACN"), Names("CR"), Names("RND"),
    Names("RNDM"), Names("CHF"), Names("CHR"), Names("ANG"), Names("AR"), Names("AP"), Names("RP"),
    Names("TURN"), Names("TRANS"), Names("ATRANS"), Names("ROT"), Names("AROT"), Names("SCALE"),
    Names("ASCALE"), Names("MIRROR"), Names("AMIRROR"), Names("SUPA"), Names("MCALL"),
    Names("EXTCALL"), Names("GOTOF"), Names("GOTOB"), Names("GOTOC"), Names("MSG"), Names("DEF"),
    Names("REAL"), Names("INT"), Names("BOOL"), Names("STRING"), Names("PROC"), Names("RET"),
    Names("FOR"), Names("TO"), Names("ENDFOR"), Names("LOOP"), Names("ENDLOOP"), Names("UNTIL"),
    Names("CASE"), Names("OF"), Names("DEFAULT"), Names("DIAMON"), Names("DIAMOF"), Names("CFTCP"),
    Names("CFC"), Names("SOFT"), Names("BRISK"), Names("FFWON"), Names("COMPOF"), Names("COMPCAD"),
    Names("TRAORI"), Names("TRAFOOF"), Names("ORIWKS"), Names("WORKPIECE"), Names("CYCLE"),
    Names("POCKET"), Names("HOLES"), Names("SLOT"), Names("LONGHOLE"), Names("STOPRE"),
    Names("SPOS"), Names("POLY"), Names("BSPLINE"), Names("EXTERN"),
    // Klartext
    Names("BEGIN"), Names("PGM"), Names("MM"), Names("INCH"), Names("BLK"), Names("FORM"),
    Names("TOOL"), Names("FMAX"), Names("MAX"), Names("CC"), Names("DR"), Names("RL"), Names("RR"),
    Names("CYCL"), Names("LBL"), Names("REP"), Names("FN"), Names("APPR"), Names("DEP"),
    Names("LCT"), Names("CT"), Names("LT"), Names("LN"), Names("CP"), Names("LP"), Names("PA"),
    Names("PR"), Names("STOP"), Names("AUTO"), Names("FQ"), Names("IPA"), Names("IX"), Names("IY"),
    Names("IZ"),
    // Okuma
    Names("VC"), Names("VZOF"), Names("RTS"), Names("MODIN"), Names("MODOUT"), Names("NOEX"),
    Names("FMILH"), Names("FMILR"), Names("CALRG")};

constexpr std::string_view kLineBlanks = " \t\f";

bool is_block_name(std::string_view name) {
    return std::ranges::find(kBlockNames, name) != kBlockNames.end();
}

/// Returns the whole number at `at`; -1 if there is no number or the number has more than three
/// digits.
int code_at(std::string_view line, std::size_t at) {
    while (at < line.size() && is_blank(line[at]))
        ++at;
    int value = 0;
    std::size_t digits = 0;
    for (; at < line.size() && is_digit(line[at]); ++at, ++digits)
        value = 10 * value + (line[at] - '0');
    return digits == 0 || digits > 3 ? -1 : value;
}

/// Numbers of lines of a text, by class.
struct Lines {
    std::size_t blocks = 0;   ///< Readable as a block of some control.
    std::size_t codes = 0;    ///< Blocks with a G or M code.
    std::size_t others = 0;   ///< Neither a block nor a comment.
    std::size_t columns = 0;  ///< Others with commas, semicolons or tabs between values.
    std::size_t values = 0;   ///< Others with "NAME = value" or "[SECTION]".
    std::size_t foreign = 0;  ///< Blocks that only Klartext or SINUMERIK has.
};

/// Returns the line in upper case, without comments in parentheses and after ';'.
std::string code_of(std::string_view line) {
    std::string code;
    int depth = 0;
    for (const char c : line) {
        if (c == ';' && depth == 0) break;
        if (c == '(') ++depth;
        if (depth == 0) code += upper(c);
        if (c == ')' && depth > 0) --depth;
    }
    return code;
}

/// True for Klartext, with or without a line number: "L X+10 Y+5 R0 FMAX", "TOOL CALL 5 Z S2000".
bool is_klartext(std::string_view code) {
    code = trimmed(code, kLineBlanks);
    code.remove_prefix(std::min(code.find_first_not_of("0123456789"), code.size()));
    code = trimmed(code, kLineBlanks);
    constexpr std::array kBegins = {Names("BEGIN PGM "), Names("END PGM "),  Names("TOOL CALL "),
                                    Names("TOOL DEF "),  Names("CYCL DEF "), Names("CYCL CALL"),
                                    Names("BLK FORM "),  Names("LBL "),      Names("CALL LBL "),
                                    Names("CALL PGM ")};
    if (std::ranges::any_of(kBegins, [&](Names begin) { return code.starts_with(begin); }))
        return true;
    constexpr std::array kMoves = {Names("L "),  Names("C "),  Names("CC "),
                                   Names("CR "), Names("CT "), Names("LN ")};
    for (const Names move : kMoves) {
        if (!code.starts_with(move)) continue;
        std::string_view rest = trimmed(code.substr(move.size()), kLineBlanks);
        if (rest.starts_with('I')) rest.remove_prefix(1);
        return rest.size() >= 2 && rest[0] >= 'X' && rest[0] <= 'Z' &&
               (rest[1] == '+' || rest[1] == '-' || rest[1] == 'Q' || is_digit(rest[1]));
    }
    return false;
}

/// True for SINUMERIK: "CYCLE83(…)", "R1=5", "G1 X=AC(20)", "%_N_PART_MPF".
bool is_sinumerik(std::string_view code) {
    constexpr std::array kSigns = {Names("CYCLE"), Names("WORKPIECE"), Names("MCALL"),
                                   Names("GOTOF"), Names("GOTOB"),     Names("TRAORI"),
                                   Names("_MPF"),  Names("_SPF"),      Names("SUPA"),
                                   Names("=AC"),   Names("=IC"),       Names("ATRANS")};
    return std::ranges::any_of(
        kSigns, [&](Names sign) { return code.find(sign) != std::string_view::npos; });
}

/// Reads a line of code as words. read() returns false at text that no control accepts.
class BlockScan {
public:
    explicit BlockScan(std::string_view code) : code_(code) {}

    bool read() {
        if (code_.starts_with('[')) return false;  // A section of settings.
        if (at_ < code_.size() && code_[at_] == '/') skip_digits(++at_);
        while (skip_blanks(), at_ < code_.size()) {
            if (!item()) return false;
        }
        return items_ > 0;
    }
    bool has_code() const { return has_code_; }

private:
    void skip_blanks() {
        while (at_ < code_.size() && is_blank(code_[at_]))
            ++at_;
    }
    void skip_digits(std::size_t from) {
        at_ = from;
        while (at_ < code_.size() && is_digit(code_[at_]))
            ++at_;
    }

    bool item() {
        const char c = code_[at_];
        if (is_letter(c)) return name();
        if (c == '#') return parameter();
        if (c == '[') return bracket(']');
        if (c == '<') return bracket('>');
        if (c == '"') return text();
        if (c == ':' || c == '%') {
            const std::size_t before = at_;
            skip_digits(at_ + 1);
            ++items_;
            return c == '%' || at_ > before + 1 || items_ > 1;
        }
        if (is_digit(c) || c == '.') return lone_number();
        if (c == ',' && at_ + 1 < code_.size() && is_letter(code_[at_ + 1])) return ++at_, true;
        if (c == '*' && trimmed(code_.substr(at_ + 1), kLineBlanks).empty())
            return ++at_, true;  // DIN/ISO.
        if (c == '=' && items_ > 0) return ++at_, value(true);
        if ((c == '+' || c == '-' || c == '*' || c == '/') && items_ > 0) return ++at_, true;
        return false;
    }

    /// Reads a word (letter and value), or a name of some control.
    bool name() {
        const std::size_t begin = at_;
        while (at_ < code_.size() && (is_letter(code_[at_]) || code_[at_] == '_'))
            ++at_;
        const std::string_view name = code_.substr(begin, at_ - begin);
        ++items_;
        if (name.size() > 1) {
            if (!is_block_name(name)) return false;
            // LinuxCNC: "o<probe> call", "o100 if …".
            if (code_.starts_with('O') && items_ > 1) has_code_ = true;
            skip_digits(at_);
            return true;
        }
        if (name == "G" || name == "M") has_code_ = has_code_ || code_at(code_, at_) >= 0;
        skip_blanks();
        if (at_ == code_.size()) return name == "L" || name == "C" || name == "O";
        return value(false);
    }

    /// Reads a number, parameter or expression. `is_assigned`: the value is after "=".
    bool value(bool is_assigned) {
        skip_blanks();
        if (at_ < code_.size() && code_[at_] == '=') ++at_, is_assigned = true, skip_blanks();
        if (at_ < code_.size() && (code_[at_] == '+' || code_[at_] == '-')) ++at_;
        skip_blanks();
        if (at_ == code_.size()) return false;
        const char c = code_[at_];
        if (c == '#') return parameter();
        // "x = [0, 100]" is a list of settings; "#1 = [#2 + 1]" is a value.
        if (c == '[') return (!is_assigned || code_.starts_with('#')) && bracket(']');
        if (c == '<') return bracket('>');
        if (c == '"') return text();
        if (is_letter(c)) return true;  // X=AC(…), a call by name, a Q parameter.
        return number();
    }

    bool number() {
        const std::size_t begin = at_;
        bool has_digit = false;
        while (at_ < code_.size() && (is_digit(code_[at_]) || code_[at_] == '.')) {
            has_digit = has_digit || is_digit(code_[at_]);
            ++at_;
        }
        return has_digit && at_ > begin;
    }

    /// Reads a number without a letter: the line number of Klartext, or a value in an expression.
    bool lone_number() {
        const bool is_first = items_ == 0;
        ++items_;
        return number() && (is_first || items_ > 2);
    }

    /// Reads "#1", "#<name>", "#[…]".
    /// Returns: false for "# text" and "#define".
    bool parameter() {
        std::size_t end = code_.find_first_not_of('#', at_);
        if (end == std::string_view::npos) return false;
        ++items_;
        at_ = end;
        if (code_[at_] == '<') return bracket('>');
        if (code_[at_] == '[') return bracket(']');
        return number();
    }

    bool bracket(char close) {
        const char open = code_[at_];
        int depth = 0;
        ++items_;
        for (; at_ < code_.size(); ++at_) {
            if (code_[at_] == open) ++depth;
            if (code_[at_] == close && --depth == 0) return ++at_, true;
        }
        return false;
    }

    bool text() {
        const std::size_t end = code_.find('"', at_ + 1);
        if (end == std::string_view::npos) return false;
        at_ = end + 1;
        return items_ > 0;
    }

    std::string_view code_;
    std::size_t at_ = 0;
    std::size_t items_ = 0;
    bool has_code_ = false;
};

void count_other(std::string_view line, Lines& lines) {
    ++lines.others;
    const auto separators = std::ranges::count_if(
        line, [](char c) { return c == ',' || c == ';' || c == '\t' || c == '|'; });
    const bool has_digit = std::ranges::any_of(line, is_digit);
    const bool is_number = is_digit(line[0]) || line[0] == '.';
    if (separators >= (is_number ? 1 : 2) && has_digit) ++lines.columns;
    // "NAME = value", "$100=250.000", "[SECTION]".
    const std::size_t name = line.find_first_of(" \t=");
    const std::size_t equals = line.find_first_not_of(" \t", name);
    const bool is_setting = name != std::string_view::npos && name > 0 && equals < line.size() &&
                            line[equals] == '=' &&
                            line.substr(0, name).find_first_of("(){}<>,;") == Names::npos;
    if (is_setting || (line.starts_with('[') && line.ends_with(']'))) ++lines.values;
}

void count(std::string_view raw, Lines& lines) {
    const std::string_view line = trimmed(raw, kLineBlanks);
    if (line.empty()) return;
    const std::string whole = code_of(line);
    const std::string_view code = trimmed(whole, kLineBlanks);
    if (code.empty()) return;
    const bool has_columns = std::ranges::count(line, '\t') >= 3;
    if (!has_columns && (is_klartext(code) || is_sinumerik(code))) {
        ++lines.blocks;
        ++lines.foreign;
        return;
    }
    BlockScan scan(code);
    if (!scan.read()) return count_other(line, lines);
    ++lines.blocks;
    if (scan.has_code()) ++lines.codes;
}

/// Returns the kind that the first characters prove; Program: no proof.
TextKind kind_of_beginning(std::string_view text) {
    if (text.starts_with("#!")) return TextKind::Script;
    const std::string_view first = trimmed(text.substr(0, 4096), kLineBlanks);
    const std::size_t begin = first.find_first_not_of("\r\n \t\f");
    if (begin == std::string_view::npos) return TextKind::Program;
    const std::string_view start = first.substr(begin);
    if (start.starts_with("<?") || start.starts_with("<!") ||
        (start.starts_with('<') && start.size() > 1 && is_letter(start[1])))
        return TextKind::Markup;
    if (start.starts_with('{') || start.starts_with("[{") || start.starts_with("[\n"))
        return TextKind::Data;
    if (start.starts_with("%FS") || start.starts_with("%MO") || start.starts_with("%TF"))
        return TextKind::Data;  // Gerber.
    return TextKind::Program;
}

/// Returns the kind that a single line proves; Program: no proof.
TextKind kind_of_line(std::string_view line) {
    const std::string_view start = trimmed(line, kLineBlanks);
    constexpr std::array kSource = {Names("#include"), Names("#define"),   Names("#ifdef"),
                                    Names("#ifndef"),  Names("#pragma"),   Names("#endif"),
                                    Names("import "),  Names("def "),      Names("class "),
                                    Names("from "),    Names("function "), Names("namespace ")};
    for (const Names begin : kSource) {
        if (line.starts_with(begin) && (begin != "from " || line.find(" import ") != Names::npos))
            return TextKind::Source;
    }
    const bool is_heading =
        line.starts_with('#') &&
        is_blank(line.substr(std::min(line.find_first_not_of('#'), line.size() - 1))[0]) &&
        std::ranges::any_of(line, is_letter);
    if (is_heading || line.starts_with("```") || line.starts_with("\\documentclass"))
        return TextKind::Markup;
    if (line.starts_with("@@ -") || line.starts_with("diff --git ") || line.starts_with("--- a/"))
        return TextKind::Data;
    if (start.starts_with("<?xml")) return TextKind::Markup;
    if (start.starts_with("[[") && start.ends_with("]]")) return TextKind::Settings;
    return TextKind::Program;
}

/// True if `text` has control bytes that do not occur in text.
bool is_binary(std::string_view text) {
    // Leaders of punched tape, and the ends of files of CP/M.
    constexpr std::string_view kPadding("\0\x1a", 2);
    text = trimmed(text, kPadding);
    if (text.empty()) return true;
    if (text.find('\0') != std::string_view::npos) return true;
    const auto odd = std::ranges::count_if(text, [](char c) {
        return c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f' &&
               c != '\x1a' && c != '\x1b' && !(c >= '\x11' && c <= '\x14');
    });
    return static_cast<std::size_t>(odd) * 50 > text.size();
}

TextKind kind_of_others(const Lines& lines) {
    const std::size_t half = (lines.others + 1) / 2;
    if (lines.others == 0) return lines.blocks > 0 ? TextKind::Table : TextKind::Text;
    if (lines.values >= half) return TextKind::Settings;
    if (lines.columns >= half) return TextKind::Table;
    return TextKind::Text;
}

}  // namespace

std::string_view name_of(TextKind kind) {
    switch (kind) {
        case TextKind::Program: return "program";
        case TextKind::Empty: return "empty file";
        case TextKind::Binary: return "binary file";
        case TextKind::Source: return "source text";
        case TextKind::Script: return "script";
        case TextKind::Markup: return "document";
        case TextKind::Data: return "data";
        case TextKind::Table: return "table";
        case TextKind::Settings: return "settings";
        case TextKind::Text: return "text without G-code";
    }
    return "";
}

TextKind kind_of_text(std::string_view head) {
    const bool is_cut = head.size() > kMostHeadBytes;
    std::string_view text = head.substr(0, kMostHeadBytes);
    if (text.empty()) return TextKind::Empty;
    if (is_binary(text)) return TextKind::Binary;
    text = after_byte_order_mark(text);
    text.remove_prefix(std::min(text.find_first_not_of('\0'), text.size()));
    if (const TextKind kind = kind_of_beginning(text); kind != TextKind::Program) return kind;
    Lines lines;
    while (!text.empty()) {
        const LineEnd end = find_line_end(text);
        const std::string_view line = text.substr(0, end.length);
        text.remove_prefix(end.next);
        if (is_cut && text.empty() && lines.blocks + lines.others > 0) break;
        if (const TextKind kind = kind_of_line(line); kind != TextKind::Program) return kind;
        count(line, lines);
    }
    const std::size_t programs = lines.codes + lines.foreign;
    // Text after the program, or comments without parentheses, may be as long as the program.
    const bool is_program = programs > 0 && 2 * lines.blocks >= lines.others;
    return is_program ? TextKind::Program : kind_of_others(lines);
}

bool names_program(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0) return false;
    std::string ending(name.substr(dot));
    std::ranges::transform(ending, ending.begin(), lower);
    return std::ranges::find(kProgramEndings, ending) != kProgramEndings.end();
}

namespace {

/// Codes in a text that end or return from a program.
struct Endings {
    bool returns = false;     ///< M99 outside of subroutines.
    bool ends = false;        ///< M2 or M30 outside of subroutines.
    bool has_subs = false;    ///< "O… sub".
    bool has_effect = false;  ///< Words outside of subroutines other than M99, M2 and M30.
};

void scan_block(const Block& block, int& depth, Endings& found) {
    if (block.control.word == ControlWord::Sub) ++depth, found.has_subs = true;
    if (block.control.word == ControlWord::EndSub && depth > 0) {
        --depth;
        return;
    }
    if (depth > 0) return;
    for (const Word& word : block.words) {
        if (word.letter == 'M' && word.literal && word.number == 99.0) {
            found.returns = true;
        } else if (word.letter == 'M' && word.literal &&
                   (word.number == 2.0 || word.number == 30.0)) {
            found.ends = true;
        } else {
            found.has_effect = true;
        }
    }
    const bool is_call = block.control.word == ControlWord::Call;
    found.has_effect = found.has_effect || is_call;
}

}  // namespace

bool is_subprogram_text(std::string_view head, std::string_view tail) {
    Endings found;
    for (const std::string_view piece : {head, tail}) {
        const SourceFile file{{}, std::string(piece)};
        BlockReader reader(file);
        Block block;
        int depth = 0;
        while (reader.next(block))
            scan_block(block, depth, found);
    }
    if (found.has_subs && !found.has_effect && !found.returns) return true;
    return found.returns && !found.ends;
}

}  // namespace ncsim::gcode
