// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves on which edges lie. mm, frame W.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstddef>
#include <variant>
#include <vector>

namespace ncsim::brep {

/// Straight line between the ends of the edge.
struct Line {
    bool operator==(const Line&) const = default;
};
/// Circle; the edge runs counter-clockwise about `axis` (unit).
struct Circle {
    Vec3 centre, axis;
    double radius = 0.0;
    bool operator==(const Circle&) const = default;
};
/// Ellipse; the edge runs counter-clockwise about `axis`. `major` is a unit vector perpendicular to
/// `axis`.
struct Ellipse {
    Vec3 centre, axis, major;
    double major_radius = 0.0, minor_radius = 0.0;
    bool operator==(const Ellipse&) const = default;
};
/// Cubic B-spline with distinct knots: the first and the last knot have multiplicity 4, all inner
/// knots multiplicity 2. The number of control points is twice the number of knots. The spline
/// starts at the first control point, ends at the last, and has a continuous tangent.
struct Spline {
    std::vector<Vec3> points;
    std::vector<double> knots;
    bool operator==(const Spline&) const = default;
};

using Curve = std::variant<Line, Circle, Ellipse, Spline>;

/// Part of a curve from `from` (t = 0) to `to` (t = 1); the whole circle or ellipse if the ends are
/// equal. If the curve misses its ends by some error, points of the track miss the curve by the
/// same error. The curve must outlive the track.
class Track {
public:
    Track(const Curve& curve, Vec3 from, Vec3 to);
    Track(Curve&&, Vec3, Vec3) = delete;

    Vec3 at(double t) const { return step(t).at; }
    Vec3 derivative(double t) const { return step(t).derivative; }  ///< By t.
    /// Point and derivative by t.
    struct Step {
        Vec3 at, derivative;
    };
    Step step(double t) const;
    bool is_straight() const { return std::holds_alternative<Line>(*curve_); }
    bool is_ellipse() const { return std::holds_alternative<Ellipse>(*curve_); }
    bool is_spline() const { return std::holds_alternative<Spline>(*curve_); }
    /// Null if the curve is no circle.
    const Circle* circle() const { return std::get_if<Circle>(curve_); }
    /// Angle from start to end of a circle or an ellipse, degrees in (0, 360].
    double sweep_degrees() const { return sweep_; }
    /// Angle at the start, degrees in (-180, 180]: from the major axis of an ellipse; circles start
    /// at 0.
    double start_degrees() const { return start_; }
    /// Returns the number of pieces that are short enough for a polynomial: 15 degrees of a circle
    /// or an ellipse, one piece per knot interval of a spline.
    std::size_t pieces() const;
    /// Returns the parameter at which piece `i` starts, 0 to 1; 1 for i = pieces(). Knot intervals
    /// differ in length.
    double start_of(std::size_t i) const;

private:
    const Curve* curve_;
    Vec3 from_, to_;
    // Vectors from the centre to the start and 90 degrees on; half axes of an ellipse.
    Vec3 x_, y_;
    Vec3 centre_;
    double start_ = 0.0, sweep_ = 0.0;  // degrees
};

}  // namespace ncsim::brep
