// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts of each form by a plane.
#include "geometry/plane_cut.h"

#include "ncsim/base/angles.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>

namespace ncsim::brep {

PlaneCut::PlaneCut(const Form& form, const CutPlane& plane) : plane_(plane) {
    std::visit([this](const auto& f) { this->cut(f); }, form);
    if (kind_ == Kind::Straight || kind_ == Kind::Round) count_ = branches_.size();
}

void PlaneCut::add(const CutBranch& branch) {
    branches_.push_back(branch);
}

void PlaneCut::cut(const Plane& f) {
    const Vec3 along = cross(plane_.normal, f.normal);
    if (norm(along) < kRounding) return;
    kind_ = Kind::Straight;
    // Point of both planes that is nearest to the origin of `f`.
    const Vec3 level = normalized(cross(f.normal, along));
    const double slope = dot(level, plane_.normal);
    add({f.origin - (plane_.height(f.origin) / slope) * level, normalized(along), {}});
}

void PlaneCut::cut(const Cylinder& f) {
    const double cosine = dot(f.axis, plane_.normal);
    if (std::abs(cosine) < kRounding) {
        kind_ = Kind::Straight;
        const double h = plane_.height(f.origin);
        if (std::abs(h) > f.radius) return;
        const Vec3 foot = f.origin - h * plane_.normal;
        const Vec3 side = normalized(cross(f.axis, plane_.normal));
        const double half = std::sqrt(f.radius * f.radius - h * h);
        add({foot + half * side, f.axis, {}});
        add({foot - half * side, f.axis, {}});
        return;
    }
    kind_ = Kind::Round;
    const Vec3 centre = f.origin - (plane_.height(f.origin) / cosine) * f.axis;
    Vec3 x = f.axis - cosine * plane_.normal;
    double longer = f.radius / std::abs(cosine);
    if (norm(x) < kRounding) {
        x = any_perpendicular(plane_.normal);
        longer = f.radius;
    }
    x = normalized(x);
    add({centre, longer * x, f.radius * cross(plane_.normal, x)});
}

void PlaneCut::cut(const Cone& f) {
    const double cosine = dot(f.axis, plane_.normal);
    const double h = -plane_.height(f.apex);  // Distance of the plane in front of the apex.
    const Vec3 lean = plane_.normal - cosine * f.axis;
    const double sine = norm(lean);
    through_apex_ = std::abs(h) <= 4.0 * kPointError;
    if (sine < kRounding) {
        kind_ = Kind::Round;
        const double height = h / cosine;
        if (height <= 0.0) return;
        const Vec3 x = any_perpendicular(plane_.normal);
        const double radius = f.slope * height;
        add({f.apex + height * f.axis, radius * x, radius * cross(plane_.normal, x)});
        return;
    }
    const Vec3 side = normalized(lean);
    // Rulings in the plane of axis and normal meet the plane at h / first and h / second along the
    // axis.
    const double first = cosine + f.slope * sine, second = cosine - f.slope * sine;
    if (!through_apex_ && first * second > kLeastSine * kLeastSine) {
        kind_ = Kind::Round;
        if (h / first <= 0.0) return;
        const Vec3 a = f.apex + (h / first) * (f.axis + f.slope * side);
        const Vec3 b = f.apex + (h / second) * (f.axis - f.slope * side);
        const Vec3 centre = 0.5 * (a + b), x = 0.5 * (a - b);
        // Half width of the cone at the centre, perpendicular to the axis and to `side`.
        const Vec3 v = centre - f.apex;
        const double height = dot(v, f.axis), deviation = dot(v, side);
        const double minor =
            std::sqrt(std::max(0.0, f.slope * f.slope * height * height - deviation * deviation));
        add({centre, x, minor * normalized(cross(plane_.normal, x))});
        return;
    }
    if (!through_apex_ && first * second > -(kLeastSine * kLeastSine)) return;  // nearly a parabola
    if (through_apex_ && first * second > 0.0) {
        kind_ = Kind::Nothing;
        return;
    }
    kind_ = Kind::Conic;
    count_ = 1;
    origin_ = f.apex;
    axis_ = f.axis;
    slope_ = f.slope;
    offset_ = h;
    // The branch lies on the plane's side of the axis, away from the jump of the angle.
    x_ = h < 0.0 ? -side : side;
    y_ = cross(axis_, x_);
}

void PlaneCut::cut(const Sphere& f) {
    kind_ = Kind::Round;
    const double h = plane_.height(f.centre);
    if (std::abs(h) >= f.radius) return;
    const Vec3 x = any_perpendicular(plane_.normal);
    const double radius = std::sqrt(f.radius * f.radius - h * h);
    add({f.centre - h * plane_.normal, radius * x, radius * cross(plane_.normal, x)});
}

void PlaneCut::cut(const Torus& f) {
    const double cosine = dot(f.axis, plane_.normal);
    const double h = plane_.height(f.centre);
    if (norm(cross(f.axis, plane_.normal)) < kRounding) {
        kind_ = Kind::Round;
        if (std::abs(h) >= f.minor) return;
        const double half = std::sqrt(f.minor * f.minor - h * h);
        const Vec3 centre = f.centre - h * plane_.normal, x = any_perpendicular(plane_.normal);
        for (const double radius : {f.major + half, f.major - half}) {
            // No face of a spindle lies beyond the tip.
            if (radius > 0.0) add({centre, radius * x, radius * cross(plane_.normal, x)});
        }
        return;
    }
    if (std::abs(cosine) > kRounding) return;
    kind_ = Kind::Spiric;
    if (std::abs(h) >= f.major + f.minor) return;
    major_ = f.major;
    minor_ = f.minor;
    offset_ = std::abs(h);
    origin_ = f.centre - h * plane_.normal;
    axis_ = f.axis;
    x_ = normalized(cross(f.axis, plane_.normal));
    count_ = offset_ < f.major - f.minor ? 2 : 1;
    if (offset_ > 4.0 * kPointError) return;
    for (const double sign : {1.0, -1.0})
        add({f.centre + (sign * f.major) * x_, (sign * f.minor) * x_, f.minor * axis_});
}

void PlaneCut::cut(const Extrusion& f) {
    const double lean = dot(f.along, plane_.normal);
    // Moves vectors of the circle's plane along the line into the cutting plane.
    const auto dropped = [&](Vec3 v) { return v - (dot(v, plane_.normal) / lean) * f.along; };
    if (std::abs(lean) < kRounding) {
        kind_ = Kind::Straight;
        const Vec3 level = plane_.normal - dot(plane_.normal, f.axis) * f.axis;
        const double length = norm(level), h = plane_.height(f.centre) / length;
        if (std::abs(h) > f.radius) return;
        const Vec3 out = (1.0 / length) * level, side = cross(f.axis, out);
        const double half = std::sqrt(f.radius * f.radius - h * h);
        for (const double sign : {1.0, -1.0})
            add({f.centre - h * out + (sign * half) * side, f.along, {}});
        return;
    }
    kind_ = Kind::Round;
    const Vec3 centre = f.centre - (plane_.height(f.centre) / lean) * f.along;
    const Vec3 start = any_perpendicular(f.axis);
    const Vec3 u = dropped(f.radius * start), v = dropped(f.radius * cross(f.axis, start));
    // Half axes from conjugate diameters.
    const double difference = dot(u, u) - dot(v, v), both = 2.0 * dot(u, v);
    const double length = std::sqrt(difference * difference + both * both);
    double cosine = 1.0, sine = 0.0;
    if (length > kRounding * dot(u, u)) {
        cosine = std::sqrt(0.5 * (1.0 + difference / length));
        sine = std::sqrt(0.5 * (1.0 - difference / length));
        if (both < 0.0) sine = -sine;
    }
    const Vec3 x = cosine * u + sine * v, y = cosine * v - sine * u;
    add({centre, x, dot(cross(x, y), plane_.normal) < 0.0 ? -y : y});
}

// Level planes cut the circle at their height; all other cuts stay unknown.
void PlaneCut::cut(const Dome& f) {
    if (norm(cross(f.axis, plane_.normal)) >= kRounding) return;
    kind_ = Kind::Round;
    const Vec3 foot = f.centre - plane_.height(f.centre) * plane_.normal;
    if (std::abs(plane_.height(f.centre)) >= f.reach) return;
    const Vec3 x = any_perpendicular(plane_.normal);
    add({centre_at_height(f, foot), f.radius * x, f.radius * cross(plane_.normal, x)});
}

void PlaneCut::cut(const Coil& f) {
    if (norm(cross(f.axis, plane_.normal)) >= kRounding) return;
    kind_ = Kind::Round;
    const Vec3 foot = f.centre - plane_.height(f.centre) * plane_.normal;
    const Vec3 x = any_perpendicular(plane_.normal);
    add({place_at_height(f, foot).centre, f.radius * x, f.radius * cross(plane_.normal, x)});
}

std::size_t PlaneCut::branch_of(Vec3 p) const {
    if (count_ < 2) return 0;
    if (kind_ == Kind::Spiric) return dot(p - origin_, x_) > 0.0 ? 0 : 1;
    const auto deviation = [&](const CutBranch& b) {
        if (kind_ == Kind::Straight) return norm(cross(p - b.centre, b.x));
        return std::abs(norm(p - b.centre) - norm(b.x));
    };
    return deviation(branches_[0]) <= deviation(branches_[1]) ? 0 : 1;
}

double PlaneCut::place_of(Vec3 p) const {
    if (kind_ == Kind::Conic) return angle_of(dot(p - origin_, x_), dot(p - origin_, y_));
    if (kind_ == Kind::Spiric) {
        const double out = dot(p - origin_, x_), up = dot(p - origin_, axis_);
        if (count_ == 1) return angle_of(out, up);
        return angle_of(std::sqrt(out * out + offset_ * offset_) - major_, up);
    }
    const CutBranch& b = branches_[branch_of(p)];
    const Vec3 v = p - b.centre;
    if (kind_ == Kind::Straight) return dot(v, b.x);
    return angle_of(dot(v, b.x) / dot(b.x, b.x), dot(v, b.y) / dot(b.y, b.y));
}

Vec3 PlaneCut::at(std::size_t branch, double place) const {
    if (kind_ == Kind::Straight) return branches_[branch].centre + place * branches_[branch].x;
    const auto angle = sin_cos(place);
    if (kind_ == Kind::Conic) {
        // The rulings of a cut through the apex have one place each.
        if (offset_ == 0.0) return origin_;
        const Vec3 ruling = axis_ + slope_ * (angle.cos * x_ + angle.sin * y_);
        return origin_ + (offset_ / dot(plane_.normal, ruling)) * ruling;
    }
    if (kind_ != Kind::Spiric) {
        const CutBranch& b = branches_[branch];
        return b.centre + angle.cos * b.x + angle.sin * b.y;
    }
    if (count_ == 2) {
        const double radial = major_ + minor_ * angle.cos;
        const double out = std::sqrt(std::max(0.0, radial * radial - offset_ * offset_));
        return origin_ + (branch == 0 ? out : -out) * x_ + (minor_ * angle.sin) * axis_;
    }
    // Seen from the middle, there is one point in each direction; nearer points are inside the
    // tube.
    double near = 0.0, far = major_ + minor_;
    for (int i = 0; i < kMostSteps; ++i) {
        const double s = 0.5 * (near + far);
        const double out = s * angle.cos, up = s * angle.sin;
        const double radial = std::sqrt(out * out + offset_ * offset_) - major_;
        (radial * radial + up * up < minor_ * minor_ ? near : far) = s;
    }
    return origin_ + (near * angle.cos) * x_ + (near * angle.sin) * axis_;
}

bool PlaneCut::grows(Vec3 p, Vec3 d) const {
    const std::size_t branch = branch_of(p);
    const double place = place_of(p);
    return dot(at(branch, place + 1e-2) - at(branch, place - 1e-2), d) > 0.0;
}

std::optional<CutBranch> PlaneCut::exact(std::size_t branch) const {
    if (branch >= branches_.size()) return std::nullopt;
    return branches_[branch];
}

std::optional<Vec3> PlaneCut::apex() const {
    if (kind_ != Kind::Conic || !through_apex_) return std::nullopt;
    return origin_;
}

}  // namespace ncsim::brep
