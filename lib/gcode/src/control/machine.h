// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machine: executes commands. Modes, offsets and moves take effect in the order of execution of
// RS274/NGC, not in the order of writing.
// Source: Kramer, Proctor, Messina, 2000, table 8.
//
// The members are in several files: machine.cpp (order of execution, modes), saved_modes.cpp,
// strict_words.cpp; frames/: offsets.cpp, offset_variables.cpp, home.cpp (G28, G29, G30),
// tilted_plane.cpp (tip control, planes), polar_and_cylindrical.cpp, dynamic_offset.cpp; paths/:
// moves.cpp (G53, threads, probing), arc.cpp, spline.cpp, compensation_checks.cpp; cycles/:
// cycle.cpp, corner.cpp, hole_pattern.cpp, pocket.cpp, area_pocket.cpp.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/frame_stack.h"
#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/state.h"

#include "control/command.h"
#include "control/control_rules.h"
#include "control/control_state.h"
#include "control/cycles/outline.h"
#include "control/frames/plane_words.h"
#include "control/parameters.h"
#include "control/paths/arc_centres.h"
#include "control/paths/compensation.h"
#include "control/paths/distance_evidence.h"
#include "control/paths/path.h"
#include "control/system_variable.h"
#include "text/message.h"

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Executes the commands of a program.
class Machine {
public:
    Machine(const InterpreterOptions& options, const Rules& rules, ArcCentres& centres,
            DiagnosticLog& log, Path& path, Parameters& parameters);

    /// Executes `command`.
    /// Returns: false after reporting an error. If the command made no motion before the error,
    /// control() is restored, except that a curve that the command should have ended is discarded.
    bool execute(const Command& command);

    // Saves and restores the modes of a call level: M70 … M73 of LinuxCNC.
    struct SavedModes;
    std::shared_ptr<const SavedModes> save_modes() const;
    bool restore_modes(const SavedModes& saved, SourceSpan span);

    /// Starts cutter compensation with the tool at the offset position of `contour`, a programmed
    /// position; the next move begins at `contour`.
    void begin_compensation_at(CutterSide side, double radius, const Axes& contour);

    // Outline of a G150: between begin_contour() and end_outline(), moves are recorded and not
    // made.
    bool begin_contour(const Command& command);
    void end_outline();
    /// True if `command` may be part of an outline: lines and arcs.
    static bool belongs_to_outline(const Command& command);

    bool ended() const { return ended_; }  ///< M2 or M30 was executed.
    /// True after a code that makes correct simulation impossible; the code was reported.
    bool stopped() const { return stopped_; }
    const ControlState& control() const { return control_; }
    const MachineState& state() const { return state_; }
    MachineState& state() { return state_; }

    /// Makes held moves (a corner, cutter compensation).
    void flush() {
        if (control_.corner) settle_corner();
        compensation_.flush(state_);
    }
    /// Sets the block and the file of the following motions.
    void set_origin(SourceSpan span, std::uint32_t file);

    /// Sets an offset that the program writes as a variable. `is_relative`: `value` depends on an
    /// unknown position.
    /// Returns: true if the variable shows the state of the machine afterwards; false if the
    /// variable keeps the assigned number.
    bool set_variable(const SystemVariable& variable, double value, bool is_relative,
                      SourceSpan span);
    /// Acts as M0 does.
    void pause() { stop_at(0); }

    // For languages other than G-code, whose blocks have no words of G-code for these actions.
    /// Returns the position in the coordinates of the program: rotation, scale and mirror images
    /// are removed.
    Axes programmed_position() const { return state_.programmed_position(); }
    /// Solution of the rotary axes: as the machine prefers, with the leading axis at or above
    /// (below) 0, or with the least (greatest) position of the leading axis.
    enum class LeadingAxis : std::uint8_t { Preferred, Positive, Negative, Least, Greatest };
    /// Sets the tilted plane `frame`, in coordinates of the datum and active units. The rotary axes
    /// do not turn. `name`: the words of the program.
    bool tilt(const FeatureFrame& frame, std::string_view name, SourceSpan span);
    /// Ends the tilted plane, if any.
    void end_tilt() { end_plane(); }
    /// Returns the positions of the rotary axes that make the tool normal to the tilted plane;
    /// nullopt after reporting an error.
    std::optional<Axes> axes_of_tilt(LeadingAxis leading, std::string_view name, SourceSpan span);
    /// Turns the rotary axes to `axes`. `tip_stays`: the tip stays in place; otherwise X, Y and Z
    /// of the machine stay.
    void turn_axes(const Axes& axes, MoveKind kind, bool tip_stays);

    /// Ends the program and resets the modes to the start values of the control.
    void finish();

    /// Adds units, lengths, registers and guesses of the executed program to `result`.
    void report_to(Interpretation& result) const;

private:
    std::optional<ProgramPlace> distance_guess() const;
    void flush_held(const Command& command);
    bool keeps_frame(const Command& command) const;
    bool is_length_active(const Command& command) const;
    int length_number(const Command& command) const;
    static std::optional<Plane> plane_of(const Command& command);
    void restore(const ControlState& before);
    bool act(const Command& command);
    bool check(const Command& command);
    std::string_view forbidden_with_compensation(const Command& command) const;
    std::string_view interrupts_compensation(const Command& command) const;
    bool sets_active_data(const Command& command) const;
    bool check_compensation(const Command& command);
    static std::uint32_t letters_of_m(const Command& command);
    bool lacks(const Command& command, std::string_view name, std::string_view what);
    bool check_strict(const Command& command);
    bool check_words_of_m(const Command& command);
    bool check_words_of_g(const Command& command);
    bool check_corner_words(const Command& command);
    bool check_unused_words(const Command& command);

    // Each of these functions returns false after reporting an error.
    bool set_feed(const Command& command);
    void set_speeds_and_tools(const Command& command);
    void set_coolant(const Command& command);
    void set_units(bool inches);
    void set_modes(const Command& command);
    bool set_cutter_side(const Command& command);
    bool check_compensation_words(const Command& command, bool stated);
    bool check_tool(const Command& command, char letter);
    bool set_tool_length(const Command& command);
    std::optional<double> gauge_length() const;
    bool set_work_offset(const Command& command);
    bool has_other_use(const Command& command, char letter) const;
    bool set_programmed(const Command& command);
    bool one_shot(const Command& command);
    char letter_of_dwell(const Command& command) const;
    bool dwell(const Command& command);
    bool move(const Command& command, Code motion);
    bool moves_by_new_length(const Command& command, Code motion) const;
    void note_move_after_cycle(const Command& command, Code motion);
    void stop(const Command& command);
    void stop_at(int code);

    bool home(const Command& command, bool second);
    bool seek_home(const Command& command);
    bool return_from_home(const Command& command);
    void store_home(bool second);
    bool offset_92(const Command& command, Code code);
    bool set_data(const Command& command);  // G10.
    bool set_work_data(const Command& command, int index, bool from_position);
    bool set_external(const Command& command);
    void move_external(const Axes& external);
    static std::optional<int> extended_number(const Command& command);
    WorkOffset& offset_of(int system);
    static int system_of(Code code);
    bool set_tool_data(const Command& command, int index);
    ToolTableEntry* register_of(int index);
    bool is_register(const Command& command, int l) const;
    bool set_register(const Command& command, int index, int l);
    void set_register_value(ToolTableEntry& entry, bool of_length, bool is_wear, double mm,
                            bool adds);
    void set_work_variable(const SystemVariable& variable, double value, bool is_relative,
                           SourceSpan span);
    bool is_diameter(const ToolTableEntry& entry, double mm, bool is_wear) const;
    std::optional<double> specified_length(int tool) const;
    void select_system(int system);
    bool place_at_start();
    void assume_same_zero(Axes& machine);
    void shift_frame(std::size_t axis, int frame, double distance_mm);
    void use_system(const Axes& machine);
    void recompute_position(const Axes& machine);

    bool linear_move(const Command& command, MoveKind kind);
    bool linear_move_as_specified(const Command& command, MoveKind kind);
    bool threading(const Command& command, Code motion);
    bool arc(const Command& command, bool clockwise);
    bool arc_by_radius(const Command& command, bool clockwise, ProgramArc& arc);
    bool arc_by_centre(const Command& command, bool clockwise, ProgramArc& arc);
    bool takes_long_way(const ProgramArc& arc) const;
    bool is_huge(const ProgramArc& arc, double radius) const;
    bool is_straight(const ProgramArc& arc, double radius) const;
    void shorten(ProgramArc& arc, double radius, std::string_view name, SourceSpan span);
    void settle_centres(bool fits_incremental, bool fits_absolute, bool are_equal, SourceSpan span);
    bool spline(const Command& command, Code motion);
    bool nurbs(const Command& command, Code motion);
    bool nurbs_with_knots(const Command& command);
    void finish_curve(std::vector<double> knots);
    bool probe(const Command& command, Code motion);
    bool cycle(const Command& command, Code motion);
    void end_cycle();
    bool check_spindle(const Command& command, Code motion);
    bool cycle_words(const Command& command, Code motion);
    /// Data that are the same for all holes of a block.
    struct Drilling {
        Code motion = Code::None;
        std::size_t depth_axis = kZ;
        double r = 0.0, bottom = 0.0, clear = 0.0;
        double height = 0.0;  ///< Height of the drilling axis on the way to the next hole.
    };
    std::optional<Drilling> begin_drilling(const Command& command, Code motion);
    bool hole_place(const Command& command, Axes& hole, AxisMask& mask);
    bool hole_at(Drilling& drilling, const Axes& hole, AxisMask mask);
    void orient_in_cycle();
    void restart_spindle(SpindleTurning turning);
    bool drill(const Drilling& drilling, const Axes& above);
    std::optional<std::vector<double>> peck_depths(double r, double bottom) const;
    bool hole_pattern(const Command& command, Code code, bool words_taken);
    std::string_view corner_name(char letter) const {
        if (rules_.dialect == Dialect::Heidenhain) return letter == 'R' ? "RND" : "CHF";
        if (rules_.dialect == Dialect::Sinumerik)
            return letter == 'R' ? "RND" : letter == 'C' ? "CHR" : letter == 'L' ? "CHF" : "ANG";
        return letter == 'R' ? ",R" : letter == 'C' ? ",C" : ",A";
    }
    bool is_line(const Command& command) const;
    bool is_element(const Command& command) const;
    bool ends_in_corner(const Command& command) const;
    bool continues_from_corner(const Command& command) const;
    bool stays_in_plane(const Axes& from, const Axes& to) const;
    bool hold_corner(const Command& command, const Axes& end, AxisMask mask,
                     const ProgramArc* arc = nullptr);
    bool cut_corner(const Axes& next, const ProgramArc* arc = nullptr);
    bool round_at_arc(const Axes& next, const ProgramArc* arc);
    bool make_arc(const ProgramArc& arc, AxisMask mask);
    bool end_by_angle(const Command& command, Axes& end, AxisMask& mask);
    bool hold_angle(const Command& command, const Axes& end, AxisMask mask);
    bool find_corner(const Command& command, const Axes& next);
    bool make_held_line(const Axes& end, const Axes* second, const ProgramArc* arc);
    void settle_corner();
    bool pocket(const Command& command, Code code, bool words_taken);
    void mill_circles(const Axes& centre, const std::vector<double>& radii, bool clockwise,
                      AxisMask mask);
    bool record_outline_move(const Axes& end, const ProgramArc* arc);
    bool area_pocket(const Command& command, Code side, bool words_taken);
    bool mill_outline(const std::vector<OutlineMove>& loop, CutterSide side, double radius,
                      const Area& area, bool along_y, double level, double clear);
    double radius_of_register(const Command& command, SourceSpan span);

    /// Computes the end position `end` of the axis words, in program coordinates, and the named
    /// axes `mask`.
    bool find_ends(const Command& command, Axes& end, AxisMask& mask);
    bool polar_ends(const Command& command, Axes& end, AxisMask& mask);
    Axes to_programmed(const Axes& position) const {
        return state_.frames.programmed.remove(position);
    }
    Axes from_programmed(const Axes& programmed) const {
        return state_.frames.programmed.apply(programmed);
    }
    Axes machine_position() const { return state_.machine_position(); }
    Axes from_machine(const Axes& machine) const { return state_.frames.from_machine(machine); }
    bool needs_feed(const Command& command, std::string_view what);
    bool feed_straight(const Axes& end, MoveKind kind, AxisMask mask);
    Axes with_cancelled_offset(const Axes& end, AxisMask mask);
    bool is_modal_arc(const Command& command) const;
    bool is_speed_mode(const Command& command, Code motion) const;
    double seconds_of(const Command& command, char letter) const;
    bool needs_kinematics(const Command& command);
    bool is_turned() const;
    void choose(Coordinates coordinates);
    void take_coordinates(Coordinates coordinates);
    Axes axis_positions() const;
    Axes from_axis_positions(const Axes& axis_positions) const;
    double length_mm() const;
    void update_knowledge();
    /// Meaning of X, Y and Z to restore after a move in joint coordinates.
    struct SavedCoordinates {
        std::optional<FeatureFrame> frame;
        Coordinates coordinates = Coordinates::Axes;
        Axes offset_92{};
    };
    SavedCoordinates as_joints();
    void resume(const SavedCoordinates& before);
    bool hides_joints() const;
    bool linear_move_of_joints(const Axes& end, MoveKind kind, AxisMask mask);
    bool check_plane(const Command& command);
    bool set_plane(const Command& command);
    void set_plane_frame(const std::optional<FeatureFrame>& frame);
    std::optional<FeatureFrame> plane_of_tool(const Command& command, PlaneDialect dialect);
    void end_plane();
    std::optional<Axes> joints_for_direction(const Triple& axis, JointSolver::Way way, Code code,
                                             SourceSpan span);
    bool orient(const Command& command);
    bool polar_interpolation(const Command& command);
    void end_polar_interpolation();
    bool choose_kinematics(const Command& command, bool by_number, SourceSpan span);
    bool cylinder(const Command& command);
    double feed_on_cylinder(const Axes& end) const;
    bool linear_move_on_cylinder(const Axes& end, MoveKind kind, AxisMask mask);
    bool arc_on_cylinder(const Command& command, bool clockwise);
    bool apply_dynamic_offset(const Command& command);
    bool offset_table(const Command& command, Code code);
    bool take_setting(const TableOffsets::One& one, const TableOffsets& all, std::string_view name,
                      SourceSpan span);
    const TableOffsets& table_offsets() const;
    std::array<double, 3> dynamic_offset_at(const Axes& axis_positions) const;
    void follow_table(Axes& end, AxisMask mask);
    bool check_dynamic_offset(const Command& command);
    void set_dynamic_offset(const std::optional<std::array<double, 3>>& shift);
    double rotary_end(std::size_t axis, double value, double at) const;
    bool turn_to_vector(const Command& command, Axes& end, AxisMask& mask);
    bool stop_with(const MessageText& message, SourceSpan span,
                   std::initializer_list<std::string_view> arguments);
    bool check_tip_control(const Command& command);
    bool is_known(std::size_t axis) const { return state_.is_known(axis); }
    void mark_known(std::size_t axis);

    SourceSpan span_of(const Command& command, char letter) const;
    SourceSpan span_of_g(const Command& command, Code code) const;
    bool fail(const MessageText& message, SourceSpan span,
              std::initializer_list<std::string_view> arguments = {});
    void warn(const MessageText& message, SourceSpan span,
              std::initializer_list<std::string_view> arguments = {});
    /// Reports a warning, or an error under strict rules.
    /// Returns: true if it was a warning.
    bool tolerate(const MessageText& message, SourceSpan span,
                  std::initializer_list<std::string_view> arguments = {});

    const InterpreterOptions& options_;
    const Rules& rules_;
    ArcCentres& centres_;
    DiagnosticLog& log_;
    Path& path_;
    Parameters& parameters_;

    ControlState control_;
    MachineState& state_ = control_.machine;
    Compensation compensation_;
    struct Outline {
        ControlState before;
        std::vector<OutlineMove> moves;
        bool is_foreign = false;  ///< A move changed axes other than X and Y.
    };
    std::optional<Outline> outline_;  ///< Set while an outline is recorded.
    std::vector<OutlineMove> contour_;
    bool is_outline_valid_ = false;
    SourceSpan span_;
    std::uint32_t file_ = 0;
    static constexpr int kExtended = 9;
    /// If the block is refused, the curve that contains the block is discarded.
    bool curve_fails_ = false;
    bool uses_length_offsets_ = false;
    bool requested_tip_positions_ = false;
    bool distance_is_stated_ = false;  ///< G90 or G91 was executed.
    DistanceEvidence distance_;
    std::set<int> unread_registers_;  ///< Of the specified ones.
    double setting_askew_ = 0.0;
    bool ended_ = false;
    bool stopped_ = false;
};

}  // namespace ncsim::gcode
