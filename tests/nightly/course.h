// SPDX-License-Identifier: GPL-3.0-or-later
//
// Path of a tool during a move, as formulas: a line or an arc, with or without rotation about the
// axes through the origin of W:
//
//    p_W = Rz(C) Ry(B) Rx(A) (p_T + x)
//
// where x, A, B and C are linear in the parameter t in [0, 1]; on an arc the angle is linear in t.
#pragma once

#include "nightly/vec.h"

#include <array>
#include <optional>

namespace ncsim::nightly {

struct Axes {
    Vec x{};     ///< X, Y, Z in mm.
    Vec turn{};  ///< A, B, C in degrees.
};

/// Arc in the plane of two linear axes, with positive angles from `first` to `second`. The radius
/// changes linearly with the angle. The third axis is linear.
struct Circling {
    std::size_t first = 0, second = 1;
    std::array<double, 2> centre{};
    double start_angle = 0.0, sweep = 0.0;  ///< Radians; a positive sweep is counter-clockwise.
    double start_radius = 0.0, end_radius = 0.0;
};

class Course {
public:
    static Course straight(const Axes& from, const Axes& to);
    /// Returns the arc between `from` and `to`, counter-clockwise or clockwise, with `more_turns`
    /// additional full turns. Ends that coincide in the plane give a full turn.
    static Course arc(const Axes& from, const Axes& to, std::size_t first, std::size_t second,
                      std::array<double, 2> centre, bool counter_clockwise, int more_turns);

    const Axes& from() const { return from_; }
    const Axes& to() const { return to_; }
    bool is_straight() const { return !circling_; }
    /// True if the orientation changes during the move.
    bool turns() const { return from_.turn != to_.turn; }
    /// True if A, B or C is not 0 at any time of the move.
    bool is_turned() const { return turns() || from_.turn != Vec{}; }
    /// True if A, B and C are constant multiples of 90°.
    bool is_square() const;
    const std::optional<Circling>& circling() const { return circling_; }

    /// Returns the rotation about the tool axis (rad) relative to the least rotation that gives the
    /// same axis, which keeps the direction perpendicular to the axis and to Z. The twist of A, B
    /// and C is invisible for a round tool but not for its polygon.
    double twist(double t) const;

    Vec to_tool(double t, const Vec& p_W) const;
    Vec to_workpiece(double t, const Vec& p_T) const;
    /// Returns a bound of the second derivative of to_tool(t, p_W) with respect to t, mm.
    double bend(const Vec& p_W) const;
    /// Returns a bound of the coordinates that occur in to_tool(t, p_W), mm. Rounding is
    /// proportional to the bound.
    double magnitude(const Vec& p_W) const;

private:
    Vec linear_at(double t) const;
    Vec turn_at(double t) const;

    Axes from_, to_;
    std::optional<Circling> circling_;
};

}  // namespace ncsim::nightly
