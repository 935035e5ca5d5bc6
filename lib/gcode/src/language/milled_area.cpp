// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outlines of rectangles and polygons with round corners, and of bands about arcs.
#include "language/milled_area.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ncsim::gcode::language {
namespace {

/// A shorter side is a rounding error, relative to the size of the area.
constexpr double kSideRounding = 1e-9;

Vec2 polar(Vec2 centre, double radius, double degrees) {
    const SinCos direction = sin_cos(degrees);
    return {centre.x + radius * direction.cos, centre.y + radius * direction.sin};
}

OutlineMove arc(Vec2 from, Vec2 to, Vec2 centre, int turns) {
    return {from, to, centre, turns};
}

Pass outline_of_band(const MilledArea& area, double inset) {
    const double half = area.width / 2.0 - inset;
    const double outer = area.arc_radius + half;
    const double inner = area.arc_radius - half;
    const double end = area.angle + area.opening;
    const auto at = [&](double radius, double degrees) {
        return polar(area.centre, radius, degrees);
    };
    const Vec2 start = at(outer, area.angle + area.opening / 2.0);
    const Vec2 outer_end = at(outer, end);
    const Vec2 inner_end = at(inner, end);
    const Vec2 inner_start = at(inner, area.angle);
    const Vec2 outer_start = at(outer, area.angle);
    return {arc(start, outer_end, area.centre, 1),
            arc(outer_end, inner_end, at(area.arc_radius, end), 1),
            arc(inner_end, inner_start, area.centre, -1),
            arc(inner_start, outer_start, at(area.arc_radius, area.angle), 1),
            arc(outer_start, start, area.centre, 1)};
}

Pass outline_of_polygon(const MilledArea& area, double inset) {
    const double side = area.length / 2.0 - inset;  // Distance of the sides from the centre.
    const double r = std::clamp(area.corner - inset, 0.0, side);
    const double step = 360.0 / area.sides;
    const double to_centres = (side - r) / sin_cos(step / 2.0).cos;
    const auto centre = [&](int i) {
        return polar(area.centre, to_centres, area.angle + i * step);
    };
    // End of the corner `i`, at the side behind the corner.
    const auto behind = [&](int i) { return polar(centre(i), r, area.angle + (i + 0.5) * step); };
    const auto before = [&](int i) { return polar(centre(i), r, area.angle + (i - 0.5) * step); };
    const Vec2 start = polar(centre(0), r, area.angle);
    Pass pass;
    if (r > 0.0) pass.push_back(arc(start, behind(0), centre(0), 1));
    for (int i = 1; i < area.sides; ++i) {
        pass.push_back({behind(i - 1), before(i), {}, 0});
        if (r > 0.0) pass.push_back(arc(before(i), behind(i), centre(i), 1));
    }
    pass.push_back({behind(area.sides - 1), before(0), {}, 0});
    if (r > 0.0) pass.push_back(arc(before(0), start, centre(0), 1));
    return pass;
}

}  // namespace

double MilledArea::half_width() const {
    return (is_band() ? width : std::min(length, width)) / 2.0;
}

double MilledArea::reach() const {
    if (!is_polygon()) return length / 2.0;
    return (length / 2.0 - corner) / sin_cos(180.0 / sides).cos + corner;
}

Vec2 point_in(const MilledArea& area, double x, double y) {
    const SinCos direction = sin_cos(area.angle);
    return {area.centre.x + x * direction.cos - y * direction.sin,
            area.centre.y + x * direction.sin + y * direction.cos};
}

Pass outline_of(const MilledArea& area, double inset) {
    if (area.is_band()) return outline_of_band(area, inset);
    if (area.is_polygon()) return outline_of_polygon(area, inset);
    const double a = area.length / 2.0 - inset;
    const double b = area.width / 2.0 - inset;
    const double most = std::min(a, b);
    const double tiny = kSideRounding * std::max(area.length, area.width);
    double r = std::clamp(area.corner - inset, 0.0, most);
    if (r < tiny) r = 0.0;
    if (r > most - tiny) r = most;
    const auto at = [&](double x, double y) { return point_in(area, x, y); };
    const Vec2 start = at(a, 0.0);
    if (r == most && a - b < tiny && b - a < tiny) return {arc(start, start, area.centre, 1)};
    Pass pass;
    Vec2 here = start;
    const auto line = [&](double length, double x, double y) {
        if (length <= tiny) return;
        const Vec2 end = at(x, y);
        pass.push_back({here, end, {}, 0});
        here = end;
    };
    const auto turn = [&](double centre_x, double centre_y, double x, double y) {
        if (r == 0.0) return;
        const Vec2 end = at(x, y);
        pass.push_back(arc(here, end, at(centre_x, centre_y), 1));
        here = end;
    };
    const double x = a - r;  // Ends of the straight sides.
    const double y = b - r;
    line(y, a, y);
    turn(x, y, x, b);
    line(2.0 * x, -x, b);
    turn(-x, y, -a, y);
    line(2.0 * y, -a, -y);
    turn(-x, -y, -x, -b);
    line(2.0 * x, x, -b);
    turn(x, -y, a, -y);
    line(y, a, 0.0);
    return pass;
}

Vec2 middle_of(const MilledArea& area) {
    if (!area.is_band()) return area.centre;
    return polar(area.centre, area.arc_radius, area.angle + area.opening / 2.0);
}

Pass centre_line_of(const MilledArea& area) {
    const Vec2 middle = middle_of(area);
    if (area.is_band()) {
        const Vec2 start = polar(area.centre, area.arc_radius, area.angle);
        const Vec2 end = polar(area.centre, area.arc_radius, area.angle + area.opening);
        return {arc(middle, start, area.centre, -1), arc(start, end, area.centre, 1),
                arc(end, middle, area.centre, -1)};
    }
    const double half = (area.length - area.width) / 2.0;
    const double tiny = kSideRounding * std::max(area.length, area.width);
    if (std::abs(half) <= tiny) return {};
    const Vec2 start = half > 0.0 ? point_in(area, -half, 0.0) : point_in(area, 0.0, half);
    const Vec2 end = half > 0.0 ? point_in(area, half, 0.0) : point_in(area, 0.0, -half);
    return {{middle, start, {}, 0}, {start, end, {}, 0}, {end, middle, {}, 0}};
}

void reverse(Pass& pass) {
    std::ranges::reverse(pass);
    for (OutlineMove& move : pass) {
        std::swap(move.from, move.to);
        move.turns = -move.turns;
    }
}

}  // namespace ncsim::gcode::language
