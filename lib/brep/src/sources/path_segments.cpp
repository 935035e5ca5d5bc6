// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of arcs, splines and rotary moves to paths in the workpiece frame.
#include "sources/path_segments.h"

#include "ncsim/base/angles.h"
#include "ncsim/toolpath/spline_arcs.h"
#include "ncsim/toolpath/tool_pose.h"

#include "geometry/tolerances.h"

#include <cmath>
#include <cstddef>

namespace ncsim::brep {

namespace {

using gcode::Position;
using toolpath::Pose;

// True if no rotary axis moves and U, V and W are 0.
bool is_plain(const Position& from, const Position& to) {
    const auto is_at_0 = [](const Position& p) {
        return p.u == gcode::Length() && p.v == gcode::Length() && p.w == gcode::Length();
    };
    return are_rotary_axes_fixed(from, to) && is_at_0(from) && is_at_0(to);
}

// Returns the frame in which the program specifies X, Y and Z, seen from W, with the rotary axes at
// `p`; no value if the linear axes are not perpendicular there.
std::optional<Pose> frame_of(const toolpath::Poses& poses, Position p) {
    Pose X_WP;
    p.x = p.y = p.z = gcode::Length();
    X_WP.translation = poses.at(p).translation;
    std::array<Vec3, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) {
        Position unit = p;
        unit.*(std::array{&Position::x, &Position::y, &Position::z}[i]) =
            gcode::Length::from_mm(1.0);
        columns[i] = poses.at(unit).translation - X_WP.translation;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        X_WP.rows[i] = {columns[0][axis], columns[1][axis], columns[2][axis]};
        if (std::abs(norm(columns[i]) - 1.0) > kRounding ||
            std::abs(dot(columns[i], columns[(i + 1) % 3])) > kRounding)
            return std::nullopt;
    }
    return X_WP;
}

Pose pose_of(const gcode::FeatureFrame& frame) {
    Pose X_WF;
    const auto at = [&](double x, double y, double z) {
        const gcode::Triple p = frame.to_parent({x, y, z});
        return Vec3{p[0], p[1], p[2]};
    };
    X_WF.translation = at(0, 0, 0);
    const Vec3 x = at(1, 0, 0) - X_WF.translation, y = at(0, 1, 0) - X_WF.translation,
               z = at(0, 0, 1) - X_WF.translation;
    X_WF.rows = {{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}};
    return X_WF;
}

// Returns the centre of the circle through both ends of an arc, which is level about `about`: the
// nearest to `centre`, along the chord. The centre stays where it would move too far: the pieces of
// a level circle have one cylinder only if their centres nearly coincide, and the far side of more
// than half a turn moves as far as the centre.
Vec3 centre_of_ends(Vec3 centre, Vec3 from, Vec3 to, Vec3 about, bool is_upright) {
    const Vec3 chord = radial_vector(from, normalized(about), to);
    const double square = dot(chord, chord);
    if (square <= kRounding) return centre;
    const Vec3 fitted = centre - (dot(centre - 0.5 * (from + to), chord) / square) * chord;
    const double moved = norm(fitted - centre);
    if (!is_upright) return moved <= 0.5 * kTangencyGapMm ? fitted : centre;
    // A height error of a micrometre where the path is level is a large error to the side.
    const bool is_up_to_half_a_turn =
        norm(about) <= 1.0 && dot(about, cross(chord, centre - from)) >= 0.0;
    return is_up_to_half_a_turn || moved <= kTangencyGapMm ? fitted : centre;
}

// Returns the path in the coordinates of the arc.
std::optional<ArcPath> arc_path(const gcode::Arc& arc) {
    constexpr std::array<std::array<int, 3>, 3> kAxes{{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};
    const auto plane = static_cast<std::size_t>(arc.plane);
    if (plane >= kAxes.size()) return std::nullopt;
    const int first = kAxes[plane][0], second = kAxes[plane][1], third = kAxes[plane][2];
    const Vec3 from = toolpath::linear_axes(arc.from), to = toolpath::linear_axes(arc.to);
    ArcPath path;
    path.centre = from;
    path.centre[first] = arc.centre_1.mm();
    path.centre[second] = arc.centre_2.mm();
    path.about[third] = 1.0;
    const auto radius = [&](Vec3 p) {
        const double x = p[first] - path.centre[first], y = p[second] - path.centre[second];
        return std::sqrt(x * x + y * y);
    };
    const double growth = radius(to) - radius(from);
    // The radii of both ends differ only because programs round ends and centre.
    const bool is_circle = std::abs(growth) <= 4.0 * kLeastSizeMm;
    if (is_circle) {
        path.centre = centre_of_ends(path.centre, from, to, arc.turns * path.about, third != 2);
    }
    path.radius = 0.5 * (radius(from) + radius(to));
    path.is_level = std::abs(from[third] - to[third]) <= kRounding;
    const auto level = [&](Vec3 p) {
        Vec3 v = p - path.centre;
        v[third] = 0.0;
        return normalized(v);
    };
    path.ahead = level(from);
    const Vec3 end = level(to);
    double swept = angle_of(dot(end, path.ahead), dot(end, cross(path.about, path.ahead)));
    const bool is_left = arc.turns > 0;
    if (is_left && swept <= 100.0 * kRounding) swept += kTurnDegrees;
    if (!is_left && swept >= -100.0 * kRounding) swept -= kTurnDegrees;
    swept += kTurnDegrees * static_cast<double>(is_left ? arc.turns - 1 : arc.turns + 1);
    path.swept = swept * kRadiansPerDegree;
    path.rise = (to[third] - from[third]) / path.swept;
    path.start = path.radius;
    if (is_circle) return path;
    const double lead = growth / (swept * kRadiansPerDegree);
    if (std::abs(swept) > kTurnDegrees || std::abs(lead) > 0.2 * path.radius) return std::nullopt;
    path.start = radius(from);
    path.growth = lead;
    path.left = 0.5 * (kTurnDegrees - std::abs(swept)) * kRadiansPerDegree;
    const auto middle = sin_cos(0.5 * swept);
    const Vec3 ahead = middle.cos * path.ahead + middle.sin * cross(path.about, path.ahead);
    path.spiral = Spiral{path.centre, path.about, normalized(ahead), path.radius, lead, 0.0};
    return path;
}

// Interpolates all axes linearly, also before the start and beyond the end.
Position in_step(const Position& from, const Position& to, double t) {
    const auto length = [t](gcode::Length p, gcode::Length q) {
        return gcode::Length::from_mm(p.mm() + t * (q.mm() - p.mm()));
    };
    const auto angle = [t](gcode::Angle p, gcode::Angle q) {
        return gcode::Angle::from_degrees(p.degrees() + t * (q.degrees() - p.degrees()));
    };
    return {length(from.x, to.x), length(from.y, to.y), length(from.z, to.z),
            angle(from.a, to.a),  angle(from.b, to.b),  angle(from.c, to.c),
            length(from.u, to.u), length(from.v, to.v), length(from.w, to.w)};
}

}  // namespace

bool are_rotary_axes_fixed(const Position& from, const Position& to) {
    return from.a == to.a && from.b == to.b && from.c == to.c;
}

std::optional<ArcPath> arc_path(const gcode::Arc& arc, const toolpath::Poses& poses) {
    if (!is_plain(arc.from, arc.to)) return std::nullopt;
    auto X_WP = frame_of(poses, arc.from);
    std::optional<ArcPath> path = X_WP ? arc_path(gcode::in_own_frame(arc)) : std::nullopt;
    if (!path) return std::nullopt;
    if (arc.tilted) X_WP = *X_WP * pose_of(*arc.tilted);
    if (X_WP->rows == Pose().rows && X_WP->translation == Vec3{}) return path;
    const Pose turn{X_WP->rows, {}};
    path->centre = *X_WP * path->centre;
    path->about = turn * path->about;
    path->ahead = turn * path->ahead;
    if (path->spiral) {
        path->spiral->centre = *X_WP * path->spiral->centre;
        path->spiral->axis = turn * path->spiral->axis;
        path->spiral->ahead = turn * path->spiral->ahead;
    }
    return path;
}

std::vector<SplinePath> spline_paths(const gcode::Spline& spline, const toolpath::Poses& poses) {
    if (!is_plain(spline.from, spline.to)) return {};
    const auto X_WP = frame_of(poses, spline.from);
    if (!X_WP) return {};
    const Pose turn{X_WP->rows, {}};
    std::vector<SplinePath> paths;
    for (const toolpath::SplinePiece& piece : toolpath::arcs_of(spline, kSplineArcError)) {
        SplinePath path{*X_WP * piece.from, *X_WP * piece.to, {}, {}, {}, piece.begins_in_corner};
        path.ends = {Plane{path.from, normalized(path.to - path.from)},
                     Plane{path.to, normalized(path.to - path.from)}};
        path.box.add(path.from);
        path.box.add(path.to);
        if (piece.radius > 0.0) {
            ArcPath arc;
            arc.centre = *X_WP * piece.centre;
            arc.about = turn * Vec3{0.0, 0.0, 1.0};
            arc.radius = arc.start = piece.radius;
            arc.ahead = normalized(path.from - arc.centre);
            arc.swept = piece.swept_degrees * kRadiansPerDegree;
            const Vec3 side = cross(arc.about, arc.ahead);
            for (const double share : {0.25, 0.5, 0.75}) {
                const auto angle = sin_cos(share * piece.swept_degrees);
                path.box.add(arc.centre +
                             piece.radius * (angle.cos * arc.ahead + angle.sin * side));
            }
            const auto direction = [&](Vec3 p) {
                const Vec3 left = normalized(cross(arc.about, p - arc.centre));
                return arc.swept > 0.0 ? left : -left;
            };
            path.ends = {Plane{path.from, direction(path.from)},
                         Plane{path.to, direction(path.to)}};
            path.arc = arc;
        }
        paths.push_back(path);
    }
    return paths;
}

std::vector<RotaryPath> rotary_paths(const gcode::Motion& motion, const toolpath::Poses& poses) {
    const auto* line = std::get_if<gcode::Linear>(&motion.action);
    if (!line) return {};
    const auto in_pieces = [&](int pieces) {
        std::vector<RotaryPath> paths;
        for (int i = 0; i < pieces; ++i) {
            const auto path = fit_rotary_path([&](double t) {
                const Pose pose = poses.at(in_step(line->from, line->to, (i + t) / pieces));
                return TipAndAxis{pose.translation, axis_of(pose)};
            });
            if (!path) return std::vector<RotaryPath>{};
            paths.push_back(*path);
        }
        return paths;
    };
    const Position &from = line->from, &to = line->to;
    double largest = 0.0;
    for (const auto& [a, b] : {std::pair(from.a, to.a), {from.b, to.b}, {from.c, to.c}})
        largest = std::max(largest, std::abs(b.degrees() - a.degrees()));
    // Planes at the ends of a piece separate its sides. Beyond three quarters of a turn, a path
    // that is continued at its ends meets itself. 120 turns are too many surfaces.
    const double pieces = largest <= 270.0 ? 1.0 : std::ceil(largest / 120.0);
    if (pieces > 360) return {};
    return in_pieces(static_cast<int>(pieces));
}

std::array<Plane, 2> ends_of(const std::vector<RotaryPath>& paths, std::size_t i) {
    // Before the first and after the last piece, the surface goes on by what the tool is wide.
    const auto plane_at = [&](double t) {
        const ToolFrame frame = tool_frame(paths[i], t);
        return Plane{frame.tip, normalized(norm(frame.speed) > 0.0 ? frame.speed : frame.turn)};
    };
    return {plane_at(i == 0 ? -0.9 * kPathExtension : 0.0),
            plane_at(i + 1 == paths.size() ? 1.0 + 0.9 * kPathExtension : 1.0)};
}

}  // namespace ncsim::brep
