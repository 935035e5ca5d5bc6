// SPDX-License-Identifier: GPL-3.0-or-later
//
// G28 and G30: via the intermediate point to a position of the machine. G29: back via the
// intermediate point. G28.2: to the home switches.
#include "control/machine.h"

namespace ncsim::gcode {

bool Machine::home(const Command& command, bool second) {
    const Code code = second ? Code::G30 : Code::G28;
    if (state_.cutter_side != CutterSide::Off && rules_.strict) {
        return fail(Message::ForbiddenWithCompensation, span_of_g(command, code), {"G28"});
    }
    Axes via = state_.position;
    AxisMask mask = 0;
    if (command.axis_words && !find_ends(command, via, mask)) return false;
    if (mask == 0) mask = kAllAxes;
    // G91 G28 Z0, the usual homing block, has no intermediate point, so no position becomes known
    // there.
    AxisMask moved = command.axis_words ? mask : 0;
    for (std::size_t i = 0; i < via.size(); ++i) {
        if (state_.incremental && via[i] == state_.position[i]) moved &= ~(1U << i);
    }
    path_.linear_move(state_, via, MoveKind::Rapid, moved);
    Store& store = control_.store.change();
    store.via = via;
    store.has_via = command.axis_words;

    std::optional<SavedCoordinates> before;
    if (hides_joints()) before = as_joints();
    Axes target = machine_position();
    const Axes& home = store.homes[second ? 1 : 0];
    for (std::size_t i = 0; i < target.size(); ++i) {
        if ((mask & 1U << i) != 0) target[i] = is_rotary(i) ? home[i] : home[i] / state_.unit_mm();
    }
    path_.set_machine_coordinates(true);
    path_.linear_move(state_, from_machine(target), MoveKind::Rapid, mask);
    path_.set_machine_coordinates(false);
    if (before) resume(*before);
    if (rules_.home_cancels_length) state_.length_register = kNoLength;
    if (rules_.home_cancels_length && state_.frames.tool_offset != Axes{}) {
        const Axes machine = machine_position();
        state_.frames.tool_offset = {};
        recompute_position(machine);
        ++state_.length_changes;
    }
    return true;
}

/// G28.2 of TinyG, g2core, Smoothieware: moves to the switches of the named axes (or of X, Y and
/// Z), Z first. The values of the words have no meaning.
bool Machine::seek_home(const Command& command) {
    constexpr std::string_view kLetters = "XYZABCUVW";
    AxisMask named = 0;
    for (std::size_t i = 0; i < kLetters.size(); ++i) {
        if (command.has(kLetters[i])) named |= 1U << i;
    }
    if (named == 0) named = 1U << kX | 1U << kY | 1U << kZ;
    std::optional<SavedCoordinates> before;
    if (hides_joints()) before = as_joints();
    constexpr AxisMask kUp = 1U << kZ;
    for (const AxisMask mask : {named & kUp, named & ~kUp}) {
        if (mask == 0) continue;
        Axes target = machine_position();
        const Axes& home = control_.store->homes[0];
        for (std::size_t i = 0; i < target.size(); ++i) {
            if ((mask & 1U << i) != 0)
                target[i] = is_rotary(i) ? home[i] : home[i] / state_.unit_mm();
        }
        path_.set_machine_coordinates(true);
        path_.linear_move(state_, from_machine(target), MoveKind::Rapid, mask);
        path_.set_machine_coordinates(false);
    }
    if (before) resume(*before);
    return true;
}

bool Machine::return_from_home(const Command& command) {
    if (!command.axis_words) return fail(Message::AxesMissing, command.span, {"G29"});
    Axes end{};
    AxisMask mask = 0;
    if (!find_ends(command, end, mask)) return false;
    if (control_.store->has_via)
        path_.linear_move(state_, control_.store->via, MoveKind::Rapid, mask);
    path_.linear_move(state_, end, MoveKind::Rapid, mask);
    return true;
}

void Machine::store_home(bool second) {
    Axes& home = control_.store.change().homes[second ? 1 : 0];
    home = machine_position();
    for (std::size_t i = 0; i < home.size(); ++i) {
        if (!is_rotary(i)) home[i] *= state_.unit_mm();
    }
}

}  // namespace ncsim::gcode
