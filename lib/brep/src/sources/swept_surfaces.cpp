// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces that the elements of a tool's profile sweep on lines, arcs, splines and paths of tools
// that turn.
#include "ncsim/brep/swept_surfaces.h"

#include "ncsim/base/angles.h"
#include "ncsim/toolpath/kinematics.h"
#include "ncsim/toolpath/tool_pose.h"

#include "geometry/tolerances.h"
#include "sources/path_segments.h"
#include "sources/profile_elements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

namespace ncsim::brep {

namespace {

using gcode::Position;
using toolpath::Pose;

// Largest distance of facets from the surface that a rim sweeps, mm.
constexpr double kRimMargin = 0.5;

// Returns the i-th of `pieces` equal pieces of the path.
HelixPath piece_of(const HelixPath& path, int i, int pieces) {
    if (pieces == 1) return path;
    const double width = path.swept / pieces, begin = i * width;
    const auto angle = sin_cos(begin / kRadiansPerDegree);
    HelixPath piece = path;
    piece.centre = path.centre + (path.lead * begin) * path.about;
    piece.ahead = angle.cos * path.ahead + angle.sin * cross(path.about, path.ahead);
    piece.reach = path.reach + path.growth * begin;
    piece.swept = width;
    return piece;
}

// Returns the least and the greatest height above the centre, along `axis`, that an arc passes on
// the side of the centre to which `side` points, mm; no value if the arc does not pass there.
std::optional<std::array<double, 2>> heights_passed(const ArcPath& path, Vec3 axis, Vec3 side) {
    const Vec3 on =
        path.swept < 0.0 ? cross(path.ahead, path.about) : cross(path.about, path.ahead);
    const double swept = std::abs(path.swept) / kRadiansPerDegree;
    // Returns the angle from the start, along the arc, at which the arc passes `direction`.
    const auto angle_at = [&](Vec3 direction) {
        const double angle = angle_of(dot(direction, path.ahead), dot(direction, on));
        return angle < 0.0 ? angle + kTurnDegrees : angle;
    };
    const double enters = angle_at(-axis), leaves = angle_at(axis);
    std::optional<std::array<double, 2>> heights;
    const auto take = [&](double degrees) {
        const auto angle = sin_cos(degrees);
        const Vec3 out = angle.cos * path.ahead + angle.sin * on;
        if (dot(out, side) < -kRounding) return;
        const double height = path.radius * dot(out, axis);
        if (!heights) heights = {height, height};
        (*heights)[0] = std::min((*heights)[0], height);
        (*heights)[1] = std::max((*heights)[1], height);
    };
    for (const double degrees : {0.0, swept, enters, leaves}) {
        if (degrees <= swept) take(degrees);
    }
    // The arc is on the opposite side except for the point in which it crosses the axis.
    if (heights && (*heights)[1] - (*heights)[0] <= kRounding &&
        swept > kRounding * kQuarterTurnDegrees)
        return std::nullopt;
    return heights;
}

class Sweeps {
public:
    explicit Sweeps(std::vector<CandidateSurface>& into) : into_(&into) {}

    void set_at_rest(bool at_rest) { at_rest_ = at_rest; }

    /// Sets CandidateSurface::below_side of the surfaces that follow.
    void set_below_side(std::optional<Vec3> axis) { below_side_ = axis; }

    /// Sets the box for surfaces that follow, except planes, and the end planes for surfaces that
    /// are not at rest.
    void set_place(const std::optional<Box>& place,
                   const std::optional<std::array<Plane, 2>>& ends) {
        place_ = place;
        ends_ = ends;
    }

    /// True if some surface of the motion is missing.
    bool may_leave_other_surfaces() const { return may_leave_other_surfaces_; }
    void note_unlisted_surfaces() { may_leave_other_surfaces_ = true; }

    /// Returns the factor of chord errors by which facets may be off.
    double chords() const { return chords_; }

    // Adds the surface of the element at rest.
    void rest(const ProfileElement& e, Vec3 tip, Vec3 axis) {
        const Vec3 at = tip + e.height * axis;
        if (e.fillet > 0.0) {
            tube(at, axis, e.radius, e.fillet);
        } else if (std::abs(e.rise()) <= kRounding) {
            disc(e, at, axis);
        } else if (std::abs(e.widening()) <= kRounding) {
            add(Cylinder{at, axis, e.radius});
        } else {
            cone(at, axis, e.radius, e.widening() / e.rise());
        }
    }

    void line(const ProfileElement& e, Vec3 tip, Vec3 axis, Vec3 d) {
        const double along = dot(d, axis);
        const bool is_level = std::abs(along) <= kRounding;
        const Vec3 at = tip + e.height * axis;
        const Vec3 side = normalized(cross(axis, d));
        if (norm(cross(axis, d)) <= kRounding) {
            // Along the axis, the element leaves the same surface as at rest, without the end that
            // is left last.
            rest(e, tip, axis);
        } else if (e.fillet > 0.0) {
            if (e.radius <= kRounding) {
                add(Cylinder{at, d, e.fillet});
            } else if (is_level) {
                for (const double sign : {-1.0, 1.0})
                    add(Cylinder{at + (sign * e.radius) * side, d, e.fillet});
            } else {
                envelope(e, StraightPath{tip, d, axis});
            }
        } else if (std::abs(e.rise()) <= kRounding) {
            if (is_level) disc(e, at, axis);
        } else {
            slopes(e, at, axis, side, d);
        }
    }

    // Adds the surface of the lower corner of an element on a line oblique to the axis.
    void rim(const ProfileElement& e, Vec3 tip, Vec3 axis, Vec3 d) {
        const double along = dot(d, axis);
        if (e.radius <= kRounding || std::abs(along) <= kLeastSine ||
            norm(cross(axis, d)) <= kRounding)
            return;
        add(Extrusion{tip + e.height * axis, axis, along > 0.0 ? d : -d, e.radius});
    }

    // Adds the surfaces of an arc about an axis parallel to the tool's.
    void arc(const ProfileElement& e, const HelixPath& path, bool is_level) {
        const Vec3 axis = path.axis, at = path.centre + e.height * axis;
        const double reach = path.reach;
        if (e.fillet > 0.0) {
            if (!is_level) return envelope(e, path);
            tube(at, axis, reach + e.radius, e.fillet);
            if (e.radius > kRounding && reach > e.radius)
                tube(at, axis, reach - e.radius, e.fillet);
        } else if (std::abs(e.rise()) <= kRounding) {
            if (is_level) disc(e, at, axis);
        } else if (std::abs(e.widening()) <= kRounding) {
            add(Cylinder{at, axis, reach + e.radius});
            if (reach > e.radius + kRounding) {
                add(Cylinder{at, axis, reach - e.radius}, false);
                if (!is_level) add_plunge_chords(reach, e.radius);
            }
        } else if (is_level) {
            const double slope = e.widening() / e.rise();
            cone(at, axis, reach + e.radius, slope);
            if (reach > e.radius) cone(at, axis, reach - e.radius, -slope, false);
        } else {
            note_unlisted_surfaces();
        }
    }

    // Adds the surfaces of a straight element on a path on which the tool turns.
    void flank(const ProfileElement& e, const RotaryPath& path) {
        const double length = std::sqrt(e.rise() * e.rise() + e.widening() * e.widening());
        if (e.rise() <= kRounding) {
            // The element that closes the profile above cuts no material.
            const Fillet edge{e.end_radius, e.end_height, 0.0};
            const bool is_unknown =
                e.widening() > 0.0 ? !has_across(Sweep(edge, path)) : e.rise() < -kRounding;
            if (is_unknown) note_unlisted_surfaces();
            return;
        }
        // On both sides of the path of a tip, the surface would have an edge.
        if (e.radius <= kRounding) return note_unlisted_surfaces();
        auto sweep = std::make_shared<Sweep>(
            Flank{e.radius, e.height, e.rise() / length, -e.widening() / length, length}, path);
        if (!has_across(*sweep)) return note_unlisted_surfaces();
        if (walls(*sweep)) return;
        add(Envelope{std::move(sweep)});
    }

    // Adds the envelopes of a round element on any path. If the path returns to its start, the
    // surface that is left last is tangent to the tool at the end, and the surface that is left
    // first crosses the tool there. Half turns keep these surfaces separate.
    void envelope(const ProfileElement& e, const ToolPath& path) {
        const auto* turning = std::get_if<RotaryPath>(&path);
        if (turning && e.fillet <= 0.0) return flank(e, *turning);
        if (e.fillet <= 0.0) return note_unlisted_surfaces();
        const auto* round = std::get_if<HelixPath>(&path);
        const double turns = round ? std::abs(round->swept) / (2.0 * std::numbers::pi) : 0.0;
        const int pieces = turns > 0.7 ? static_cast<int>(std::ceil(2.0 * turns)) : 1;
        // On many turns, the flank usually leaves the surface between the ends, and each envelope
        // costs time.
        if (pieces > 8) note_unlisted_surfaces();
        for (int i = 0; i < pieces; ++i) {
            if (i >= 4 && i < pieces - 4) continue;
            const ToolPath piece = round ? ToolPath(piece_of(*round, i, pieces)) : path;
            auto sweep = std::make_shared<Sweep>(Fillet{e.radius, e.height, e.fillet}, piece);
            if (!has_across(*sweep)) return note_unlisted_surfaces();
            add(Envelope{std::move(sweep)});
        }
    }

    // Adds the envelope of the corner at the start of a flank, on a path on which the tool turns.
    void rim(const ProfileElement& e, const RotaryPath& path) {
        if (e.radius <= kRounding || e.rise() <= kRounding) return;
        auto sweep = std::make_shared<Sweep>(Fillet{e.radius, e.height, 0.0}, path);
        if (!has_across(*sweep)) return note_unlisted_surfaces();
        add(Envelope{std::move(sweep)});
    }

    // True if a flat end touches the whole floor that it leaves. Its plane touches the cylinder in
    // a line, `off` from its middle. If the end slides along the line, by `slide` mm per radian,
    // the walls of the groove are farther apart than the line is long; the rim leaves the rest
    // higher. On a spiral, the next turn touches the rest if its line begins before the last one
    // ends.
    static bool is_touched(double end_radius, double radius, double slide, double off,
                           bool is_spiral) {
        if (std::abs(off) >= end_radius || radius <= end_radius * kLeastSine) return false;
        if (slide <= kRounding) return true;
        const double half = std::sqrt(end_radius * end_radius - off * off);
        if (is_spiral && std::numbers::pi * slide <= half) return true;
        const double angle =
            (end_radius * std::sqrt(1.0 + slide * slide / (radius * radius)) - half) / slide;
        return 0.5 * radius * angle * angle <= 2.0 * kLeastSizeMm;
    }

    // Adds the cylinder that a flat end leaves if it turns about a fixed line at a fixed distance:
    // the floor of a groove around a bar. The plane of the end with normal n(φ) is tangent to the
    // cylinder if n·p(φ) = n·o + radius for a point o of the line.
    void floor_around(const ProfileElement& e, const RotaryPath& path, bool is_spiral) {
        if (std::abs(e.rise()) > kRounding || e.widening() <= 0.0) return;
        const ToolFrame start = tool_frame(path, 0.0);
        const Vec3 about = normalized(cross(start.axis, start.turn));
        const Vec3 ahead = cross(about, start.axis);
        struct Level {
            double cosine, sine, height;
        };
        const auto level_at = [&](double t) {
            const ToolFrame at = tool_frame(path, t);
            return Level{dot(at.axis, start.axis), dot(at.axis, ahead),
                         dot(at.tip, at.axis) + e.height};
        };
        const Level a = level_at(0.0), b = level_at(0.5), c = level_at(1.0);
        const double determinant = (b.cosine - 1.0) * c.sine - (c.cosine - 1.0) * b.sine;
        if (std::abs(determinant) <= 1e-4) return;  // about 3 degrees
        const double u =
            ((b.height - a.height) * c.sine - (c.height - a.height) * b.sine) / determinant;
        const double w =
            ((b.cosine - 1.0) * (c.height - a.height) - (c.cosine - 1.0) * (b.height - a.height)) /
            determinant;
        const double radius = a.height - u;
        for (const double t : {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0}) {
            const Level at = level_at(t);
            const bool is_upright =
                std::abs(dot(tool_frame(path, t).axis, about)) * std::abs(radius) <= kPointError;
            if (!is_upright ||
                std::abs(u * at.cosine + w * at.sine + radius - at.height) > kPointError)
                return;
        }
        const Vec3 centre = u * start.axis + w * ahead;
        const double slide = std::abs(dot(start.speed, about)) / norm(start.turn);  // mm per radian
        const double off = dot(start.tip - centre, ahead);
        if (!is_touched(e.end_radius, std::abs(radius), slide, off, is_spiral)) return;
        add(Cylinder{centre, about, std::abs(radius)}, radius < 0.0);
        // Hulls of tools that turn may gain as many tolerances (toolpath::SamplingOptions).
        chords_ = std::max(chords_, 10.0);
    }

    // Adds the torus of a ball that turns about a fixed line at a fixed distance, without moving
    // along the line: a ring around a bar. A corner radius leaves two if its tool points at the
    // line. Returns false on any other path.
    bool ring_around(const ProfileElement& e, const RotaryPath& path) {
        if (e.fillet <= 0.0) return false;
        const auto ball_at = [&](double t) {
            const ToolFrame at = tool_frame(path, t);
            return at.tip + e.height * at.axis;
        };
        // The perpendicular bisectors of two chords meet in the centre.
        const Vec3 start = ball_at(0.0), one = ball_at(0.5) - start, two = ball_at(1.0) - start;
        const Vec3 normal = cross(one, two);
        const double square = dot(normal, normal);
        if (square <= kLeastSine * kLeastSine * dot(one, one) * dot(two, two)) return false;
        const Vec3 to_centre =
            (0.5 / square) * cross(dot(one, one) * two - dot(two, two) * one, normal);
        const Vec3 centre = start + to_centre, about = normalized(normal);
        const double radius = norm(to_centre);
        for (const double t : {0.125, 0.25, 0.375, 0.625, 0.75, 0.875}) {
            const Vec3 v = ball_at(t) - centre;
            if (std::abs(norm(v) - radius) > kPointError || std::abs(dot(v, about)) > kPointError)
                return false;
        }
        if (e.radius <= kRounding) {
            tube(centre, about, radius, e.fillet);
            return true;
        }
        const Vec3 axis = tool_frame(path, 0.0).axis;
        if (norm(start - radius * axis - centre) > kPointError) return false;
        for (const double sign : {-1.0, 1.0})
            tube(centre + (sign * e.radius) * about, about, radius, e.fillet);
        return true;
    }

    // Adds the walls of an arc whose ends have different radii. `left` is half of the angle that is
    // missing to a full turn, radians.
    void spiral(const ProfileElement& e, const Spiral& path, double left, Vec3 axis,
                bool is_level) {
        if (std::abs(e.rise()) <= kRounding) {
            if (is_level) disc(e, path.centre + e.height * axis, axis);
        } else if (std::abs(e.widening()) > kRounding) {
            note_unlisted_surfaces();
        } else {
            const double least = path.reach - std::numbers::pi * std::abs(path.lead);
            // If the ends are close, a point next to the first end is also next to the second.
            if (left < 5.0 * kRadiansPerDegree && left * least < 2.0 * e.radius)
                return note_unlisted_surfaces();
            Spiral wall = path;
            wall.offset = e.radius;
            add(wall);
            wall.offset = -e.radius;
            // Nearer to the centre, the wall has a cusp.
            if (least > 1.05 * e.radius) add(wall, false);
        }
    }

    // Adds the coil of a corner on a helix.
    void rim_around(const ProfileElement& e, const HelixPath& path, double lead) {
        if (e.radius <= kRounding || path.reach <= kRounding || std::abs(lead) <= kRounding) return;
        const Vec3 start = path.centre + e.height * path.axis;
        add(Coil{start, path.axis, path.ahead, path.reach, e.radius, lead});
        // The remaining turns of the coil pass near any level face.
        Vec3 beyond;
        for (int i = 0; i < 3; ++i) {
            const double level = std::sqrt(std::max(0.0, 1.0 - path.axis[i] * path.axis[i]));
            beyond[i] = (path.reach + e.radius) * level + kRimMargin;
        }
        Box box;
        for (const Vec3 end : {start, start + (path.lead * path.swept) * path.about}) {
            box.add(end + beyond);
            box.add(end - beyond);
        }
        into_->back().place = box;
    }

    // Adds the domes of a corner on an arc about an axis perpendicular to the tool's: a dome on
    // each side of the arc's centre, limited to the heights that the arc passes there. Beyond these
    // heights, the dome would continue along walls at the start or the end of the motion.
    void rim_across(const ProfileElement& e, const ArcPath& path, Vec3 axis) {
        if (e.radius <= kRounding || path.radius <= kRounding ||
            std::abs(dot(path.about, axis)) > kRounding)
            return;
        const Vec3 centre = path.centre + e.height * axis;
        for (const double sign : {-1.0, 1.0}) {
            const Vec3 side = sign * cross(path.about, axis);
            const auto heights = heights_passed(path, axis, side);
            if (!heights) continue;
            add(Dome{centre, axis, side, path.radius, e.radius});
            if (into_->back().ends) continue;
            const auto [low, high] = *heights;
            into_->back().ends = std::array{Plane{centre + (low - kTangencyGapMm) * axis, axis},
                                            Plane{centre + (high + kTangencyGapMm) * axis, axis}};
        }
    }

    // Adds the plane of a flat end where such an arc is level, at the bottom of a dip.
    void level_across(const ProfileElement& e, Vec3 centre, Vec3 axis, double reach) {
        if (e.fillet > 0.0 || std::abs(e.rise()) > kRounding) return;
        disc(e, centre + (e.height + (e.widening() > 0.0 ? -reach : reach)) * axis, axis);
    }

    // Adds the surfaces of an arc about an axis perpendicular to the tool's; upright sides leave
    // planes.
    void arc_across(const ProfileElement& e, const ArcPath& path, Vec3 axis) {
        if (e.fillet > 0.0) {
            tube(path.centre + e.height * axis, path.about, path.radius, e.fillet);
        } else if (std::abs(e.widening()) <= kRounding) {
            for (const double sign : {-1.0, 1.0})
                add(Plane{path.centre + (sign * e.radius) * path.about, -sign * path.about}, false);
        } else if (std::abs(e.rise()) > kRounding) {
            note_unlisted_surfaces();
        }
    }

private:
    // Sets the chord factor for helices. Between a pose of a helix and the next, lower pose, a
    // ledge is left on the inner wall, as wide as two circles are apart next to their point of
    // tangency.
    void add_plunge_chords(double reach, double radius) {
        chords_ = std::min(4.0 * reach * (1.0 / (reach - radius) + 1.0 / radius), 16.0);
    }

    // Adds the planes of an upright flank if the tool turns in the plane of its path; otherwise
    // returns false.
    bool walls(const Sweep& sweep) {
        const Flank& side = *sweep.flank();
        const ToolFrame& start = sweep.samples().front();
        const Vec3 low = cross(start.speed, start.axis), turned = cross(start.turn, start.axis);
        const Vec3 n = normalized(norm(turned) > kRounding ? turned : low);
        const auto is_across = [&](const ToolFrame& at) {
            return std::abs(dot(at.axis, n)) <= kRounding &&
                   std::abs(dot(at.tip - start.tip, n)) <= kRounding;
        };
        if (std::abs(side.sine) > kRounding || !std::ranges::all_of(sweep.samples(), is_across))
            return false;
        for (const double sign : {-1.0, 1.0})
            add(Plane{start.tip + (sign * side.radius) * n, -sign * n});
        return true;
    }

    void add(const Form& form, bool is_hollow = true) {
        const bool is_plane = std::holds_alternative<Plane>(form);
        into_->push_back({{form, is_hollow && !is_plane}, at_rest_});
        if (is_plane) return;
        into_->back().below_side = below_side_;
        into_->back().place = place_;
        if (!at_rest_) into_->back().ends = ends_;
    }

    // An element that closes the profile below looks down, above up; the material is on the
    // opposite side.
    void disc(const ProfileElement& e, Vec3 at, Vec3 axis) {
        add(Plane{at, e.widening() > 0.0 ? axis : -axis});
    }

    void tube(Vec3 centre, Vec3 axis, double major, double minor) {
        if (major <= kRounding) {
            add(Sphere{centre, minor});
        } else {
            add(Torus{centre, axis, major, minor});
        }
    }

    // Adds the cone through the circle of `radius` about `at`.
    void cone(Vec3 at, Vec3 axis, double radius, double slope, bool is_hollow = true) {
        const Vec3 apex = at - (radius / slope) * axis;
        add(Cone{apex, slope > 0.0 ? axis : -axis, std::abs(slope)}, is_hollow);
    }

    // Adds the planes that are tangent to the side along two of its rulings and parallel to the
    // path.
    void slopes(const ProfileElement& e, Vec3 at, Vec3 axis, Vec3 side, Vec3 d) {
        const double length = std::sqrt(e.rise() * e.rise() + e.widening() * e.widening());
        const double up = e.rise() / length, out = e.widening() / length;
        const Vec3 ahead = cross(side, axis);
        const double cosine = out * dot(d, axis) / (up * dot(d, ahead));
        if (std::abs(cosine) >= 1.0) return;
        const double sine = std::sqrt(1.0 - cosine * cosine);
        for (const double sign : {-1.0, 1.0}) {
            const Vec3 towards = cosine * ahead + (sign * sine) * side;
            add(Plane{at + e.radius * towards, -(up * towards - out * axis)});
        }
    }

    std::vector<CandidateSurface>* into_;
    bool at_rest_ = false;
    std::optional<Vec3> below_side_;
    std::optional<Box> place_;
    std::optional<std::array<Plane, 2>> ends_;
    bool may_leave_other_surfaces_ = false;
    double chords_ = 1.0;
};

// Adds the surfaces of an element on an arc.
void sweep_arc(Sweeps& sweeps, const ProfileElement& e, bool is_corner, const ArcPath& path,
               Vec3 axis) {
    const double along = std::abs(dot(path.about, axis));
    const bool is_about = along > 1.0 - kRounding, is_across = along <= kRounding;
    const bool is_ball = e.fillet > 0.0 && e.radius <= kRounding;
    const HelixPath round{path.centre, path.about, path.ahead, path.start,
                          path.growth, path.rise,  path.swept, axis};
    if (path.spiral && is_about && e.fillet <= 0.0) {
        sweeps.spiral(e, *path.spiral, path.left, axis, path.is_level);
    } else if (!path.spiral && is_about) {
        sweeps.arc(e, round, path.is_level);
        if (is_corner && !path.is_level) sweeps.rim_around(e, round, path.rise);
    } else if (!path.spiral && path.is_level && (is_ball || e.fillet <= 0.0)) {
        sweeps.arc_across(e, path, axis);
        if (is_across) sweeps.level_across(e, path.centre, axis, path.radius);
        if (is_corner) sweeps.rim_across(e, path, axis);
    } else {
        sweeps.envelope(e, round);
    }
}

// Adds the surfaces of an element along a spline. Each arc's surfaces are limited to a box around
// the arc.
void sweep_spline(Sweeps& sweeps, const ProfileElement& e, bool is_corner,
                  const std::vector<SplinePath>& paths, Vec3 axis) {
    const double wide = std::max(e.radius, e.end_radius) + e.fillet + kRimMargin;
    for (const SplinePath& path : paths) {
        Box box;
        for (const double height : {e.height, e.end_height}) {
            for (const Vec3 corner : {path.box.min, path.box.max}) {
                box.add(corner + height * axis + Vec3{wide, wide, wide});
                box.add(corner + height * axis - Vec3{wide, wide, wide});
            }
        }
        sweeps.set_place(box, path.ends);
        sweeps.set_at_rest(false);
        if (path.arc) {
            sweep_arc(sweeps, e, is_corner, *path.arc, axis);
        } else {
            sweeps.line(e, path.from, axis, normalized(path.to - path.from));
        }
        sweeps.set_at_rest(true);
        if (path.begins_in_corner) sweeps.rest(e, path.from, axis);
    }
    sweeps.set_place({}, {});
}

// Adds the surfaces of an element along the pieces of a path on which the tool turns.
void sweep_turning(Sweeps& sweeps, const ProfileElement& e, bool is_corner,
                   const std::vector<RotaryPath>& path) {
    if (sweeps.ring_around(e, path.front())) return;
    // Two turns are six pieces.
    sweeps.floor_around(e, path.front(), path.size() >= 6);
    // On many turns, the walls between the ends usually vanish.
    const bool has_all = path.size() <= (e.fillet > 0.0 ? 48 : 12);
    if (!has_all) sweeps.note_unlisted_surfaces();
    for (std::size_t k = 0; k < path.size(); ++k) {
        if (!has_all && k >= 4 && k + 4 < path.size()) continue;
        if (path.size() > 1) sweeps.set_place({}, ends_of(path, k));
        sweeps.envelope(e, path[k]);
        if (is_corner) sweeps.rim(e, path[k]);
    }
    sweeps.set_place({}, {});
}

// Returns the unit direction of a line. Programs round the end of a motion along the tool's axis.
Vec3 direction_of(Vec3 motion, Vec3 axis) {
    const double lateral = norm(cross(axis, motion));
    if (lateral <= 2.0 * kLeastSizeMm && lateral <= kLeastSine * norm(motion))
        return dot(axis, motion) < 0.0 ? -axis : axis;
    return normalized(motion);
}

}  // namespace

SweptSurfaces surfaces_of(const gcode::Motion& motion, const toolpath::Tool& tool,
                          const toolpath::Kinematics* specified) {
    SweptSurfaces source;
    const Position* from = gcode::start_of(motion);
    const Position* to = gcode::end_of(motion);
    if (!from || !to) return source;
    const toolpath::Poses poses(specified, motion);
    const Pose start = poses.at(*from), end = poses.at(*to);
    // If the program specifies the tip, a tool that turns about its own axis still moves straight.
    const bool turns =
        poses.has_tip_control() ? start.rows != end.rows : !are_rotary_axes_fixed(*from, *to);
    const Vec3 axis = axis_of(start);
    const auto* arc = std::get_if<gcode::Arc>(&motion.action);
    std::optional<ArcPath> path;
    if (arc) path = arc_path(*arc, poses);
    std::vector<RotaryPath> turning;
    if (turns) turning = rotary_paths(motion, poses);
    std::vector<SplinePath> spline;
    if (const auto* curve = std::get_if<gcode::Spline>(&motion.action); curve && !turns)
        spline = spline_paths(*curve, poses);
    if (!spline.empty()) source.deviation_mm = kSplineArcError;
    Sweeps sweeps(source.candidates);
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        if (!piece.cutting) continue;
        const std::vector<ProfileElement> elements = elements_of(piece);
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const ProfileElement& e = elements[i];
            const bool is_corner = i > 0 && e.fillet <= 0.0 && elements[i - 1].fillet <= 0.0;
            const bool is_below_side = e.fillet > 0.0 && i + 1 < elements.size() &&
                                       std::abs(elements[i + 1].widening()) <= kRounding && !turns;
            sweeps.set_below_side(is_below_side ? std::optional(axis) : std::nullopt);
            sweeps.set_at_rest(false);
            if (path) {
                sweep_arc(sweeps, e, is_corner, *path, axis);
            } else if (!spline.empty()) {
                sweep_spline(sweeps, e, is_corner, spline, axis);
            } else if (!turning.empty()) {
                sweep_turning(sweeps, e, is_corner, turning);
            } else if (turns || !std::holds_alternative<gcode::Linear>(motion.action)) {
                sweeps.note_unlisted_surfaces();
            } else if (start.translation != end.translation) {
                const Vec3 d = direction_of(end.translation - start.translation, axis);
                sweeps.line(e, start.translation, axis, d);
                if (is_corner) sweeps.rim(e, start.translation, axis, d);
            }
            sweeps.set_at_rest(true);
            sweeps.rest(e, start.translation, axis);
            sweeps.rest(e, end.translation, axis_of(end));
        }
    }
    source.may_leave_other_surfaces = sweeps.may_leave_other_surfaces();
    const bool is_straight = !turns && std::holds_alternative<gcode::Linear>(motion.action);
    source.chords = is_straight ? 0.0 : sweeps.chords();
    return source;
}

std::vector<CandidateSurface> surfaces_of(const toolpath::Stock& stock) {
    std::vector<CandidateSurface> candidates;
    if (stock.shape) return candidates;
    for (int i = 0; i < 3; ++i) {
        if (stock.is_round && i != stock.axis) continue;
        Vec3 n;
        n[i] = 1.0;
        candidates.push_back({{Plane{stock.box.max, n}, false}, false});
        candidates.push_back({{Plane{stock.box.min, -n}, false}, false});
    }
    if (stock.is_round) {
        Vec3 axis;
        axis[stock.axis] = 1.0;
        const double radius = 0.5 * stock.box.size()[(stock.axis + 1) % 3];
        candidates.push_back({{Cylinder{stock.box.centre(), axis, radius}, false}, false});
    }
    return candidates;
}

}  // namespace ncsim::brep
