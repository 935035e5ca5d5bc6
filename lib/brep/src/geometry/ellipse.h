// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distance of a point from an ellipse.
#pragma once

namespace ncsim::brep {

/// Point of an ellipse that is nearest to a given point.
struct EllipseFoot {
    double distance = 0.0;    ///< Negative inside.
    double x = 0.0, y = 0.0;  ///< Unit normal, outwards.
};

/// Returns the point nearest to (x, y) on the ellipse about the origin with the half axes `a` >=
/// `b` along X and Y.
EllipseFoot foot_on_ellipse(double a, double b, double x, double y);

}  // namespace ncsim::brep
