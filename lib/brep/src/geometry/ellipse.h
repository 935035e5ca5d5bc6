// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a point is from an ellipse.
#pragma once

namespace ncsim::brep {

struct EllipseFoot {
    double distance = 0.0;    ///< Negative inside.
    double x = 0.0, y = 0.0;  ///< Normal, unit, outwards.
};

/// Of the ellipse about the origin with half axes `a` >= `b` along X and Y the point nearest to
/// (x, y).
EllipseFoot foot_on_ellipse(double a, double b, double x, double y);

}  // namespace ncsim::brep
