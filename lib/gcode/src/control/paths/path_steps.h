// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps of a block that read end positions and make lines, arcs and curves. Functions that return
// bool return false after reporting an error.
#pragma once

#include "control/command.h"
#include "control/context.h"
#include "control/control_state.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Smallest radius of a circle, and largest excess of half the chord over R: 0.00127 mm = 0.00005
/// inch.
constexpr double kMinArcRadius = 0.00127;

// --- ends.cpp ---

/// Marks the position of `axis` as known in the active system.
void mark_known(MachineState& state, std::size_t axis);
/// Records the unit of the first length.
void note_length(MachineState& state);
/// True for "I-7.5 J0" alone: a full circle while G2 or G3 is active.
bool is_modal_arc(const MachineState& state, const Command& command);
/// Checks that the feed of a move by `what` is specified.
bool needs_feed(const MachineState& state, const Command& command, std::string_view what,
                Context& context);
/// Computes the end position `end` of the axis words, in program coordinates, and the named axes
/// `mask`.
bool find_ends(MachineState& state, const Command& command, Axes& end, AxisMask& mask,
               Context& context);
/// G33 is synchronised with the spindle; G33.1 taps and returns.
bool cut_thread(MachineState& state, const Command& command, Code motion, Context& context);
/// G31 and G38: moves to the end at probing feed; the contact is assumed at the end.
bool probe_move(ControlState& control, const Command& command, Code motion, Context& context);

// --- programmed_path.cpp ---

/// Makes a move of the programmed path, with or without cutter compensation.
bool feed_straight(ControlState& control, const Axes& end, MoveKind kind, AxisMask mask,
                   Context& context);
/// Makes an arc with the present state: of an outline, under cutter compensation, or plain.
bool make_arc(ControlState& control, const ProgramArc& arc, AxisMask mask, Context& context);
/// Records a move of the outline: a line to `end`, or the arc `arc`.
bool record_outline_move(MachineState& state, const Axes& end, const ProgramArc* arc,
                         Context& context);

// --- arc.cpp ---

/// True if `arc` is not a full circle and the radius exceeds the travel of any machine.
bool is_huge(const MachineState& state, const ProgramArc& arc, double radius);
/// True if the angle of the short way is within the rounding of angles.
bool is_straight(const MachineState& state, const ProgramArc& arc, double radius);
/// Makes `arc` take the short way. Rounding in a CAM system can put the centre on the wrong side of
/// a chord, and controls execute such arcs differently.
void shorten(const MachineState& state, ProgramArc& arc, double radius, std::string_view name,
             SourceSpan span, Context& context);
/// True if `command` has a word for the centre in the plane.
bool has_centre_words(const MachineState& state, const Command& command);
/// Reads the arc `out` and the named axes `mask`. `out.is_open`: the arc is given by its radius.
bool read_arc(MachineState& state, const Command& command, bool clockwise, ProgramArc& out,
              AxisMask& mask, Context& context);

// --- spline.cpp ---

/// G5 and G5.1: a Bézier curve.
bool spline_move(MachineState& state, const Command& command, Code motion, Context& context);
/// G5.2 opens a curve and gives the first points, further blocks give points, G5.3 closes the
/// curve.
bool nurbs_move(ControlState& control, const Command& command, Code motion, Context& context);
/// G6.2 X Y R K P: control points with weight and knot, the order in the first block. Blocks with
/// only a knot end the curve. The curve begins at the first control point.
bool nurbs_move_with_knots(ControlState& control, const Command& command, Context& context);

}  // namespace ncsim::gcode
