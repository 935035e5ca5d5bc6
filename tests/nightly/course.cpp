// SPDX-License-Identifier: GPL-3.0-or-later
//
// Formulas of lines, arcs and rotations.
#include "nightly/course.h"

#include <algorithm>
#include <numbers>

namespace ncsim::nightly {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// Rotates about an axis, counter-clockwise seen from the positive end of the axis.
Vec rotated(const Vec& p, std::size_t axis, double degrees) {
    if (degrees == 0.0) return p;
    const std::size_t i = (axis + 1) % 3;
    const std::size_t j = (axis + 2) % 3;
    const double c = std::cos(degrees * kDegree);
    const double s = std::sin(degrees * kDegree);
    Vec q = p;
    q[i] = c * p[i] - s * p[j];
    q[j] = s * p[i] + c * p[j];
    return q;
}

double sum_of_sizes(const Vec& v) {
    return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

}  // namespace

Course Course::straight(const Axes& from, const Axes& to) {
    Course course;
    course.from_ = from;
    course.to_ = to;
    return course;
}

Course Course::arc(const Axes& from, const Axes& to, std::size_t first, std::size_t second,
                   std::array<double, 2> centre, bool counter_clockwise, int more_turns) {
    Course course = straight(from, to);
    Circling c;
    c.first = first;
    c.second = second;
    c.centre = centre;
    const double x0 = from.x[first] - centre[0];
    const double y0 = from.x[second] - centre[1];
    const double x1 = to.x[first] - centre[0];
    const double y1 = to.x[second] - centre[1];
    c.start_radius = std::sqrt(x0 * x0 + y0 * y0);
    c.end_radius = std::sqrt(x1 * x1 + y1 * y1);
    c.start_angle = std::atan2(y0, x0);
    constexpr double kTurn = 2 * std::numbers::pi;
    double sweep = std::atan2(y1, x1) - c.start_angle;
    const bool is_full = x0 == x1 && y0 == y1;
    if (counter_clockwise) {
        if (is_full || sweep <= 0.0) sweep += kTurn;
    } else {
        if (is_full || sweep >= 0.0) sweep -= kTurn;
    }
    c.sweep = sweep + (counter_clockwise ? kTurn : -kTurn) * more_turns;
    course.circling_ = c;
    return course;
}

bool Course::is_square() const {
    return !turns() && std::all_of(from_.turn.begin(), from_.turn.end(),
                                   [](double degrees) { return std::fmod(degrees, 90.0) == 0.0; });
}

Vec Course::linear_at(double t) const {
    Vec x = from_.x + t * (to_.x - from_.x);
    if (circling_) {
        const Circling& c = *circling_;
        const double angle = c.start_angle + t * c.sweep;
        const double radius = c.start_radius + t * (c.end_radius - c.start_radius);
        x[c.first] = c.centre[0] + radius * std::cos(angle);
        x[c.second] = c.centre[1] + radius * std::sin(angle);
    }
    return x;
}

Vec Course::turn_at(double t) const {
    return turns() ? from_.turn + t * (to_.turn - from_.turn) : from_.turn;
}

Vec Course::to_workpiece(double t, const Vec& p_T) const {
    const Vec turn = turn_at(t);
    Vec p = p_T + linear_at(t);
    for (std::size_t axis = 0; axis < 3; ++axis)
        p = rotated(p, axis, turn[axis]);
    return p;
}

Vec Course::to_tool(double t, const Vec& p_W) const {
    const Vec turn = turn_at(t);
    Vec p = p_W;
    for (std::size_t axis = 3; axis-- > 0;)
        p = rotated(p, axis, -turn[axis]);
    return p - linear_at(t);
}

double Course::twist(double t) const {
    const Vec origin = to_workpiece(t, {});
    const Vec axis = to_workpiece(t, {0, 0, 1}) - origin;
    Vec kept{-axis[1], axis[0], 0.0};
    if (norm(kept) < 1e-12) kept = {1, 0, 0};
    const Vec as_turned = to_tool(t, origin + kept);
    return std::atan2(kept[1], kept[0]) - std::atan2(as_turned[1], as_turned[0]);
}

double Course::bend(const Vec& p_W) const {
    const double turned = turns() ? kDegree * sum_of_sizes(to_.turn - from_.turn) : 0.0;
    double bend = turned * turned * norm(p_W);
    if (circling_) {
        const Circling& c = *circling_;
        bend += std::max(c.start_radius, c.end_radius) * c.sweep * c.sweep +
                2 * std::abs((c.end_radius - c.start_radius) * c.sweep);
    }
    return bend;
}

double Course::magnitude(const Vec& p_W) const {
    double size = norm(p_W) + std::max(norm(from_.x), norm(to_.x));
    if (circling_) {
        const Circling& c = *circling_;
        size += std::abs(c.centre[0]) + std::abs(c.centre[1]) +
                (1.0 + std::abs(c.sweep)) * (c.start_radius + c.end_radius);
    }
    return size;
}

}  // namespace ncsim::nightly
