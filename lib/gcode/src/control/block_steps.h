// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps of the execution of a block that belong to no room: checks, modes, cutter compensation, and
// the choice of the move. Functions that return bool return false after reporting an error.
#pragma once

#include "control/command.h"
#include "control/context.h"
#include "control/control_state.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace ncsim::gcode {

// --- block_checks.cpp ---

/// Checks that RS274/NGC makes before executing the block.
bool check_block(const ControlState& control, const Command& command, Context& context);

// --- strict_words.cpp ---

/// Returns the letters that the M codes of `command` use on LinuxCNC.
std::uint32_t letters_of_m(const Command& command);
/// Checks the words of the block as LinuxCNC does.
bool check_strict(const ControlState& control, const Command& command, Context& context);

// --- compensation_checks.cpp ---

/// True if the words of `command` that select a plane, a system or a length change none of the
/// three. Cutter compensation continues across such words.
bool keeps_frame(const ControlState& control, const Command& command, const Setup& setup);
/// Returns the word of `command` that LinuxCNC refuses while G41 or G42 is on, even if the word
/// changes nothing; empty: none. M codes and planes act before G40 in a block, other words after
/// G40.
std::string_view forbidden_with_compensation(const ControlState& control, const Command& command);
/// True if G10 of `command` sets the active coordinate system or tool length.
bool sets_active_data(const MachineState& state, const Command& command, const Setup& setup);
/// Reports an interruption of cutter compensation: LinuxCNC refuses every interruption, Fanuc and
/// Haas a new plane. For other controls and codes the report is a warning.
bool check_compensation(const ControlState& control, const Command& command, Context& context);

// --- modes.cpp ---

/// Returns the plane that `command` selects.
std::optional<Plane> plane_of(const Command& command);
bool set_feed(ControlState& control, const Command& command, Context& context);
void set_speeds_and_tools(ControlState& control, const Command& command, Context& context);
/// True if the position of the tip depends on an M428 or similar code whose kinematics are
/// unspecified. If no rotary axis has turned, the kinematics do not matter.
bool needs_kinematics(const MachineState& state, const Command& command);
void set_units(ControlState& control, bool inches);
void set_modes(MachineState& state, const Command& command, Context& context);
/// Returns the letter of the dwell time of G4; ' ': none. A word has a single meaning in a block,
/// so the word sets neither feed nor spindle speed.
char letter_of_dwell(const Command& command, const Setup& setup);
bool make_dwell(ControlState& control, const Command& command, Context& context);
void execute_stop(ControlState& control, const Command& command, Context& context);
/// Acts as M0, M1 or M60 does.
void stop_at(MachineState& state, int code, const Setup& setup);
/// Ends the program and resets the modes to the start values of the control.
void finish_program(ControlState& control, Context& context);

// --- cutter_side.cpp ---

/// Makes a move held back by cutter compensation before a command that interrupts compensation.
void flush_held(ControlState& control, const Command& command, Context& context);
bool set_cutter_side(ControlState& control, const Command& command, Context& context);
/// See Controller.
void begin_compensation_at(ControlState& control, CutterSide side, double radius,
                           const Axes& contour, Context& context);

// --- moves.cpp ---

/// Makes the move of `command`; `motion`: the motion code of the block, or None.
bool make_move(ControlState& control, const Command& command, Code motion, Context& context);

// --- controller.cpp ---

/// Restores the control to `before`.
/// Requires: the path has made no motion since `before`.
void restore(ControlState& control, const ControlState& before, Context& context);

}  // namespace ncsim::gcode
