// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares what a tool of 10 mm sweeps at a height with an area.
#pragma once

#include "ncsim/base/angles.h"

#include "gcode/language_made.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace ncsim::gcode::swept_area {

using language_test::Made;

inline constexpr double kRadius = 5.0;  // Of the tool.

/// Distance of a point from the wall: negative inside the area.
using Distance = std::function<double(double x, double y)>;

/// A rectangle with round corners about the zero, turned by `degrees`.
inline Distance rectangle(double length, double width, double corner, double degrees = 0.0,
                          double centre_x = 0.0, double centre_y = 0.0) {
    return [=](double x, double y) {
        const SinCos turn = sin_cos(degrees);
        x -= centre_x;
        y -= centre_y;
        const double u = std::abs(x * turn.cos + y * turn.sin) - (length / 2.0 - corner);
        const double v = std::abs(y * turn.cos - x * turn.sin) - (width / 2.0 - corner);
        const double outside = hypotenuse(std::max(u, 0.0), std::max(v, 0.0));
        return outside + std::min(std::max(u, v), 0.0) - corner;
    };
}

/// A band about an arc about the zero.
inline Distance band(double radius, double width, double start, double opening) {
    return [=](double x, double y) {
        double angle = angle_of(x, y) - start;
        while (angle < 0.0)
            angle += 360.0;
        if (angle <= opening) return std::abs(hypotenuse(x, y) - radius) - width / 2.0;
        const auto from_end = [&](double degrees) {
            const SinCos at = sin_cos(degrees);
            return hypotenuse(x - radius * at.cos, y - radius * at.sin);
        };
        return std::min(from_end(start), from_end(start + opening)) - width / 2.0;
    };
}

struct Point {
    double x = 0.0, y = 0.0;
};

/// Points of the path of `motion`, at most 0.02 mm apart, if both ends are at most at `height`.
inline void add_path(std::vector<Point>& points, const Motion& motion, double height) {
    const Position* const from = start_of(motion);
    const Position* const to = end_of(motion);
    if (!from || from->z.mm() > height + 1e-9 || to->z.mm() > height + 1e-9) return;
    constexpr double kStep = 0.02;
    const double dx = to->x.mm() - from->x.mm();
    const double dy = to->y.mm() - from->y.mm();
    const auto* const arc = std::get_if<Arc>(&motion.action);
    double radius = 0.0;
    double begin = 0.0;
    double sweep = 0.0;
    if (arc) {
        const double x = from->x.mm() - arc->centre_1.mm();
        const double y = from->y.mm() - arc->centre_2.mm();
        radius = hypotenuse(x, y);
        begin = angle_of(x, y);
        const double end =
            angle_of(to->x.mm() - arc->centre_1.mm(), to->y.mm() - arc->centre_2.mm());
        sweep = arc->turns > 0 ? end - begin : begin - end;
        while (sweep < 1e-7)
            sweep += 360.0;
        if (arc->turns < 0) sweep = -sweep;
    }
    const double length = arc ? radius * std::abs(sweep) / 57.0 : hypotenuse(dx, dy);
    const int count = static_cast<int>(length / kStep) + 1;
    for (int i = 0; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        if (!arc) {
            points.push_back({from->x.mm() + share * dx, from->y.mm() + share * dy});
            continue;
        }
        const SinCos at = sin_cos(begin + share * sweep);
        points.push_back(
            {arc->centre_1.mm() + radius * at.cos, arc->centre_2.mm() + radius * at.sin});
    }
}

/// Expects that the tool sweeps the points of the area at `bottom`, no point outside, and is never
/// lower. `reach`: half of the side of the square whose points are looked at.
inline void expect_swept(const Made& made, const Distance& area, double bottom, double reach) {
    EXPECT_EQ(made.errors(), "");
    std::vector<Point> path;
    for (const Motion& motion : made.moves) {
        add_path(path, motion, bottom);
        EXPECT_GE(end_of(motion)->z.mm(), bottom - 1e-9);
    }
    ASSERT_FALSE(path.empty());
    constexpr double kMargin = 0.02;
    constexpr double kGrid = 0.73;
    int wrong = 0;
    for (double x = -reach; x <= reach && wrong < 3; x += kGrid) {
        for (double y = -reach; y <= reach && wrong < 3; y += kGrid) {
            const double distance = area(x, y);
            if (std::abs(distance) < kMargin) continue;
            const bool is_swept = std::ranges::any_of(path, [&](const Point& p) {
                return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y) <= kRadius * kRadius;
            });
            if (is_swept == (distance < 0.0)) continue;
            ADD_FAILURE() << "at " << x << ' ' << y << ": swept " << is_swept;
            ++wrong;
        }
    }
}

/// Expects that rapid moves below `surface` are where feed moves were before, within the radius.
inline void expect_rapids_in_cut(const Made& made, double surface) {
    std::vector<Point> path;
    for (const Motion& motion : made.moves) {
        if (motion.kind == MoveKind::Feed) {
            add_path(path, motion, surface - 1e-6);
            continue;
        }
        std::vector<Point> rapid;
        add_path(rapid, motion, surface - 1e-6);
        for (const Point& p : rapid) {
            EXPECT_TRUE(std::ranges::any_of(
                path, [&](const Point& q) { return hypotenuse(p.x - q.x, p.y - q.y) < kRadius; }))
                << p.x << ' ' << p.y;
        }
    }
}

}  // namespace ncsim::gcode::swept_area
