// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps of a block that change the frame stack: origins, tool lengths, tilted planes, the meaning
// of X, Y and Z. Functions that return bool return false after reporting an error.
#pragma once

#include "ncsim/gcode/feature_frame.h"
#include "ncsim/gcode/interpretation.h"

#include "control/command.h"
#include "control/context.h"
#include "control/control_state.h"
#include "control/frames/plane_words.h"
#include "control/system_variable.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace ncsim::gcode {

/// Meaning of X, Y and Z to restore after a move in joint coordinates.
struct SavedCoordinates {
    std::optional<FeatureFrame> frame;
    Coordinates coordinates = Coordinates::Axes;
    Axes offset_92{};
};

/// Solution of the rotary axes: as the machine prefers, with the leading axis at or above (below)
/// 0, or with the least (greatest) position of the leading axis.
enum class LeadingAxis : std::uint8_t { Preferred, Positive, Negative, Least, Greatest };

/// Converts mm to active units of size `unit`; rotary axes stay.
inline Axes from_mm(const Axes& mm, double unit) {
    Axes out = mm;
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (!is_rotary(i)) out[i] /= unit;
    }
    return out;
}

/// Returns `position` with the rotary axes of `rotary`.
inline Axes with_rotary(Axes position, const Axes& rotary) {
    for (std::size_t i = kA; i <= kC; ++i)
        position[i] = rotary[i];
    return position;
}

// --- coordinates.cpp ---

/// Reports that `name` needs rotary axes, if the axes are unspecified.
/// Returns: true if the axes are specified.
bool has_rotary_axes(std::string_view name, SourceSpan span, Context& context);
/// True if a rotary axis is not at 0.
bool is_turned(const MachineState& state);
/// Returns the axis positions in the convention of JointSolver: mm, without the tool length.
Axes axis_positions(const MachineState& state);
/// Converts axis positions of JointSolver to machine_position() coordinates.
Axes from_axis_positions(const MachineState& state, const Axes& axis_positions);
/// Returns the active tool length along Z, mm.
double length_mm(const MachineState& state);
/// Changes the meaning of X, Y and Z without a motion. With all rotary axes at 0, tip and linear
/// axes have equal positions; otherwise the positions depend on the kinematics of the machine.
void take_coordinates(MachineState& state, Coordinates coordinates, Context& context);
/// Chooses the meaning of X, Y and Z outside of tilted planes.
void choose_coordinates(MachineState& state, Coordinates coordinates, Context& context);
/// Sets the tilted plane. The machine position stays; the program coordinates change.
void set_tilt_frame(MachineState& state, const std::optional<FeatureFrame>& frame);
/// Sets the tilted plane, and makes X, Y and Z positions of the tip.
void enter_tilt(MachineState& state, const std::optional<FeatureFrame>& frame, Context& context);
/// Makes X, Y and Z positions of the joints until resume().
SavedCoordinates as_joints(MachineState& state, Context& context);
void resume(MachineState& state, const SavedCoordinates& before, Context& context);
/// True if positions of the joints differ from positions of the tip.
bool hides_joints(const MachineState& state, const Setup& setup);
/// Makes a move with rotary words in a tilted plane: all axes move linearly to the joint positions
/// that bring the tip to `end`.
bool linear_move_of_joints(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask,
                           Context& context);

// --- offsets.cpp ---

/// Updates the program coordinates after a change of offsets; the machine position `machine` stays.
void keep_machine_position(MachineState& state, const Axes& machine);
/// Returns the offset of `system`: 1 … 9 are G54 … G59.3, kExtended + n is G54.1 Pn.
WorkOffset& offset_of(ControlState& control, int system);
void select_system(ControlState& control, int system, Context& context);
/// Applies the stored origin of the active system, with the axes at `machine`.
void use_system(ControlState& control, const Axes& machine);
/// Relates the stored origin of the active system, which is not in effect yet, to the origin in
/// effect. Along an axis with an unspecified distance, both zeros are assumed to coincide, so the
/// position keeps its value, and the unspecified reference is shifted. `machine`: position of the
/// axes; moves with the shift.
void assume_same_zero(ControlState& control, Axes& machine, Context& context);
/// Before the first move: places the axes at the specified start in the present G54, and relates
/// the active system to G54.
/// Returns: false, without effect, if X, Y and Z are not axis positions.
bool place_at_start(ControlState& control, Context& context);
/// Returns the number of the system that `code` selects without P; 1 for other codes.
int system_of(Code code);
/// True if a code of `command` other than the coordinate system uses the word `letter`.
bool has_other_use(const MachineState& state, const Command& command, char letter);
bool set_work_offset(ControlState& control, const Command& command, Context& context);
bool set_offset_92(ControlState& control, const Command& command, Code code, Context& context);
bool set_data(ControlState& control, const Command& command, Context& context);
void move_external(ControlState& control, const Axes& external, Context& context);

// --- offset_variables.cpp ---

bool set_variable_offset(ControlState& control, const SystemVariable& variable, double value,
                         bool is_relative, SourceSpan span, Context& context);

// --- programmed.cpp ---

/// G68, G69, G51, G50, G51.1, G16: transformations of programmed positions.
bool set_programmed(MachineState& state, const Command& command, Context& context);

// --- tool_data.cpp ---

/// True if G43 of `command` selects the active length with the same value.
bool is_length_active(const ControlState& control, const Command& command, const Setup& setup);
/// Returns the register `index`, which is added if missing; null if there are too many registers.
ToolTableEntry* register_of(ControlState& control, int index);
/// True for G10 of Fanuc and Haas that sets a register without naming an axis: "G10 L10 P1 R120.".
bool is_register(const Command& command, int l, const Setup& setup);
/// Sets a register. L10: length; L11, and L1 of Haas: wear of the length; L12: radius; L13: wear of
/// the radius. The control adds wear to length and radius. Under G91 the value is added to the old
/// value.
bool set_register(ControlState& control, const Command& command, int index, int l,
                  Context& context);
/// Sets the length or radius of `entry`, or the wear, to `mm`; `adds`: adds `mm` to the old value.
void set_register_value(ControlState& control, ToolTableEntry& entry, bool of_length, bool is_wear,
                        double mm, bool adds, const Setup& setup);
bool set_tool_data(ControlState& control, const Command& command, int index, Context& context);
/// Returns the length of the tool in the spindle, mm: the value specified before the program
/// starts, even if the program changes the register; otherwise the value of the register.
std::optional<double> gauge_length(const ControlState& control, const Setup& setup);
bool set_tool_length(ControlState& control, const Command& command, Context& context);
/// Returns the radius of register D, or of the tool in the spindle, in active units. If the radius
/// is unspecified, reports a warning and returns 0.
double radius_of_register(const ControlState& control, const Command& command, SourceSpan span,
                          Context& context);
/// Checks a tool number under strict rules: 0 is the tool in the spindle; every other number must
/// be in the table.
bool check_tool(const ControlState& control, const Command& command, char letter, Context& context);

// --- tilted_plane.cpp ---

/// Reports codes that would move incorrectly under tip control with the tool tilted.
bool check_tip_control(const MachineState& state, const Command& command, Context& context);
/// Reports codes that would move incorrectly in a tilted plane.
bool check_tilted_plane(const MachineState& state, const Command& command, Context& context);
bool set_tilted_plane(ControlState& control, const Command& command, Context& context);
/// Ends the tilted plane, also one of which only a part is defined.
void end_plane(ControlState& control, Context& context);
/// G53.1 and similar codes: turn the tool normal to the plane.
bool orient_tool(ControlState& control, const Command& command, Context& context);
/// See Controller::tilt.
bool set_tilt(MachineState& state, const FeatureFrame& frame, std::string_view name,
              SourceSpan span, Context& context);
/// See Controller.
std::optional<Axes> axes_of_tilt(const MachineState& state, LeadingAxis leading,
                                 std::string_view name, SourceSpan span, Context& context);
/// See Controller.
void turn_axes(MachineState& state, const Axes& axes, MoveKind kind, bool tip_stays,
               Context& context);
/// Applies I, J and K of a straight move under G43.5.
bool turn_to_vector(const MachineState& state, const Command& command, Axes& end, AxisMask& mask,
                    Context& context);

// --- home.cpp ---

bool move_home(ControlState& control, const Command& command, bool second, Context& context);
/// G28.2 of TinyG, g2core, Smoothieware: moves to the switches of the named axes (or of X, Y and
/// Z), Z first. The values of the words have no meaning.
bool seek_home(ControlState& control, const Command& command, Context& context);
bool return_from_home(ControlState& control, const Command& command, Context& context);
void set_home(ControlState& control, bool second);

// --- dynamic_offset.cpp ---

/// Sets the displacement of the zero. The machine position stays; the program coordinates change.
void set_dynamic_offset(MachineState& state, const std::optional<std::array<double, 3>>& shift);
/// G254: the zero moves with the table to the present rotary positions; X, Y and Z keep the
/// directions of the machine. G255 ends the mode.
bool apply_dynamic_offset(MachineState& state, const Command& command, Context& context);
/// Returns the displacement of the zero with the rotary axes of `axis_positions`, in machine
/// coordinates, active units.
std::array<double, 3> dynamic_offset_at(const MachineState& state, const Axes& axis_positions,
                                        const Setup& setup);
/// For a straight move that turns the table: `end`, with the named axes `mask`, refers to the zero
/// at the end of the move.
void follow_table(MachineState& state, Axes& end, AxisMask mask, const Setup& setup);
/// Reports codes that are not simulated with a dynamic work offset.
bool check_dynamic_offset(const MachineState& state, const Command& command, Context& context);

// --- polar_and_cylindrical.cpp ---

bool set_polar_interpolation(MachineState& state, const Command& command, Context& context);
/// Ends polar interpolation: X is the distance from the axis again, and C the angle of the tip.
void end_polar_interpolation(MachineState& state, Context& context);
/// G7.1 C25: C turns a cylinder with this radius; radius 0 ends the mode.
bool set_cylinder(MachineState& state, const Command& command, Context& context);
bool linear_move_on_cylinder(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask,
                             Context& context);
/// Makes an arc in the plane of the cylinder's axis and the circumference, by chords.
bool arc_on_cylinder(MachineState& state, const Command& command, bool clockwise, Context& context);

}  // namespace ncsim::gcode
