// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps of a block that expand cycles, patterns, pockets and corners into moves. Functions that
// return bool return false after reporting an error.
#pragma once

#include "control/command.h"
#include "control/context.h"
#include "control/control_state.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Data that are the same for all holes of a block.
struct Drilling {
    Code motion = Code::None;
    std::size_t depth_axis = kZ;
    double r = 0.0, bottom = 0.0, clear = 0.0;
    double height = 0.0;  ///< Height of the drilling axis on the way to the next hole.
};

// --- cycle.cpp ---

/// Returns seconds. On Fanuc and similar controls P without a decimal point is in milliseconds.
double seconds_of(const Command& command, char letter, const Setup& setup);
/// Updates the modal words of the cycle. Reports words that the cycle cannot use.
bool cycle_words(MachineState& state, const Command& command, Code motion, Context& context);
/// Ends the cycle. LinuxCNC keeps the dwell.
void end_cycle(MachineState& state, const Setup& setup);
/// True for R alone under a modal cycle of Fanuc, which drills again.
bool drills_again(const MachineState& state, const Command& command, const Setup& setup);
bool drill_cycle(MachineState& state, const Command& command, Code motion, Context& context);
/// Computes the position of the first hole, excluding the depth word.
bool hole_place(MachineState& state, const Command& command, Axes& hole, AxisMask& mask,
                Context& context);
/// Computes the heights, and moves up to R if the tool is below R.
std::optional<Drilling> begin_drilling(MachineState& state, const Command& command, Code motion,
                                       Context& context);
/// Moves over the hole at the height of `drilling`, down to R, and drills the hole.
bool hole_at(MachineState& state, Drilling& drilling, const Axes& hole, AxisMask mask,
             Context& context);

// --- corner.cpp ---

/// Returns the word of the program for a corner.
std::string_view corner_name(char letter, const Setup& setup);
/// True for G1 with axis words that no other code of the block uses.
bool is_line(const MachineState& state, const Command& command);
bool ends_in_corner(const MachineState& state, const Command& command, const Setup& setup);
/// True for a line in the coordinate frame of the line before.
bool continues_from_corner(const ControlState& control, const Command& command, const Setup& setup);
/// Holds back the line to `end`, or the arc `arc`.
bool hold_corner(ControlState& control, const Command& command, const Axes& end, AxisMask mask,
                 const ProgramArc* arc, Context& context);
/// Makes the held line up to the corner, and the corner itself. `next`: end of the next element,
/// which is a line or the arc `arc`.
bool cut_corner(ControlState& control, const Axes& next, const ProgramArc* arc, Context& context);
/// Completes the end of a line with a direction: "X50. ,A30.". If both coordinates are given, both
/// must agree with the direction within the rounding of three decimals.
bool end_by_angle(const MachineState& state, const Command& command, Axes& end, AxisMask& mask,
                  Context& context);
/// Holds back a line without coordinates, "G1 ,A30.", which ends at the next line.
bool hold_angle(ControlState& control, const Command& command, const Axes& end, AxisMask mask,
                Context& context);
/// Computes where the held line meets the next line, whose end `next` and direction are given.
bool find_corner(ControlState& control, const Command& command, const Axes& next, Context& context);
/// Reports that the next block is no line. Makes the held line to the programmed corner; a line
/// with unknown end is discarded.
void settle_corner(ControlState& control, Context& context);

// --- hole_pattern.cpp ---

/// Drills the holes of a pattern about the position of X and Y in the block, or about the position
/// of the tool: the centre of G70 and G71, the first hole of G72. Angles count from the first axis
/// of the plane to the second. A negative radius or distance reverses the direction.
bool drill_pattern(ControlState& control, const Command& command, Code code, bool words_taken,
                   Context& context);

// --- pocket.cpp ---

/// Mills a circular pocket about X Y of the block, or about the position of the tool. Each of the L
/// passes: down to the depth; a half circle to the first circle; around the circle; half circles to
/// the next circles, around each; a half circle back to the centre. The manual gives the circles
/// and only draws the connections; every connection is inside the next circle.
bool mill_pocket(ControlState& control, const Command& command, Code code, bool words_taken,
                 Context& context);

// --- area_pocket.cpp ---

/// Starts recording moves instead of making moves, at X and Y of the G150 block.
bool begin_contour(ControlState& control, const Command& command, Context& context);
/// Keeps the recorded moves for the G150 block and restores the control.
void end_outline(ControlState& control, Context& context);
/// True if `command` may be part of an outline: lines and arcs.
bool belongs_to_outline(const Command& command);
/// Mills the pocket. At each level: down at the starting hole; strokes along Y (I) or X (J) over
/// the area whose distance from the outline is at least the cutter radius plus the finishing
/// allowance; once around this area. At the last level, once more around the outline on size.
/// Between strokes without a straight connection inside the area the tool retracts to R. The Haas
/// manual gives the order and the words but not the strokes; the choice of strokes does not change
/// the material left.
bool mill_area_pocket(ControlState& control, const Command& command, Code side, bool words_taken,
                      Context& context);

}  // namespace ncsim::gcode
