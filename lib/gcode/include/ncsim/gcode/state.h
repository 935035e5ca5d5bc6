// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a control remembers between two blocks. A value: to go back, keep a copy.
//
// Numbers that a program can write are kept as it writes them, in *program coordinates* and in
// the units that are active, so that they stay exact until they leave as motions:
//
//     machine = rotate_z(rotation) * (plane * (position + offset_92) + outer_92) + work_offset +
//               tool_offset
//               + carried
#pragma once

#include "ncsim/gcode/feature_frame.h"
#include "ncsim/gcode/motion.h"

#include <array>
#include <cstdint>
#include <optional>

namespace ncsim::gcode {

/// X Y Z A B C U V W: lengths in the units of the moment (or mm, where said), angles in degrees.
using Axes = std::array<double, 9>;

/// A G code; the names are those of src/control/codes.def. -1: none, else ten times the number.
enum class Code : std::int16_t;

enum Axis : std::uint8_t { kX, kY, kZ, kA, kB, kC, kU, kV, kW };

constexpr bool is_rotary(std::size_t axis) {
    return axis >= kA && axis <= kC;
}

/// On which side of the programmed path the cutter goes (G41, G42).
enum class CutterSide : std::uint8_t { Off, Left, Right };

/// What a canned cycle keeps from block to block. Program coordinates.
struct CycleState {
    double r = 0.0, z = 0.0, q = 0.0;  ///< z: the depth, along the axis that drills.
    double p = 0.0;                    ///< Seconds.
    /// Pecks of Haas by I, J, K: the first, how much less each next is, the least. 0: by q.
    double first_peck = 0.0, peck_reduction = 0.0, least_peck = 0.0;
    bool has_r = false, has_z = false, has_p = false;
    Code code{-1};         ///< Of the cycle.
    double initial = 0.0;  ///< Where the drilling axis stood before the first cycle of the series.
    bool running = false;
    bool operator==(const CycleState&) const = default;
};

/// G68, G51 and G16 of Fanuc and its kin: what happens to programmed coordinates first.
struct Programmed {
    bool rotated = false, scaled = false, polar = false;
    Plane plane = Plane::XY;  ///< Of G68 and G16.
    double angle = 0.0;       ///< Degrees, G68.
    double centre_1 = 0.0, centre_2 = 0.0;
    std::array<double, 3> scale{1.0, 1.0, 1.0};  ///< G51; negative mirrors.
    std::array<double, 3> scale_centre{};
    bool operator==(const Programmed&) const = default;
};

/// What the origin of a coordinate system is known from, an axis (X, Y, Z): 0 is the machine, any
/// other number some place that nobody told. How far two systems are apart is known where they have
/// the same.
using OriginFrame = std::array<int, 3>;

/// In MachineState::place_frame: the axis is at a place of the machine (G28, G30, G53).
constexpr int kMachinePlace = -1;

/// One coordinate system G54 … G59.3. Millimetres and degrees, machine coordinates.
struct WorkOffset {
    Axes origin{};
    double rotation = 0.0;  ///< Degrees about Z.
    OriginFrame frame{};
    bool operator==(const WorkOffset&) const = default;
};

/// Registers of tool lengths that are no number of a tool table.
enum LengthRegister : int {
    kNoLength = 0,        ///< G49, H0, or never anything else.
    kStatedLength = -1,   ///< G43.1: the program says the length itself.
    kNegatedLength = -2,  ///< G44.
};

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
    bool spindle_in_doubt = false;  ///< M0 came after M3; on many machines that stops the spindle.
    bool spindle_oriented = false;  ///< M19, and no M3, M4 or M5 since.
    std::optional<bool> steps_aside;   ///< As in Motion.
    bool previous_was_spline = false;  ///< G5 may leave out its first control point.
    bool units_stated = false;
    bool first_length_seen = false, first_length_in_inches = false;
    bool just_left_compensation = false;
    /// After G40 on Fanuc and Haas: the vector from the tool to the programmed point. The next move
    /// in the plane goes along it, too. Active units.
    Axes uncancelled{};
    Code motion{-1};  ///< The motion mode; G80 after that; -1: none yet.
    Code last_straight{
        0};  ///< G0 or G1: what bare axis words after G80 mean where that is allowed.

    // Values
    double feed = 0.0;  ///< In active units per minute or revolution; 0: never set.
    double spindle_rpm = 0.0;
    SpindleTurning spindle = SpindleTurning::Stopped;
    Coolant coolant;
    int selected_tool = -1;  ///< T; -1: none yet.
    int tool = 0;            ///< In the spindle.
    CutterSide cutter_side = CutterSide::Off;
    double cutter_radius = 0.0;         ///< Active units; with `cutter_side`.
    int length_register = kNoLength;    ///< H of G43, or a LengthRegister.
    bool length_told = false;           ///< Of that register.
    std::optional<double> tool_length;  ///< Of the tool in the spindle, mm, where it is told.
    /// The M code that last chose how the machine turns (M428 …), if nobody told it; 0: none.
    int kinematics = 0;
    Coordinates coordinates = Coordinates::Axes;
    Coordinates chosen = Coordinates::Axes;  ///< What they are as soon as no plane is tilted.
    bool tip_by_length = false;              ///< By G43.4.
    bool by_vector = false;                  ///< G43.5: I, J and K tell the direction of the tool.
    /// Of a tilted plane: what program coordinates are counted in. Active units.
    std::optional<FeatureFrame> plane_frame;
    std::array<double, 3> outer_92{};  ///< What offset_92 was outside of the plane; X, Y, Z.
    std::array<bool, 3> clamped{};     ///< A, B and C.
    /// G12.1: X and C are places across the axis of C, in a plane_frame of its own.
    struct Face {
        double angle = 0.0;       ///< Of its X, on the part; degrees.
        double start = 0.0;       ///< Where C stood when it began, degrees.
        double sign = 1.0;        ///< Of C, seen on the part.
        Plane plane = Plane::XY;  ///< Of before.
        bool operator==(const Face&) const = default;
    };
    std::optional<Face> face;
    /// G7.1: a rotary axis turns a cylinder.
    struct Cylinder {
        std::size_t axis = 5;
        double radius = 0.0;  ///< Active units.
        bool operator==(const Cylinder&) const = default;
    };
    std::optional<Cylinder> cylinder;
    /// G254, G54.2, G54.4: how far the zero of the system went with the table. Machine coordinates,
    /// active units.
    std::optional<std::array<double, 3>> carried;
    /// Of G54.2 and G54.4: where that is with all rotary axes at 0,
    std::array<double, 3> carried_home{};
    int table_offset = 0;           ///< and its number; 0: none.
    bool is_setting_error = false;  ///< It is of G54.4.

    // Places
    Axes position{};     ///< Of the controlled point, program coordinates.
    Axes work_offset{};  ///< Of the active system.
    Axes offset_92{};    ///< G92 and G52.
    Axes tool_offset{};  ///< G43
    /// How often the tip got elsewhere though nothing moved: a tool length came or went.
    std::uint32_t length_changes = 0;
    double rotation = 0.0;  ///< Of the active system, degrees.
    OriginFrame frame{};    ///< Of the active system.
    /// Frames in which the places of X, Y and Z are known: of the system that was active when the
    /// axis moved last, or kMachinePlace.
    OriginFrame place_frame{};
    /// How far unspecified frames were shifted by assumptions, mm.
    std::array<double, 3> frame_shift{};
    /// Nothing has moved, and no G92 or G10 L20 refers to the place of the tool.
    bool is_at_start = true;
    int system = 1;  ///< 1: G54 … 9: G59.3; 9 + n: G54.1 Pn.
    KnownAxes known{false, false, false};
    /// Of those, the ones that incremental words moved from where nobody knows,
    KnownAxes relative{false, false, false};
    /// and the ones that stand at a place of the machine of which nobody knows where it is.
    KnownAxes of_machine{false, false, false};
    /// The part of offset_92 that said where an axis stands of which nobody knew it: it is where
    /// the program has its zero, and no shift from there.
    Axes zero_92{};
    std::array<bool, 3> is_zero_by_hand{};  ///< X, Y, Z of zero_92 are set, to 0 or another value.
    std::array<double, 2> last_pq{};        ///< Of the last G5.

    Programmed programmed;
    CycleState cycle;

    double unit_mm() const { return inches ? 25.4 : 1.0; }
    bool operator==(const MachineState&) const = default;
};

/// The frame a motion was programmed in, for those who want to show it as it was written.
/// Lengths in the active units, angles in degrees.
struct ProgramFrame {
    bool inches = false;
    int system = 1;
    Axes work_offset{};
    Axes offset_92{};
    Axes tool_offset{};
    double rotation = 0.0;
    Plane plane = Plane::XY;
    int length_register = kNoLength;
    bool length_told = false;           ///< Of that register.
    std::optional<double> tool_length;  ///< Of the tool in the spindle, mm, where it is told.
    bool operator==(const ProgramFrame&) const = default;
};

}  // namespace ncsim::gcode
