// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of words, and groups of G and M codes.
#include "program/block_resolver.h"

#include "ncsim/gcode/control_codes.h"
#include "ncsim/gcode/print.h"

#include "text/number.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {
namespace {

/// Larger than any machine, and small enough that sums and squares are finite.
constexpr double kLargest = 1e12;

/// True for the codes of grbl, including optional codes, and for M6, which senders execute.
bool is_of_grbl(char letter, double number) {
    static const ControlCodes& grbl = *find_control_codes("grbl");
    return (letter == 'M' && number == 6.0) || support_of(grbl, letter, number) != CodeSupport::No;
}

}  // namespace

Resolver::Resolver(const Rules& rules, const Parameters& parameters, DiagnosticLog& log,
                   const InterpreterOptions& options)
    : rules_(rules),
      parameters_(parameters),
      log_(log),
      tip_control_(options.tip_control),
      clamps_(options.clamps),
      knows_joints_(options.joints != nullptr) {
    for (const std::string& word : options.allow) {
        if (word.empty()) continue;
        const char letter =
            word[0] >= 'a' && word[0] <= 'z' ? static_cast<char>(word[0] - 32) : word[0];
        const PlainNumber number = read_plain_number(word.data() + 1, word.data() + word.size());
        allow_.emplace_back(letter, number.end ? number.value : kVacant);  // "E": any number.
    }
}

bool Resolver::is_allowed(char letter, double value) const {
    return std::ranges::any_of(allow_, [&](const auto& entry) {
        return entry.first == letter &&
               (std::isnan(entry.second) || std::abs(entry.second - value) < 1e-6);
    });
}

std::string Resolver::text_of(const Word& word, double value) const {
    std::string out(word.comma ? "," : "");
    out += word.letter;
    if (word.letter == 'G' || word.letter == 'M') {
        print_number(out, std::round(value * 1e4) / 1e4);
    }
    return out;
}

bool Resolver::tolerate(const MessageText& message, SourceSpan span,
                        std::initializer_list<std::string_view> arguments) {
    log_.add(rules_.strict ? Severity::Error : Severity::Warning, message, span, arguments);
    return !rules_.strict;
}

void Resolver::report_unknown(std::string_view name, SourceSpan span) {
    if (name.empty()) return;
    // Limit, because a program may read whole tables of variables.
    constexpr std::size_t kMostNames = 20;
    if (named_.size() >= kMostNames && !named_.contains(name))
        return log_.add(Message::VariablesUnknown, span);
    named_.emplace(name);
    log_.add(Message::VariableUnknown, span, {name, name});
}

std::optional<double> Resolver::value_to_keep(std::string_view text, SourceSpan span, bool open,
                                              std::string& unknown) {
    return evaluated(text, span, open, rules_.arithmetic, unknown);
}

std::optional<double> Resolver::evaluated(std::string_view text, SourceSpan span, bool open,
                                          const Arithmetic& arithmetic, std::string& unknown) {
    ExpressionFault fault;
    parameters_.take_unknown();
    const std::optional<double> value = evaluate(text, parameters_, arithmetic, fault, open);
    unknown = parameters_.take_unknown();
    if (!value) log_.add(Severity::Error, fault.message, span, {fault.argument});
    if (value && rules_.macro_b) report_power(text, span);
    return value;
}

/// Reports ** and ^ on Fanuc and Haas, whose macros have no operator for powers.
void Resolver::report_power(std::string_view text, SourceSpan span) {
    if (text.find('^') == std::string_view::npos && text.find("**") == std::string_view::npos)
        return;
    log_.add(Message::PowerOperator, span);
}

std::optional<double> Resolver::value_to_keep(const Word& word, std::string& unknown) {
    unknown.clear();
    if (word.literal) return word.number;
    return value_to_keep(word.text, word.span, !rules_.strict, unknown);
}

std::optional<double> Resolver::value_of(std::string_view text, SourceSpan span, bool open) {
    std::string unknown;
    const std::optional<double> value = value_to_keep(text, span, open, unknown);
    if (value) report_unknown(unknown, span);
    return value;
}

std::optional<double> Resolver::value_of(const Word& word) {
    if (word.literal) return word.number;
    Arithmetic arithmetic = rules_.arithmetic;
    arithmetic.round_scale = round_scale_of(word.letter);
    std::string unknown;
    const std::optional<double> value =
        evaluated(word.text, word.span, !rules_.strict, arithmetic, unknown);
    if (value) report_unknown(unknown, word.span);
    return value;
}

/// ROUND in a word of Fanuc and Haas rounds to the least increment of the address.
double Resolver::round_scale_of(char letter) const {
    constexpr double kMetric = 1e3;
    constexpr double kInch = 1e4;
    const std::string_view addresses = "XYZABCUVWIJKRQ";
    if (!rules_.macro_b || addresses.find(letter) == std::string_view::npos) return 1.0;
    const bool is_angle = letter >= 'A' && letter <= 'C';
    return parameters_.view.state->inches && !is_angle ? kInch : kMetric;
}

namespace {

/// True if G70, G71 or G72 of `block` has a radius, an angle or a number of holes, so the code is a
/// hole pattern.
bool is_hole_pattern(const Block& block) {
    return find_word(block, 'I') || find_word(block, 'J') || find_word(block, 'L');
}

/// True if `block` has all words of a hole pattern, so no other meaning is possible.
bool is_whole_hole_pattern(const Block& block, Code code) {
    return find_word(block, 'I') && find_word(block, 'J') && find_word(block, 'L') &&
           (code != Code::G71 || find_word(block, 'K'));
}

}  // namespace

bool Resolver::take_g(const Block& block, const Word& word, double value, Command& command) {
    const double tenths = std::round(value * 10.0);
    Code code = Code::None;
    if (std::abs(value * 10.0 - tenths) < 1e-3 && tenths >= 0.0 && tenths < 1e5) {
        code = find_g(static_cast<int>(tenths));
    }
    const auto put = [&](Group group) {
        command.g[static_cast<std::size_t>(group)] = code;
        return true;
    };
    const bool haas = rules_.dialect == Dialect::Haas;
    // G70 and G71 select units on some controls. On RS274/NGC the codes are lathe cycles; on Haas,
    // patterns of holes.
    if (code == Code::G70 || code == Code::G71 || code == Code::G72) {
        if (rules_.strict) return put(Group::Unsupported);
        if (rules_.hole_patterns &&
            (haas ? is_hole_pattern(block) : is_whole_hole_pattern(block, code))) {
            const Code other = command.group(Group::HolePattern);
            if (other == Code::None || other == code) return put(Group::HolePattern);
            log_.add(Severity::Error, Message::GroupTwice, word.span,
                     {name_of(other), text_of(word, value)});
            return false;
        }
        if (is_hole_pattern(block) || (code != Code::G72 && !rules_.g70_is_units)) {
            return put(Group::NotSimulated);
        }
    }
    const Availability availability =
        code == Code::None ? Availability::All : entry_of(code).availability;
    if ((rules_.strict && availability != Availability::All) ||
        (!haas && availability == Availability::Haas)) {
        code = Code::None;
    }
    if (code == Code::G12 || code == Code::G13) {
        const bool specified = haas || (find_word(block, 'I') && find_word(block, 'D'));
        if (!rules_.circular_pockets || !specified) return put(Group::NotSimulated);
    }
    // P is the number of the line or program with the outline of G150.
    if (code == Code::G150 && haas && find_word(block, 'P')) return put(Group::Pocket);
    if (code == Code::None) {
        command.has_others = true;
        if (is_allowed('G', value)) return true;
        const std::string text = text_of(word, value);
        log_.add(Message::UnknownG, word.span, {text, text});
        unknown_g_ = true;
        return true;  // The rest of the block may have further faults.
    }
    if (rules_.only_grbl && !is_of_grbl('G', 0.1 * tenths_of(code)) && !is_allowed('G', value)) {
        log_.add(Message::NotOfGrbl, word.span, {text_of(word, value)});
        return false;
    }
    Group group = entry_of(code).group;
    // G107 of Haas maps a linear axis onto a rotary axis.
    if (code == Code::G107 && haas) group = Group::Unsupported;
    if ((code == Code::G43_4 || code == Code::G43_5) && tip_control_.by_length_word)
        group = Group::ToolLength;
    if (code == Code::G234 && knows_joints_) group = Group::ToolLength;
    if (group == Group::Ignored) {
        command.has_others = true;  // The code may have words.
        command.from_one_side = command.from_one_side || code == Code::G60;
        return entry_of(code).takes_axes ? put(group) : true;  // X Y Z of G22 are limits.
    }
    const Code other = command.group(group);
    if (group == Group::Motion && other != Code::None &&
        (other == Code::G80 || code == Code::G80)) {
        return other == Code::G80 ? put(group) : true;  // "G0 G80": ends the cycle and moves.
    }
    if (other != Code::None && (other != code || rules_.strict)) {
        // G53 may be combined with G0 and G1 of the motion group, but not with a code of its own
        // group.
        if (!tolerate(Message::GroupTwice, word.span, {name_of(other), text_of(word, value)})) {
            return false;
        }
    }
    if (group == Group::Motion) command.span = word.span;
    return put(group);
}

bool Resolver::take_m(const Word& word, double value, Command& command) {
    const double whole = std::round(value);
    const bool is_whole = std::abs(value - whole) < 1e-4 && whole >= 0.0 && whole < 32000.0;
    const auto number = static_cast<std::int16_t>(is_whole ? whole : -1.0);
    const bool is_specified = tip_control_.m_codes.contains(number);
    const bool is_clamp = std::ranges::any_of(clamps_, [number](const RotaryClamp& clamp) {
        return clamp.clamp == number || clamp.release == number;
    });
    const MGroup group = is_specified ? MGroup::Kinematics
                         : is_clamp   ? MGroup::Clamp
                         : is_whole   ? m_group(number)
                                      : MGroup::Unknown;
    const bool foreign = rules_.strict && !is_specified && !is_clamp &&
                         (number == 13 || number == 14 || group == MGroup::Kinematics);
    if (group == MGroup::Unknown || foreign) {
        // M100 … M199 are defined by the user on LinuxCNC; without the scripts these codes are
        // unknown.
        constexpr int kRigidTapping = 29;
        const bool taps = number == kRigidTapping && rules_.dialect == Dialect::Fanuc;
        command.rigid_tapping = command.rigid_tapping || (taps && !rules_.strict);
        if (is_allowed('M', value)) return true;
        if (is_whole && !rules_.strict && is_harmless_m(number, rules_.dialect)) return true;
        return tolerate(Message::UnknownM, word.span, {text_of(word, value)});
    }
    if (rules_.only_grbl && !is_of_grbl('M', number) && !is_allowed('M', value)) {
        log_.add(Message::NotOfGrbl, word.span, {text_of(word, value)});
        return false;
    }
    std::int16_t& slot = command.m[static_cast<std::size_t>(group)];
    if (slot != kNone && slot != number) {
        if (group == MGroup::Coolant && slot != 9 && number != 9 && !rules_.strict) {
            command.mist_and_flood = true;
            return true;
        }
        if (group == MGroup::Clamp) {  // M codes of several axes.
            command.clamps.push_back(number);
            return true;
        }
        std::string other = "M";
        print_number(other, slot);
        if (!tolerate(Message::GroupTwice, word.span, {other, text_of(word, value)})) return false;
    }
    slot = number;
    if (group == MGroup::Clamp) command.clamps.push_back(number);
    return true;
}

bool Resolver::resolve(const Block& block, Command& command) {
    command.block = &block;
    command.span = block.words.empty() ? block.line_span() : block.words.front().span;
    command.present = 0;
    command.g.fill(Code::None);
    command.m.fill(kNone);
    command.next_tool = -1.0;
    command.corner = 0;
    command.has_angle = false;
    command.has_m = false;
    command.mist_and_flood = false;
    command.rigid_tapping = false;
    command.from_one_side = false;
    bool takes_e = false;  // E is a port of M66 to M68, or the tolerance of G187.
    command.clamps.clear();
    command.has_others = false;
    unknown_g_ = false;
    for (const Word& word : block.words) {
        double value = word.number;
        if (!word.literal) {
            const std::optional<double> computed = value_of(word);
            if (!computed) return false;
            if (std::isnan(*computed)) continue;  // A vacant value removes the word.
            value = *computed;
        }
        if (std::abs(value) > kLargest) {
            log_.add(Message::ValueTooLarge, word.span, {text_of(word, 0.0)});
            return false;
        }
        if (word.letter == 'G') {
            takes_e = takes_e || value == 187.0;  // Smoothness.
            if (!take_g(block, word, value, command)) return false;
            continue;
        }
        if (word.letter == 'M') {
            command.has_m = true;
            takes_e = takes_e || value == 66.0 || value == 67.0 || value == 68.0;
            if (!take_m(word, value, command)) return false;
            continue;
        }
        const bool is_corner = word.comma && (word.letter == 'R' || word.letter == 'C');
        if (is_corner && rules_.corner_words && command.corner == 0) {
            command.corner = word.letter;
            command.corner_size = value;
            command.corner_span = word.span;
            continue;
        }
        if (word.comma && word.letter == 'A' && rules_.corner_words && !command.has_angle) {
            command.has_angle = true;
            command.angle = value;
            command.angle_span = word.span;
            continue;
        }
        if (word.comma) {
            log_.add(Message::CornerWord, word.span, {text_of(word, value)});
            return false;
        }
        if (word.letter == 'O' || word.letter == 'N') {
            if (is_allowed(word.letter, value)) continue;
            if (!tolerate(Message::UnknownWord, word.span, {text_of(word, value)})) return false;
            continue;
        }
        const std::size_t i = letter_index(word.letter);
        if ((command.present >> i & 1U) != 0) {
            if (word.letter == 'T' && !rules_.strict && value >= 0.0) {
                log_.add(Message::NextTool, word.span, {"T"});
                command.next_tool = value;
                continue;
            }
            if (!tolerate(Message::WordTwice, word.span, {text_of(word, value)})) return false;
        }
        command.present |= 1U << i;
        command.value[i] = value;
    }
    command.axis_words = command.has_any(kAxisLetters) || command.has_angle;
    if (command.has('E') && !takes_e && !rules_.strict && !is_allowed('E', command['E'])) {
        const Word* word = find_word(block, 'E');
        log_.add(Message::UnknownWord, word ? word->span : command.span, {"E"});
    }
    return !unknown_g_;
}

}  // namespace ncsim::gcode
