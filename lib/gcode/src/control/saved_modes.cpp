// SPDX-License-Identifier: GPL-3.0-or-later
//
// M70 to M73 of LinuxCNC: saves the modes of a call level, and restores the modes by a block of the
// differing words, as LinuxCNC does.
#include "control/controller.h"

#include <cmath>

namespace ncsim::gcode {

/// Modes saved by M70. Lengths and feeds are in the units that were active at M70.
struct Controller::SavedModes {
    MachineState state;
    double feed_word;
};

std::shared_ptr<const Controller::SavedModes> Controller::save_modes() const {
    return std::make_shared<const SavedModes>(SavedModes{state(), control_.feed_word});
}

namespace {

Code code_of(FeedMode mode) {
    return mode == FeedMode::InverseTime ? Code::G93
           : mode == FeedMode::PerMinute ? Code::G94
                                         : Code::G95;
}

int code_of(SpindleTurning turning) {
    return turning == SpindleTurning::Clockwise          ? 3
           : turning == SpindleTurning::Counterclockwise ? 4
                                                         : 5;
}

}  // namespace

bool Controller::restore_modes(const SavedModes& saved, SourceSpan span) {
    const MachineState& before = saved.state;
    const Block block;
    if (before.inches != state().inches) {
        Command units = empty_command(block, span);
        put(units, before.inches ? Code::G20 : Code::G21);
        if (!execute(units)) return false;
    }
    Command words = empty_command(block, span);
    const MachineState now = state();
    // LinuxCNC writes F with one decimal and S without decimals: F12.34 becomes F12.3. The number
    // is that of the last F, even if the units have changed since.
    if (saved.feed_word != control_.feed_word)
        put(words, 'F', std::round(saved.feed_word * 10.0) / 10.0);
    if (before.spindle_rpm != now.spindle_rpm) put(words, 'S', std::round(before.spindle_rpm));
    const auto put_if = [&words](bool differs, Code code) {
        if (differs) put(words, code);
    };
    put_if(before.plane != now.plane, code_of(before.plane));
    put_if(before.cutter_side != now.cutter_side, before.cutter_side == CutterSide::Off ? Code::G40
                                                  : before.cutter_side == CutterSide::Left
                                                      ? Code::G41
                                                      : Code::G42);
    put_if(before.incremental != now.incremental, before.incremental ? Code::G91 : Code::G90);
    put_if(before.feed_mode != now.feed_mode, code_of(before.feed_mode));
    const auto system = static_cast<std::size_t>(before.system - 1);
    put_if(before.system != now.system && system < kSystemCodes.size(),
           system < kSystemCodes.size() ? kSystemCodes[system] : Code::G54);
    const bool had_length = before.frames.tool_offset != Axes{};
    put_if(had_length != (now.frames.tool_offset != Axes{}), had_length ? Code::G43 : Code::G49);
    put_if(before.retract_to_r != now.retract_to_r, before.retract_to_r ? Code::G99 : Code::G98);
    put_if(before.absolute_centres != now.absolute_centres,
           before.absolute_centres ? Code::G90_1 : Code::G91_1);
    put_if(before.lathe_diameter != now.lathe_diameter,
           before.lathe_diameter ? Code::G7 : Code::G8);
    put_if(before.offset_92_active != now.offset_92_active,
           before.offset_92_active ? Code::G92_3 : Code::G92_2);
    if (!execute(words)) return false;
    const auto coolant = [&](int code) {
        Command m = empty_command(block, span);
        put(m, MGroup::Coolant, code);
        return execute(m);
    };
    if (before.spindle != state().spindle) {
        Command m = empty_command(block, span);
        put(m, MGroup::Spindle, code_of(before.spindle));
        if (!execute(m)) return false;
    }
    if (before.coolant != state().coolant) {
        if (!coolant(9)) return false;
        if (before.coolant.mist && !coolant(7)) return false;
        if (before.coolant.flood && !coolant(8)) return false;
    }
    return true;
}

}  // namespace ncsim::gcode
