// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method for the only parameter t for which (x a² / (t + a²), y b² / (t + b²)) lies on the
// ellipse, started where t can only grow.
// Source: Eberly, Distance from a Point to an Ellipse, 2013.
#include "geometry/ellipse.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>

namespace ncsim::brep {

EllipseFoot foot_on_ellipse(double a, double b, double x, double y) {
    const double u = std::abs(x), v = std::abs(y), a2 = a * a, b2 = b * b;
    double px = 0.0, py = 0.0;
    if (v * b2 <= 1e-30 * a2 * a && u * a <= a2 - b2) {
        px = a2 * u / (a2 - b2);
        py = b * std::sqrt(std::max(0.0, 1.0 - px * px / a2));
    } else {
        double t = std::max(a * u - a2, b * v - b2);
        for (int step = 0; step < 2 * kMostSteps; ++step) {
            const double p = a * u / (t + a2), q = b * v / (t + b2);
            const double f = p * p + q * q - 1.0;
            const double slope = -2.0 * (p * p / (t + a2) + q * q / (t + b2));
            const double next = t - f / slope;
            if (!(next > t)) break;
            t = next;
        }
        px = a2 * u / (t + a2);
        py = b2 * v / (t + b2);
    }
    const double nx = px / a2, ny = py / b2;
    const double length = std::sqrt(nx * nx + ny * ny);
    EllipseFoot foot{0.0, nx / length, ny / length};
    foot.distance = (u - px) * foot.x + (v - py) * foot.y;
    if (x < 0.0) foot.x = -foot.x;
    if (y < 0.0) foot.y = -foot.y;
    return foot;
}

}  // namespace ncsim::brep
