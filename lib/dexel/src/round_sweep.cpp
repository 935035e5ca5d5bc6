// SPDX-License-Identifier: GPL-3.0-or-later
#include "round_sweep.h"

#include <algorithm>
#include <cmath>

namespace ncsim::dexel {

namespace {

using cda::Vec3;

void join(SweptTool::Interval& all, const SweptTool::Interval& part) {
    if (part.low.at < all.low.at) all.low = part.low;
    if (part.high.at > all.high.at) all.high = part.high;
}

}  // namespace

SweptTool::SweptTool(const cda::RoundSweep& sweep, const cda::Lattice& lattice, const Grid& grid)
    : box(sweep.bounds, lattice, grid),
      origin(sweep.origin),
      radius_(sweep.radius / lattice.unit_mm),
      height_(sweep.height / lattice.unit_mm),
      is_ball_(sweep.is_ball) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        from_[a] = sweep.from[axis] / lattice.unit_mm;
        way_[a] = sweep.to[axis] / lattice.unit_mm - from_[a];
    }
}

bool SweptTool::meet(std::size_t axis, double u, double v, Interval& result) const {
    const auto meets_cylinder = [&](Interval& interval) {
        if (axis == 2) return meet_along_z(u, v, interval);
        return axis == 0 ? meet_across_z(0, u, v, interval) : meet_across_z(1, v, u, interval);
    };
    const bool has_cylinder = meets_cylinder(result);
    if (!is_ball_) return has_cylinder;
    Interval ball;
    if (!meet_ball(axis, u, v, ball)) return has_cylinder;
    if (has_cylinder) {
        join(result, ball);
    } else {
        result = ball;
    }
    return true;
}

bool SweptTool::meet_ball(std::size_t axis, double u, double v, Interval& result) const {
    const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
    Triple centre = from_;
    centre[2] += radius_;
    const double wu = centre[p] - u, wv = centre[q] - v;
    const double a = way_[p] * way_[p] + way_[q] * way_[q];
    const double b = wu * way_[p] + wv * way_[q];
    const double along = way_[axis];
    double root = 0.0;  // of how far the best place is from where the centre is nearest, by a
    if (a > 0.0) {
        // What the ray leaves of the ball where the centre passes nearest.
        const double cross = wu * way_[q] - wv * way_[p];
        const double room = radius_ * radius_ - cross * cross / a;
        if (room < 0.0) return false;
        root = along * std::sqrt(room / (a * (a + along * along)));
    }
    const auto at = [&](double sign, double s, Meeting& meeting) {
        s = std::clamp(s, 0.0, 1.0);
        const double du = wu + s * way_[p], dv = wv + s * way_[q];
        const double square = radius_ * radius_ - du * du - dv * dv;
        if (square < 0.0) return false;
        const double depth = sign * std::sqrt(square);
        meeting.at = centre[axis] + s * along + depth;
        meeting.normal[static_cast<int>(axis)] = depth;
        meeting.normal[static_cast<int>(p)] = -du;
        meeting.normal[static_cast<int>(q)] = -dv;
        return true;
    };
    if (a == 0.0)
        return at(-1.0, along < 0.0 ? 1.0 : 0.0, result.low) &&
               at(1.0, along < 0.0 ? 0.0 : 1.0, result.high);
    return at(-1.0, -b / a - root, result.low) && at(1.0, -b / a + root, result.high);
}

// Of the surface that the lower (upper) rim leaves: z as the tool has it when the rim comes by.
Vec3 SweptTool::rim_normal(double x, double y, double s, bool is_lower) const {
    const double dx = from_[0] + s * way_[0] - x, dy = from_[1] + s * way_[1] - y;
    const double across = dx * way_[0] + dy * way_[1];
    const double sign = is_lower ? 1.0 : -1.0;
    // (F_x, F_y, -1) for z = F(x, y), times |across|, so that where the rim stands still beside the
    // ray it is level.
    const double climb = across < 0.0 ? -way_[2] : way_[2];
    const Vec3 normal{sign * climb * dx, sign * climb * dy, -sign * std::abs(across)};
    return cda::norm(normal) > 0.0 ? normal : Vec3{0.0, 0.0, -sign};
}

bool SweptTool::meet_along_z(double x, double y, Interval& result) const {
    const double wx = from_[0] - x, wy = from_[1] - y;
    const double a = way_[0] * way_[0] + way_[1] * way_[1];
    double first = 0.0, last = 1.0;  // while the ray is in the cylinder
    if (a > 0.0) {
        const double b = wx * way_[0] + wy * way_[1];
        const double cross = wx * way_[1] - wy * way_[0];
        const double room = radius_ * radius_ - cross * cross / a;
        if (room < 0.0) return false;
        const double half = std::sqrt(room / a);
        first = std::max(0.0, -b / a - half);
        last = std::min(1.0, -b / a + half);
        if (first > last) return false;
    } else if (wx * wx + wy * wy > radius_ * radius_) {
        return false;
    }
    const double base = is_ball_ ? radius_ : 0.0;
    const double low = way_[2] < 0.0 ? last : first;
    const double high = way_[2] < 0.0 ? first : last;
    result.low.at = from_[2] + base + low * way_[2];
    result.high.at = from_[2] + height_ + high * way_[2];
    // At the ends of the way the flat end is there itself.
    result.low.normal = low > 0.0 && low < 1.0 ? rim_normal(x, y, low, true) : Vec3{0, 0, -1};
    result.high.normal = high > 0.0 && high < 1.0 ? rim_normal(x, y, high, false) : Vec3{0, 0, 1};
    return true;
}

// `other`: the coordinate across both the ray and z.
bool SweptTool::meet_across_z(std::size_t axis, double other, double z, Interval& result) const {
    const std::size_t o = 1 - axis;
    const double base = from_[2] + (is_ball_ ? radius_ : 0.0);
    const double top = from_[2] + height_;
    double first = 0.0, last = 1.0;  // while the cylinder has the height of the ray
    if (way_[2] == 0.0) {
        if (z < base || z > top) return false;
    } else {
        const double at_base = (z - base) / way_[2];
        const double at_top = (z - top) / way_[2];
        first = std::max(first, std::min(at_base, at_top));
        last = std::min(last, std::max(at_base, at_top));
        if (first > last) return false;
    }
    const double w = from_[o] - other;
    const auto at = [&](double sign, Meeting& meeting) {
        double s = sign * way_[axis] > 0.0 ? last : first;
        if (way_[o] != 0.0) {
            const double k = sign * radius_ * way_[axis] /
                             std::sqrt(way_[axis] * way_[axis] + way_[o] * way_[o]) *
                             (way_[o] < 0.0 ? -1.0 : 1.0);
            s = std::clamp((k - w) / way_[o], first, last);
        }
        const double k = w + s * way_[o];
        const double square = radius_ * radius_ - k * k;
        if (square < 0.0) return false;
        const double depth = sign * std::sqrt(square);
        meeting.at = from_[axis] + s * way_[axis] + depth;
        const bool by_rim = s > 0.0 && s < 1.0 && (s == first || s == last);
        if (by_rim) {
            Triple p{};
            p[axis] = meeting.at;
            p[o] = other;
            const bool is_lower =
                std::abs(base + s * way_[2] - z) < std::abs(top + s * way_[2] - z);
            meeting.normal = rim_normal(p[0], p[1], s, is_lower);
            const double faces = meeting.normal[static_cast<int>(axis)] * sign;
            if (faces > 0.0) return true;
        }
        meeting.normal = {};
        meeting.normal[static_cast<int>(axis)] = depth;
        meeting.normal[static_cast<int>(o)] = -k;
        return true;
    };
    return at(-1.0, result.low) && at(1.0, result.high);
}

}  // namespace ncsim::dexel
