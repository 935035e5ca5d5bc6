// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides motions into steps with bounds: chords of arcs and splines, rotations about rotary axes
// of the default machine and of specified machines.
#include "ncsim/toolpath/sampler.h"

#include "ncsim/base/angles.h"
#include "ncsim/toolpath/extent.h"
#include "ncsim/toolpath/kinematics.h"

#include "motion/axis_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ncsim::toolpath {

using gcode::Angle;
using gcode::Length;
using gcode::Position;

namespace {

// --- Steps --------------------------------------------------------------------------------

// Values of a whole motion, from which the bounds of its steps follow.
struct Course {
    double sweep_rad = 0.0;  // angle of an arc
    double radius_mm = 0.0;  // largest radius
    double radius_change_mm = 0.0;
    double way_mm = 0.0;  // length of the tip's path without rotations
    RotationBounds turning;

    RotationBounds step(double steps) const {
        RotationBounds t = turning;
        const double delta = sweep_rad / steps;
        t.chord_mm = (radius_mm * delta * delta + 2 * radius_change_mm / steps * delta) / 8;
        t.turn_rad /= steps;
        t.tilt_rad /= steps;
        t.tilt_bend_rad /= steps * steps;
        t.moved_mm /= steps;
        return t;
    }
};

// Returns the fewest steps, from `low` to `most`, for which `enough` is true. Requires: if n steps
// are enough, so are more.
template <typename Enough>
std::uint32_t fewest(std::uint32_t low, std::uint32_t most, const Enough& enough) {
    std::uint32_t high = low;
    while (high < most && !enough(high))
        high = std::min(most, high * 2);
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

// Returns the least number of steps. An arc has at least two chords, whatever the tolerance, and a
// full circle three, so that the circle has an area. A rotation has steps of at most 5 degrees,
// even where nothing is cut, because pictures of the path show the tool's positions.
std::uint32_t least_steps(const Course& c, const SamplingOptions& o) {
    constexpr double kLongestTurn = 5.0 * kRadiansPerDegree;
    const double thirds = std::ceil(c.sweep_rad / (2 * std::numbers::pi / 3));
    const double turns = std::ceil(c.turning.turn_rad / kLongestTurn);
    const double least = std::clamp(std::max(thirds, turns), 1.0, double{1e9});
    auto low = static_cast<std::uint32_t>(least);
    if (c.sweep_rad > 0) low = std::max(low, 2U);
    return std::min(low, std::max(1U, o.max_steps));
}

// Divides the turns of a helix equally, like a circle of the same radius. Then the chords of each
// turn lie above those of the preceding turn, and a shank as thick as its cutter meets no cusps
// between the turns.
std::uint32_t whole_turns(const Course& c, std::uint32_t steps, const SamplingOptions& o) {
    const double turns = std::round(c.sweep_rad / (2 * std::numbers::pi));
    constexpr double kRounding = 1e-9;
    if (turns < 2.0 || std::abs(c.sweep_rad - 2 * std::numbers::pi * turns) > kRounding * turns)
        return steps;
    const double even = std::ceil(steps / turns) * turns;
    return even <= o.max_steps ? static_cast<std::uint32_t>(even) : steps;
}

// Returns the cost of a step in the simulation. Longer hulls meet more of the part and of each
// other, and each hull has its facets.
double cost_of(const ToolExtent& tool) {
    double sum = 0.0;
    for (const PieceExtent& piece : tool.pieces)
        sum += piece.high_mm - piece.low_mm + 4 * piece.radius_mm;
    return sum;
}

double radius_of(const ToolExtent& tool) {
    double radius = 0.0;
    for (const PieceExtent& piece : tool.pieces)
        radius = std::max(radius, piece.radius_mm);
    return radius;
}

double longest_straight(const ToolExtent& tool) {
    double length = 0.0;
    for (const PieceExtent& piece : tool.pieces)
        length = std::max(length, piece.high_mm - piece.straight_mm);
    return length;
}

template <typename PositionAt>
Samples sample_course(const Course& course, const ToolExtent& whole, const SamplingOptions& options,
                      const Poses& poses, const PositionAt& position_at) {
    const ToolExtent tool = below(whole, course.turning.top_mm);
    Samples samples;
    const auto pose = [&](std::uint32_t i, std::uint32_t steps) {
        return poses.at(position_at(i == steps ? 1.0 : static_cast<double>(i) / steps));
    };
    // Returns the gain of the step with the largest gain. Stops at a gain above `limit`.
    const auto gained = [&](const RotationBounds& turning, const ToolExtent& slabs,
                            std::uint32_t steps, double limit) {
        double worst = 0.0;
        Pose last = pose(0, steps);
        for (std::uint32_t i = 1; i <= steps && worst <= limit; ++i) {
            const Pose next = pose(i, steps);
            worst = std::max(worst, gained_mm(last, next, turning, slabs));
            last = next;
        }
        return worst;
    };
    // First, bounds that hold for all steps at once determine a least number of steps.
    std::uint32_t steps =
        fewest(least_steps(course, options), options.max_steps, [&](std::uint32_t n) {
            const RotationBounds t = course.step(n);
            if (t.chord_mm > options.chord_tolerance_mm) return false;
            return t.turn_rad == 0.0 || t.chord_mm + missed_mm(t, tool) <= options.rotation_miss_mm;
        });
    double slab_mm = RotationBounds::kInf;
    if (course.turning.turn_rad > 0.0) {
        const auto fewest_in = [&](const ToolExtent& slabs) {
            return fewest(steps, options.max_steps, [&](std::uint32_t n) {
                const std::uint32_t even = whole_turns(course, n, options);
                return gained(course.step(even), slabs, even, options.rotation_gain_mm) <=
                       options.rotation_gain_mm;
            });
        };
        std::uint32_t best = fewest_in(tool);
        double least = best * cost_of(tool);
        // Shorter slabs need fewer steps if the gain decides. They are used while the total cost
        // falls.
        for (double slab = longest_straight(tool) / 2; best > steps && slab >= 2 * radius_of(tool);
             slab /= 2) {
            const ToolExtent slabs = split_into_slabs(tool, slab);
            const std::uint32_t fewer = fewest_in(slabs);
            const double cost = fewer * cost_of(slabs);
            if (!(cost < least)) break;
            least = cost;
            best = fewer;
            slab_mm = slab;
        }
        steps = best;
    }
    steps = whole_turns(course, steps, options);
    samples.turning = course.step(steps);
    samples.turning.slab_mm = slab_mm;
    samples.bounds.missed_mm = samples.turning.chord_mm + missed_mm(samples.turning, tool);
    samples.bounds.gained_mm = samples.turning.chord_mm;
    if (course.turning.turn_rad > 0.0) {
        samples.bounds.gained_mm +=
            gained(samples.turning, split_into_slabs(tool, slab_mm), steps, RotationBounds::kInf);
    }
    samples.poses.reserve(steps + std::size_t{1});
    for (std::uint32_t i = 0; i <= steps; ++i)
        samples.poses.push_back(pose(i, steps));
    return samples;
}

// --- Rotary axes --------------------------------------------------------------------------

// Least and largest |cos| of the angles from a to b.
struct Cosines {
    double least = 1.0, largest = 1.0;
};
Cosines cosines(Angle a, Angle b) {
    const double low = std::min(a.degrees(), b.degrees());
    const double high = std::max(a.degrees(), b.degrees());
    const double at_low = std::abs(sin_cos(low).cos);
    const double at_high = std::abs(sin_cos(high).cos);
    const auto passes = [&](double degrees) {  // or `degrees` plus a multiple of 180
        return std::floor((high - degrees) / 180.0) >= std::ceil((low - degrees) / 180.0);
    };
    return {passes(90.0) ? 0.0 : std::min(at_low, at_high),
            passes(0.0) ? 1.0 : std::max(at_low, at_high)};
}

// Returns the direction of the line through the origin about which a motion rotates. Empty if not
// exactly a single rotary axis moves.
std::optional<Vec3> turning_axis(const Position& from, const Position& to) {
    const bool a = from.a != to.a, b = from.b != to.b, c = from.c != to.c;
    if (a + b + c != 1) return {};
    // A point on the axis, rotated by the axes that follow in pose_at().
    Position at;
    at.*(a ? &Position::x : b ? &Position::y : &Position::z) = Length::from_mm(1.0);
    if (a) at.b = from.b;
    if (a || b) at.c = from.c;
    return pose_at(at).translation;
}

double distance_from(const std::optional<Vec3>& axis, Vec3 p) {
    return norm(axis ? p - dot(p, *axis) * *axis : p);
}

// Returns a bound on the height above the tip, along the tool axis, of a place in the box `place`
// within `radius_mm` of the tool axis. The tool is near the pose X_WT: its axis deviates by at most
// `tilt_rad`, and its tip by at most `way_mm`. At height z, a disc across the axis a extends along
// X from T + z a - r to T + z a + r, with r² = radius² (1 - a²).
double highest_point_near(const Pose& X_WT, double tilt_rad, double way_mm, double radius_mm,
                          const Box& place) {
    double highest = RotationBounds::kInf;
    const Vec3 axis = axis_of(X_WT);
    for (int i = 0; i < 3; ++i) {
        const double steepest = std::min(1.0, std::abs(axis[i]) + tilt_rad);
        const double flattest = std::abs(axis[i]) - tilt_rad;
        if (!(flattest > 0.0)) continue;
        const double up =
            axis[i] > 0.0 ? place.max[i] - X_WT.translation[i] : X_WT.translation[i] - place.min[i];
        const double aside = radius_mm * std::sqrt(std::max(0.0, 1.0 - flattest * flattest));
        const double room = up + way_mm + aside;
        highest = std::min(highest, room / (room > 0.0 ? flattest : steepest));
    }
    return highest;
}

// Returns the same bound for a whole motion. `tilt_rad` and `way_mm` are the lengths of the paths
// of axis and tip; at any time, the nearer end of the motion is at most half of these away.
double highest_point_near(const Pose& start, const Pose& end, double tilt_rad, double way_mm,
                          double radius_mm, const Box& place) {
    return std::max(highest_point_near(start, tilt_rad / 2, way_mm / 2, radius_mm, place),
                    highest_point_near(end, tilt_rad / 2, way_mm / 2, radius_mm, place));
}

std::array<Vec3, 8> corners_of(const Box& box) {
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {i & 1 ? box.min.x : box.max.x, i & 2 ? box.min.y : box.max.y,
                      i & 4 ? box.min.z : box.max.z};
    return corners;
}

// Returns the rotation of a whole motion of the default machine. Between the ends, the tip is at
// most `bulge_mm` farther from the axis than at the ends, and not lower than `lowest_mm()`, which
// is only called for rotary moves. `way_mm` is the length of the tip's path without rotations,
// `radius_mm` the largest radius of the tool.
template <class Lowest>
RotationBounds rotation_bounds_of(const Position& from, const Position& to, const Lowest& lowest_mm,
                                  double bulge_mm, double way_mm, double radius_mm,
                                  const std::optional<Box>& place) {
    RotationBounds t;
    t.moved_mm = way_mm;
    const auto radians = [](Angle a, Angle b) {
        return kRadiansPerDegree * std::abs((b - a).degrees());
    };
    const double a = radians(from.a, to.a), b = radians(from.b, to.b), c = radians(from.c, to.c);
    t.turn_rad = a + b + c;
    if (t.turn_rad == 0.0) return t;
    // The tool axis is at right angles to X. `from_y` and `from_z` bound the sine of its angle to Y
    // and Z.
    const Cosines of_a = cosines(from.a, to.a), of_b = cosines(from.b, to.b);
    const double from_y = of_a.largest;
    const double upright = of_a.least * of_b.least;
    const double from_z = std::sqrt(std::max(0.0, 1.0 - upright * upright));
    t.tilt_bend_rad =
        a * a + (b * b * from_y + 2 * b * a) + (c * c * from_z + 2 * c * (a + b * from_y));
    t.tilt_rad = a + b * from_y + c * from_z;

    const std::optional<Vec3> axis = turning_axis(from, to);
    if (axis) t.lean = a > 0.0 ? 1.0 : b > 0.0 ? from_y : from_z;
    const Pose start = pose_at(from), end = pose_at(to);
    t.tip_mm = bulge_mm + std::max(distance_from(axis, start.translation),
                                   distance_from(axis, end.translation));
    if (!place || place->is_empty()) return t;
    // Heights along the tool axis: heights of the places above the origin, less the height of the
    // tip, which is Z.
    t.place_mm = 0.0;
    double highest = 0.0, farthest = 0.0;
    double at_ends = -RotationBounds::kInf;
    for (const Vec3 corner : corners_of(*place)) {
        const double distance = distance_from(axis, corner);
        t.place_mm = std::max(t.place_mm, distance);
        farthest = std::max(farthest, norm(corner));
        at_ends = std::max({at_ends, dot(axis_of(start), corner), dot(axis_of(end), corner)});
        if (!axis) continue;
        const double lean = dot(axis_of(start), *axis);
        highest = std::max(highest, std::abs(lean * dot(corner, *axis)) +
                                        std::sqrt(std::max(0.0, 1.0 - lean * lean)) * distance);
    }
    if (!axis) highest = farthest;
    t.top_mm = std::min(highest, at_ends + t.tilt_rad / 2 * farthest) - lowest_mm();
    const double way = way_mm + t.turn_rad * t.tip_mm;
    t.top_mm =
        std::min(t.top_mm, highest_point_near(start, end, t.tilt_rad, way,
                                              radius_mm + RotationBounds::kSideMargin, *place));
    return t;
}

// --- Specified machines ----------------------------------------------------------------------

// A rotary joint that moves in a motion, with the remaining joints at the start of the motion.
struct RotatingJoint {
    Vec3 direction, through;  // in W
    double radians = 0.0;
};

// Position of the tip during the whole motion, seen from between two joints: within `radius` mm of
// a point that moves from `from` to `to`.
struct Reach {
    Vec3 from, to;
    double radius = 0.0;
};

double distance_from_line(Vec3 p, Vec3 through, Vec3 direction) {
    const Vec3 out = p - through;
    return norm(out - dot(out, direction) * direction);
}

// Returns the rotation of a whole motion of a specified machine, following the joints from the tool
// to the part. `bulge_mm` has the meaning above; `way_mm` is the length of the tip's path relative
// to bodies that do not rotate.
RotationBounds rotation_bounds_of(const Poses& poses, const gcode::Motion& motion, double bulge_mm,
                                  double way_mm, double radius_mm,
                                  const std::optional<Box>& place) {
    const machine::Chain& chain = *poses.chain();
    const Position &from = *gcode::start_of(motion), &to = *gcode::end_of(motion);
    const SecondAxes second = poses.has_tip_control() ? second_axes(chain, motion) : SecondAxes{};
    const machine::Values v0 = values_of(from), v1 = values_of(to);
    const auto of = [&chain](const machine::Values& v, const machine::Joint& joint) {
        const std::size_t i = *machine::index_of(joint.letter);
        const bool adds = i < 3 && !chain.find(machine::kLetters[i + 6]);  // U, V, W
        return adds ? v[i] + v[i + 6] : v[i];
    };
    RotationBounds t;
    Reach tip{{}, {}, bulge_mm};
    Vec3 axis{0, 0, 1};        // tool axis at the start of the motion
    double ways = 0.0;         // sum over linear joints
    bool is_one_block = true;  // no rotary joint between linear joints that move
    bool has_turned = false, has_moved = false;
    bool is_alone = true;
    double distance = 0.0;
    std::vector<RotatingJoint> turning;  // from the tool to the part
    // Whether a linear joint moves between a rotary joint that moves and the part.
    bool head_turns = false;
    for (std::size_t i = chain.joints.size(); i-- > 0;) {
        const machine::Joint& joint = chain.joints[i];
        const double a = of(v0, joint), b = of(v1, joint);
        const auto carry = [&](RotatingJoint& inner) {
            inner.through = machine::move_by_joint(joint, a, inner.through);
            inner.direction = machine::rotate_by_joint(joint, a, inner.direction);
        };
        if (!joint.turns) {
            tip.from = machine::move_by_joint(joint, a, tip.from);
            tip.to = machine::move_by_joint(joint, b, tip.to);
            if (a != b) {
                is_one_block &= !has_moved || !has_turned;
                has_moved = true;
                ways += std::abs(b - a);
                head_turns |= !turning.empty();
            }
            std::ranges::for_each(turning, carry);
            continue;
        }
        has_turned |= has_moved;
        const Vec3 n = joint.direction;
        const double radians = kRadiansPerDegree * std::abs(b - a);
        if (radians == 0.0) {
            tip.from = machine::move_by_joint(joint, a, tip.from);
            tip.to = machine::move_by_joint(joint, b, tip.to);
            axis = machine::rotate_by_joint(joint, a, axis);
            std::ranges::for_each(turning, carry);
            continue;
        }
        // Sine of the angle between the tool axis and the joint's axis.
        const double lean = std::min(1.0, norm(cross(n, axis)) + t.tilt_rad);
        const bool spins = poses.has_tip_control() && second.along_tool &&
                           norm(cross(n, axis)) + t.tilt_rad == 0.0;
        t.tilt_bend_rad += radians * (radians * lean + 2 * t.tilt_rad);
        t.tilt_rad += radians * lean;
        if (!spins) t.turn_rad += radians;
        axis = machine::rotate_by_joint(joint, a, axis);
        // The point of the joint's axis nearest to the tip. If only a single joint rotates, the
        // distance from its axis counts.
        const Vec3 middle = 0.5 * (tip.from + tip.to);
        const Vec3 through = joint.through + dot(middle - joint.through, n) * n;
        const bool first = turning.empty();
        is_alone = first;
        const double far = std::max(norm(tip.from - through), norm(tip.to - through)) + tip.radius;
        if (first) {
            t.lean = lean;
            distance = std::max(distance_from_line(tip.from, through, n),
                                distance_from_line(tip.to, through, n)) +
                       tip.radius;
            t.tip_mm = far;
        } else {
            t.tip_mm = std::max(t.tip_mm, far);
        }
        tip = {through, through, far};
        std::ranges::for_each(turning, carry);
        turning.push_back({n, through, radians});
    }
    // The speeds of three axes add up to at most √3 times their common speed, which is at most 2.
    const double moved = is_one_block ? way_mm : std::max(ways, 2 * way_mm);
    // Length of the tip's path in W.
    double tip_way = moved;
    const Pose start = poses.at(from), end = poses.at(to);
    if (poses.has_tip_control()) {
        // The tool rotates about the programmed point X, Y, Z. U, V and W determine the distance of
        // the tip from that point.
        t.tip_mm = second.reach_mm;
        t.lean = 1.0;
        t.moved_mm = second.way_mm;
        tip_way = way_mm + second.way_mm + t.turn_rad * second.reach_mm;
    } else {
        t.moved_mm = moved;
        tip_way += t.turn_rad * t.tip_mm;
        if (is_alone && !turning.empty()) {
            t.tip_mm = distance;
        } else {
            t.lean = 1.0;
        }
    }
    if (t.turn_rad == 0.0 || !place || place->is_empty()) return t;
    if (!poses.has_tip_control() && !head_turns) {
        // Distances of the places from the first axis. The distances between the axes are added,
        // there and back.
        const RotatingJoint& outer = turning.back();
        t.place_mm = 0.0;
        for (const Vec3 corner : corners_of(*place)) {
            t.place_mm = std::max(
                t.place_mm, is_alone ? distance_from_line(corner, outer.through, outer.direction)
                                     : norm(corner - outer.through));
        }
        for (std::size_t i = 1; i < turning.size(); ++i)
            t.place_mm += 2 * norm(turning[i].through - turning[i - 1].through);
    }
    // Heights of the places above the tip, along the tool axis, from the nearer end of the motion.
    t.top_mm = -RotationBounds::kInf;
    for (const Pose& X_WT : {start, end}) {
        for (const Vec3 corner : corners_of(*place)) {
            const Vec3 out = corner - X_WT.translation;
            t.top_mm = std::max(
                t.top_mm, dot(out, axis_of(X_WT)) + std::min(2.0, t.tilt_rad / 2) * norm(out));
        }
    }
    t.top_mm += tip_way / 2 + bulge_mm;
    t.top_mm =
        std::min(t.top_mm, highest_point_near(start, end, t.tilt_rad, tip_way,
                                              radius_mm + RotationBounds::kSideMargin, *place));
    return t;
}

Course course_of(const gcode::Motion& motion, const gcode::Linear& m, const Poses& poses,
                 const ToolExtent& tool, const std::optional<Box>& place) {
    Course c;
    const double way = norm(poses.unrotated_place(m.to) - poses.unrotated_place(m.from));
    c.way_mm = way;
    if (poses.chain()) {
        c.turning = rotation_bounds_of(poses, motion, 0.0, way, radius_of(tool), place);
    } else {
        const auto lowest_mm = [&m] {
            return std::min(linear_axes(m.from).z, linear_axes(m.to).z);
        };
        c.turning = rotation_bounds_of(m.from, m.to, lowest_mm, 0.0, way, radius_of(tool), place);
    }
    return c;
}

Samples sample_linear(const gcode::Motion& motion, const gcode::Linear& m, const Poses& poses,
                      const ToolExtent& tool, const SamplingOptions& options,
                      const std::optional<Box>& place) {
    return sample_course(course_of(motion, m, poses, tool, place), tool, options, poses,
                         [&m](double t) { return interpolate(m.from, m.to, t); });
}

Course course_of(const gcode::Motion& motion, const gcode::Arc& m, const PolarArc& p,
                 const Poses& poses, const ToolExtent& tool, const std::optional<Box>& place) {
    Course c;
    c.sweep_rad = std::abs(p.sweep_degrees) * kRadiansPerDegree;
    c.radius_mm = std::max(p.start_radius, p.end_radius);
    c.radius_change_mm = std::abs(p.end_radius - p.start_radius);
    const double way = c.radius_mm * c.sweep_rad + c.radius_change_mm +
                       norm(poses.unrotated_place(m.to) - poses.unrotated_place(m.from));
    c.way_mm = way;
    if (poses.chain()) {
        c.turning = rotation_bounds_of(poses, motion, 2 * c.radius_mm, way, radius_of(tool), place);
    } else {
        const auto lowest_mm = [&] { return extent_of_path(motion, poses).min.z; };
        c.turning = rotation_bounds_of(m.from, m.to, lowest_mm, 2 * c.radius_mm, way,
                                       radius_of(tool), place);
    }
    return c;
}

Samples sample_arc(const gcode::Motion& motion, const gcode::Arc& m, const Poses& poses,
                   const ToolExtent& tool, const SamplingOptions& options,
                   const std::optional<Box>& place) {
    const PolarArc p = polar(m);
    return sample_course(course_of(motion, m, p, poses, tool, place), tool, options, poses,
                         [&](double t) { return arc_position(m, p, t); });
}

// --- Splines ------------------------------------------------------------------------------

double distance_to_chord(Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 ab = b - a;
    const double squared = dot(ab, ab);
    const double t = squared > 0 ? std::clamp(dot(p - a, ab) / squared, 0.0, 1.0) : 0.0;
    return norm(p - (a + t * ab));
}

Samples sample_spline(const gcode::Motion& motion, const gcode::Spline& m, const Poses& poses,
                      const ToolExtent& tool, const SamplingOptions& options,
                      const std::optional<Box>& place) {
    const SplineCurve curve(m);
    if (!curve.is_sound())
        return sample_linear(motion, {m.from, m.to}, poses, tool, options, place);
    Samples samples;
    samples.poses.push_back(poses.at(m.from));
    struct Piece {
        double from, to;
        int depth;
    };
    std::vector<Piece> pending;
    const std::vector<double> breaks = curve.breaks();
    for (std::size_t i = breaks.size(); i-- > 1;)
        pending.push_back({breaks[i - 1], breaks[i], 0});
    constexpr int kMinDepth = 2;  // the middle of an S lies on its chord
    constexpr int kMaxDepth = 20;
    double worst = 0.0;
    while (!pending.empty()) {
        const Piece piece = pending.back();
        pending.pop_back();
        const Vec3 a = poses.place(curve.at(piece.from));
        const Vec3 b = poses.place(curve.at(piece.to));
        double off = 0.0;
        for (const double t : {0.25, 0.5, 0.75}) {
            const Vec3 p = poses.place(curve.at(lerp(piece.from, piece.to, t)));
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
            samples.poses.push_back(poses.at(curve.at(piece.to)));
        }
    }
    samples.bounds = {2 * worst, 2 * worst};
    return samples;
}

}  // namespace

std::optional<double> max_deviation_mm(const gcode::Motion& motion, const Poses& poses,
                                       double reach_mm) {
    Course c;
    if (const auto* linear = std::get_if<gcode::Linear>(&motion.action)) {
        c = course_of(motion, *linear, poses, {}, {});
    } else if (const auto* arc = std::get_if<gcode::Arc>(&motion.action)) {
        c = course_of(motion, *arc, polar(*arc), poses, {}, {});
    } else {
        return std::nullopt;
    }
    // At any time, the nearer end is at most half of the total path away.
    const RotationBounds& t = c.turning;
    const double moved =
        poses.has_tip_control() ? c.way_mm + t.moved_mm : std::max(c.way_mm, t.moved_mm);
    const double way = moved + t.turn_rad * t.tip_mm;
    return way / 2 + t.tilt_rad / 2 * reach_mm;
}

Samples sample(const gcode::Motion& motion, const ToolExtent& tool, const SamplingOptions& options,
               const std::optional<Box>& place, const Kinematics* specified) {
    const Poses poses(specified, motion);
    if (const auto* linear = std::get_if<gcode::Linear>(&motion.action)) {
        return sample_linear(motion, *linear, poses, tool, options, place);
    }
    if (const auto* arc = std::get_if<gcode::Arc>(&motion.action)) {
        return sample_arc(motion, *arc, poses, tool, options, place);
    }
    if (const auto* spline = std::get_if<gcode::Spline>(&motion.action)) {
        return sample_spline(motion, *spline, poses, tool, options, place);
    }
    return {};
}

}  // namespace ncsim::toolpath
