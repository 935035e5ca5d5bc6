// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/sampler.h"

#include "ncsim/toolpath/angles.h"
#include "ncsim/toolpath/machine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ncsim::toolpath {

using cda::Vec3;
using gcode::Angle;
using gcode::Length;
using gcode::Position;

namespace {

// Not std::hypot, whose last bit is the library's own affair.
double length_of(double a, double b) {
    return std::sqrt(a * a + b * b);
}

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

double lerp(double a, double b, double t) {
    return a + t * (b - a);
}

// All axes in step; the ends come out exactly.
Position between(const Position& a, const Position& b, double t) {
    if (t <= 0.0) return a;
    if (t >= 1.0) return b;
    const auto length = [t](Length p, Length q) {
        return Length::from_mm(lerp(p.mm(), q.mm(), t));
    };
    const auto angle = [t](Angle p, Angle q) {
        return Angle::from_degrees(lerp(p.degrees(), q.degrees(), t));
    };
    return {length(a.x, b.x), length(a.y, b.y), length(a.z, b.z), angle(a.a, b.a), angle(a.b, b.b),
            angle(a.c, b.c),  length(a.u, b.u), length(a.v, b.v), length(a.w, b.w)};
}

double turned_radians(const Position& a, const Position& b) {
    return kRadiansPerDegree * (std::abs((b.a - a.a).degrees()) + std::abs((b.b - a.b).degrees()) +
                                std::abs((b.c - a.c).degrees()));
}

// --- Arcs ---------------------------------------------------------------------------------

// The two axes of the plane of an arc, as members of Position.
struct ArcAxes {
    Length Position::*first;
    Length Position::*second;
};

ArcAxes axes_of(gcode::Plane plane) {
    switch (plane) {
        case gcode::Plane::XY: return {&Position::x, &Position::y};
        case gcode::Plane::ZX: return {&Position::z, &Position::x};
        case gcode::Plane::YZ: return {&Position::y, &Position::z};
        case gcode::Plane::UV: return {&Position::u, &Position::v};
        case gcode::Plane::WU: return {&Position::w, &Position::u};
        case gcode::Plane::VW: return {&Position::v, &Position::w};
    }
    return {&Position::x, &Position::y};
}

// An arc in polar coordinates about its centre: radius and angle run from start to end in step.
struct Polar {
    double centre_1 = 0, centre_2 = 0;
    double start_degrees = 0, sweep_degrees = 0;
    double start_radius = 0, end_radius = 0;
};

Polar polar(const gcode::Arc& arc) {
    const ArcAxes axes = axes_of(arc.plane);
    Polar p;
    p.centre_1 = arc.centre_1.mm();
    p.centre_2 = arc.centre_2.mm();
    const double x0 = (arc.from.*axes.first).mm() - p.centre_1;
    const double y0 = (arc.from.*axes.second).mm() - p.centre_2;
    const double x1 = (arc.to.*axes.first).mm() - p.centre_1;
    const double y1 = (arc.to.*axes.second).mm() - p.centre_2;
    p.start_radius = std::sqrt(x0 * x0 + y0 * y0);
    p.end_radius = std::sqrt(x1 * x1 + y1 * y1);
    p.start_degrees = angle_of(x0, y0);
    // Equal ends are a full circle; below this the two angles are equal but for rounding.
    constexpr double kNoAngle = 1e-10;
    double sweep = angle_of(x1, y1) - p.start_degrees;
    if (arc.turns >= 0) {
        while (sweep <= kNoAngle)
            sweep += 360.0;
        sweep += 360.0 * std::max(0, arc.turns - 1);
    } else {
        while (sweep >= -kNoAngle)
            sweep -= 360.0;
        sweep -= 360.0 * (-arc.turns - 1);
    }
    p.sweep_degrees = sweep;
    return p;
}

Position on_arc(const gcode::Arc& arc, const Polar& p, double t) {
    Position at = between(arc.from, arc.to, t);
    if (t <= 0.0 || t >= 1.0) return at;
    const ArcAxes axes = axes_of(arc.plane);
    const double radius = lerp(p.start_radius, p.end_radius, t);
    const SinCos angle = sin_cos(p.start_degrees + t * p.sweep_degrees);
    at.*axes.first = Length::from_mm(p.centre_1 + radius * angle.cos);
    at.*axes.second = Length::from_mm(p.centre_2 + radius * angle.sin);
    return at;
}

// --- Steps --------------------------------------------------------------------------------

// What the bounds are made of, for a whole motion.
struct Course {
    double sweep_rad = 0.0;  // of an arc
    double radius_mm = 0.0;  // the largest
    double radius_change_mm = 0.0;
    double turn_rad = 0.0;     // of the rotary axes
    double length_mm = 0.0;    // at least the path of the tip in the rotating frame
    double farthest_mm = 0.0;  // of the path from the origin, through which the axes pass
};

struct StepBounds {
    double chord_mm = 0.0;
    double missed_by_turning_mm = 0.0;
    double gained_by_turning_mm = 0.0;
};

StepBounds bounds_of(const Course& c, const ToolExtent& tool, double steps) {
    const double delta = c.sweep_rad / steps;
    const double theta = c.turn_rad / steps;
    const double s = c.length_mm / steps;
    const double rho = c.farthest_mm + tool.reach_mm;
    StepBounds b;
    b.chord_mm = (c.radius_mm * delta * delta + 2 * c.radius_change_mm / steps * delta) / 8;
    b.missed_by_turning_mm = (theta * theta * rho + 2 * theta * s) / 8;
    b.gained_by_turning_mm = theta * tool.across_mm / 4 + b.missed_by_turning_mm;
    return b;
}

// The fewest steps that keep all three bounds, none of which grows with the number of steps.
std::uint32_t steps_for(const Course& c, const ToolExtent& tool, const SamplingOptions& o) {
    const auto enough = [&](std::uint32_t n) {
        const StepBounds b = bounds_of(c, tool, n);
        return b.chord_mm <= o.chord_tolerance_mm && b.missed_by_turning_mm <= o.rotation_miss_mm &&
               b.gained_by_turning_mm <= o.rotation_gain_mm;
    };
    // An arc never becomes one chord, whatever the tolerance: three make a full circle a body.
    const double thirds = std::ceil(c.sweep_rad / (2 * std::numbers::pi / 3));
    std::uint32_t low = static_cast<std::uint32_t>(std::clamp(thirds, 1.0, double{1e9}));
    if (c.sweep_rad > 0) low = std::max(low, 2U);
    low = std::min(low, std::max(1U, o.max_steps));
    std::uint32_t high = low;
    while (high < o.max_steps && !enough(high))
        high = std::min(o.max_steps, high * 2);
    while (low < high) {
        const std::uint32_t middle = low + (high - low) / 2;
        if (enough(middle)) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return high;
}

// The turns of a helix are divided alike, and as a circle of its radius: then the chords of one
// turn stand above those of the last, and a shank as thick as its cutter meets no cusps between
// them.
std::uint32_t whole_turns(const Course& c, std::uint32_t steps, const SamplingOptions& o) {
    const double turns = std::round(c.sweep_rad / (2 * std::numbers::pi));
    constexpr double kRounding = 1e-9;
    if (turns < 2.0 || std::abs(c.sweep_rad - 2 * std::numbers::pi * turns) > kRounding * turns)
        return steps;
    const double even = std::ceil(steps / turns) * turns;
    return even <= o.max_steps ? static_cast<std::uint32_t>(even) : steps;
}

template <typename PositionAt>
Samples sample_course(const Course& course, const ToolExtent& tool, const SamplingOptions& options,
                      const PositionAt& position_at) {
    const std::uint32_t steps = whole_turns(course, steps_for(course, tool, options), options);
    const StepBounds b = bounds_of(course, tool, steps);
    Samples samples;
    samples.bounds = {b.chord_mm + b.missed_by_turning_mm, b.chord_mm + b.gained_by_turning_mm};
    samples.poses.reserve(steps + std::size_t{1});
    for (std::uint32_t i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        samples.poses.push_back(pose_at(position_at(i == steps ? 1.0 : t)));
    }
    return samples;
}

Samples sample_linear(const gcode::Linear& m, const ToolExtent& tool,
                      const SamplingOptions& options) {
    Course c;
    const Vec3 from = linear_axes(m.from);
    const Vec3 to = linear_axes(m.to);
    c.turn_rad = turned_radians(m.from, m.to);
    c.length_mm = norm(to - from);
    c.farthest_mm = std::max(norm(from), norm(to));
    return sample_course(c, tool, options, [&m](double t) { return between(m.from, m.to, t); });
}

Samples sample_arc(const gcode::Arc& m, const ToolExtent& tool, const SamplingOptions& options) {
    const Polar p = polar(m);
    Course c;
    c.sweep_rad = std::abs(p.sweep_degrees) * kRadiansPerDegree;
    c.radius_mm = std::max(p.start_radius, p.end_radius);
    c.radius_change_mm = std::abs(p.end_radius - p.start_radius);
    c.turn_rad = turned_radians(m.from, m.to);
    const Vec3 from = linear_axes(m.from);
    const Vec3 to = linear_axes(m.to);
    c.length_mm = c.radius_mm * c.sweep_rad + c.radius_change_mm + norm(to - from);
    c.farthest_mm = std::max(norm(from), norm(to)) + 2 * c.radius_mm;
    return sample_course(c, tool, options, [&](double t) { return on_arc(m, p, t); });
}

// --- Splines ------------------------------------------------------------------------------

// A point of a rational B-spline by de Boor's algorithm in homogeneous coordinates (Piegl and
// Tiller, The NURBS Book, 2nd ed. 1997, algorithm A4.1).
class SplineCurve {
public:
    explicit SplineCurve(const gcode::Spline& m) : m_(m), degree_(m.order - 1) {}

    bool is_sound() const {
        const std::size_t n = m_.control_points.size();
        return degree_ >= 1 && n > static_cast<std::size_t>(degree_) &&
               m_.knots.size() == n + static_cast<std::size_t>(m_.order) &&
               std::is_sorted(m_.knots.begin(), m_.knots.end()) && first() < last();
    }
    double first() const { return m_.knots[static_cast<std::size_t>(degree_)]; }
    double last() const { return m_.knots[m_.control_points.size()]; }

    // Parameters at which the curve may have a corner, from the first to the last.
    std::vector<double> breaks() const {
        std::vector<double> all;
        for (const double k : m_.knots) {
            if (k >= first() && k <= last() && (all.empty() || all.back() < k)) all.push_back(k);
        }
        return all;
    }

    Position at(double u) const {
        if (u <= first()) return m_.from;
        if (u >= last()) return m_.to;
        const auto p = static_cast<std::size_t>(degree_);
        std::size_t span = p;
        while (span + 1 < m_.control_points.size() && m_.knots[span + 1] <= u)
            ++span;
        struct Homogeneous {
            double x, y, w;
        };
        std::vector<Homogeneous> d;
        for (std::size_t j = 0; j <= p; ++j) {
            const auto& c = m_.control_points[span - p + j];
            d.push_back({c.x.mm() * c.weight, c.y.mm() * c.weight, c.weight});
        }
        for (std::size_t r = 1; r <= p; ++r) {
            for (std::size_t j = p; j >= r; --j) {
                const double low = m_.knots[span - p + j];
                const double high = m_.knots[span + 1 + j - r];
                const double a = high > low ? (u - low) / (high - low) : 0.0;
                d[j] = {lerp(d[j - 1].x, d[j].x, a), lerp(d[j - 1].y, d[j].y, a),
                        lerp(d[j - 1].w, d[j].w, a)};
            }
        }
        Position result = between(m_.from, m_.to, (u - first()) / (last() - first()));
        if (d[p].w != 0.0) {
            result.x = Length::from_mm(d[p].x / d[p].w);
            result.y = Length::from_mm(d[p].y / d[p].w);
        }
        return result;
    }

private:
    const gcode::Spline& m_;
    int degree_;
};

double distance_to_chord(Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 ab = b - a;
    const double squared = dot(ab, ab);
    const double t = squared > 0 ? std::clamp(dot(p - a, ab) / squared, 0.0, 1.0) : 0.0;
    return norm(p - (a + t * ab));
}

Samples sample_spline(const gcode::Spline& m, const ToolExtent& tool,
                      const SamplingOptions& options) {
    const SplineCurve curve(m);
    if (!curve.is_sound()) return sample_linear({m.from, m.to}, tool, options);
    Samples samples;
    samples.poses.push_back(pose_at(m.from));
    struct Piece {
        double from, to;
        int depth;
    };
    std::vector<Piece> pending;
    const std::vector<double> breaks = curve.breaks();
    for (std::size_t i = breaks.size(); i-- > 1;)
        pending.push_back({breaks[i - 1], breaks[i], 0});
    constexpr int kMinDepth = 2;  // an S has its middle on its chord
    constexpr int kMaxDepth = 20;
    double worst = 0.0;
    while (!pending.empty()) {
        const Piece piece = pending.back();
        pending.pop_back();
        const Vec3 a = linear_axes(curve.at(piece.from));
        const Vec3 b = linear_axes(curve.at(piece.to));
        double off = 0.0;
        for (const double t : {0.25, 0.5, 0.75}) {
            const Vec3 p = linear_axes(curve.at(lerp(piece.from, piece.to, t)));
            off = std::max(off, distance_to_chord(p, a, b));
        }
        const bool divide = piece.depth < kMinDepth ||
                            (off > options.chord_tolerance_mm / 2 && piece.depth < kMaxDepth);
        if (divide && samples.poses.size() + pending.size() < options.max_steps) {
            const double middle = lerp(piece.from, piece.to, 0.5);
            pending.push_back({middle, piece.to, piece.depth + 1});
            pending.push_back({piece.from, middle, piece.depth + 1});
        } else {
            worst = std::max(worst, off);
            samples.poses.push_back(pose_at(curve.at(piece.to)));
        }
    }
    samples.bounds = {2 * worst, 2 * worst};
    return samples;
}

}  // namespace

namespace {

// Where a coordinate of an arc is farthest out: at right angles to its axis, on a spiral near by.
void add_extremes(cda::Box& box, const gcode::Arc& arc, const Polar& p) {
    const double low = std::min(p.start_degrees, p.start_degrees + p.sweep_degrees);
    const double high = std::max(p.start_degrees, p.start_degrees + p.sweep_degrees);
    const auto time_of = [&](double degrees) {
        return std::clamp((degrees - p.start_degrees) / p.sweep_degrees, 0.0, 1.0);
    };
    const auto at = [&](double t) { return linear_axes(on_arc(arc, p, t)); };
    const bool is_spiral = p.start_radius != p.end_radius;
    for (double q = std::ceil(low / 90.0) * 90.0; q <= high; q += 90.0) {
        // Radii grow or shrink all the way: the first and the last turn are farthest out.
        if (q > low + 450.0 && q < high - 450.0) q = std::floor((high - 450.0) / 90.0) * 90.0;
        box.add(at(time_of(q)));
        if (!is_spiral) continue;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double sign : {-1.0, 1.0}) {
                double t0 = time_of(q - 45.0), t1 = time_of(q + 45.0);
                if (t0 > t1) std::swap(t0, t1);
                const auto value = [&](double t) { return sign * at(t)[axis]; };
                for (int k = 0; k < 64; ++k) {  // one extreme between, or none
                    const double third = (t1 - t0) / 3.0;
                    if (value(t0 + third) < value(t1 - third)) {
                        t0 += third;
                    } else {
                        t1 -= third;
                    }
                }
                box.add(at(0.5 * (t0 + t1)));
            }
        }
    }
}

}  // namespace

cda::Box extent_of_path(const gcode::Motion& motion) {
    cda::Box box;
    const Position* from = start_of(motion);
    const Position* to = end_of(motion);
    if (!from || !to) return box;
    box.add(linear_axes(*from));
    box.add(linear_axes(*to));
    if (const auto* arc = std::get_if<gcode::Arc>(&motion.what)) {
        add_extremes(box, *arc, polar(*arc));
    } else if (const auto* spline = std::get_if<gcode::Spline>(&motion.what)) {
        for (const auto& point : spline->control_points) {
            Position p = *from;
            p.x = point.x, p.y = point.y;
            box.add(linear_axes(p));
        }
    }
    return box;
}

ToolExtent extent_of(const Tool& tool) {
    ToolExtent extent;
    for (const ToolPiece& piece : tool.pieces) {
        if (!piece.cutting) continue;
        for (const ProfilePoint& p : piece.profile) {
            extent.reach_mm = std::max(extent.reach_mm, length_of(p.radius, p.height));
            for (const ProfilePoint& q : piece.profile) {
                extent.across_mm =
                    std::max(extent.across_mm, length_of(p.radius + q.radius, p.height - q.height));
            }
        }
    }
    return extent;
}

Samples sample(const gcode::Motion& motion, const ToolExtent& tool,
               const SamplingOptions& options) {
    if (const auto* linear = std::get_if<gcode::Linear>(&motion.what)) {
        return sample_linear(*linear, tool, options);
    }
    if (const auto* arc = std::get_if<gcode::Arc>(&motion.what)) {
        return sample_arc(*arc, tool, options);
    }
    if (const auto* spline = std::get_if<gcode::Spline>(&motion.what)) {
        return sample_spline(*spline, tool, options);
    }
    return {};
}

}  // namespace ncsim::toolpath
