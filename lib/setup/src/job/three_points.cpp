// SPDX-License-Identifier: GPL-3.0-or-later
//
// Position of a part from three points of the part.
#include "job/three_points.h"

#include "ncsim/base/angles.h"
#include "ncsim/setup/stock_file.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace ncsim::setup {

namespace {

using Axes = std::array<Vec3, 3>;

// Returns right-handed unit vectors: along the line to the second point, in the plane of the third
// point, and perpendicular to both.
Axes axes_of(const std::array<Vec3, 3>& points, const char* when) {
    constexpr double kLeastSine = 1e-3;
    const Vec3 a = points[1] - points[0], b = points[2] - points[0];
    const Vec3 normal = cross(a, b);
    if (!(norm(normal) > kLeastSine * norm(a) * norm(b)))
        throw std::invalid_argument(fmt::format("the points '{}' are on a line", when));
    const Vec3 x = normalized(a), z = normalized(normal);
    return {x, cross(z, x), z};
}

void require_same_distances(const std::array<Vec3, 3>& before, const std::array<Vec3, 3>& now) {
    for (const auto& [i, k] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(k);
        const double was = norm(before[b] - before[a]), is = norm(now[b] - now[a]);
        if (std::abs(was - is) > kPointTolerance) {
            throw std::invalid_argument(
                fmt::format("the points {} and {} are {:.4g} mm apart before, {:.4g} mm now", i + 1,
                            k + 1, was, is));
        }
    }
}

// Returns the angle of (x, y), degrees. An angle that differs from a multiple of 90 by rounding
// becomes the multiple.
double degrees(double y, double x) {
    constexpr double kSnap = 1e-6, kRight = 90.0;
    const double angle = angle_of(x, y);
    const double right = std::round(angle / kRight) * kRight;
    return std::abs(angle - right) < kSnap ? right : angle;
}

}  // namespace

TurnAndMove motion_of(const std::array<Vec3, 3>& before, const std::array<Vec3, 3>& now) {
    const Axes from = axes_of(before, "before"), to = axes_of(now, "now");
    require_same_distances(before, now);
    // The rotation takes from[k] to to[k].
    const auto entry = [&](double Vec3::*row, double Vec3::*column) {
        return to[0].*row * from[0].*column + to[1].*row * from[1].*column +
               to[2].*row * from[2].*column;
    };
    using V = Vec3;
    // Rotation about X, then Y, then Z. If the angle about Y is a right angle, X and Z turn about
    // the same axis, and the whole rotation is assigned to X.
    const double sine = -entry(&V::z, &V::x);
    const double cosine = hypotenuse(entry(&V::z, &V::y), entry(&V::z, &V::z));
    constexpr double kLeastCosine = 1e-8;
    const bool is_upright = cosine < kLeastCosine;
    const double about_x = is_upright ? degrees(-entry(&V::y, &V::z), entry(&V::y, &V::y))
                                      : degrees(entry(&V::z, &V::y), entry(&V::z, &V::z));
    const double about_y = degrees(sine, cosine);
    const double about_z = is_upright ? 0.0 : degrees(entry(&V::y, &V::x), entry(&V::x, &V::x));
    TurnAndMove motion;
    for (const auto& [axis, angle] :
         {std::pair('X', about_x), std::pair('Y', about_y), std::pair('Z', about_z)}) {
        if (angle == 0.0) continue;
        motion.turn += fmt::format("{}{}{:.12g}", motion.turn.empty() ? "" : ",", axis, angle);
    }
    const auto rows = parse_any_turn(motion.turn.empty() ? "X0" : motion.turn).rows;
    const auto turned = [&](std::size_t i) {
        return rows[i][0] * before[0].x + rows[i][1] * before[0].y + rows[i][2] * before[0].z;
    };
    motion.move = now[0] - Vec3{turned(0), turned(1), turned(2)};
    return motion;
}

}  // namespace ncsim::setup
