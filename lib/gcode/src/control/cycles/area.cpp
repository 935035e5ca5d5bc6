// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances and scan lines of polygons.
#include "control/cycles/area.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace ncsim::gcode {
namespace {

/// Rounding tolerances of strokes and of connections, relative to the sum of the distance and the
/// height of the outline.
constexpr double kRounding = 1e-12;
constexpr double kPathRounding = 1e-9;

double distance(Vec2 p, Vec2 a, Vec2 b) {
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    const double length_2 = x * x + y * y;
    double t = length_2 > 0.0 ? ((p.x - a.x) * x + (p.y - a.y) * y) / length_2 : 0.0;
    t = std::clamp(t, 0.0, 1.0);
    return hypotenuse(p.x - (a.x + t * x), p.y - (a.y + t * y));
}

double distance(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const bool cd_apart = (cross(d - c, a - c) > 0.0) != (cross(d - c, b - c) > 0.0);
    const bool ab_apart = (cross(b - a, c - a) > 0.0) != (cross(b - a, d - a) > 0.0);
    if (cd_apart && ab_apart) return 0.0;
    return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

/// Returns the part of the horizontal line at `y` whose distance from the segment is below
/// `radius`.
std::optional<Stroke> near_segment(Vec2 a, Vec2 b, double radius, double y) {
    std::optional<Stroke> out;
    const auto add = [&](double from, double to) {
        if (!out) out = Stroke{from, to};
        out->from = std::min(out->from, from);
        out->to = std::max(out->to, to);
    };
    for (const Vec2& p : {a, b}) {
        const double up = y - p.y;
        if (std::abs(up) >= radius) continue;
        const double half = std::sqrt((radius - up) * (radius + up));
        add(p.x - half, p.x + half);
    }
    // The two sides of the band between the end circles.
    const double length = hypotenuse(b.x - a.x, b.y - a.y);
    if (length == 0.0) return out;
    const Vec2 n{-(b.y - a.y) / length * radius, (b.x - a.x) / length * radius};
    for (const double side : {-1.0, 1.0}) {
        const Vec2 p{a.x + side * n.x, a.y + side * n.y};
        const Vec2 q{b.x + side * n.x, b.y + side * n.y};
        if ((p.y < y) == (q.y < y)) continue;
        const double x = p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y));
        add(x, x);
    }
    return out;
}

}  // namespace

double signed_area(const std::vector<Vec2>& outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 next = outline[(i + 1) % outline.size()];
        twice += cross(outline[i] - outline[0], next - outline[0]);
    }
    return twice / 2.0;
}

Area::Area(const std::vector<std::vector<Vec2>>& outlines, double distance) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const std::vector<Vec2>& outline : outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            sides_.push_back({outline[i], outline[(i + 1) % outline.size()]});
            low = std::min(low, outline[i].y);
            high = std::max(high, outline[i].y);
        }
    }
    lowest_ = low + distance;
    highest_ = high - distance;
    const double size = distance + high - low;
    of_strokes_ = std::max(0.0, distance - kRounding * size);
    path_margin_ = std::max(0.0, distance - kPathRounding * size);
}

bool Area::contains(Vec2 p) const {
    bool inside = false;
    for (const auto& [a, b] : sides_) {
        if (distance(p, a, b) < path_margin_) return false;
        if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) {
            inside = !inside;
        }
    }
    return inside;
}

bool Area::contains(Vec2 a, Vec2 b) const {
    return std::ranges::none_of(
        sides_, [&](const Side& side) { return distance(a, b, side.a, side.b) < path_margin_; });
}

std::vector<Stroke> Area::strokes_at(double y) const {
    std::vector<double> crossings;
    std::vector<Stroke> near;
    for (const auto& [a, b] : sides_) {
        if ((a.y <= y) != (b.y <= y))
            crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
        if (const auto stroke = near_segment(a, b, of_strokes_, y)) near.push_back(*stroke);
    }
    std::ranges::sort(crossings);
    std::ranges::sort(near, {}, &Stroke::from);
    std::vector<Stroke> strokes;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        double from = crossings[i];
        const double end = crossings[i + 1];
        for (const Stroke& n : near) {
            if (n.to <= from) continue;
            if (n.from >= end) break;
            if (n.from > from) strokes.push_back({from, n.from});
            from = std::max(from, n.to);
        }
        if (from < end) strokes.push_back({from, end});
    }
    return strokes;
}

}  // namespace ncsim::gcode
