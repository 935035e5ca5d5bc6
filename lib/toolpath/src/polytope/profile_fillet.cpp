// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounded corners of a profile.
#include "polytope/profile_fillet.h"

#include "ncsim/base/angles.h"

namespace ncsim::toolpath {

double Fillet::angle_to(Vec2 d) const {
    return angle_of(dot(d1, d), cross(d1, d));
}

Vec2 Fillet::meet_end_line(Vec2 from, Vec2 d) const {
    return from + (cross(end - from, d2) / cross(d, d2)) * d;
}

Fillet fillet_of(Vec2 before, Vec2 corner, Vec2 after, double rho) {
    Fillet f;
    f.d1 = normalized(corner - before);
    f.d2 = normalized(after - corner);
    f.rho = rho;
    f.turn_degrees = angle_of(dot(f.d1, f.d2), cross(f.d1, f.d2));
    const double leg = rho * cross(f.d1, f.d2) / (1 + dot(f.d1, f.d2));
    f.start = corner - leg * f.d1;
    f.end = corner + leg * f.d2;
    f.centre = f.start + rho * left_normal(f.d1);
    return f;
}

std::vector<Vec2> corners_of(const std::vector<ProfilePoint>& profile, double unit_mm) {
    std::vector<Vec2> points;
    points.reserve(profile.size());
    for (const ProfilePoint& p : profile)
        points.push_back({p.radius / unit_mm, p.height / unit_mm});
    return points;
}

Vec2 previous_point(const std::vector<Vec2>& points, std::size_t i) {
    return i > 0 ? points[i - 1] : Vec2{0, points[i].y};
}

Vec2 next_point(const std::vector<Vec2>& points, std::size_t i) {
    return i + 1 < points.size() ? points[i + 1] : Vec2{0, points[i].y};
}

std::vector<Fillet> fillets_of(const std::vector<ProfilePoint>& profile, double unit_mm) {
    const std::vector<Vec2> points = corners_of(profile, unit_mm);
    std::vector<Fillet> fillets;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (profile[i].fillet <= 0) continue;
        fillets.push_back(fillet_of(previous_point(points, i), points[i], next_point(points, i),
                                    profile[i].fillet / unit_mm));
    }
    return fillets;
}

}  // namespace ncsim::toolpath
