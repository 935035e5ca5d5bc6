// SPDX-License-Identifier: GPL-3.0-or-later
//
// Let e be the unit vector from the axis a to a point of the circle, R the radius, V the velocity
// of the centre. The point moves with w = V - R (a' e) a. The swept surface contains w and the
// tangent of the circle. At the nearest time, w is perpendicular to the vector from the foot to the
// point.
#include "geometry/rim.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ncsim::brep {

namespace {

// Point of the circle that is nearest to a given point, with derivatives.
struct RimPoint {
    RimPoint(const Fillet& rim, const ToolFrame& at, Vec3 p)
        : radius(rim.centre_radius), axis(at.axis) {
        const Vec3 v = p - at.tip;
        const double height = dot(v, axis);
        const Vec3 radial = v - height * axis;
        far = norm(radial);
        out = far > 0.0 ? (1.0 / far) * radial : Vec3{};
        round = cross(axis, out);
        foot = at.tip + rim.height * axis + radius * out;
        centre_speed = velocity_at(at, rim.height);
        speed = centre_speed - (radius * dot(at.turn, out)) * axis;
        // Derivatives of the nearest point by time, with the given point fixed.
        const double slip = far > 0.0 ? dot(at.speed + height * at.turn, round) / far : 0.0;
        out_change = -slip * round - dot(out, at.turn) * axis;
        centre_change = at.change + rim.height * at.bend;
        rise_change = dot(at.change, axis) + dot(at.speed, at.turn) -
                      radius * (dot(at.bend, out) + dot(at.turn, out_change));
        ahead_change = dot(centre_change, out) + dot(centre_speed, out_change);
    }
    double ahead() const { return dot(speed, out); }
    double rise() const { return dot(speed, axis); }
    // Returns the outward normal of the swept surface.
    Vec3 normal() const {
        const Vec3 n = normalized(rise() * out - ahead() * axis);
        return rise() < 0.0 ? -n : n;
    }
    double radius, far = 0.0;
    Vec3 axis, out, round, foot;
    Vec3 centre_speed, speed, out_change, centre_change;
    // Derivatives of the speeds along the axis and outwards.
    double rise_change = 0.0, ahead_change = 0.0;
};

// Returns the direction, perpendicular to the axis, to the middle of the swept part.
Vec3 middle_way(const Sweep& sweep, const ToolFrame& tool, const PathFrame& at) {
    const Vec3 ahead = cross(at.side, tool.axis);
    const double rise = dot(velocity_at(tool, sweep.fillet()->height), tool.axis);
    return (rise < 0.0) == (dot(ahead, at.ahead) < 0.0) ? ahead : -ahead;
}

}  // namespace

ClosestPoint closest_point_on_rim(const Fillet& rim, const ToolFrame& at, Vec3 p) {
    const RimPoint on(rim, at, p);
    const Vec3 d = p - on.foot, n = on.normal();
    ClosestPoint closest;
    closest.tool = at;
    closest.normal = n;
    closest.deviation = dot(d, n) < 0.0 ? -norm(d) : norm(d);
    closest.foot = p - closest.deviation * n;
    closest.rate = -dot(d, on.speed);
    const double share = on.far > 0.0 ? on.radius / on.far : 0.0;
    closest.drift =
        share * (dot(on.speed, on.round) + dot(at.turn, on.round) * dot(d, on.axis)) * on.round -
        on.speed;
    const Vec3 d_change = -on.centre_speed - on.radius * on.out_change;
    const Vec3 speed_change =
        on.centre_change -
        on.radius * (dot(at.bend, on.out) + dot(at.turn, on.out_change)) * on.axis -
        (on.radius * dot(at.turn, on.out)) * at.turn;
    closest.bend = -dot(d_change, on.speed) - dot(d, speed_change);
    return closest;
}

std::vector<double> rim_start_times(const Sweep& sweep, Vec3 p) {
    const std::vector<ToolFrame>& samples = sweep.samples();
    const Fillet& rim = *sweep.fillet();
    // Squared distance from the axis; on straight paths a parabola.
    const auto squared_distance = [&](std::size_t i) {
        const Vec3 v = p - samples[i].tip;
        const double height = dot(v, samples[i].axis);
        return dot(v, v) - height * height;
    };
    const bool rises = dot(velocity_at(samples[0], rim.height), samples[0].axis) > 0.0;
    const std::size_t last = samples.size() - 1;
    std::vector<double> starts;
    double before = squared_distance(0), here = squared_distance(1);
    for (std::size_t i = 1; i < last; ++i) {
        const double after = squared_distance(i + 1);
        const bool is_lowest = (i == 1 || here <= before) && (i + 1 == last || here < after) &&
                               after + before > 2.0 * here;
        if (is_lowest) {
            const double slope = 0.5 * (after - before), bend = after - 2.0 * here + before;
            const double square =
                slope * slope - 2.0 * bend * (here - rim.centre_radius * rim.centre_radius);
            const double out = square > 0.0 ? std::sqrt(square) : 0.0;
            const double ahead = (-slope + (rises ? -out : out)) / bend;
            const double most = static_cast<double>(last);
            starts.push_back(std::clamp((static_cast<double>(i) + ahead) / most, -kPathExtension,
                                        1.0 + kPathExtension));
        }
        before = here;
        here = after;
    }
    if (starts.empty()) starts.push_back(0.5);
    return starts;
}

Vec3 gradient_of_rise_of_rim(const Fillet& rim, const ClosestPoint& closest) {
    const ToolFrame& at = closest.tool;
    const RimPoint on(rim, at, closest.foot + closest.deviation * closest.normal);
    if (!(on.far > 0.0)) return {};
    const double ahead = on.ahead(), rise = on.rise();
    const double square = ahead * ahead + rise * rise;
    const Vec3 time = gradient_of_time(closest);
    const Vec3 ahead_slope =
        (dot(on.centre_speed, on.round) / on.far) * on.round + on.ahead_change * time;
    const Vec3 rise_slope =
        -(on.radius * dot(at.turn, on.round) / on.far) * on.round + on.rise_change * time;
    const double cosine = std::abs(rise) / std::sqrt(square);
    return (-cosine / square) * (rise * ahead_slope - ahead * rise_slope);
}

double place_on_rim(const Sweep& sweep, const ToolFrame& tool, Vec3 p) {
    const PathFrame at = path_frame(sweep, tool);
    const Vec3 v = p - at.centre;
    const double degrees = angle_of(dot(v, middle_way(sweep, tool, at)), dot(v, at.side));
    return kHalfTurnDegrees - degrees;
}

Vec3 point_on_rim(const Sweep& sweep, const ToolFrame& tool, double place) {
    const PathFrame at = path_frame(sweep, tool);
    const auto angle = sin_cos(kHalfTurnDegrees - place);
    const Vec3 out = angle.cos * middle_way(sweep, tool, at) + angle.sin * at.side;
    return at.centre + sweep.fillet()->centre_radius * out;
}

}  // namespace ncsim::brep
