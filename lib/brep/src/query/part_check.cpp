// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces are tested on a map, on which each surface is laid out flat without a seam. Cones are seen
// along the axis; parts of cylinders and extrusions from the front, whole cylinders and tori as
// annuli; spheres in stereographic projection from the point opposite the face; coils by both
// angles as lengths; envelopes by the place across the path and the time.
#include "query/part_check.h"

#include "ncsim/brep/measure.h"
#include "ncsim/trig/angles.h"

#include "geometry/tolerances.h"
#include "query/arc_crossings.h"
#include "topology/angular_extent.h"
#include "topology/axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::brep {

using trig::kRadiansPerDegree;

namespace {

using cda::cross;
using cda::dot;
using cda::norm;
using cda::normalized;

// --- The map ------------------------------------------------------------------------------

struct Point {
    double x, y;
};

class Map {
public:
    Map(const Part& part, const Face& face)
        : form_(&face.surface.form), axes_(axes_of(face, face.frame.origin)) {
        if (is_straight_up()) {
            low_ = std::numeric_limits<double>::infinity();
            for_edges(part, face, [&](const Track& track, double) {
                for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                    const Local p = local(track.at(t));
                    low_ = std::min(low_, p.z);
                    // The x axis points away from the face.
                    constexpr double kSteep = 0.2;
                    faces_one_way_ = faces_one_way_ && p.x < -kSteep * p.radius;
                }
            });
            low_ -= 2.0 * radius_of(*form_);
        } else if (const auto* c = std::get_if<Cone>(form_)) {
            axes_.origin = c->apex;
        } else if (const auto* s = std::get_if<Sphere>(form_)) {
            Vec3 sum;
            for_edges(part, face, [&](const Track& track, double) {
                for (const double t : {0.0, 0.25, 0.5, 0.75})
                    sum = sum + (track.at(t) - s->centre);
            });
            // The loops lie about in one plane, so the face is on their left on two sides.
            Vec3 middle = normalized(sum);
            if (norm(sum) < 0.1 * s->radius) middle = face.frame.axis;
            axes_ = Axes(s->centre, {s->centre, middle, any_perpendicular(middle)});
        } else if (const auto* t = std::get_if<Torus>(form_)) {
            cut_ = cut_of(part, face, axes_, *t);
        } else if (const auto* coil = std::get_if<Coil>(form_)) {
            double sum = 0.0;
            for_edges(part, face, [&](const Track& track, double) {
                for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                    const CoilPlace place = project_onto(*coil, track.at(at));
                    sum += dot(place.out, place.motion);
                }
            });
            ahead_ = sum < 0.0 ? -1.0 : 1.0;
        }
    }

    // Position on the map, and distance from the form.
    struct Place {
        Point at;
        double deviation;
    };
    Place place(Vec3 p, ProjectionSeed& seed) const {
        const auto* envelope = std::get_if<Envelope>(form_);
        if (!envelope) return {(*this)(p), distance(*form_, p)};
        const ClosestPoint closest = project_onto(*envelope, p, seed);
        return {point_of(*envelope->sweep, closest), closest.deviation};
    }

    Point operator()(Vec3 at) const {
        // Angles count from the middle of the half of the circle, which turns with the path.
        if (const auto* c = std::get_if<Coil>(form_)) {
            const CoilPlace place = project_onto(*c, at);
            const double x = ahead_ * dot(place.out, place.motion);
            const double y = ahead_ * dot(place.out, cross(c->axis, place.motion));
            return {c->radius * trig::angle_of(x, y) * kRadiansPerDegree, c->reach * place.turn};
        }
        if (const auto* s = std::get_if<Spiral>(form_)) {
            const SpiralPlace place = project_onto(*s, at);
            return {(s->reach + s->offset) * place.turn, place.height};
        }
        if (const auto* e = std::get_if<Envelope>(form_))
            return point_of(*e->sweep, project_onto(*e, at));
        const Local p = local(at);
        if (std::holds_alternative<Plane>(*form_) || std::holds_alternative<Cone>(*form_))
            return {p.x, p.y};
        if (is_straight_up()) return faces_one_way_ ? Point{p.y, p.z} : out(p, p.z - low_);
        if (const auto* s = std::get_if<Sphere>(form_)) {
            const double scale = 2.0 * s->radius / std::max(1e-9 * s->radius, s->radius + p.z);
            return {scale * p.x, scale * p.y};
        }
        const auto& t = std::get<Torus>(*form_);
        const double angle = degrees_from(cut_, t, p) * kRadiansPerDegree;
        if (!is_spindle(t)) return out(p, t.minor * (1.0 + angle));
        return p.radius > 0.0 ? out(p, t.minor * angle) : Point{0.0, 0.0};
    }

    bool is_cone() const { return std::holds_alternative<Cone>(*form_); }

    // True if `at` is on the half of a coil's circle that leaves no surface there.
    bool is_of_other_half(Point at, double tolerance_mm) const {
        constexpr double kQuarter = 90.0 * kRadiansPerDegree;
        const auto* coil = std::get_if<Coil>(form_);
        return coil && std::abs(at.x) > kQuarter * coil->radius + tolerance_mm;
    }

    // True if straight lines are straight on the map.
    bool keeps_lines() const {
        return std::holds_alternative<Plane>(*form_) || std::holds_alternative<Cone>(*form_) ||
               std::holds_alternative<Spiral>(*form_) ||
               (is_straight_up() && faces_one_way_ && !std::holds_alternative<Dome>(*form_));
    }

private:
    static Point point_of(const Sweep& sweep, const ClosestPoint& place) {
        const double across = place_across(sweep, place.tool, place.foot);
        const Fillet* fillet = sweep.fillet();
        const double scale =
            fillet ? (fillet->centre_radius + fillet->radius) * kRadiansPerDegree : 1.0;
        return {scale * across, sweep.length_mm() * place.t};
    }

    // True if the form is a cylinder in the coordinates of its axes.
    bool is_straight_up() const {
        return std::holds_alternative<Cylinder>(*form_) ||
               std::holds_alternative<Extrusion>(*form_) || std::holds_alternative<Dome>(*form_);
    }
    Local local(Vec3 p) const {
        const auto* dome = std::get_if<Dome>(form_);
        return dome ? local_on(*dome, axes_, p) : axes_(p);
    }
    static Point out(const Local& p, double radius) {
        return {radius * p.x / p.radius, radius * p.y / p.radius};
    }

    const Form* form_;
    Axes axes_;
    double low_ = 0.0, cut_ = 0.0;
    double ahead_ = 1.0;         // Coils: which half of the circle.
    bool faces_one_way_ = true;  // True if the face is seen from the front without hiding itself.
};

struct Segment {
    Point a, b;
    std::uint64_t from, to;  // Names of the ends; adjacent segments have a common name.
    const Track* track;      // Edge of which the segment is a chord, between `begin` and `end`.
    double begin, end;
    bool is_straight;  // Also on the map.
    std::uint32_t edge;
    double deviation = 0.0;  // Bound of the distance between chord and curve.
    double low() const { return std::min(a.y, b.y) - deviation; }
    double high() const { return std::max(a.y, b.y) + deviation; }
    double left() const { return std::min(a.x, b.x) - deviation; }
    double right() const { return std::max(a.x, b.x) + deviation; }
};

double turn(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double squared_distance(Point p, const Segment& s) {
    const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
    const double length = dx * dx + dy * dy;
    double t = length > 0.0 ? ((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / length : 0.0;
    t = std::clamp(t, 0.0, 1.0);
    const double x = s.a.x + t * dx - p.x, y = s.a.y + t * dy - p.y;
    return x * x + y * y;
}

bool cross_each_other(const Segment& s, const Segment& t) {
    return (turn(s.a, s.b, t.a) > 0.0) != (turn(s.a, s.b, t.b) > 0.0) &&
           (turn(t.a, t.b, s.a) > 0.0) != (turn(t.a, t.b, s.b) > 0.0);
}

bool interfere(const Segment& s, const Segment& t, double clear) {
    const double near = clear * clear;
    // Adjacent segments share a point; the parts beyond that point must not lie on each other.
    const bool joined = s.to == t.from;
    const bool joined_back = t.to == s.from;
    const bool heads = s.from == t.from;
    const bool tails = s.to == t.to;
    if (joined || joined_back || heads || tails) {
        if (joined && joined_back) return false;
        const Point& s_far = joined || tails ? s.a : s.b;
        const Point& t_far = joined || heads ? t.b : t.a;
        return squared_distance(s_far, t) < near || squared_distance(t_far, s) < near;
    }
    return cross_each_other(s, t) || squared_distance(s.a, t) < near ||
           squared_distance(s.b, t) < near || squared_distance(t.a, s) < near ||
           squared_distance(t.b, s) < near;
}

double segment_distance(const Segment& s, const Segment& t) {
    if (cross_each_other(s, t)) return 0.0;
    return std::sqrt(std::min({squared_distance(s.a, t), squared_distance(s.b, t),
                               squared_distance(t.a, s), squared_distance(t.b, s)}));
}

// Splits a segment. For nearly circular curves, each half is off by a quarter of the whole's
// distance.
std::array<Segment, 2> halves_of(const Map& map, const Segment& s) {
    const double middle = 0.5 * (s.begin + s.end);
    const Point p = map(s.track->at(middle));
    Segment first = s, second = s;
    first.b = second.a = p;
    first.end = second.begin = middle;
    first.deviation = second.deviation =
        s.is_straight ? 0.0 : 0.5 * std::sqrt(squared_distance(p, s));
    return {first, second};
}

// Returns the sine of the angle between two chords.
double sine_between(const Segment& s, const Segment& t) {
    const double sx = s.b.x - s.a.x, sy = s.b.y - s.a.y, tx = t.b.x - t.a.x, ty = t.b.y - t.a.y;
    const double lengths = std::sqrt((sx * sx + sy * sy) * (tx * tx + ty * ty));
    return lengths > 0.0 ? std::abs(sx * ty - sy * tx) / lengths : 0.0;
}

// True if two pieces of curves without a common end come nearer than `clear`. Chords are halved
// until the result is clear; a segment outside the map counts as near. Pieces at an angle below
// `least_sine` may be near each other.
bool curves_interfere(const Map& map, Segment s, Segment t, double clear, int depth,
                      double least_sine = 0.0) {
    if (!std::isfinite(s.deviation + t.deviation)) return true;
    if (segment_distance(s, t) >= s.deviation + t.deviation + clear) return false;
    if (depth == 0 || s.deviation + t.deviation <= 0.25 * clear)
        return segment_distance(s, t) < clear && sine_between(s, t) >= least_sine;
    if (s.deviation < t.deviation) std::swap(s, t);
    const auto [first, second] = halves_of(map, s);
    return curves_interfere(map, first, t, clear, depth - 1, least_sine) ||
           curves_interfere(map, second, t, clear, depth - 1, least_sine);
}

// Criterion for pieces of curves from a common point that meet again.
struct RepeatedContact {
    double clearance;       // mm: the pieces come nearer than this to each other,
    double least_sine;      // at an angle with at least this sine,
    double least_distance;  // mm: farther than this from the common point.
};
// Angle that readers notice. At smaller angles, curves are tangent in their corner except for
// rounding.
constexpr RepeatedContact kCrossing{1e-9, 0.06, 1e-3};
// Any angle, far from the corner. Facets may leave a corner that stands for two; curves that miss
// only by rounding cross nearer to the corner.
constexpr RepeatedContact kCrossingElsewhere{1e-9, 0.0, 0.1};

// True if the pieces, which start in a common point, meet again. Next to facets, curves miss their
// ends by more than the criterion; the piece left after all halvings is such a miss.
bool meet_past_common_end(const Map& map, const Segment& s, const Segment& t,
                          const RepeatedContact& limits, int halvings = 40) {
    constexpr int kDepth = 30;
    if (halvings == 0) return false;
    const double sx = s.b.x - s.a.x, sy = s.b.y - s.a.y, tx = t.b.x - t.a.x, ty = t.b.y - t.a.y;
    const double near = limits.least_distance * limits.least_distance;
    const bool is_acute = sx * tx + sy * ty > 0.0;
    if (!is_acute || sx * sx + sy * sy < near || tx * tx + ty * ty < near) return false;
    const auto [s_near, s_far] = halves_of(map, s);
    const auto [t_near, t_far] = halves_of(map, t);
    const auto meet = [&](const Segment& one, const Segment& other) {
        return curves_interfere(map, one, other, limits.clearance, kDepth, limits.least_sine);
    };
    return meet(s_far, t_far) || meet(s_near, t_far) || meet(s_far, t_near) ||
           meet_past_common_end(map, s_near, t_near, limits, halvings - 1);
}

// Reverses the pieces so that both start in the common point.
bool neighbours_meet_again(const Map& map, Segment s, Segment t, const RepeatedContact& limits) {
    if (s.to == t.from && t.to == s.from) return false;
    const auto reverse = [](Segment& piece) {
        std::swap(piece.a, piece.b);
        std::swap(piece.begin, piece.end);
    };
    if (s.to == t.from || s.to == t.to) reverse(s);
    if (t.to == s.from || t.to == s.to) reverse(t);
    return meet_past_common_end(map, s, t, limits);
}

bool have_common_end(const Segment& s, const Segment& t) {
    return s.to == t.from || t.to == s.from || s.from == t.from || s.to == t.to;
}

// Segments by the strips of x in which they lie. A face with a grid of holes has many segments at
// the same height, but few of them are near each other.
class Strips {
public:
    /// Requires: `segments` ascending by low(), with a longer lifetime than the strips.
    Strips(const std::vector<Segment>& segments, double clear)
        : segments_(segments), clear_(clear) {
        constexpr std::size_t kOfAStrip = 256;  // segments
        double right = -std::numeric_limits<double>::infinity();
        left_ = -right;
        for (const Segment& s : segments) {
            left_ = std::min(left_, s.left());
            right = std::max(right, s.right());
        }
        std::size_t count = segments.size() / kOfAStrip + 1;
        const double width = (right - left_) / static_cast<double>(count);
        // A single strip is used if positions are not finite.
        const bool has_width = std::isfinite(width) && width > 0.0 && std::isfinite(1.0 / width);
        if (!has_width) count = 1;
        per_mm_ = has_width ? 1.0 / width : 0.0;
        members_.resize(count);
        first_.resize(count, 0);
        if (count == 1) {
            members_.front().resize(segments.size());
            std::iota(members_.front().begin(), members_.front().end(), 0U);
            return;
        }
        for (std::uint32_t i = 0; i < segments.size(); ++i) {
            const auto [first, last] = strips_of(segments[i], 0.0);
            for (std::size_t k = first; k <= last; ++k)
                members_[k].push_back(i);
        }
    }

    /// Writes the segments after `i` whose boxes come within the clearance of the box of `i`,
    /// ascending.
    /// Requires: `i` is not less than in the last call.
    void find(std::uint32_t i, std::vector<std::uint32_t>& others) {
        const Segment& s = segments_[i];
        others.clear();
        const auto [first, last] = strips_of(s, clear_);
        for (std::size_t k = first; k <= last; ++k) {
            const auto& members = members_[k];
            std::size_t& next = first_[k];
            while (next < members.size() && members[next] <= i)
                ++next;
            for (std::size_t m = next; m < members.size(); ++m) {
                const Segment& t = segments_[members[m]];
                if (t.low() > s.high() + clear_) break;
                if (t.right() < s.left() - clear_ || t.left() > s.right() + clear_) continue;
                others.push_back(members[m]);
            }
        }
        if (first == last) return;
        std::ranges::sort(others);
        others.erase(std::unique(others.begin(), others.end()), others.end());
    }

private:
    // Returns the first and the last strip of a segment; all strips if the segment has no finite
    // position.
    std::pair<std::size_t, std::size_t> strips_of(const Segment& s, double more) const {
        const std::size_t last = members_.size() - 1;
        const auto strip = [&](double x, std::size_t least_distance) {
            const double at = (x - left_) * per_mm_;
            if (!std::isfinite(at)) return least_distance;
            return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(last)));
        };
        return {strip(s.left() - more, 0), strip(s.right() + more, last)};
    }

    const std::vector<Segment>& segments_;
    double clear_, left_ = 0.0, per_mm_ = 0.0;
    std::vector<std::vector<std::uint32_t>> members_;
    std::vector<std::size_t> first_;  // For each strip: first member after `i`.
};

// Returns the edges of two pieces that interfere.
std::optional<std::array<std::uint32_t, 2>> any_interfere(const Map& map,
                                                          std::vector<Segment> segments,
                                                          double clear) {
    // A piece of 4 degrees is off by a hundredth of its length; the map may bend pieces more.
    constexpr double kMostOff = 0.1, kNearEnd = 0.05;
    constexpr int kDepth = 40;
    const auto length = [](const Segment& s) {
        const double x = s.b.x - s.a.x, y = s.b.y - s.a.y;
        return std::sqrt(x * x + y * y);
    };
    for (Segment& s : segments) {
        if (!s.is_straight) s.deviation = kMostOff * length(s);
    }
    std::sort(segments.begin(), segments.end(),
              [](const Segment& s, const Segment& t) { return s.low() < t.low(); });
    const auto do_interfere = [&](const Segment& s, const Segment& t) {
        const bool both_straight = s.is_straight && t.is_straight;
        if (both_straight) return interfere(s, t, clear);
        // Chords of curves that are tangent in a common end may lie on each other. On cones,
        // readers report a crossing.
        const RepeatedContact near_end{clear, 0.0, kNearEnd};
        const auto is_near = [&] {
            return interfere(s, t, clear) &&
                   (map.is_cone() || std::min(length(s), length(t)) < kNearEnd ||
                    neighbours_meet_again(map, s, t, near_end));
        };
        return have_common_end(s, t) ? is_near() || neighbours_meet_again(map, s, t, kCrossing) ||
                                           neighbours_meet_again(map, s, t, kCrossingElsewhere)
                                     : curves_interfere(map, s, t, clear, kDepth);
    };
    Strips strips(segments, clear);
    std::vector<std::uint32_t> others;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        const Segment& s = segments[i];
        strips.find(i, others);
        for (const std::uint32_t j : others) {
            if (do_interfere(s, segments[j])) return {{s.edge, segments[j].edge}};
        }
    }
    return std::nullopt;
}

// True if a chord passes so near to the apex of a cone, and is off the cone by more than rounding
// in programs, that the side of the apex is undetermined; or if the chord passes the axis.
bool passes_near_apex(const Form& form, Vec3 from, Vec3 to) {
    const auto* cone = std::get_if<Cone>(&form);
    if (!cone) return false;
    constexpr double kNearEnd = 4.0;
    const auto nearest_to = [&](Vec3 v, Vec3 chord) {
        const double length = dot(chord, chord);
        const double t = length > 0.0 ? -dot(v, chord) / length : 0.0;
        return from + std::clamp(t, 0.0, 1.0) * (to - from);
    };
    const auto deviation = [&](Vec3 p) { return std::abs(distance(form, p)); };
    const auto level = [&](Vec3 v) { return v - dot(v, cone->axis) * cone->axis; };
    const Vec3 begin = from - cone->apex, end = to - cone->apex;
    const Vec3 nearest = nearest_to(begin, to - from);
    if (deviation(nearest) > kTangencyGapMm &&
        norm(nearest - cone->apex) < kNearEnd * deviation(nearest))
        return true;
    const bool goes_past = dot(level(begin), level(end)) < 0.0;
    return goes_past && deviation(nearest_to(level(begin), level(to - from))) > kTangencyGapMm;
}

// Returns the total number of turns of the loops about an axis through `origin` that the loops do
// not meet.
double turns_about(const std::vector<std::vector<Vec3>>& loops, Vec3 origin, Vec3 axis) {
    constexpr double kTurn = 360.0;
    double degrees = 0.0;
    for (std::vector<Vec3> points : loops) {
        points.push_back(points.front());
        degrees += winding_angle(points, origin, axis);
    }
    return degrees / kTurn;
}

// True if loops that go round a closed form do not come in pairs with the face between. The circles
// of a tube are compared in a common plane.
bool is_without_end(const Part& part, const Face& face) {
    constexpr double kHalf = 0.5;
    if (const auto* cylinder = std::get_if<Cylinder>(&face.surface.form))
        return std::abs(turns_about(points_along(part, face), cylinder->origin, cylinder->axis)) >
               kHalf;
    const auto* torus = std::get_if<Torus>(&face.surface.form);
    if (!torus) return false;
    auto loops = points_along(part, face);
    if (std::abs(turns_about(loops, torus->centre, torus->axis)) > kHalf) return true;
    const Axes axes(torus->centre, face.frame);
    for (auto& points : loops) {
        for (Vec3& p : points) {
            const Local at = axes(p);
            p = {at.radius - torus->major, at.z, 0.0};
        }
    }
    return std::abs(turns_about(loops, {}, {0.0, 0.0, 1.0})) > kHalf;
}

double twice_area(const std::vector<Segment>& loop) {
    double sum = 0.0;
    for (const Segment& s : loop)
        sum += (s.a.x - loop[0].a.x) * (s.b.y - loop[0].a.y) -
               (s.a.y - loop[0].a.y) * (s.b.x - loop[0].a.x);
    return sum;
}

}  // namespace

std::vector<Fault> faults_of(const Part& part, std::uint32_t face_number, double tolerance_mm,
                             double& miss_mm, double clear_mm, std::optional<double> area_mm2) {
    const Face& face = part.faces[face_number];
    std::vector<Fault> faults;
    const auto report = [&](std::string what) { faults.push_back({face_number, std::move(what)}); };
    const Map map(part, face);
    std::vector<Segment> all;
    int outlines = 0;
    double miss = 0.0;
    std::uint64_t inside = std::uint64_t{1} << 32;  // Names of points between vertices.
    std::deque<Track> tracks;
    for (const Loop& loop : face.loops) {
        std::vector<Segment> segments;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const EdgeUse& use = loop[i];
            const Edge& edge = part.edges[use.edge];
            const std::uint32_t begin = use.is_forward ? edge.from : edge.to;
            const std::uint32_t end = use.is_forward ? edge.to : edge.from;
            const EdgeUse& next = loop[(i + 1) % loop.size()];
            const Edge& after = part.edges[next.edge];
            if (end != (next.is_forward ? after.from : after.to)) report("a loop is open");
            const Track& track =
                tracks.emplace_back(edge.curve, part.vertices[edge.from], part.vertices[edge.to]);
            const bool is_straight = std::holds_alternative<Line>(edge.curve);
            const std::size_t steps = 4 * track.pieces();
            if (!(norm(track.at(1.0) - part.vertices[edge.to]) <= tolerance_mm) ||
                !(norm(track.at(0.0) - part.vertices[edge.from]) <= tolerance_mm))
                report("a curve misses its end");
            Vec3 last = part.vertices[begin];
            Point last_place = map(last);
            ProjectionSeed seed;
            std::uint64_t last_name = begin;
            double last_at = 0.0;
            for (std::size_t k = 0; k <= steps; ++k) {
                const std::size_t step = use.is_forward ? k : steps - k, piece = step / 4;
                double at = track.start_of(piece);
                if (const std::size_t quarter = step % 4; quarter != 0)
                    at += 0.25 * static_cast<double>(quarter) * (track.start_of(piece + 1) - at);
                Vec3 p = track.at(at);
                if (k == steps) p = part.vertices[end];
                const Map::Place place = map.place(p, seed);
                if (!std::isfinite(place.at.x + place.at.y + place.deviation)) {
                    report("an edge is nowhere on the surface");
                    return faults;
                }
                miss = std::max(miss, std::abs(place.deviation));
                if (map.is_of_other_half(place.at, tolerance_mm))
                    report("an edge is on the other half of the circle");
                if (const auto* cone = std::get_if<Cone>(&face.surface.form);
                    cone && dot(p - cone->apex, cone->axis) < -tolerance_mm) {
                    report("an edge is beyond the apex");
                }
                if (passes_near_apex(face.surface.form, last, p)) report("an edge misses the apex");
                if (k > 0) {
                    const std::uint64_t name = k == steps ? end : ++inside;
                    segments.push_back({last_place, place.at, last_name, name, &track, last_at, at,
                                        is_straight && map.keeps_lines(), use.edge});
                    last_name = name;
                    last_place = place.at;
                }
                last = p;
                last_at = at;
            }
        }
        if (twice_area(segments) > 0.0) ++outlines;
        all.insert(all.end(), segments.begin(), segments.end());
    }
    miss_mm = std::max(miss_mm, miss);
    if (miss > tolerance_mm) report("an edge is off the surface");
    if (std::holds_alternative<Plane>(face.surface.form) && outlines != 1)
        report("it has not one outline");
    const double area = area_mm2 ? *area_mm2 : measure(part, face, face.frame.origin).area;
    if (area <= 0.0) report("it has no area");
    if (is_without_end(part, face)) report("it goes round and has no other end");
    auto edges = any_interfere(map, std::move(all), clear_mm);
    if (!edges && std::holds_alternative<Plane>(face.surface.form))
        edges = arcs_crossing_near_corner(part, face);
    if (edges) faults.push_back({face_number, kCrossOrTouch, {edges->begin(), edges->end()}});
    return faults;
}

bool only_touches_itself(const Part& part, const Face& face, double clear_mm) {
    const auto* plane = std::get_if<Plane>(&face.surface.form);
    if (!plane) return false;
    struct Straight {
        std::uint32_t from, to;
        Vec3 a, b;
    };
    std::vector<Straight> edges;
    for (const Loop& loop : face.loops) {
        for (const EdgeUse& use : loop) {
            const Edge& edge = part.edges[use.edge];
            if (!std::holds_alternative<Line>(edge.curve)) return false;
            edges.push_back({edge.from, edge.to, part.vertices[edge.from], part.vertices[edge.to]});
        }
    }
    // Returns the distance of a point to the left of an edge.
    const auto left_distance = [&](const Straight& s, Vec3 p) {
        return dot(plane->normal, cross(normalized(s.b - s.a), p - s.a));
    };
    const auto parts = [&](const Straight& s, const Straight& t) {
        const double a = left_distance(s, t.a), b = left_distance(s, t.b);
        return (a > clear_mm && b < -clear_mm) || (a < -clear_mm && b > clear_mm);
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const Straight &s = edges[i], &t = edges[j];
            const bool have_an_end =
                s.from == t.from || s.from == t.to || s.to == t.from || s.to == t.to;
            if (!have_an_end && parts(s, t) && parts(t, s)) return false;
        }
    }
    return true;
}

std::vector<Fault> check_part(Part& part, double tolerance_mm) {
    std::vector<Fault> faults;
    std::vector<int> uses(part.edges.size(), 0), sum(part.edges.size(), 0);
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        for (const Loop& loop : part.faces[f].loops) {
            for (const EdgeUse& use : loop) {
                ++uses[use.edge];
                sum[use.edge] += use.is_forward ? 1 : -1;
            }
        }
        const auto more = faults_of(part, f, tolerance_mm, part.miss_mm);
        faults.insert(faults.end(), more.begin(), more.end());
    }
    for (std::size_t e = 0; e < uses.size(); ++e) {
        if (uses[e] != 0 && (uses[e] != 2 || sum[e] != 0)) faults.push_back({0, "it is open"});
    }
    return faults;
}

}  // namespace ncsim::brep
