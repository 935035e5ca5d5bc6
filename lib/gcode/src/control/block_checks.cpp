// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of a block before the block acts: two uses of the axis words, corner words, unused words.
#include "control/block_steps.h"
#include "control/cycles/cycle_steps.h"
#include "control/paths/path_steps.h"

#include <algorithm>
#include <string_view>

namespace ncsim::gcode {
namespace {

/// Reports "G1 X50. R2." and "X50. C4.": corners in the form of lathe controls; mill controls of
/// the same makers require a comma.
bool check_corner_words(const MachineState& state, const Command& command, Context& context) {
    if (!context.rules.corner_words || !is_line(state, command) || state.polar_interpolation)
        return true;
    if (command.has('R') && command['R'] != 0.0)
        return fail(context, Message::CornerWithoutComma, span_of(command, 'R'), {"R", "R", ""});
    if (!command.has('C') || !context.rules.c_may_be_corner) return true;
    return fail(context, Message::CornerWithoutComma, span_of(command, 'C'),
                {"C", "C", ", or begin with C0. if it is an axis"});
}

/// Reports words that no code of the block uses. RS274/NGC refuses such words. Other controls
/// ignore the words, which may then hide a missing code.
bool check_unused_words(const ControlState& control, const Command& command, Context& context) {
    const MachineState& state = control.machine;
    constexpr std::string_view kParameters = "DEHIJKLPQR";
    if (!command.has_any(letters('D', 'E', 'H', 'I', 'J', 'K', 'L', 'P', 'Q', 'R'))) return true;
    Code motion = command.group(Group::Motion);
    if (motion == Code::None && (command.axis_words || is_modal_arc(state, command) ||
                                 drills_again(state, command, context)))
        motion = state.motion;
    // On other controls, register words are allowed anywhere, ignored codes may have words, and
    // cycles have further words.
    const bool lax = !context.rules.strict;
    const bool user_m = command.has_m;  // M66 P, M61 Q, M68 E, and M codes of the user.
    std::uint32_t used = !user_m ? 0U
                         : lax   ? letters('E', 'L', 'P', 'Q', 'R')
                                 : letters_of_m(command);
    bool others = user_m || command.has_others || control.curve.by_knots ||
                  command.group(MGroup::ToolChange) != kNone ||
                  command.group(Group::HolePattern) != Code::None;
    const auto use = [&](Code code) {
        if (code == Code::None) return;
        used |= entry_of(code).letters;
        others |= entry_of(code).has_other_letters;
    };
    use(motion);
    std::ranges::for_each(command.g, use);
    if (state.by_vector) used |= letters('I', 'J', 'K');
    if (lax) used |= letters('D', 'E', 'H');
    if (lax && others) return true;
    for (const char& letter : kParameters) {
        if (!command.has(letter) || (used >> letter_index(letter) & 1U) != 0) continue;
        if (!tolerate(context, Message::WordUnused, span_of(command, letter), {{&letter, 1}}))
            return false;
    }
    return true;
}

}  // namespace

bool check_block(const ControlState& control, const Command& command, Context& context) {
    const Code motion = command.group(Group::Motion);
    const Code one_shot = command.group(Group::OneShot);
    const bool takes_axes = one_shot != Code::None && entry_of(one_shot).takes_axes;
    if (takes_axes && motion != Code::None && motion != Code::G80 && context.rules.strict) {
        return fail(context, Message::TwoCodesUseAxes, span_of_g(command, one_shot),
                    {name_of(one_shot)});
    }
    if (context.rules.strict) {
        const std::string_view forbidden = forbidden_with_compensation(control, command);
        if (!forbidden.empty())
            return fail(context, Message::ForbiddenWithCompensation, command.span, {forbidden});
        if (!check_strict(control, command, context)) return false;
    } else if (!check_compensation(control, command, context)) {
        return false;
    }
    return check_corner_words(control.machine, command, context) &&
           check_unused_words(control, command, context);
}

}  // namespace ncsim::gcode
