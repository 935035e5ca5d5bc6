// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axis positions along arcs and splines.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/kinematics.h"

#include <cstddef>
#include <vector>

namespace ncsim::toolpath {

inline double lerp(double a, double b, double t) {
    return a + t * (b - a);
}

/// An arc in polar coordinates about its centre; radius and angle change linearly from start to
/// end. mm.
struct PolarArc {
    double centre_1 = 0, centre_2 = 0;
    double start_degrees = 0, sweep_degrees = 0;
    double start_radius = 0, end_radius = 0;
};

/// Converts an arc to polar coordinates, in the arc's own frame if its plane is tilted.
PolarArc polar(const gcode::Arc& arc);
/// Returns the position at `t` from 0 to 1; t = 0 and t = 1 give the ends exactly. `p` is
/// polar(`arc`).
gcode::Position arc_position(const gcode::Arc& arc, const PolarArc& p, double t);

/// Bounds on the shift of the tip by U, V and W where X, Y and Z do not include it
/// (Poses::shift()).
struct SecondAxes {
    /// Largest distance by which the axes shift the tip, at any time of the motion.
    double reach_mm = 0.0;
    double way_mm = 0.0;  ///< Length of the axes' own path, seen from the bodies that carry them.
    /// True if the shift is always along the tool, so rotations about the tool axis do not change
    /// it.
    bool along_tool = true;
};
/// Returns the bounds for `motion` on the machine `chain`.
SecondAxes second_axes(const machine::Chain& chain, const gcode::Motion& motion);

/// A rational B-spline.
class SplineCurve {
public:
    /// Requires: `motion` outlives this object.
    explicit SplineCurve(const gcode::Spline& motion) : m_(motion), degree_(motion.order - 1) {}

    /// True if order, control points and knots form a valid curve.
    bool is_sound() const;
    double first() const { return m_.knots[static_cast<std::size_t>(degree_)]; }
    double last() const { return m_.knots[m_.control_points.size()]; }
    /// Returns the parameters at which the curve may have a corner, from the first to the last.
    std::vector<double> breaks() const;
    /// Returns the position at parameter `u`.
    gcode::Position at(double u) const;

private:
    const gcode::Spline& m_;
    int degree_;
};

}  // namespace ncsim::toolpath
