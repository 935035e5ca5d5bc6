// SPDX-License-Identifier: GPL-3.0-or-later
//
// The state of a control between two blocks, as a value: a copy restores the state.
#pragma once

#include "ncsim/gcode/frame_stack.h"
#include "ncsim/gcode/motion.h"

#include <array>
#include <cstdint>
#include <optional>

namespace ncsim::gcode {

/// A G code, with the names of src/control/codes.def. Value: ten times the number; -1: none.
enum class Code : std::int16_t;

/// Side of the programmed path on which the cutter moves (G41, G42).
enum class CutterSide : std::uint8_t { Off, Left, Right };

/// Modal data of a canned cycle, in program coordinates.
struct CycleState {
    double r = 0.0, z = 0.0, q = 0.0;  ///< z: the depth, along the drilling axis.
    double p = 0.0;                    ///< Seconds.
    /// Peck depths of Haas by I, J, K: first depth, reduction per peck, minimum. 0: all pecks by q.
    double first_peck = 0.0, peck_reduction = 0.0, least_peck = 0.0;
    bool has_r = false, has_z = false, has_p = false;
    Code code{-1};         ///< The G code of the cycle.
    double initial = 0.0;  ///< Position of the drilling axis before the first cycle of the series.
    bool running = false;
    bool operator==(const CycleState&) const = default;
};

/// Cycle of Klartext or SINUMERIK that is defined for calls or for each move.
struct DefinedCycle {
    /// n > 0: CYCL DEF n; n < 0: MCALL CYCLE-n, or kModalProgram; 0: none.
    int number = 0;
    std::uint32_t line = 0;  ///< Line of the definition.
    bool operator==(const DefinedCycle&) const = default;
};
/// Number of a subprogram that MCALL calls after each move.
inline constexpr int kModalProgram = -1'000'000;

/// Reference of a coordinate system's origin for each axis (X, Y, Z). 0: the machine; any nonzero
/// number: an unknown position with that number. The distance between two systems is known along
/// the axes with equal references.
using OriginFrame = std::array<int, 3>;

/// Value of MachineState::place_frame: the axis is at a position of the machine (G28, G30, G53).
constexpr int kMachinePlace = -1;

/// A coordinate system G54 … G59.3, in machine coordinates, mm and degrees.
struct WorkOffset {
    Axes origin{};
    double rotation = 0.0;  ///< Degrees about Z.
    OriginFrame frame{};
    bool operator==(const WorkOffset&) const = default;
};

/// Tool length registers that are not numbers of a tool table.
enum LengthRegister : int {
    kNoLength = 0,        ///< G49, H0, or no length code yet.
    kStatedLength = -1,   ///< G43.1: the program states the length itself.
    kNegatedLength = -2,  ///< G44.
};

/// The modes, values and positions of a control.
struct MachineState {
    // Modes
    bool inches = false;
    bool incremental = false;
    bool absolute_centres = false;  ///< G90.1
    bool retract_to_r = false;      ///< G99
    bool offset_92_active = false;
    bool constant_surface_speed = false;  ///< G96
    bool lathe_diameter = false;          ///< G7
    Plane plane = Plane::XY;
    FeedMode feed_mode = FeedMode::PerMinute;
    bool spindle_in_doubt = false;     ///< M0 came after M3; on many machines M0 stops the spindle.
    bool rigid_tapping = false;        ///< M29 of Fanuc, until a cycle ends.
    bool spindle_oriented = false;     ///< M19, and no M3, M4 or M5 since.
    std::optional<bool> steps_aside;   ///< As in Motion.
    bool previous_was_spline = false;  ///< The next G5 may omit the first control point.
    bool units_stated = false;
    bool first_length_seen = false, first_length_in_inches = false;
    bool just_left_compensation = false;
    /// After G40 on Fanuc and Haas: the vector from the tool to the programmed point. The next move
    /// in the plane includes the vector. Active units.
    Axes uncancelled{};
    Code motion{-1};  ///< The motion mode; G80 after a G80; -1: none yet.
    /// G0 or G1: mode of bare axis words after G80, where allowed.
    Code last_straight{0};

    // Values
    double feed = 0.0;  ///< In active units per minute or revolution; 0: never set.
    double spindle_rpm = 0.0;
    SpindleTurning spindle = SpindleTurning::Stopped;
    Coolant coolant;
    int selected_tool = -1;  ///< By T; -1: none yet.
    int tool = 0;            ///< Tool in the spindle.
    CutterSide cutter_side = CutterSide::Off;
    double cutter_radius = 0.0;       ///< Active units; with `cutter_side`.
    int length_register = kNoLength;  ///< H of G43, or a LengthRegister.
    bool length_specified = false;    ///< The length of `length_register` is specified.
    /// Length of the tool in the spindle, mm; empty: unspecified.
    std::optional<double> tool_length;
    /// M code (M428 …) that last chose the kinematics, if unspecified; 0: none.
    int kinematics = 0;
    Coordinates coordinates = Coordinates::Axes;
    Coordinates chosen = Coordinates::Axes;  ///< Meaning of X, Y and Z while no plane is tilted.
    bool tip_by_length = false;              ///< Chosen by G43.4.
    bool by_vector = false;                  ///< G43.5: I, J and K are the direction of the tool.
    std::array<bool, 3> clamped{};           ///< A, B and C are clamped.
    /// G12.1 (polar interpolation): X and C are positions in the plane normal to the axis of C, in
    /// a separate tilt of `frames`.
    struct PolarInterpolation {
        double angle = 0.0;       ///< Direction of the frame's X axis on the part, degrees.
        double start = 0.0;       ///< Position of C at G12.1, degrees.
        double sign = 1.0;        ///< Sense of C seen on the part: 1 or -1.
        Plane plane = Plane::XY;  ///< Plane before G12.1.
        bool operator==(const PolarInterpolation&) const = default;
    };
    std::optional<PolarInterpolation> polar_interpolation;
    /// Radius (active units) and angle (degrees) that the last polar words of G16 gave. A position
    /// does not determine the sign of its radius, and the pole has no angle.
    struct PolarWords {
        double radius = 0.0, angle = 0.0;
        bool operator==(const PolarWords&) const = default;
    };
    std::optional<PolarWords> polar_words;
    /// G7.1 (cylindrical interpolation): a rotary axis turns a cylinder.
    struct Cylinder {
        std::size_t axis = 5;
        double radius = 0.0;  ///< Active units.
        bool operator==(const Cylinder&) const = default;
    };
    std::optional<Cylinder> cylinder;
    int table_offset = 0;           ///< G54.2, G54.4: number of the offset (P); 0: none.
    bool is_setting_error = false;  ///< The offset is a setting error (G54.4).

    // Places
    Axes position{};  ///< Position of the controlled point, program coordinates.
    FrameStack frames;
    /// Number of changes of the tip's position without a motion: a new tool length, a new meaning
    /// of X, Y and Z, a new start position.
    std::uint32_t length_changes = 0;
    OriginFrame frame{};  ///< Reference of the active system.
    /// References in which the positions of X, Y and Z are known: the reference of the system that
    /// was active when the axis last moved, or kMachinePlace.
    OriginFrame place_frame{};
    /// Shift of unspecified references by assumptions, mm.
    std::array<double, 3> frame_shift{};
    /// No motion yet, and no G92 or G10 L20 refers to the position of the tool.
    bool is_at_start = true;
    int system = 1;  ///< 1: G54 … 9: G59.3; 9 + n: G54.1 Pn.
    KnownAxes known{false, false, false};
    /// Axes of `known` that incremental words moved from an unknown position.
    KnownAxes relative{false, false, false};
    /// Axes of `known` that are at a position of the machine unknown in the active system.
    KnownAxes of_machine{false, false, false};
    std::array<double, 2> last_pq{};  ///< P and Q of the last G5.

    CycleState cycle;
    DefinedCycle defined_cycle;

    double unit_mm() const { return inches ? 25.4 : 1.0; }
    /// Returns `position` in machine coordinates.
    Axes machine_position() const { return frames.to_machine(position); }
    /// Returns `position` in the coordinates of the program: rotation, scale and mirror images are
    /// removed.
    Axes programmed_position() const { return frames.programmed.remove(position); }
    bool is_known(std::size_t axis) const { return axis > kZ || known[axis]; }
    bool operator==(const MachineState&) const = default;
};

/// The frame in which a motion was programmed, for display in program coordinates. Lengths in the
/// active units, angles in degrees.
struct ProgramFrame {
    bool inches = false;
    int system = 1;
    Axes work_offset{};
    Axes offset_92{};
    Axes tool_offset{};
    double rotation = 0.0;
    Plane plane = Plane::XY;
    int length_register = kNoLength;
    bool length_specified = false;  ///< The length of `length_register` is specified.
    /// Length of the tool in the spindle, mm; empty: unspecified.
    std::optional<double> tool_length;
    bool operator==(const ProgramFrame&) const = default;
};

}  // namespace ncsim::gcode
