// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the axes are along a motion.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/machine.h"

#include <cstddef>
#include <vector>

namespace ncsim::toolpath {

inline double lerp(double a, double b, double t) {
    return a + t * (b - a);
}

/// An arc in polar coordinates about its centre: radius and angle run from start to end in step.
struct Polar {
    double centre_1 = 0, centre_2 = 0;
    double start_degrees = 0, sweep_degrees = 0;
    double start_radius = 0, end_radius = 0;
};

Polar polar(const gcode::Arc& arc);
/// t from 0 to 1; the ends come out exactly. `p`: its polar().
gcode::Position on_arc(const gcode::Arc& arc, const Polar& p, double t);

/// What U, V and W do to the tip where X, Y and Z do not tell it themselves (Poses::shift()).
struct SecondAxes {
    double reach_mm = 0.0;   ///< They move it no farther, at any time of the motion.
    double way_mm = 0.0;     ///< How far they go themselves, seen from what they are on.
    bool along_tool = true;  ///< All the way: turns of the tool about itself change nothing.
};
SecondAxes second_axes(const machine::Chain& chain, const gcode::Motion& motion);

/// A rational B-spline.
class SplineCurve {
public:
    /// `motion` must outlive it.
    explicit SplineCurve(const gcode::Spline& motion) : m_(motion), degree_(motion.order - 1) {}

    bool is_sound() const;
    double first() const { return m_.knots[static_cast<std::size_t>(degree_)]; }
    double last() const { return m_.knots[m_.control_points.size()]; }
    /// Parameters at which the curve may have a corner, from the first to the last.
    std::vector<double> breaks() const;
    gcode::Position at(double u) const;

private:
    const gcode::Spline& m_;
    int degree_;
};

}  // namespace ncsim::toolpath
