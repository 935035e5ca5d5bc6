// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an NC program makes the machine do: the values that leave lib/gcode.
//
// Frame W (workpiece): the coordinate system (G54, say) that is active at the first cutting move,
// as it stands then: stock and fixtures are clamped where the program's zero is, so a G10 before it
// moves them along, and one after it does not. Without tool length offset and without
// G52/G68; with G92 only where it told an axis its place (a zero that was set by hand). Every
// position below is absolute and in W, whatever offsets, units, scales and rotations the program
// used on the way, and belongs to the *controlled point* (the tool tip, if tool lengths are entered
// as measured). Units have ended here: lengths are Length, angles Angle.
#pragma once

#include "ncsim/gcode/feature_frame.h"
#include "ncsim/gcode/source.h"
#include "ncsim/gcode/units.h"

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace ncsim::gcode {

/// Where all axes are. Rotary axes are not wrapped.
struct Position {
    Length x, y, z;
    Angle a, b, c;
    Length u, v, w;
    bool operator==(const Position&) const = default;
};

enum class Plane : std::uint8_t { XY, ZX, YZ, UV, WU, VW };  ///< G17, G18, G19, G17.1, G18.1, G19.1

/// A straight move, all axes in step.
struct Linear {
    Position from, to;
    bool operator==(const Linear&) const = default;
};

/// A circular or helical move. In `plane`, seen from the positive end of its normal (for ZX: Y
/// towards the viewer), with first and second axis X,Y (XY), Z,X (ZX), Y,Z (YZ). The third
/// axis and the rotary axes run in step with the angle. Where `from` and `to` are not equally far
/// from the centre, the radius changes linearly with the angle (a spiral).
struct Arc {
    Position from, to;
    Plane plane = Plane::XY;
    Length centre_1, centre_2;  ///< Along the first and the second axis of the plane.
    int turns = 1;  ///< > 0 counter-clockwise, < 0 clockwise; |turns| - 1 extra full circles.
    /// In a tilted plane, mm: plane and centre are those of this frame of W. The ends are in W.
    std::optional<FeatureFrame> tilted;
    bool operator==(const Arc&) const = default;
};
/// The same arc with its ends in the frame of its plane, too, which then is not tilted.
Arc in_own_frame(const Arc& arc);
/// X, Y and Z of a position of `frame` (mm) in the frame it is told in; the other axes as they are.
Position outward(const FeatureFrame& frame, const Position& p);

/// A non-uniform rational B-spline (G5, G5.1, G5.2) in X and Y of W, the other axes constant.
struct Spline {
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

struct Dwell {
    double seconds = 0.0;
    bool operator==(const Dwell&) const = default;
};

/// The tool in the spindle from here on; 0: none. `at` is where the machine stands (M6 does not
/// move).
struct ToolChange {
    int tool = 0;
    Position at;
    bool operator==(const ToolChange&) const = default;
};

enum class SpindleTurning : std::uint8_t { Stopped, Clockwise, Counterclockwise };
/// Coolant by M7, M8 and M9. M codes that a machine builder adds do not count.
struct Coolant {
    bool mist = false, flood = false;
    bool operator==(const Coolant&) const = default;
};
enum class FeedMode : std::uint8_t { PerMinute, InverseTime, PerRevolution };

/// How a move is made.
enum class MoveKind : std::uint8_t {
    Rapid,  ///< G0, also inside cycles, G28 and the like
    Feed,   ///< G1, G2, G3, cycles
    Probe,  ///< G38.x, G31: assumed to make contact at its target
};
/// "rapid", "feed" or "probe".
const char* name_of(MoveKind kind);

/// What X, Y and Z of a motion are.
enum class Coordinates : std::uint8_t {
    Axes,  ///< Where the linear axes stand, less offsets: rotary axes turn that away from W.
    Tip,   ///< Where the tip is in W, which turns with the table: the control moves the axes.
};

/// Which axes of a start position were never set by the program: what is known of
/// where a move begins. A move whose start is unknown in an axis must not cut a phantom path.
struct KnownAxes {
    bool x = true, y = true, z = true;
    bool all() const { return x && y && z; }
    bool any() const { return x || y || z; }
    bool operator==(const KnownAxes&) const = default;
};

/// One thing the machine does, with everything a later stage asks of it.
struct Motion {
    std::variant<Linear, Arc, Spline, Dwell, ToolChange> what;
    SourceSpan span;         ///< The block that made it (its main word).
    std::uint32_t file = 0;  ///< Index into Interpretation::files; 0 is the program itself.
    MoveKind kind = MoveKind::Feed;
    FeedMode feed_mode = FeedMode::PerMinute;
    /// mm/min (degrees/min for purely rotary moves), 1/min or mm/rev by `feed_mode`. 0: never set.
    double feed = 0.0;
    SpindleTurning spindle = SpindleTurning::Stopped;
    double spindle_rpm = 0.0;  ///< As programmed by S; 0: never set.
    Coolant coolant;
    int tool = 0;  ///< In the spindle, 0: none was called.
    Coordinates coordinates = Coordinates::Axes;
    Length length;  ///< Of the tool as the control counts it (G43), along Z.
    KnownAxes known_start, known_end;
    /// Some axis is known by incremental words only, from a place that nobody told: the start of
    /// the program (taken as 0), or a place of the machine.
    bool start_assumed = false;
    /// The target came from G53, G28, G30: W knows it only if the place of W in the machine is
    /// told.
    bool machine_coordinates = false;
    /// Programmed in a coordinate system of which nobody told how far it is from W; taken to be W.
    bool offset_unknown = false;
    /// A rotary axis turns that an M code holds.
    bool turns_clamped = false;
    /// M0 came since the spindle was started: on many machines it stands still.
    bool spindle_in_doubt = false;
    /// The spindle is held in a direction: M19, or the ways in G76 and G87 on which it is.
    bool spindle_oriented = false;
    /// In such a cycle: true if the tool steps aside (Q), which is not part of the motion.
    std::optional<bool> steps_aside;
};

/// Start and end of a motion; both the machine's place for dwells and tool changes is unknown here,
/// so only moves (Linear, Arc, Spline) have them.
const Position* start_of(const Motion& motion);
const Position* end_of(const Motion& motion);

}  // namespace ncsim::gcode
