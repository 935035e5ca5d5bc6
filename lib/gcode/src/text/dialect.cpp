// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signs of dialects and of other languages in the text of a program.
#include "ncsim/gcode/dialect.h"

#include "ncsim/base/ascii.h"

#include "text/line_end.h"
#include "text/number.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::gcode {

std::string_view name_of(Dialect dialect) {
    switch (dialect) {
        case Dialect::Auto: return "auto";
        case Dialect::Rs274: return "rs274";
        case Dialect::Fanuc: return "fanuc";
        case Dialect::Haas: return "haas";
        case Dialect::Grbl: return "grbl";
        case Dialect::Mach3: return "mach3";
        case Dialect::Heidenhain: return "heidenhain";
        case Dialect::Sinumerik: return "sinumerik";
        case Dialect::SinumerikIso: return "sinumerik-iso";
    }
    return "";
}

std::string_view name_of(Kind kind) {
    switch (kind) {
        case Kind::Milling: return "milling";
        case Kind::Heidenhain: return "Heidenhain controls";
        case Kind::HeidenhainIso: return "Heidenhain controls (DIN/ISO)";
        case Kind::Siemens: return "Siemens controls";
        case Kind::Okuma: return "Okuma controls";
        case Kind::Isg: return "ISG and TwinCAT controls";
        case Kind::Lathe: return "a lathe";
        case Kind::Laser: return "a laser";
        case Kind::Plasma: return "a plasma torch";
        case Kind::Printer: return "a 3-D printer";
        case Kind::NotAProgram: return "no NC program";
    }
    return "";
}

namespace {

constexpr std::size_t kEveryLine = 128'000;  // Bytes; post processors write signs at the beginning.

/// Characters of a text as bits. A text can contain a sign only if the text has all bits of the
/// sign.
using Letters = std::uint64_t;
constexpr Letters bit_of(char c) {
    return Letters{1} << (static_cast<unsigned char>(c) & 63U);
}
constexpr Letters letters_of(std::string_view text) {
    Letters letters = 0;
    for (const char c : text)
        letters |= bit_of(c);
    return letters;
}

enum class Place : std::uint8_t { Code, Comment };

/// A text in upper case in `place` that supports the conclusion `of`, with a weight. In code, a
/// sign that starts with a letter must not follow a letter.
template <typename Conclusion>
struct Sign {
    Conclusion of;
    std::string_view text;
    int weight;
    Place place;
    std::string_view because;
    Letters letters = letters_of(text);
};

#define NCSIM_SIGN(of, text, weight, place, because) \
    {Dialect::of, text, weight, Place::place, because},
constexpr Sign<Dialect> kDialectSigns[] = {
#include "text/dialect_signs.def"
};
#undef NCSIM_SIGN

#define NCSIM_SIGN(of, text, weight, place, because) \
    {Kind::of, text, weight, Place::place, because},
constexpr Sign<Kind> kKindSigns[] = {
#include "text/kind_signs.def"
};
#undef NCSIM_SIGN
static_assert(kKindSigns[0].text == "BEGIN PGM");

/// Kinds by precedence, each with the weight that suffices.
constexpr std::array<std::pair<Kind, int>, 8> kEnough{{{Kind::Heidenhain, 4},
                                                       {Kind::HeidenhainIso, 4},
                                                       {Kind::Siemens, 4},
                                                       {Kind::Okuma, 4},
                                                       {Kind::Isg, 4},
                                                       {Kind::Printer, 5},
                                                       {Kind::Laser, 4},
                                                       {Kind::Plasma, 4}}};

constexpr bool is_capital(char c) {
    return c >= 'A' && c <= 'Z';
}

/// True if `text` contains `what`, not as a part of a longer word or number.
bool contains(std::string_view text, std::string_view what) {
    for (std::size_t at = text.find(what); at != std::string_view::npos;
         at = text.find(what, at + 1)) {
        const char before = at == 0 ? ' ' : text[at - 1];
        const bool starts =
            !is_capital(what[0]) || (!is_capital(before) && before != '<' && before != '_');
        const std::size_t end = at + what.size();
        const bool ends = end == text.size() || !is_digit(what.back()) ||
                          (!is_digit(text[end]) && text[end] != '.');
        if (starts && ends) return true;
    }
    return false;
}

/// A line in upper case, split into code and comments.
struct SplitLine {
    std::string code, remarks;
    Letters code_letters = 0, remark_letters = 0;

    void split(std::string_view line) {
        code.clear();
        remarks.clear();
        code_letters = remark_letters = 0;
        int depth = 0;
        for (const char raw : line.substr(0, 400)) {
            const char c = raw >= 'a' && raw <= 'z' ? static_cast<char>(raw - 32) : raw;
            if (c == '(') ++depth;
            if (c == ';') depth = 1000;
            (depth > 0 ? remarks : code) += c;
            (depth > 0 ? remark_letters : code_letters) |= bit_of(c);
            if (c == ')' && depth > 0 && depth < 1000) --depth;
        }
    }
};

/// True if `line` consists of words with letters `plain` that look alike on all controls: "N10 G1
/// X1.5 Y-2 F100". Adds the letters of the line to `letters_seen`.
bool is_plain(std::string_view line, Letters plain, Letters& letters_seen) {
    constexpr Letters kNumbers = letters_of("0123456789.+- \t\r");
    Letters letters = 0;
    bool has_digit = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        char c = line[i];
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
        if (is_capital(c)) {
            if ((bit_of(c) & plain) != 0) {
                letters |= bit_of(c);
                continue;
            }
            if (c != 'G') return false;
            // G0 … G3, optionally with a leading zero.
            ++i;
            if (i + 1 < line.size() && line[i] == '0' && is_digit(line[i + 1])) ++i;
            if (i == line.size() || line[i] < '0' || line[i] > '3') return false;
            if (i + 1 < line.size() && (is_digit(line[i + 1]) || line[i + 1] == '.')) return false;
        } else if (static_cast<unsigned char>(c) >= 64 || (bit_of(c) & kNumbers) == 0) {
            return false;
        } else if (is_digit(c)) {
            has_digit = true;
        }
    }
    letters_seen |= letters;
    return letters != 0 && has_digit;
}

/// Returns `line` without the beginning "120 L " of a straight move in Klartext.
std::string_view without_line_verb(std::string_view line) {
    std::size_t at = 0;
    while (at < line.size() && (is_digit(line[at]) || line[at] == ' '))
        ++at;
    const bool has_verb = at + 1 < line.size() && line[at] == 'L' && line[at + 1] == ' ';
    return has_verb ? line.substr(at + 2) : line;
}

/// True for "PART.MPF", "part.spf": main programs and subprograms of SINUMERIK.
bool has_siemens_name(std::string_view name) {
    if (name.size() < 4) return false;
    std::string ending(name.substr(name.size() - 4));
    for (char& c : ending)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
    return ending == ".MPF" || ending == ".SPF";
}

/// True if `code` has G20, G21 or G43, which the language of SINUMERIK lacks.
bool has_iso_code(std::string_view code) {
    for (std::size_t i = 0; i + 2 < code.size(); ++i) {
        const std::string_view word = code.substr(i, 3);
        const bool ends = i + 3 == code.size() || !(is_digit(code[i + 3]) || code[i + 3] == '.');
        if (ends && (word == "G20" || word == "G21" || word == "G43")) return true;
    }
    return false;
}

/// Sign of Kind::Heidenhain: lines like "L X+10".
constexpr std::size_t kLinesOfKlartext = 40;

class DialectDetector {
public:
    explicit DialectDetector(std::string_view name) : is_named_siemens_(has_siemens_name(name)) {}

    /// Counts the signs of a line. Lines with only the letters N X Y Z F and G0 … G3, and, unless
    /// `every`, also A B C I J K R S, contain no signs; such lines only contribute axes.
    void scan_line(std::string_view line, std::uint32_t number, bool every) {
        constexpr Letters kPlain = letters_of("NXYZF");
        constexpr Letters kPlainArcs = kPlain | letters_of("ABCIJKRS");
        Letters seen = 0;
        const bool has_lines = (kinds_[Kind::Heidenhain].seen >> kLinesOfKlartext & 1U) != 0;
        if (is_plain(has_lines ? without_line_verb(line) : line, every ? kPlain : kPlainArcs,
                     seen)) {
            has_words_ = true;
            has_y_ = has_y_ || (seen & bit_of('Y')) != 0;
            has_xz_ = has_xz_ || (seen & letters_of("XZ")) != 0;
            if ((seen & bit_of('C')) != 0) split_.split(line);
            record_axes(seen, number);
            return;
        }
        split_.split(line);
        add_weights(kDialectSigns, dialects_, number);
        add_weights(kKindSigns, kinds_, number);
        find_turning(number);
        find_header(number);
        find_heidenhain(number);
        find_values_after_equals(number);
        find_named_cycles(number);
        find_siemens(number);
        find_power(number);
        has_iso_codes_ = has_iso_codes_ || (is_named_siemens_ && has_iso_code(split_.code));
        const std::string& code = split_.code;
        Letters words = 0;
        for (std::size_t i = 0; i + 1 < code.size(); ++i) {
            const std::size_t value = code.find_first_not_of(' ', i + 1);
            if (!is_capital(code[i]) || value == std::string::npos) continue;
            if (i > 0 && code[i - 1] == ',') continue;
            const char first = code[value];
            const bool signed_or_point = first == '-' || first == '+' || first == '.';
            const bool digit_follows = value + 1 < code.size() && is_digit(code[value + 1]);
            if (is_digit(first) || first == '#' || first == '[' || first == '<' ||
                (signed_or_point && digit_follows)) {
                words |= bit_of(code[i]);
            }
        }
        has_words_ = has_words_ || words != 0;
        record_axes(words, number);
    }

    /// True if no further line can change the conclusion that the program is Klartext.
    bool is_certainly_klartext() const {
        constexpr int kCertain = 12;
        return kinds_[Kind::Heidenhain].weight >= kCertain;
    }

    void conclude(DialectFindings& findings) const {
        findings.c_may_be_corner = c_like_corners_ && !c_is_axis_;
        const Dialect best = *std::ranges::max_element(
            kDialectList, {}, [this](Dialect dialect) { return dialects_[dialect].weight; });
        if (dialects_[best].weight >= 2) {
            findings.dialect = best;
            findings.evidence = dialects_[best].evidence;
        }
        for (const auto& [kind, enough] : kEnough) {
            // Printers extrude (E words); heaters alone also occur on other machines.
            if (kind == Kind::Printer && !extrudes_) continue;
            if (kinds_[kind].weight >= enough && findings.kind == Kind::Milling) {
                findings.kind = kind;
                findings.kind_evidence = kinds_[kind].evidence;
            }
        }
        // The file name decides unless the text has signs of a different control.
        constexpr int kStronger = 4;
        if (findings.kind == Kind::Milling && is_named_siemens_ && !has_iso_codes_ &&
            dialects_[best].weight < kStronger) {
            findings.kind = Kind::Siemens;
            findings.kind_evidence = {{"a file name ending in .mpf or .spf", 0}};
        }
        if (findings.kind == Kind::Milling && turning_.weight >= (changes_tools_ ? 5 : 4) &&
            !has_y_ && !turns_a_or_b_ && has_xz_) {
            findings.kind = Kind::Lathe;
            findings.kind_evidence = turning_.evidence;
        }
        if (findings.kind == Kind::Milling && power_.weight >= 4 && !has_z_ && !changes_tools_) {
            findings.kind = Kind::Laser;
            findings.kind_evidence = power_.evidence;
        }
        // A Klartext program may consist of calls without numbers.
        const bool begins_klartext = (kinds_[Kind::Heidenhain].seen & 1U) != 0;
        if (!has_words_ && !begins_klartext) {
            findings.kind = Kind::NotAProgram;
            findings.kind_evidence = {{"no word of a letter and a number in it", 0}};
        }
    }

private:
    struct Case {
        int weight = 0;
        std::vector<Evidence> evidence;
        std::uint64_t seen = 0;
    };
    /// A case for each value of an enumeration.
    template <typename Conclusion, std::size_t kCount>
    struct Cases {
        std::array<Case, kCount> all;
        Case& operator[](Conclusion of) { return all[static_cast<std::size_t>(of)]; }
        const Case& operator[](Conclusion of) const { return all[static_cast<std::size_t>(of)]; }
    };

    static void add(Case& which, std::size_t sign, int weight, std::string_view because,
                    std::uint32_t line) {
        if ((which.seen >> sign & 1U) != 0) return;  // Each sign counts once.
        which.seen |= std::uint64_t{1} << sign;
        which.weight += weight;
        which.evidence.push_back({std::string(because), line});
    }

    template <typename Signs, typename Cases>
    void add_weights(const Signs& signs, Cases& cases, std::uint32_t line) const {
        std::size_t number = 0;  // Number of the sign among the signs of one conclusion.
        for (std::size_t i = 0; i < std::size(signs); ++i) {
            const auto& sign = signs[i];
            number = i > 0 && signs[i - 1].of == sign.of ? number + 1 : 0;
            const bool in_comments = sign.place == Place::Comment;
            const Letters there = in_comments ? split_.remark_letters : split_.code_letters;
            if ((sign.letters & ~there) != 0) continue;
            Case& which = cases[sign.of];
            if ((which.seen >> number & 1U) != 0) continue;
            if (contains(in_comments ? split_.remarks : split_.code, sign.text))
                add(which, number, sign.weight, sign.because, line);
        }
    }

    /// Counts signs of lathe programs: no Y, tools such as T0101, constant surface speed, cycles
    /// from P to Q.
    void find_turning(std::uint32_t line) {
        const std::string& code = split_.code;
        for (std::size_t i = 0; i + 1 < code.size(); ++i) {
            if (!is_capital(code[i]) || (i > 0 && is_capital(code[i - 1]))) continue;
            const bool number = is_digit(code[i + 1]) || code[i + 1] == '-' || code[i + 1] == '.' ||
                                code[i + 1] == '#' || code[i + 1] == '[' || code[i + 1] == ' ';
            if (code[i] == 'Y' && number) has_y_ = true;
            if ((code[i] == 'X' || code[i] == 'Z') && number) has_xz_ = true;
            if (code[i] == 'T') {
                std::size_t digits = 0;
                while (i + 1 + digits < code.size() && is_digit(code[i + 1 + digits]))
                    ++digits;
                if (digits == 4 && code.substr(i + 1, 2) == code.substr(i + 3, 2)) {
                    add(turning_, 0, 4, "tools like T0101", line);
                }
            }
        }
        if (contains(code, "G96")) add(turning_, 1, 4, "constant surface speed (G96)", line);
        if (contains(code, "G50") && contains(code, "S")) add(turning_, 6, 4, "G50 S", line);
        if (contains(code, "G28") && (contains(code, "U0") || contains(code, "U0.")))
            add(turning_, 8, 4, "home along U and W", line);
        for (const std::string_view cycle : {"G70", "G71", "G72", "G73", "G76"}) {
            if (contains(code, cycle) && code.find('P') != std::string::npos &&
                code.find('Q') != std::string::npos) {
                add(turning_, 2, 5, "turning cycles from P to Q", line);
            }
        }
        const bool is_arc = contains(code, "G2") || contains(code, "G02") || contains(code, "G3") ||
                            contains(code, "G03");
        if (contains(code, "G18") || contains(code, "G19")) has_plane_ = true;
        if (is_arc && !has_plane_ && code.find('K') != std::string::npos &&
            code.find('Z') != std::string::npos && code.find('X') != std::string::npos &&
            code.find('J') == std::string::npos) {
            add(turning_, 7, 5, "arcs in X and Z without G18", line);
        }
        if (contains(split_.remarks, "LATHE"))
            add(turning_, 3, 3, "a comment speaks of a lathe", line);
        if (contains(split_.remarks, "TURNING"))
            add(turning_, 4, 2, "a comment speaks of turning", line);
        if (contains(code, "G7")) add(turning_, 5, 3, "diameters (G7)", line);
    }

    /// Counts lines with letters without numbers, as in Klartext: "12 L X+10 FMAX", "CC X+0 Y+0".
    void find_heidenhain(std::uint32_t line) {
        const std::string& code = split_.code;
        std::size_t at = code.find_first_not_of("0123456789 \t");
        if (at == std::string::npos || (code[at] != 'L' && code[at] != 'C')) return;
        const std::string::size_type end = code.find_first_of(" \t", at);
        if (end == std::string::npos) return;
        const std::string_view name = std::string_view(code).substr(at, end - at);
        if (name != "L" && name != "C" && name != "CC") return;
        at = code.find_first_not_of(" \t", end);
        if (at != std::string::npos && code[at] == 'I') ++at;  // IX+5: an increment.
        if (at == std::string::npos || (code[at] != 'X' && code[at] != 'Y' && code[at] != 'Z'))
            return;
        ++at;
        if (at < code.size() && (code[at] == '+' || code[at] == '-')) ++at;
        if (at >= code.size() || (code[at] != 'Q' && code[at] != '.' && !is_digit(code[at])))
            return;  // "C X-axis to the left" is prose.
        add(kinds_[Kind::Heidenhain], kLinesOfKlartext, 4, "lines like L X+10 and CC X+10", line);
    }

    /// Counts values after "=", as on Siemens: "G1 X=AC(20)", "CR=5", "R1=10". In other languages
    /// only parameters (#1=, #<a>=) and settings ($1=) have "=".
    void find_values_after_equals(std::uint32_t line) {
        const std::string& code = split_.code;
        if (code.find('=') == std::string::npos || code.find('$') != std::string::npos) return;
        for (const std::string_view text : {"DPRNT", "POPEN", "M117", "M118"}) {
            if (code.find(text) != std::string::npos) return;
        }
        const std::size_t g = code.find('G');
        const bool has_g = g != std::string::npos && g + 1 < code.size() && is_digit(code[g + 1]);
        for (std::size_t p = code.find('='); p != std::string::npos; p = code.find('=', p + 1)) {
            const std::string_view before = name_before(code, p);
            if (before.empty()) continue;
            const bool numbered = is_digit(before.back());
            if (numbered && (before[0] == 'R' || before[0] == 'S') && is_digit(before[1])) {
                add(kinds_[Kind::Siemens], 40, 4, "values of parameters (R1=…)", line);
            } else if (before == "CR" || before == "RND" || before == "CHF" || before == "CHR" ||
                       before == "ANG") {
                add(kinds_[Kind::Siemens], 41, 4, std::string(before) + "=", line);
            } else if (before.size() == 1 && has_g &&
                       std::string_view("XYZABCIJKF").find(before[0]) != std::string_view::npos) {
                add(kinds_[Kind::Siemens], 42, 4, "values behind = (X=…)", line);
            }
        }
    }

    /// Counts "CYCLE83(5,0,1,-20)", "POCKET3(…)", "HOLES2(…)", "MSG("…")".
    void find_named_cycles(std::uint32_t line) {
        const std::string& code = split_.code;
        const std::size_t last = code.find_last_not_of(" \r");
        const std::size_t text = split_.remarks.find_first_not_of("( ");
        if (last != std::string::npos && last >= 2 && code.compare(last - 2, 3, "MSG") == 0 &&
            text != std::string::npos && split_.remarks[text] == '"') {
            add(kinds_[Kind::Siemens], 44, 4, "messages as MSG(\"…\")", line);
        }
        for (const std::string_view name : {"CYCLE", "POCKET", "HOLES", "SLOT"}) {
            const std::size_t at = code.find(name);
            if (at == std::string::npos) continue;
            const std::size_t end = code.find_first_not_of("0123456789", at + name.size());
            const bool starts = at == 0 || code[at - 1] == ' ' || is_digit(code[at - 1]);
            const bool ends = end == std::string::npos || code[end] == ' ' || code[end] == '\r';
            if (starts && ends && at + name.size() < code.size() &&
                is_digit(code[at + name.size()])) {
                add(kinds_[Kind::Siemens], 43, 4, code.substr(at, std::min(end, code.size()) - at),
                    line);
            }
        }
    }

    /// Counts blocks that begin with a statement of SINUMERIK ("PROC CUT", "FOR I=1 TO 5", "TRANS
    /// X10"), its keywords, and G codes that other controls lack.
    void find_siemens(std::uint32_t line) {
        const std::string_view code = split_.code;
        Case& siemens = kinds_[Kind::Siemens];
        std::size_t at = code.find_first_not_of(" \t");
        if (at == std::string_view::npos) return;
        if (code[at] == 'N' && at + 1 < code.size() && is_digit(code[at + 1])) {
            at = code.find_first_not_of("0123456789", at + 1);
            at = at == std::string_view::npos ? at : code.find_first_not_of(" \t", at);
            if (at == std::string_view::npos) return;
        }
        std::size_t end = at;
        while (end < code.size() && is_capital(code[end]))
            ++end;
        const std::string_view first = code.substr(at, end - at);
        const std::size_t next = code.find_first_not_of(" \t\r", end);
        const std::string_view rest =
            next == std::string_view::npos ? std::string_view() : code.substr(next);
        const auto begins = [&](std::string_view name) {
            return rest.starts_with(name) && rest.size() > name.size() &&
                   (rest[name.size()] == ' ' || rest[name.size()] == '[');
        };
        const bool has_name = !rest.empty() && (is_capital(rest[0]) || rest[0] == '_');
        const bool is_spaced = end < code.size() && code[end] == ' ';
        if ((first == "PROC" || first == "EXTERN") && has_name && is_spaced)
            add(siemens, 45, 4, first, line);
        if (first == "DEF" &&
            (begins("INT") || begins("REAL") || begins("BOOL") || begins("STRING") ||
             begins("CHAR") || begins("AXIS") || begins("FRAME")))
            add(siemens, 46, 4, "variables (DEF)", line);
        if (first == "FOR" && code.find('=') != std::string_view::npos &&
            code.find(" TO ") != std::string_view::npos)
            add(siemens, 47, 4, "FOR … TO", line);
        if (first == "CASE" && code.find(" OF ") != std::string_view::npos)
            add(siemens, 48, 4, "CASE … OF", line);
        constexpr std::array<std::string_view, 8> kFrames{"TRANS", "ATRANS", "ROT",    "AROT",
                                                          "SCALE", "ASCALE", "MIRROR", "AMIRROR"};
        const bool is_frame = std::ranges::find(kFrames, first) != kFrames.end();
        const bool has_axis = rest.size() > 1 &&
                              ((rest[0] >= 'X' && rest[0] <= 'Z') || rest.starts_with("RPL")) &&
                              rest.find_first_of("0123456789=") != std::string_view::npos;
        if (is_frame && (rest.empty() || (has_axis && is_spaced))) add(siemens, 49, 4, first, line);
        constexpr std::array<std::string_view, 6> kWords{"TRAFOOF", "STOPRE", "SETMS",
                                                         "FNORM",   "CUT2D",  "COMPOF"};
        for (std::size_t i = 0; i < kWords.size(); ++i) {
            if (contains(code, kWords[i])) add(siemens, 50 + i, 4, kWords[i], line);
        }
        constexpr std::array<std::string_view, 7> kCodes{"G500", "G700", "G710", "G601",
                                                         "G602", "G641", "G642"};
        for (std::size_t i = 0; i < kCodes.size(); ++i) {
            if (contains(code, kCodes[i])) add(siemens, 56 + i, 3, kCodes[i], line);
        }
    }

    /// Returns the letters and following digits that end right before `p`; empty for parameters
    /// (#1, #<a>).
    static std::string_view name_before(std::string_view code, std::size_t p) {
        std::size_t end = p;
        while (end > 0 && code[end - 1] == ' ')
            --end;
        std::size_t at = end;
        while (at > 0 && is_digit(code[at - 1]))
            --at;
        const std::size_t digits = at;
        while (at > 0 && is_capital(code[at - 1]))
            --at;
        if (at == digits) return {};
        if (at > 0 && std::string_view("#<>_./]").find(code[at - 1]) != std::string_view::npos)
            return {};
        return code.substr(at, end - at);
    }

    /// Counts signs of lasers, which have no Z: switched on and off, power within moves.
    void find_power(std::uint32_t line) {
        const std::string& code = split_.code;
        for (const std::string_view on : {"M3", "M4", "M03", "M04"}) {
            if (contains(code, on) && (contains(code, "S0") || contains(code, "S 0")))
                add(power_, 0, 2, "a spindle on at S0", line);
        }
        if (contains(code, "M106") || contains(code, "M107"))
            add(power_, 1, 2, "power by M106 and M107", line);
    }

    /// Records the axes of a line, and signs in the same line.
    void record_axes(Letters words, std::uint32_t line) {
        constexpr Letters kXY = letters_of("XY");
        has_z_ = has_z_ || (words & bit_of('Z')) != 0;
        turns_a_or_b_ = turns_a_or_b_ || (words & letters_of("AB")) != 0;
        extrudes_ = extrudes_ || (words & bit_of('E')) != 0;
        if ((words & bit_of('S')) != 0 && (words & kXY) != 0)
            add(power_, 2, 2, "S with moves, and no Z", line);
        if ((words & bit_of('C')) != 0) classify_c(words);
        if ((words & letters_of("MT")) == 0) return;
        changes_tools_ =
            changes_tools_ || contains(split_.code, "M6") || contains(split_.code, "M06");
    }

    static double number_at(const std::string& code, std::size_t at) {
        const PlainNumber number = read_plain_number(code.data() + at, code.data() + code.size());
        return number.end ? number.value : 0.0;
    }

    /// Decides whether the C of a line is a rotary axis or may be the size of a chamfer.
    void classify_c(Letters words) {
        constexpr double kLargestChamfer = 20.0;
        const std::string& code = split_.code;
        const std::size_t c = code.find('C');
        const double size = c == std::string::npos ? 0.0 : number_at(code, c + 1);
        const bool line =
            (words & letters_of("ABZIJKRUVWHLPQTMO")) == 0 && (words & letters_of("XY")) != 0;
        bool other_code = false;  // A G code other than G1 and modes.
        for (std::size_t g = code.find('G'); g != std::string::npos; g = code.find('G', g + 1)) {
            const double number = number_at(code, g + 1);
            other_code = other_code || (number != 1.0 && number != 17.0 && number != 40.0 &&
                                        number != 90.0 && number != 94.0);
        }
        if (line && !other_code && size > 0.0 && size <= kLargestChamfer) {
            c_like_corners_ = true;
        } else {
            c_is_axis_ = true;
        }
    }

    /// Counts a header of Fanuc programs: "O1234" near the beginning.
    void find_header(std::uint32_t line) {
        const std::string& code = split_.code;
        if (line > 5 || code.size() < 5 || (code[0] != 'O' && code[0] != ':')) return;
        for (std::size_t i = 1; i < 5; ++i) {
            if (!is_digit(code[i])) return;
        }
        if (code.find("SUB") != std::string::npos) return;
        const std::size_t end = std::min(code.find_first_not_of("0123456789", 1), code.size());
        const std::string number = code.substr(0, std::min<std::size_t>(end, 12));
        add(dialects_[Dialect::Fanuc], 60, 2, "the program number " + number, line);
    }

    bool is_named_siemens_ = false;
    bool has_iso_codes_ = false;
    SplitLine split_;
    Cases<Dialect, kDialectList.size()> dialects_;
    Cases<Kind, static_cast<std::size_t>(Kind::NotAProgram)> kinds_;
    Case turning_, power_;
    bool has_y_ = false;
    bool has_xz_ = false;
    bool has_z_ = false;
    bool turns_a_or_b_ = false;
    bool changes_tools_ = false;
    bool extrudes_ = false;
    bool c_like_corners_ = false;
    bool c_is_axis_ = false;
    bool has_words_ = false;
    bool has_plane_ = false;
};

/// True if `text` has too many control bytes for a program.
bool looks_binary(std::string_view text) {
    const std::string_view head = text.substr(0, 4096);
    const auto odd = std::ranges::count_if(head, [](char c) {
        return c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f' &&
               c != '\x1a' && c != '\x1b';
    });
    return odd > 16 && static_cast<std::size_t>(odd) * 20 > head.size();
}

}  // namespace

DialectFindings detect_dialect(const SourceFile& program) {
    DialectFindings findings;
    std::string_view rest = after_byte_order_mark(program.text);
    if (looks_binary(rest)) {
        findings.kind = Kind::NotAProgram;
        findings.kind_evidence = {{"its bytes are no text", 1}};
        return findings;
    }
    DialectDetector detective(program.name);
    const std::size_t whole = rest.size();
    for (std::uint32_t line = 1; !rest.empty(); ++line) {
        const LineEnd end = find_line_end(rest);
        const bool every = whole - rest.size() < kEveryLine;
        if (!every && detective.is_certainly_klartext()) break;
        detective.scan_line(rest.substr(0, end.length), line, every);
        rest.remove_prefix(end.next);
    }
    detective.conclude(findings);
    return findings;
}

}  // namespace ncsim::gcode
