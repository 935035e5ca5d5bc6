// SPDX-License-Identifier: GPL-3.0-or-later
//
// Circles whose arcs end exactly in their corners.
#include "geometry/arc_ends.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>

namespace ncsim::brep {

std::optional<Circle> circle_through(const Circle& circle, Vec3 tangent_at, Vec3 other) {
    const Vec3 out = radial_vector(circle.centre, circle.axis, tangent_at);
    const Vec3 chord = radial_vector(tangent_at, circle.axis, other);
    const double reach = norm(out), into = -dot(chord, out);
    if (!(into > 0.0)) return std::nullopt;
    const double radius = 0.5 * dot(chord, chord) * reach / into;
    const double height = dot(tangent_at - circle.centre, circle.axis);
    // The new circle deviates most from the old circle in `tangent_at` and opposite.
    const double deviation =
        std::max(std::abs(reach - circle.radius), std::abs(2.0 * radius - reach - circle.radius));
    if (!(deviation <= 2.0 * kReaderMm) || std::abs(height) > 2.0 * kReaderMm) return std::nullopt;
    return Circle{circle.centre + (1.0 - radius / reach) * out, circle.axis, radius};
}

double angle_between(const Circle& a, const Circle& b, Vec3 p) {
    const Vec3 one = radial_vector(a.centre, a.axis, p), two = radial_vector(b.centre, b.axis, p);
    const double lengths = norm(one) * norm(two);
    return lengths > 0.0 ? norm(cross(one, two)) / lengths : 0.0;
}

}  // namespace ncsim::brep
