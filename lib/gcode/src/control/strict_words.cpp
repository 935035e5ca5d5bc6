// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words that LinuxCNC refuses before the block acts: numbers that are not whole, tools missing in
// the table, words of M codes.
// Source: refusals of rs274 of linuxcnc-uspace 2.9, recorded in tests/gcode/rs274_refusals.txt.
#include "control/block_steps.h"
#include "control/frames/frame_steps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace ncsim::gcode {
namespace {

constexpr double kWholeTolerance = 1e-4;  // Tolerance of LinuxCNC for whole numbers.

bool is_whole(double value) {
    return std::abs(value - std::round(value)) < kWholeTolerance;
}

/// Checks the words of M19, M61 and M62 … M68.
bool check_words_of_m(const ControlState& control, const Command& command, Context& context) {
    const auto is_index = [&](char letter) {
        return command.has(letter) && command[letter] >= 0.0;
    };
    if (command.group(MGroup::ToolChange) == 61) {
        if (!is_index('Q'))
            return lacks(context, command, "M61", "the number of a tool, 0 or more (Q)");
        if (!check_tool(control, command, 'Q', context)) return false;
    }
    if (command.group(MGroup::Spindle) == 19) {
        const double p = command.get('P', 0.0);
        const double r = command.get('R', 0.0);
        if (r < 0.0 || r > 360.0) return lacks(context, command, "M19", "R from 0 to 360");
        if (p != 0.0 && p != 1.0 && p != 2.0) return lacks(context, command, "M19", "P 0, 1 or 2");
        if (command.has('Q') && command['Q'] <= 0.0)
            return lacks(context, command, "M19", "Q above 0");
    }
    const int io = command.group(MGroup::Io);
    if (io >= 62 && io <= 65 && !command.has('P'))
        return lacks(context, command, "M62 to M65", "an output (P)");
    if ((io == 67 || io == 68) && !is_index('E'))
        return lacks(context, command, "M67 and M68", "an output (E)");
    if (io != 66) return true;
    if (is_index('P') == is_index('E'))
        return lacks(context, command, "M66", "an input, either P or E");
    const double l = command.get('L', 0.0);
    if (l < 0.0) return fail(context, Message::NegativeValue, span_of(command, 'L'), {"L"});
    if (l == 0.0) return true;
    if (is_index('E')) return lacks(context, command, "M66", "L0 with an analog input (E)");
    return command.get('Q', 0.0) > 0.0 ||
           lacks(context, command, "M66", "a time above 0 (Q) with L above 0");
}

bool check_words_of_g(const ControlState& control, const Command& command, Context& context) {
    const MachineState& state = control.machine;
    Code motion = command.group(Group::Motion);
    if (motion == Code::None && command.axis_words && !command.axes_are_taken())
        motion = state.motion;
    const bool dwells =
        motion == Code::G82 || motion == Code::G86 || motion == Code::G88 || motion == Code::G89;
    if (dwells && command.has('P') && command['P'] < 0.0)
        return fail(context, Message::NegativeValue, span_of(command, 'P'), {"P"});
    if (command.group(Group::SpindleSpeed) == Code::G96 && !command.has('S'))
        return lacks(context, command, "G96", "a speed (S) in its block");
    if (command.group(Group::OneShot) == Code::G10) {
        const double l = command.get('L', 0.0);
        const bool of_tool = l == 1.0 || l == 10.0 || l == 11.0;
        const double p = command.get('P', 0.0);
        if (of_tool && p < 1.0) return lacks(context, command, "G10 of a tool", "its number (P)");
        if (of_tool && !check_tool(control, command, 'P', context)) return false;
        const double q = command.get('Q', 0.0);
        if (of_tool && (q < 0.0 || q > 9.0))
            return lacks(context, command, "G10 of a tool", "Q from 0 to 9");
    }
    if (command.group(Group::ToolLength) == Code::G43_2 && command.has('H') == command.axis_words)
        return lacks(context, command, "G43.2", "either H or axis words");
    const bool by_polar = command.has('@') || command.has('^');
    if (by_polar && (command.has('X') || command.has('Y')))
        return fail(context, Message::PolarWithAxes,
                    span_of(command, command.has('X') ? 'X' : 'Y'));
    const bool is_at_origin = state.position[kX] == 0.0 && state.position[kY] == 0.0;
    const Code distance = command.group(Group::Distance);
    const bool is_incremental = distance == Code::None ? state.incremental : distance == Code::G91;
    if (by_polar && is_incremental && is_at_origin)
        return lacks(context, command, "@ and ^ under G91", "a place other than the origin");
    const bool threads = motion == Code::G33 || motion == Code::G33_1;
    const int spindle = command.group(MGroup::Spindle);
    const bool starts = spindle == 3 || spindle == 4;
    if (threads && !starts && state.spindle == SpindleTurning::Stopped)
        return lacks(context, command, name_of(motion), "the spindle on");
    return true;
}

}  // namespace

std::uint32_t letters_of_m(const Command& command) {
    std::uint32_t used = 0;
    for (const Word& word : command.block->words) {
        if (word.letter != 'M' || !word.literal) continue;
        const double number = std::round(word.number);
        if (number == 19) used |= letters('P', 'Q', 'R');
        if (number >= 50 && number <= 53) used |= letters('P');
        if (number == 61) used |= letters('Q');
        if (number >= 62 && number <= 65) used |= letters('P');
        if (number == 66) used |= letters('E', 'L', 'P', 'Q');
        if (number == 67 || number == 68) used |= letters('E', 'Q');
        if (number == 98) used |= letters('L', 'P');
        if (number >= 100 && number <= 199) used |= letters('P', 'Q');
    }
    return used;
}

bool check_strict(const ControlState& control, const Command& command, Context& context) {
    const auto refuse = [&](char letter, const MessageText& message) {
        return fail(context, message, span_of(command, letter), {{&letter, 1}});
    };
    for (const char letter : {'S', 'T'}) {
        if (command.has(letter) && command[letter] < 0.0)
            return refuse(letter, Message::NegativeValue);
    }
    const bool by_register = command.group(Group::CutterSide) == Code::G41 ||
                             command.group(Group::CutterSide) == Code::G42;
    for (const char letter : {'D', 'H', 'L', 'T'}) {
        const bool counts = letter != 'D' || by_register;
        if (counts && command.has(letter) && !is_whole(command[letter]))
            return refuse(letter, Message::NotWhole);
    }
    if (command.has('T') && !check_tool(control, command, 'T', context)) return false;
    constexpr std::ptrdiff_t kMostM = 4;
    if (std::ranges::count(command.block->words, 'M', &Word::letter) > kMostM)
        return fail(context, Message::TooManyM, command.span);
    return check_words_of_m(control, command, context) &&
           check_words_of_g(control, command, context);
}

}  // namespace ncsim::gcode
