// SPDX-License-Identifier: GPL-3.0-or-later
//
// Addresses, G codes and keywords.
// Source: SINUMERIK 840D sl, Programming Manual Fundamentals, "Tables", 06/2019.
#include "sinumerik/words.h"

#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::sinumerik {
namespace {

constexpr std::string_view kAxes = "XYZABCUVW";
constexpr std::string_view kCentres = "IJK";

/// Keywords that move no axis: look-ahead, precision, compressors, displays, spindles.
constexpr auto kWithoutPath = std::to_array<std::string_view>({
    "FNORM",     "FLIN",     "FCUB",      "FFWON",    "FFWOF",    "SOFT",     "BRISK",
    "DRIVE",     "STOPRE",   "COMPON",    "COMPOF",   "COMPCURV", "COMPCAD",  "COMPSURF",
    "CFC",       "CFTCP",    "CFIN",      "CUT2D",    "CUT2DF",   "CDON",     "CDOF",
    "CDOF2",     "DIAMOF",   "NORM",      "ORIMKS",   "ORIAXES",  "ORIWKS",   "ORIVECT",
    "ORIEULER",  "ORIRPY",   "OSC",       "OSOF",     "OSS",      "OSSE",     "OSD",
    "OST",       "RTLION",   "UPATH",     "SPATH",    "WALIMON",  "WALIMOF",  "SBLON",
    "SBLOF",     "DISPLON",  "DISPLOF",   "DYNNORM",  "DYNPOS",   "DYNROUGH", "DYNSEMIFIN",
    "DYNFINISH", "SPCON",    "SPCOF",     "LFOF",     "LFON",     "TOFROF",   "TOROTOF",
    "PAROTOF",   "FIFOCTRL", "STARTFIFO", "STOPFIFO", "CPRECON",  "CPRECOF",  "GWPSOF",
    "FENDNORM",  "ORISON",   "ORISOF",    "DYNPREC",
});

/// Keywords of the language that ncsim refuses. Unknown names are calls of subprograms.
constexpr auto kRefused = std::to_array<std::string_view>({
    "ASPLINE",  "BSPLINE", "CSPLINE",  "POLY",     "POLYPATH",  "INVCW",    "INVCCW",   "TRANSMIT",
    "TRACYL",   "TRAANG",  "TRACON",   "TCARR",    "TCOFR",     "TOROT",    "TOROTX",   "TOROTY",
    "TOROTZ",   "TOFRAME", "TOFRAMEX", "TOFRAMEY", "TOFRAMEZ",  "PAROT",    "KONT",     "KONTC",
    "KONTT",    "DIAMON",  "DIAM90",   "DIAMONA",  "RTLIOF",    "CUT3DC",   "CUT3DF",   "CUT3DFS",
    "CUT3DFF",  "CUT3DCC", "CUT3DCCD", "SETINT",   "CLRINT",    "ENABLE",   "DISABLE",  "WHEN",
    "WHENEVER", "EVERY",   "FROM",     "ID",       "IDS",       "DO",       "DEFINE",   "MEAS",
    "MEAW",     "MEAC",    "MEASA",    "MEAWA",    "TRAILON",   "TRAILOF",  "LEADON",   "LEADOF",
    "COUPON",   "COUPOF",  "EGON",     "EGOF",     "REPOSA",    "REPOSL",   "REPOSQ",   "REPOSH",
    "REPOSQA",  "REPOSHA", "ORIPLANE", "ORICONCW", "ORICONCCW", "ORICONTO", "ORICONIO", "ORICURVE",
    "PRESETON", "TOFRON",  "TOFF",     "ISOCALL",  "ROTS",      "AROTS",    "CROTS",    "CTRANS",
    "CROT",     "CSCALE",  "CMIRROR",  "CFINE",    "INIT",      "START",    "WAITE",    "GETEXEC",
    "CLEARM",   "SETM",    "DELT",     "NEWT",     "WRITE",     "READ",     "DELETE",   "PUNCHACC",
    "SON",      "PON",     "FXS",      "FXST",     "FXSW",      "CONTPRON",
});

template <std::size_t N>
bool has_name(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

constexpr auto kLong = std::to_array<std::string_view>(
    {"CR",       "AR",    "AP",      "RP",     "RPL",   "TURN",    "RND",     "RNDM",    "CHF",
     "CHR",      "ANG",   "I1",      "J1",     "K1",    "A2",      "B2",      "C2",      "A3",
     "B3",       "C3",    "A4",      "B4",     "C4",    "A5",      "B5",      "C5",      "A6",
     "B6",       "C6",    "A7",      "B7",     "C7",    "OFFN",    "DISR",    "DISCL",   "DISC",
     "SPOS",     "SPOSA", "OVR",     "OVRRAP", "FAD",   "FRC",     "FRCM",    "FB",      "FP",
     "LIMS",     "ADIS",  "ADISPOS", "SF",     "DITS",  "DITE",    "PM",      "PR",      "FZ",
     "ACC",      "FA",    "OVRA",    "FL",     "S1",    "M1",      "S2",      "M2",      "S3",
     "M3",       "T1",    "PHI",     "PSI",    "THETA", "LEAD",    "TILT",    "PL",      "PW",
     "SPI",      "CTOL",  "OTOL",    "ATOL",   "TCARR", "JERKLIM", "VELOLIM", "ACCLIMA", "JERKLIMA",
     "VELOLIMA", "X1",    "Y1",      "Z1",     "G",     "TOFFL",   "TOFFR"});

std::string name_of_g(double number) {
    return "G" + text_of(number);
}

/// Addresses that move no axis.
constexpr auto kLongWithoutPath = std::to_array<std::string_view>(
    {"OVR",     "OVRRAP",  "FAD",     "LIMS",     "ADIS",     "ADISPOS", "ACC",
     "OVRA",    "FL",      "CTOL",    "OTOL",     "ATOL",     "DISC",    "FP",
     "JERKLIM", "VELOLIM", "ACCLIMA", "JERKLIMA", "VELOLIMA", "FA"});

}  // namespace

bool is_long_address(std::string_view name) {
    const bool is_output =
        name.size() > 1 && name[0] == 'H' && std::ranges::all_of(name.substr(1), is_digit);  // H5=3
    return is_output || has_name(kLong, name);
}

bool Words::has_m(int number) const {
    return std::ranges::find(m, number) != m.end();
}

bool Words::has_axes() const {
    const auto is_set = [](const auto& word) { return word.has_value(); };
    return has_plain_axes() || polar_angle || polar_radius ||
           std::ranges::any_of(direction, is_set);
}

bool Words::has_plain_axes() const {
    return std::ranges::any_of(axis, [](const auto& word) { return word.has_value(); });
}

bool Words::is_empty() const {
    const auto is_set = [](const auto& word) { return word.has_value(); };
    return !has_axes() && m.empty() && !feed && !speed && !edge && !tool && !tool_name &&
           !std::ranges::any_of(centre, is_set) && !std::ranges::any_of(code, is_set);
}

WordReader::Found WordReader::fail(const MessageText& message, SourceSpan span,
                                   std::initializer_list<std::string_view> arguments) {
    log_.add(message, span, arguments);
    return Found::Error;
}

/// Sets the code of `group`. An empty `name` stands for "G" and `code`.
bool WordReader::set_code(CodeGroup group, int code, std::string_view name, SourceSpan span,
                          Words& words) {
    if (group == CodeGroup::None) return true;
    std::optional<int>& there = words.code[static_cast<std::size_t>(group)];
    if (there && *there != code) {
        log_.add(Message::CodesExclude, span, {name.empty() ? name_of_g(code) : std::string(name)});
        return false;
    }
    there = code;
    return true;
}

WordReader::Found WordReader::g_code(double number, SourceSpan span, Words& words) {
    const bool is_in_range = number >= 0.0 && number < 1000.0;
    const int g = is_in_range ? static_cast<int>(number) : -1;
    if (g != number) return fail(Message::NotRead, span, {name_of_g(number)});
    CodeGroup group = CodeGroup::None;
    if (g <= 3) {
        group = CodeGroup::Motion;
    } else if (g == 4 || g == 74 || g == 75 || (g >= 110 && g <= 112) || g == 25 || g == 26 ||
               g == 58 || g == 59) {
        group = CodeGroup::OneShot;
    } else if (g >= 17 && g <= 19) {
        group = CodeGroup::Plane;
    } else if (g >= 40 && g <= 42) {
        group = CodeGroup::Side;
    } else if ((g >= 54 && g <= 57) || g == 500 || (g >= 505 && g <= 599)) {
        group = CodeGroup::System;
    } else if (g == 53 || g == 153) {
        group = CodeGroup::Suppress;
    } else if (g == 70 || g == 71 || g == 700 || g == 710) {
        group = CodeGroup::Units;
    } else if (g == 90 || g == 91) {
        group = CodeGroup::Distance;
    } else if ((g >= 93 && g <= 97) || g == 961 || g == 971 || g == 973) {
        group = CodeGroup::Feed;
    } else if (g == 450 || g == 451) {
        group = CodeGroup::Corner;
    } else if (g == 60 || g == 64 || (g >= 641 && g <= 645)) {
        group = CodeGroup::PathMode;
    } else {
        const bool has_no_path = g == 9 || (g >= 601 && g <= 603) || g == 62 || g == 621 ||
                                 (g >= 140 && g <= 143) || g == 340 || g == 341 ||
                                 (g >= 460 && g <= 462) || g == 290;
        if (!has_no_path) return fail(Message::NotRead, span, {name_of_g(number)});
    }
    return set_code(group, g, {}, span, words) ? Found::Yes : Found::Error;
}

WordReader::Found WordReader::keyword(std::string_view name, SourceSpan span, Words& words) {
    const auto set = [&](CodeGroup group, int code) {
        return set_code(group, code, name, span, words) ? Found::Yes : Found::Error;
    };
    if (name == "SUPA") return set(CodeGroup::Suppress, kSupa);
    if (name == "CIP") return set(CodeGroup::Motion, kCip);
    if (name == "CT") return set(CodeGroup::Motion, kCt);
    if (name == "TRAORI") return set(CodeGroup::Transform, kTraori);
    if (name == "TRAFOOF") return set(CodeGroup::Transform, kTrafoof);
    if (name == "ORIWKS" || name == "ORIVECT") words.turns_by_vector = true;
    if (name == "ORIMKS" || name == "ORIAXES") words.turns_by_vector = false;
    if (has_name(kWithoutPath, name)) return Found::Yes;
    if (has_name(kRefused, name)) return fail(Message::NotRead, span, {name});
    return Found::No;
}

/// Reads the value of a coordinate: an expression, or AC(…), IC(…), DC(…), ACP(…), ACN(…).
std::optional<Coordinate> WordReader::coordinate(CodeScanner& scan, const Line& line) {
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    struct Function {
        std::string_view name;
        Way way;
    };
    constexpr std::array<Function, 5> kFunctions{{{"AC", Way::Absolute},
                                                  {"IC", Way::Increment},
                                                  {"DC", Way::Shortest},
                                                  {"ACP", Way::Positive},
                                                  {"ACN", Way::Negative}}};
    const std::string_view raw = name_at(scan.remaining());
    const std::string name = upper_of(raw);
    Coordinate found;
    for (const Function& function : kFunctions) {
        if (name != function.name) continue;
        scan.move_to(begin + raw.size());
        if (!scan.take('(')) break;
        const std::optional<double> value = expressions_.number(scan, line);
        if (!value) return std::nullopt;
        if (!scan.take(')')) {
            log_.add(Message::BracketUnclosed, line.span(begin, 1));
            return std::nullopt;
        }
        found.value = *value;
        found.way = function.way;
        found.span = line.span(begin, scan.at() - begin);
        return found;
    }
    scan.move_to(begin);
    const std::optional<double> value = expressions_.number(scan, line);
    if (!value) return std::nullopt;
    found.value = *value;
    found.span = line.span(begin, scan.at() - begin);
    return found;
}

WordReader::Found WordReader::plain_word(CodeScanner& scan, const Line& line, Words& words) {
    const std::size_t begin = scan.at();
    const char letter = upper(line.code[begin]);
    if (!is_letter(letter) || letter == 'R' || letter == 'L') return Found::No;
    scan.move_to(begin + 1);
    const std::optional<double> number = expressions_.literal(scan, line);
    if (!number) return Found::Error;
    const SourceSpan span = line.span(begin, scan.at() - begin);
    return take({&letter, 1}, *number, {*number, Way::Modal, span}, span, words);
}

WordReader::Found WordReader::word(CodeScanner& scan, const Line& line, Words& words) {
    const std::size_t begin = scan.at();
    const std::string_view raw = name_at(scan.remaining());
    if (raw.empty()) return Found::No;
    std::string name = upper_of(raw);
    scan.move_to(begin + raw.size());
    // "ACC[X]=50", "FA[C]=100", "S[1]=500"
    const bool is_indexed = scan.peek() == '[' && has_name(kLong, name);
    if (is_indexed) {
        const std::size_t end = scan.remaining().find(']');
        if (end == std::string_view::npos) return Found::No;
        scan.move_to(scan.at() + end + 1);
    }
    scan.skip_blanks();
    const bool has_sign = scan.peek() == '=' && scan.peek(1) != '=';
    const bool is_single = name.size() == 1 && is_letter(name[0]);
    Coordinate value;
    if (has_sign && (is_single || is_long_address(name))) {
        scan.move_to(scan.at() + 1);
        scan.skip_blanks();
        if (name == "T" || name == "T1") {
            const std::optional<Value> tool = expressions_.value(scan, line);
            if (!tool) return Found::Error;
            if (tool->is_text) {
                words.tool_name = tool->text;
            } else {
                words.tool = tool->number;
            }
            return Found::Yes;
        }
        const std::optional<Coordinate> read = coordinate(scan, line);
        if (!read) return Found::Error;
        value = *read;
    } else {
        // "X10", "G0X5": a letter and a number.
        const char next = raw.size() > 1                        ? raw[1]
                          : line.code.substr(begin + 1).empty() ? '\0'
                                                                : line.code[begin + 1];
        const bool is_number = is_digit(next) || next == '.' || next == '-' || next == '+';
        if (!is_letter(name[0]) || !is_number || name[0] == 'R' || name[0] == 'L') {
            scan.move_to(begin);
            return Found::No;
        }
        scan.move_to(begin + 1);
        name.resize(1);
        const std::optional<double> number = expressions_.literal(scan, line);
        if (!number) return Found::Error;
        value.value = *number;
    }
    const SourceSpan span = line.span(begin, scan.at() - begin);
    value.span = span;
    return take(name, value.value, value, span, words);
}

WordReader::Found WordReader::take(std::string_view name, double value,
                                   const Coordinate& coordinate, SourceSpan span, Words& words) {
    const auto put_value = [&](auto& slot, const auto& content) {
        if (slot) log_.add(Message::WordTwice, span, {name});
        slot = content;
        return Found::Yes;
    };
    const auto put = [&](std::optional<double>& slot, double number) {
        return put_value(slot, number);
    };
    if (name.size() == 1) {
        const char letter = name[0];
        if (const std::size_t axis = kAxes.find(letter); axis != std::string_view::npos) {
            return put_value(words.axis[axis], coordinate);
        }
        if (const std::size_t axis = kCentres.find(letter); axis != std::string_view::npos) {
            return put_value(words.centre[axis], coordinate);
        }
        switch (letter) {
            case 'G': return g_code(value, span, words);
            case 'F': return put(words.feed, value);
            case 'S': return put(words.speed, value);
            case 'D': return put(words.edge, value);
            case 'T': return put(words.tool, value);
            case 'H': return Found::Yes;  // Auxiliary output.
            case 'M': {
                const double whole = std::round(value);
                if (whole != value || !(whole >= 0.0 && whole <= 32'767.0))
                    return fail(Message::NotWhole, span, {"M"});
                words.m.push_back(static_cast<int>(whole));
                return Found::Yes;
            }
            default: return fail(Message::NotRead, span, {name});
        }
    }
    if (name[0] == 'H') return Found::Yes;
    words.corner_span = span;
    if (name == "CR") return put(words.radius, value);
    if (name == "AR") return put(words.opening, value);
    if (name == "RP") return put(words.polar_radius, value);
    if (name == "TURN") return put(words.turns, value);
    if (name == "RND") return put(words.rounding, value);
    if (name == "CHR") return put(words.chamfer, value);
    if (name == "CHF") return put(words.chamfer_length, value);
    if (name == "RNDM") return put(words.modal_rounding, value);
    if (name == "FRC") return put(words.corner_feed, value);
    if (name == "FRCM") return put(words.modal_corner_feed, value);
    if (name == "ANG") return put(words.line_angle, value);
    if (name == "RPL") return put(words.plane_angle, value);
    if (name == "S1") return put(words.speed, value);
    if (name == "M1") return take("M", value, coordinate, span, words);
    if (name == "G") return g_code(value, span, words);
    if (name == "AP") {
        return put_value(words.polar_angle, coordinate);
    }
    if (name == "SPOS" || name == "SPOSA") {
        words.m.push_back(19);
        return Found::Yes;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (name[0] == kCentres[i] && name.size() == 2 && name[1] == '1') {
            return put_value(words.via[i], coordinate);
        }
        if (name[0] == "ABC"[i] && name.size() == 2 && name[1] == '3')
            return put(words.direction[i], value);
    }
    if (has_name(kLongWithoutPath, name)) return Found::Yes;
    // "OFFN=0" and "TCARR=0" switch off functions that ncsim does not read.
    const bool ends =
        value == 0.0 && (name == "OFFN" || name == "TCARR" || name == "TOFFL" || name == "TOFFR");
    if (ends) return Found::Yes;
    return fail(Message::NotRead, span, {std::string(name) + "="});
}

}  // namespace ncsim::gcode::sinumerik
