// SPDX-License-Identifier: GPL-3.0-or-later
//
// Acts on one command after the other: the modes, offsets and moves of a control, in the order of
// execution of RS274/NGC (Kramer, Proctor, Messina, 2000, table 8), not of writing.
//
// One class whose parts stand in files of their own: machine.cpp (the order, modes), offsets.cpp
// (coordinate systems), tilted_plane.cpp (tip control, planes), face_and_cylinder.cpp, home.cpp
// (G28, G30, G53), arc.cpp, corner.cpp, cycle.cpp, hole_pattern.cpp, pocket.cpp, area_pocket.cpp,
// spline.cpp, probe.cpp.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/state.h"

#include "control/command.h"
#include "control/control_state.h"
#include "control/cycles/area.h"
#include "control/frames/plane_words.h"
#include "control/parameters.h"
#include "control/paths/arc_centres.h"
#include "control/paths/compensation.h"
#include "control/paths/distance_evidence.h"
#include "control/paths/path.h"
#include "control/rules.h"
#include "control/system_variable.h"
#include "text/message.h"

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// A move of an outline in X and Y of the program; an arc, if it turns.
struct OutlineMove {
    PlanePoint from, to, centre;
    int turns = 0;  ///< Above 0 counter-clockwise.
};

class Machine {
public:
    Machine(const InterpreterOptions& options, const Rules& rules, ArcCentres& centres,
            DiagnosticLog& log, Path& path, Parameters& parameters);

    /// Acts on `command`, or returns false after reporting an error: then control() is as it was,
    /// but for the curve that the command should have ended, and unless it had moved something.
    bool execute(const Command& command);

    // M70 … M73 of LinuxCNC: the modes of a call level.
    struct SavedModes;
    std::shared_ptr<const SavedModes> save_modes() const;
    bool restore_modes(const SavedModes& saved, SourceSpan span);

    // The outline of a G150: between these two, moves are listened to and not made.
    bool begin_outline(const Command& command);
    void end_outline();
    /// What may stand in an outline: lines and arcs.
    static bool belongs_to_outline(const Command& command);

    bool ended() const { return ended_; }  ///< M2 or M30.
    /// Met a code after which nothing could be simulated rightly; it was reported.
    bool stopped() const { return stopped_; }
    const ControlState& control() const { return control_; }
    const MachineState& state() const { return state_; }
    MachineState& state() { return state_; }

    /// Lets out what waits for the next move (a corner, cutter compensation).
    void flush() {
        if (control_.corner) settle_corner();
        compensation_.flush(state_);
    }
    /// Where the following motions come from.
    void set_origin(SourceSpan span, std::uint32_t file);

    /// Sets an offset that the program writes as a variable; `is_relative`: `value` was computed
    /// from an unknown place. False, after a report, if that is not simulated.
    bool set_variable(const SystemVariable& variable, double value, bool is_relative,
                      SourceSpan span);
    /// A stop such as M0.
    void pause() { stop_at(0); }

    /// The end of the program: modes go back to what a control starts a program with.
    void finish();

    // Which unit the first length was in, for the assumption sheet.
    bool units_stated() const { return state_.units_stated; }
    bool first_length_seen() const { return state_.first_length_seen; }
    bool first_length_in_inches() const { return state_.first_length_in_inches; }
    /// G43 or one of its kin came.
    bool uses_length_offsets() const { return uses_length_offsets_; }
    // See Interpretation.
    bool asked_for_places() const { return asked_for_places_; }
    std::optional<ProgramPlace> distance_guess() const;
    double setting_askew() const { return setting_askew_; }

private:
    void let_out(const Command& command);
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

    // Each returns false after reporting an error.
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
    bool set_data(const Command& command);  // G10
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
    std::optional<double> told_length(int tool) const;
    void select_system(int system);
    bool place_at_start();
    void assume_same_zero(Axes& machine);
    void shift_frame(std::size_t axis, int frame, double distance_mm);
    void use_system(const Axes& machine);
    void recompute_position(const Axes& machine);

    bool straight(const Command& command, MoveKind kind);
    bool straight_as_told(const Command& command, MoveKind kind);
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
    /// What is the same for all holes of a block.
    struct Drilling {
        Code motion = Code::None;
        std::size_t depth_axis = kZ;
        double r = 0.0, bottom = 0.0, clear = 0.0;
        double height = 0.0;  ///< At which the tool goes to the next hole.
    };
    std::optional<Drilling> begin_drilling(const Command& command, Code motion);
    bool hole_place(const Command& command, Axes& hole, AxisMask& mask);
    bool hole_at(Drilling& drilling, const Axes& hole, AxisMask mask);
    void orient_in_cycle();
    void turn_again(SpindleTurning turning);
    bool drill(const Drilling& drilling, const Axes& above);
    std::optional<std::vector<double>> peck_depths(double r, double bottom) const;
    bool hole_pattern(const Command& command, Code code, bool words_taken);
    static std::string_view corner_name(char letter) {
        return letter == 'R' ? ",R" : letter == 'C' ? ",C" : ",A";
    }
    bool is_line(const Command& command) const;
    bool ends_in_corner(const Command& command) const;
    bool goes_on_from_corner(const Command& command) const;
    bool stays_in_plane(const Axes& from, const Axes& to) const;
    bool hold_corner(const Command& command, const Axes& end, AxisMask mask);
    bool cut_corner(const Axes& next);
    bool end_by_angle(const Command& command, Axes& end, AxisMask& mask);
    bool hold_angle(const Command& command, const Axes& end, AxisMask mask);
    bool find_corner(const Command& command, const Axes& next);
    bool make_held_line(const Axes& end, const Axes* second, const ProgramArc* arc);
    void settle_corner();
    bool pocket(const Command& command, Code code, bool words_taken);
    void mill_circles(const Axes& centre, const std::vector<double>& radii, bool clockwise,
                      AxisMask mask);
    bool hear(const Axes& end, const ProgramArc* arc);
    bool area_pocket(const Command& command, Code side, bool words_taken);
    bool mill_around(const std::vector<OutlineMove>& loop, CutterSide side, double radius,
                     const Area& area, bool along_y, double level, double clear);
    double radius_of_register(const Command& command, SourceSpan span);

    /// Where the axis words point to, in program coordinates, and which axes they name.
    bool find_ends(const Command& command, Axes& end, AxisMask& mask);
    bool polar_ends(const Command& command, Axes& end, AxisMask& mask);
    Axes programmed_from(const Axes& position) const;
    Axes programmed_to(const Axes& programmed) const;
    Axes machine_position() const;
    Axes from_machine(const Axes& machine) const;
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
    Axes stand() const;
    Axes from_stand(const Axes& stand) const;
    double length_mm() const;
    void mix_knowledge();
    /// What X, Y and Z were before they were places of the joints.
    struct Suspended {
        std::optional<FeatureFrame> frame;
        Coordinates coordinates = Coordinates::Axes;
        Axes offset_92{};
    };
    Suspended as_joints();
    void resume(const Suspended& before);
    bool hides_joints() const;
    bool straight_of_joints(const Axes& end, MoveKind kind, AxisMask mask);
    bool check_plane(const Command& command);
    bool set_plane(const Command& command);
    void set_plane_frame(const std::optional<FeatureFrame>& frame);
    std::optional<FeatureFrame> plane_of_tool(const Command& command, PlaneDialect dialect);
    void end_plane();
    std::optional<Axes> turned_to(const Triple& axis, JointSolver::Way way, Code code,
                                  SourceSpan span);
    bool orient(const Command& command);
    bool face(const Command& command);
    void end_face();
    bool choose_kinematics(const Command& command, bool by_number, SourceSpan span);
    bool cylinder(const Command& command);
    double feed_on_cylinder(const Axes& end) const;
    bool straight_on_cylinder(const Axes& end, MoveKind kind, AxisMask mask);
    bool arc_on_cylinder(const Command& command, bool clockwise);
    bool carry_zero(const Command& command);
    bool offset_table(const Command& command, Code code);
    bool take_setting(const TableOffsets::One& one, const TableOffsets& all, std::string_view name,
                      SourceSpan span);
    const TableOffsets& table_offsets() const;
    std::array<double, 3> carried_at(const Axes& stand) const;
    void go_with_table(Axes& end, AxisMask mask);
    bool check_carried(const Command& command);
    void carry(const std::optional<std::array<double, 3>>& shift);
    double rotary_end(std::size_t axis, double value, double at) const;
    bool turn_to_vector(const Command& command, Axes& end, AxisMask& mask);
    bool stop_with(const MessageText& message, SourceSpan span,
                   std::initializer_list<std::string_view> arguments);
    bool check_tip_control(const Command& command);
    bool is_known(std::size_t axis) const;
    void tell_place(std::size_t axis);

    SourceSpan span_of(const Command& command, char letter) const;
    SourceSpan span_of_g(const Command& command, Code code) const;
    bool fail(const MessageText& message, SourceSpan span,
              std::initializer_list<std::string_view> arguments = {});
    void warn(const MessageText& message, SourceSpan span,
              std::initializer_list<std::string_view> arguments = {});
    /// A warning where other controls accept it; an error under strict rules.
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
        bool is_foreign = false;  ///< Something moved otherwise than in X and Y.
    };
    std::optional<Outline> outline_;  ///< While one is listened to.
    std::vector<OutlineMove> heard_;
    bool heard_well_ = false;
    SourceSpan span_;
    std::uint32_t file_ = 0;
    static constexpr int kExtended = 9;
    bool curve_fails_ = false;  ///< If the block is refused, the curve it is part of goes with it.
    bool motion_was_named_ = false;
    bool uses_length_offsets_ = false;
    bool asked_for_places_ = false;
    bool distance_is_stated_ = false;  ///< G90 or G91 came.
    DistanceEvidence distance_;
    double setting_askew_ = 0.0;
    bool ended_ = false;
    bool stopped_ = false;
};

}  // namespace ncsim::gcode
