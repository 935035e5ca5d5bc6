// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions: the output values of lib/gcode.
//
// Frame W (workpiece): the coordinate system (G54, for example) that is active at the first cutting
// move, as set at that move. Stock and fixtures are clamped relative to the program zero, so a G10
// before the first cut moves them along, and a G10 after the first cut does not. W excludes tool
// length offsets and G52/G68. W includes G92 only where G92 sets the position of an axis whose
// position was unknown (a zero set by hand).
//
// Every position below is absolute and in W, whatever offsets, units, scales and rotations the
// program uses, and belongs to the *controlled point* (the tool tip, if tool lengths are entered as
// measured). Lengths are of type Length, angles of type Angle.
#pragma once

#include "ncsim/gcode/feature_frame.h"
#include "ncsim/gcode/source.h"
#include "ncsim/gcode/units.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace ncsim::gcode {

struct ProgramFrame;

/// Position of all axes. Rotary axes are not wrapped.
struct Position {
    Length x, y, z;
    Angle a, b, c;
    Length u, v, w;
    bool operator==(const Position&) const = default;
};

enum class Plane : std::uint8_t { XY, ZX, YZ, UV, WU, VW };  ///< G17, G18, G19, G17.1, G18.1, G19.1

/// A straight move, all axes in proportion.
struct Linear {
    Position from, to;
    bool operator==(const Linear&) const = default;
};

/// A circular or helical move in `plane`, seen from the positive end of the normal (for ZX: Y
/// towards the viewer). First and second axis: X,Y (XY), Z,X (ZX), Y,Z (YZ). The third axis and the
/// rotary axes move in proportion to the angle. If `from` and `to` have different distances from
/// the centre, the radius changes linearly with the angle (a spiral).
struct Arc {
    Position from, to;
    Plane plane = Plane::XY;
    Length centre_1, centre_2;  ///< Coordinates along the first and the second axis of the plane.
    int turns = 1;  ///< > 0 counter-clockwise, < 0 clockwise; |turns| - 1 extra full circles.
    /// Tilted plane: `plane` and the centre are in this frame of W, mm. The ends are in W.
    std::optional<FeatureFrame> tilted;
    bool operator==(const Arc&) const = default;
};
/// Returns `arc` with the ends in the frame of the plane; the result is not tilted.
Arc in_own_frame(const Arc& arc);
/// Transforms X, Y and Z of `p` from `frame` (mm) to the parent frame; the other axes stay.
Position to_parent(const FeatureFrame& frame, const Position& p);

/// A non-uniform rational B-spline (G5, G5.1, G5.2) in X and Y of W, the other axes constant.
struct Spline {
    /// Control point with its weight, W.
    struct ControlPoint {
        Length x, y;
        double weight = 1.0;
        bool operator==(const ControlPoint&) const = default;
    };
    Position from, to;
    int order = 4;  ///< Degree + 1.
    std::vector<ControlPoint> control_points;
    std::vector<double> knots;
    bool operator==(const Spline&) const = default;
};

/// A pause (G4).
struct Dwell {
    double seconds = 0.0;
    bool operator==(const Dwell&) const = default;
};

/// A tool change: `tool` is in the spindle afterwards; 0: none. `at` is the position of the machine
/// (M6 does not move).
struct ToolChange {
    int tool = 0;
    Position at;
    bool operator==(const ToolChange&) const = default;
};

/// Rotation of the spindle.
enum class SpindleTurning : std::uint8_t { Stopped, Clockwise, Counterclockwise };
/// Coolant by M7, M8 and M9. M codes of machine builders do not count.
struct Coolant {
    bool mist = false, flood = false;
    bool operator==(const Coolant&) const = default;
};
/// Unit of the feed (G94, G93, G95).
enum class FeedMode : std::uint8_t { PerMinute, InverseTime, PerRevolution };

/// Kind of a move.
enum class MoveKind : std::uint8_t {
    Rapid,  ///< G0, also inside cycles, G28 and similar codes.
    Feed,   ///< G1, G2, G3, cycles.
    Probe,  ///< G38.x, G31; assumed to make contact at the target.
};
/// Returns "rapid", "feed" or "probe".
const char* name_of(MoveKind kind);

/// Meaning of X, Y and Z of a motion.
enum class Coordinates : std::uint8_t {
    /// Positions of the linear axes minus offsets. Turned rotary axes turn W away from these
    /// positions.
    Axes,
    Tip,  ///< Positions of the tip in W, which turns with the table: the control moves the axes.
};

/// Axes among X, Y and Z whose position is known. A move with an unknown start must not cut a
/// phantom path.
struct KnownAxes {
    bool x = true, y = true, z = true;
    bool all() const { return x && y && z; }
    bool any() const { return x || y || z; }
    /// Returns the value of `axis` (0: X, 1: Y, 2: Z).
    bool& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    bool operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    bool operator==(const KnownAxes&) const = default;
};

/// One action of the machine with the state that later stages need.
struct Motion {
    std::variant<Linear, Arc, Spline, Dwell, ToolChange> action;
    SourceSpan span;         ///< The block that made the motion (main word).
    std::uint32_t file = 0;  ///< Index into Interpretation::files; 0 is the main program.
    MoveKind kind = MoveKind::Feed;
    FeedMode feed_mode = FeedMode::PerMinute;
    /// mm/min (degrees/min for purely rotary moves), 1/min or mm/rev by `feed_mode`; 0: never set.
    double feed = 0.0;
    SpindleTurning spindle = SpindleTurning::Stopped;
    double spindle_rpm = 0.0;  ///< Speed by S, 1/min; 0: never set.
    Coolant coolant;
    int tool = 0;  ///< Tool in the spindle; 0: none was called.
    Coordinates coordinates = Coordinates::Axes;
    Length length;  ///< Tool length along Z as applied by the control (G43).
    KnownAxes known_start, known_end;
    /// An axis is known only by increments from an unknown position: the start of the program
    /// (taken as 0), or a position of the machine.
    bool start_assumed = false;
    /// The target is from G53, G28 or G30. The target in W is known only if the position of W in
    /// the machine is specified.
    bool machine_coordinates = false;
    /// Programmed in a coordinate system whose distance from W is unspecified; the system is taken
    /// as W.
    bool offset_unknown = false;
    /// Turns a rotary axis that an M code clamps.
    bool turns_clamped = false;
    /// M0 came after the spindle start; on many machines M0 stops the spindle.
    bool spindle_in_doubt = false;
    /// The spindle is held in a direction: M19, or the ways in G76 and G87 on which it is.
    bool spindle_oriented = false;
    /// In such a cycle: true if the tool steps aside (Q), which is not part of the motion.
    std::optional<bool> steps_aside;
    /// The frame in which the motion was programmed; never null for motions of interpret().
    std::shared_ptr<const ProgramFrame> frame;
};

/// Returns the start or the end of a move (Linear, Arc, Spline); nullptr for dwells and tool
/// changes.
const Position* start_of(const Motion& motion);
const Position* end_of(const Motion& motion);

}  // namespace ncsim::gcode
