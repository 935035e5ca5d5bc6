// SPDX-License-Identifier: GPL-3.0-or-later
//
// M70 to M73 of LinuxCNC: saves the modes of a call level, and restores the modes by a block of the
// differing words, as LinuxCNC does.
#include "control/machine.h"

#include <cmath>

namespace ncsim::gcode {

/// Modes saved by M70. Lengths and feeds are in the units that were active at M70.
struct Machine::SavedModes {
    MachineState state;
    double feed_word;
};

std::shared_ptr<const Machine::SavedModes> Machine::save_modes() const {
    return std::make_shared<const SavedModes>(SavedModes{state_, control_.feed_word});
}

namespace {

constexpr std::array kSystemCodes{Code::G54, Code::G55,   Code::G56,   Code::G57,  Code::G58,
                                  Code::G59, Code::G59_1, Code::G59_2, Code::G59_3};

void put(Command& command, Group group, Code code) {
    command.g[static_cast<std::size_t>(group)] = code;
}

void put(Command& command, char letter, double value) {
    command.present |= 1U << letter_index(letter);
    command.value[letter_index(letter)] = value;
}

Code code_of(Plane plane) {
    constexpr std::array kPlanes{Code::G17,   Code::G18,   Code::G19,
                                 Code::G17_1, Code::G18_1, Code::G19_1};
    return kPlanes[static_cast<std::size_t>(plane)];
}

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

bool Machine::restore_modes(const SavedModes& saved, SourceSpan span) {
    const MachineState& before = saved.state;
    const Block block;
    const auto empty = [&] {
        Command command{};
        command.block = &block;
        command.span = span;
        command.g.fill(Code::None);
        command.m.fill(kNone);
        return command;
    };
    if (before.inches != state_.inches) {
        Command units = empty();
        put(units, Group::Units, before.inches ? Code::G20 : Code::G21);
        if (!execute(units)) return false;
    }
    Command words = empty();
    const MachineState now = state_;
    // LinuxCNC writes F with one decimal and S without decimals: F12.34 becomes F12.3. The number
    // is that of the last F, even if the units have changed since.
    if (saved.feed_word != control_.feed_word)
        put(words, 'F', std::round(saved.feed_word * 10.0) / 10.0);
    if (before.spindle_rpm != now.spindle_rpm) put(words, 'S', std::round(before.spindle_rpm));
    const auto put_if = [&words](bool differs, Group group, Code code) {
        if (differs) put(words, group, code);
    };
    put_if(before.plane != now.plane, Group::Plane, code_of(before.plane));
    put_if(before.cutter_side != now.cutter_side, Group::CutterSide,
           before.cutter_side == CutterSide::Off    ? Code::G40
           : before.cutter_side == CutterSide::Left ? Code::G41
                                                    : Code::G42);
    put_if(before.incremental != now.incremental, Group::Distance,
           before.incremental ? Code::G91 : Code::G90);
    put_if(before.feed_mode != now.feed_mode, Group::Feed, code_of(before.feed_mode));
    const auto system = static_cast<std::size_t>(before.system - 1);
    put_if(before.system != now.system && system < kSystemCodes.size(), Group::WorkOffset,
           system < kSystemCodes.size() ? kSystemCodes[system] : Code::G54);
    const bool had_length = before.frames.tool_offset != Axes{};
    put_if(had_length != (now.frames.tool_offset != Axes{}), Group::ToolLength,
           had_length ? Code::G43 : Code::G49);
    put_if(before.retract_to_r != now.retract_to_r, Group::Retract,
           before.retract_to_r ? Code::G99 : Code::G98);
    put_if(before.absolute_centres != now.absolute_centres, Group::Centre,
           before.absolute_centres ? Code::G90_1 : Code::G91_1);
    put_if(before.lathe_diameter != now.lathe_diameter, Group::Diameter,
           before.lathe_diameter ? Code::G7 : Code::G8);
    put_if(before.offset_92_active != now.offset_92_active, Group::OneShot,
           before.offset_92_active ? Code::G92_3 : Code::G92_2);
    if (!execute(words)) return false;
    const auto coolant = [&](int code) {
        Command m = empty();
        m.m[static_cast<std::size_t>(MGroup::Coolant)] = static_cast<std::int16_t>(code);
        return execute(m);
    };
    if (before.spindle != state_.spindle) {
        Command m = empty();
        m.m[static_cast<std::size_t>(MGroup::Spindle)] =
            static_cast<std::int16_t>(code_of(before.spindle));
        if (!execute(m)) return false;
    }
    if (before.coolant != state_.coolant) {
        if (!coolant(9)) return false;
        if (before.coolant.mist && !coolant(7)) return false;
        if (before.coolant.flood && !coolant(8)) return false;
    }
    return true;
}

}  // namespace ncsim::gcode
