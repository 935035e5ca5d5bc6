// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves that edges lie on. mm, frame W.
#pragma once

#include "ncsim/cda/vec.h"

#include <cstddef>
#include <variant>
#include <vector>

namespace ncsim::brep {

using cda::Vec3;

struct Line {
    bool operator==(const Line&) const = default;
};
/// The edge runs counter-clockwise about `axis` (unit).
struct Circle {
    Vec3 centre, axis;
    double radius = 0.0;
    bool operator==(const Circle&) const = default;
};
/// The edge runs counter-clockwise about `axis`. `major` is a unit vector at right angles to it.
struct Ellipse {
    Vec3 centre, axis, major;
    double major_radius = 0.0, minor_radius = 0.0;
    bool operator==(const Ellipse&) const = default;
};
/// A cubic B-spline. Of the knots, each different, the first and the last count four times, the
/// others twice: there are twice as many control points as knots. It ends in its first and last
/// control point, and goes on smoothly between.
struct Spline {
    std::vector<Vec3> points;
    std::vector<double> knots;
    bool operator==(const Spline&) const = default;
};

using Curve = std::variant<Line, Circle, Ellipse, Spline>;

/// A curve between two points of it: from `from` to `to` for t from 0 to 1. Where both are one,
/// a circle or an ellipse as a whole. Points of a curve that misses its ends by some error miss by
/// as much. The curve must outlive it.
class Track {
public:
    Track(const Curve& curve, Vec3 from, Vec3 to);
    Track(Curve&&, Vec3, Vec3) = delete;

    Vec3 at(double t) const { return step(t).at; }
    Vec3 derivative(double t) const { return step(t).derivative; }  ///< By t.
    struct Step {
        Vec3 at, derivative;
    };
    Step step(double t) const;  ///< Both at once.
    bool is_straight() const { return std::holds_alternative<Line>(*curve_); }
    bool is_spline() const { return std::holds_alternative<Spline>(*curve_); }
    const Circle* circle() const { return std::get_if<Circle>(curve_); }  ///< Null if it is none.
    /// Of circles and ellipses: the angle that is passed, in degrees, in (0, 360].
    double sweep_degrees() const { return sweep_; }
    /// Pieces so short that a polynomial follows each: of 15 degrees, one for each knot.
    std::size_t pieces() const;
    /// Where piece `i` starts, from 0 to 1; of the number of pieces: 1. Knots are not even.
    double start_of(std::size_t i) const;

private:
    const Curve* curve_;
    Vec3 from_, to_;
    Vec3 x_, y_;  // to where the edge starts, and on from there; of an ellipse its half axes
    Vec3 centre_;
    double start_ = 0.0, sweep_ = 0.0;  // degrees
};

}  // namespace ncsim::brep
