// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/part.h"

#include "ncsim/trig/angles.h"

#include "nesting.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>

namespace ncsim::brep {

namespace {

using cda::cross;
using cda::dot;
using cda::norm;
using cda::normalized;

// --- Frames -------------------------------------------------------------------------------

// Points along the loops of a face, in order, and where each edge ends.
std::vector<std::vector<Vec3>> points_along(const Part& part, const Face& face) {
    constexpr std::size_t kInAPiece = 4;
    std::vector<std::vector<Vec3>> loops;
    for (const Loop& loop : face.loops) {
        std::vector<Vec3>& points = loops.emplace_back();
        for (const EdgeUse& use : loop) {
            const Edge& edge = part.edges[use.edge];
            const Track track(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
            const std::size_t steps = kInAPiece * track.pieces();
            for (std::size_t i = 0; i < steps; ++i) {
                const double t = static_cast<double>(i) / static_cast<double>(steps);
                points.push_back(track.at(use.is_forward ? t : 1.0 - t));
            }
        }
    }
    return loops;
}

// What the loops cover of a turn about an axis, degrees.
struct Round {
    double gap_begin = 0.0, gap = 0.0;  // the widest that they do not
    bool goes_round = false;            // one of them does, as a whole
    double sum = 0.0;                   // of all of them, degrees
    double nearest = 1.0;               // sine of the angle between a point and the axis, at least
};

Round round_of(const std::vector<std::vector<Vec3>>& loops, Vec3 origin, Vec3 axis, Vec3 x) {
    const Vec3 y = cross(axis, x);
    Round round;
    std::vector<std::pair<double, double>> covered;  // begin in [0, 360), length
    for (const auto& points : loops) {
        double sum = 0.0;
        std::optional<double> first, last;
        const auto take = [&](double angle) {
            if (last) {
                double step = angle - *last;
                step -= 360.0 * std::floor(step / 360.0 + 0.5);
                sum += step;
                double begin = step < 0.0 ? angle : *last;
                if (begin < 0.0) begin += 360.0;
                covered.emplace_back(begin, std::abs(step));
            } else {
                first = angle;
            }
            last = angle;
        };
        for (const Vec3& p : points) {
            const Vec3 v = p - origin;
            const double u = dot(v, x), w = dot(v, y);
            const double away = std::sqrt(u * u + w * w);
            const double far = norm(v);
            if (far > 0.0) round.nearest = std::min(round.nearest, away / far);
            // A tip has no angle.
            constexpr double kAtTip = 1e-6;
            if (away > kAtTip) take(trig::angle_of(u, w));
        }
        if (first) take(*first);
        round.goes_round = round.goes_round || std::abs(sum) > 180.0;
        round.sum += sum;
    }
    if (covered.empty()) return round;
    std::sort(covered.begin(), covered.end());
    double end = covered.front().first;
    for (const auto& [begin, length] : covered) {
        if (begin - end > round.gap) {
            round.gap = begin - end;
            round.gap_begin = end;
        }
        end = std::max(end, begin + length);
    }
    if (covered.front().first + 360.0 - end > round.gap) {
        round.gap = covered.front().first + 360.0 - end;
        round.gap_begin = end;
    }
    return round;
}

// The x axis that a face with these loops gets.
Vec3 x_axis(const std::vector<std::vector<Vec3>>& loops, Vec3 origin, Vec3 axis) {
    const Vec3 x = across(axis);
    const Round round = round_of(loops, origin, axis, x);
    constexpr double kLeastGap = 0.01;
    if (round.goes_round || round.gap < kLeastGap) {
        const Vec3 v = loops.front().front() - origin;
        const Vec3 out = v - dot(v, axis) * axis;
        return norm(out) > 1e-6 ? normalized(out) : x;
    }
    const auto angle = trig::sin_cos(round.gap_begin + 0.5 * round.gap);
    return normalized(angle.cos * x + angle.sin * cross(axis, x));
}

// Is the face a cap or a zone, between circles about one axis?
std::optional<Vec3> axis_of_zone(const Part& part, const Face& face) {
    std::optional<Vec3> axis;
    for (const Loop& loop : face.loops) {
        for (const EdgeUse& use : loop) {
            const auto* circle = std::get_if<Circle>(&part.edges[use.edge].curve);
            constexpr double kOne = 1e-9;
            if (!circle || (axis && norm(cross(*axis, circle->axis)) > kOne)) return std::nullopt;
            if (!axis) axis = circle->axis;
        }
    }
    return axis;
}

// The axis of a sphere: as far from the loops as may be, and not through the face.
Vec3 sphere_axis(const std::vector<std::vector<Vec3>>& loops, Vec3 centre) {
    const Vec3 up{0, 0, 1};
    std::vector<Vec3> axes{up};
    for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
            for (int k = 0; k <= 2; ++k) {
                const Vec3 v{double(i), double(j), double(k)};
                if (dot(v, v) > 0.0) axes.push_back(normalized(v));
            }
        }
    }
    Vec3 best = up;
    double farthest = 0.0;
    for (const Vec3& axis : axes) {
        const Round round = round_of(loops, centre, axis, across(axis));
        if (round.goes_round || round.nearest <= farthest + 1e-3) continue;
        farthest = round.nearest;
        best = axis;
    }
    return best;
}

}  // namespace

Part faceted(const cda::Boundary& boundary, const std::vector<std::vector<cda::Origin>>& origins) {
    Part part;
    part.vertices = boundary.vertices;
    std::unordered_map<std::uint64_t, std::uint32_t> edges;  // by the two vertices
    const auto edge = [&](std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax(a, b);
        const auto [at, is_new] = edges.try_emplace(std::uint64_t{low} << 32 | high,
                                                    static_cast<std::uint32_t>(part.edges.size()));
        if (is_new) part.edges.push_back({low, high, Line{}});
        return at->second;
    };
    const auto shells = shells_of(boundary);
    const auto shell = [&](std::uint32_t s) {
        Shell made;
        for (const std::uint32_t f : shells[s]) {
            const cda::BoundaryFace& from = boundary.faces[f];
            Face face;
            const Vec3 a = boundary.vertices[from.loops[0][0]];
            const Vec3 b = boundary.vertices[from.loops[0][1]];
            face.surface.form = Plane{a, from.normal};
            face.frame = {a, from.normal,
                          normalized(from.loops[0][0] < from.loops[0][1] ? b - a : a - b)};
            for (const auto& corners : from.loops) {
                Loop& loop = face.loops.emplace_back();
                for (std::size_t i = 0; i < corners.size(); ++i) {
                    const std::uint32_t p = corners[i], q = corners[(i + 1) % corners.size()];
                    loop.push_back({edge(p, q), p < q});
                }
            }
            face.origin = from.origin;
            face.origins = origins[f];
            made.push_back(static_cast<std::uint32_t>(part.faces.size()));
            part.faces.push_back(std::move(face));
        }
        return made;
    };
    for (const Nesting& nesting : nesting_of(boundary)) {
        Solid solid{shell(nesting.outside), {}};
        for (const std::uint32_t s : nesting.voids)
            solid.voids.push_back(shell(s));
        part.solids.push_back(std::move(solid));
    }
    return part;
}

bool has_tip(const Part& part, const Face& face) {
    const auto* cone = std::get_if<Cone>(&face.surface.form);
    if (!cone) return false;
    const Round round =
        round_of(points_along(part, face), cone->apex, cone->axis, across(cone->axis));
    return std::abs(round.sum) > 180.0;
}

Frame frame_for(const Part& part, const Face& face) {
    const auto loops = points_along(part, face);
    if (const auto* f = std::get_if<Cylinder>(&face.surface.form))
        return {f->origin, f->axis, x_axis(loops, f->origin, f->axis)};
    if (const auto* f = std::get_if<Torus>(&face.surface.form))
        return {f->centre, f->axis, x_axis(loops, f->centre, f->axis)};
    if (const auto* f = std::get_if<Sphere>(&face.surface.form)) {
        const auto zone = axis_of_zone(part, face);
        const Vec3 axis = zone ? *zone : sphere_axis(loops, f->centre);
        return {f->centre, axis, x_axis(loops, f->centre, axis)};
    }
    if (const auto* f = std::get_if<Cone>(&face.surface.form)) {
        // Not in the apex, where CAD would have to take a radius of 0.
        double height = 0.0;
        for (const auto& points : loops) {
            for (const Vec3& p : points)
                height = std::max(height, dot(p - f->apex, f->axis));
        }
        return {f->apex + height * f->axis, f->axis, x_axis(loops, f->apex, f->axis)};
    }
    const auto& plane = std::get<Plane>(face.surface.form);
    const EdgeUse& use = face.loops.front().front();
    const Edge& edge = part.edges[use.edge];
    const Vec3 start = part.vertices[use.is_forward ? edge.from : edge.to];
    Vec3 along = across(plane.normal);
    if (std::holds_alternative<Line>(edge.curve) && edge.from != edge.to) {
        const Vec3 v = part.vertices[edge.to] - part.vertices[edge.from];
        along = normalized(v - dot(v, plane.normal) * plane.normal);
    }
    return {start, plane.normal, along};
}

}  // namespace ncsim::brep
