// SPDX-License-Identifier: GPL-3.0-or-later
//
// The way of a tool during one move, as formulas: straight or along an arc, with or without turning
// about the axes through the origin of W:
//
//     p_W = Rz(C) Ry(B) Rx(A) (p_T + x)
//
// where x, A, B and C run in step with the parameter t in [0, 1] (on an arc with its angle).
#pragma once

#include "nightly/vec.h"

#include <array>
#include <optional>

namespace ncsim::nightly {

struct Axes {
    Vec x{};     ///< X, Y, Z in mm.
    Vec turn{};  ///< A, B, C in degrees.
};

/// In the plane of two of the linear axes, the first turning into the second; the radius changes
/// linearly with the angle. The third axis is linear.
struct Circling {
    std::size_t first = 0, second = 1;
    std::array<double, 2> centre{};
    double start_angle = 0.0, sweep = 0.0;  ///< Radians; a positive sweep is counter-clockwise.
    double start_radius = 0.0, end_radius = 0.0;
};

class Course {
public:
    static Course straight(const Axes& from, const Axes& to);
    /// From `from` to `to`, counter-clockwise or clockwise, with so many more full turns; ends that
    /// are equal in the plane make one turn.
    static Course arc(const Axes& from, const Axes& to, std::size_t first, std::size_t second,
                      std::array<double, 2> centre, bool counter_clockwise, int more_turns);

    const Axes& from() const { return from_; }
    const Axes& to() const { return to_; }
    bool is_straight() const { return !circling_; }
    /// Does the orientation change on the way?
    bool turns() const { return from_.turn != to_.turn; }
    /// Is it turned at all?
    bool is_turned() const { return turns() || from_.turn != Vec{}; }
    /// Does it stand in one orientation of right angles?
    bool is_square() const;
    const std::optional<Circling>& circling() const { return circling_; }

    /// A, B and C turn a tool about itself, too, which no round tool shows but its polygon does: so
    /// far (radians, about the axis of the tool) from standing as the least rotation puts it, the
    /// one that keeps what is at right angles to its axis and to Z.
    double twist(double t) const;

    Vec to_tool(double t, const Vec& p_W) const;
    Vec to_workpiece(double t, const Vec& p_T) const;
    /// A bound on the second derivative of to_tool(t, p_W) by t, mm.
    double bend(const Vec& p_W) const;
    /// A bound on the coordinates that occur in to_tool(t, p_W), mm: what rounding scales with.
    double magnitude(const Vec& p_W) const;

private:
    Vec linear_at(double t) const;
    Vec turn_at(double t) const;

    Axes from_, to_;
    std::optional<Circling> circling_;
};

}  // namespace ncsim::nightly
