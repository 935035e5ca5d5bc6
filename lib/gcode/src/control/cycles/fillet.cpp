// SPDX-License-Identifier: GPL-3.0-or-later
//
// The centre of the arc has the distance `radius` from both elements: it is an intersection of two
// parallel lines or concentric circles.
#include "control/cycles/fillet.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ncsim::gcode {
namespace {

/// Rounding tolerance of lengths, in program units.
constexpr double kFilletRounding = 1e-9;

double distance(Vec2 a, Vec2 b) {
    return hypotenuse(b.x - a.x, b.y - a.y);
}

/// Points at the same distance from an element: a line, or a circle.
struct Locus {
    Vec2 point;      ///< Point of the line, or centre of the circle.
    Vec2 direction;  ///< Unit vector of the line.
    bool is_circle = false;
    double radius = 0.0;
};

Locus locus_of(const PlaneElement& element, Vec2 corner, double radius, double side) {
    if (element.is_arc)
        return {element.centre, {}, true, element.radius() - radius * side * element.turn};
    const Vec2 d = element.direction_at(corner);
    return {{corner.x - side * radius * d.y, corner.y + side * radius * d.x}, d, false, 0.0};
}

/// Returns the intersections of the circle `a` and the locus `b`.
std::vector<Vec2> intersections(const Locus& a, const Locus& b) {
    if (!(a.radius > kFilletRounding) || (b.is_circle && !(b.radius > kFilletRounding))) return {};
    Vec2 base;
    Vec2 direction = b.direction;
    if (b.is_circle) {
        const double apart = distance(a.point, b.point);
        if (apart <= kFilletRounding) return {};
        const double x = (b.point.x - a.point.x) / apart;
        const double y = (b.point.y - a.point.y) / apart;
        const double along =
            (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2.0 * apart);
        base = {a.point.x + along * x, a.point.y + along * y};
        direction = {-y, x};
    } else {
        const double along =
            (a.point.x - b.point.x) * direction.x + (a.point.y - b.point.y) * direction.y;
        base = {b.point.x + along * direction.x, b.point.y + along * direction.y};
    }
    const double off = distance(a.point, base);
    if (off > a.radius + kFilletRounding) return {};
    const double half = std::sqrt(std::max(0.0, a.radius * a.radius - off * off));
    return {{base.x + half * direction.x, base.y + half * direction.y},
            {base.x - half * direction.x, base.y - half * direction.y}};
}

}  // namespace

double PlaneElement::radius() const {
    return distance(centre, from);
}

double PlaneElement::length() const {
    if (!is_arc) return distance(from, to);
    const double length = way(from, to);
    return length > 0.0 ? length : 2.0 * std::numbers::pi * radius();
}

Vec2 PlaneElement::direction_at(Vec2 p) const {
    const double size = is_arc ? radius() : distance(from, to);
    if (is_arc) return {-turn * (p.y - centre.y) / size, turn * (p.x - centre.x) / size};
    return {(to.x - from.x) / size, (to.y - from.y) / size};
}

double PlaneElement::way(Vec2 a, Vec2 b) const {
    if (!is_arc) {
        const Vec2 d = direction_at(a);
        return (b.x - a.x) * d.x + (b.y - a.y) * d.y;
    }
    constexpr double kTurn = 360.0;
    const double begin = angle_of(a.x - centre.x, a.y - centre.y);
    const double end = angle_of(b.x - centre.x, b.y - centre.y);
    double angle = turn * (end - begin);
    angle -= kTurn * std::floor(angle / kTurn);
    const double per_degree = radius() * std::numbers::pi / 180.0;
    return (kTurn - angle) * per_degree <= kFilletRounding ? 0.0 : angle * per_degree;
}

Vec2 PlaneElement::foot(Vec2 p) const {
    const Vec2& base = is_arc ? centre : from;
    const double x = p.x - base.x;
    const double y = p.y - base.y;
    if (is_arc) {
        const double factor = radius() / hypotenuse(x, y);
        return {centre.x + factor * x, centre.y + factor * y};
    }
    const Vec2 d = direction_at(from);
    const double along = x * d.x + y * d.y;
    return {from.x + along * d.x, from.y + along * d.y};
}

std::optional<Fillet> fillet(const PlaneElement& first, const PlaneElement& second, double radius,
                             double side) {
    const Vec2 corner = first.to;
    const Locus a = locus_of(first, corner, radius, side);
    const Locus b = locus_of(second, corner, radius, side);
    std::optional<Fillet> best;
    double shortest = 0.0;
    for (const Vec2& centre : a.is_circle ? intersections(a, b) : intersections(b, a)) {
        const Fillet found{first.foot(centre), second.foot(centre), centre};
        const double before = first.way(found.begin, corner);
        const double after = second.way(corner, found.end);
        const bool fits = before >= -kFilletRounding &&
                          before <= first.length() + kFilletRounding && after >= -kFilletRounding &&
                          after <= second.length() + kFilletRounding;
        if (!fits || (best && before + after >= shortest)) continue;
        best = found;
        shortest = before + after;
    }
    return best;
}

}  // namespace ncsim::gcode
