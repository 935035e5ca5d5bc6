// SPDX-License-Identifier: GPL-3.0-or-later
#include "query/part_check.h"

#include "ncsim/base/angles.h"
#include "ncsim/brep/measure.h"

#include "geometry/tolerances.h"
#include "query/arc_crossings.h"
#include "query/face_map.h"
#include "query/map_segments.h"
#include "topology/angular_extent.h"
#include "topology/axes.h"
#include "topology/face_edges.h"
#include "topology/whole_circle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::brep {

namespace {

// True if a chord passes so near to the apex of a cone, and is off the cone by more than rounding
// in programs, that the side of the apex is undetermined; or if the chord passes the axis.
bool passes_near_apex(const Form& form, Vec3 from, Vec3 to) {
    const auto* cone = std::get_if<Cone>(&form);
    if (!cone) return false;
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
        norm(nearest - cone->apex) < 4.0 * deviation(nearest))
        return true;
    const bool goes_past = dot(level(begin), level(end)) < 0.0;
    return goes_past && deviation(nearest_to(level(begin), level(to - from))) > kTangencyGapMm;
}

// Returns the total number of turns of the loops about an axis through `origin` that the loops do
// not meet.
double turns_about(const std::vector<std::vector<Vec3>>& loops, Vec3 origin, Vec3 axis) {
    double degrees = 0.0;
    for (std::vector<Vec3> points : loops) {
        points.push_back(points.front());
        degrees += winding_angle(points, origin, axis);
    }
    return degrees / kTurnDegrees;
}

// Returns the turns about the axis of a cylinder whose loops all are whole circles about the axis.
std::optional<double> turns_of_circles(const Part& part, const Face& face) {
    const auto* cylinder = std::get_if<Cylinder>(&face.surface.form);
    if (!cylinder) return std::nullopt;
    double turns = 0.0;
    for (const Loop& loop : face.loops) {
        const auto circle = whole_circle(part, loop);
        if (!circle || !circle->is_about(cylinder->origin, cylinder->axis)) return std::nullopt;
        turns += dot(circle->axis, cylinder->axis) > 0.0 ? 1.0 : -1.0;
    }
    return turns;
}

// True if loops that go round a closed form do not occur in pairs with the face between. The
// circles
// of a tube are compared in a common plane.
bool is_without_end(const Part& part, const Face& face) {
    if (const auto turns = turns_of_circles(part, face)) return std::abs(*turns) > 0.5;
    if (const auto* cylinder = std::get_if<Cylinder>(&face.surface.form))
        return std::abs(turns_about(points_along(part, face), cylinder->origin, cylinder->axis)) >
               0.5;
    const auto* torus = std::get_if<Torus>(&face.surface.form);
    if (!torus) return false;
    auto loops = points_along(part, face);
    // A face of a spindle torus may end in the tip instead of a second loop.
    if (is_spindle(*torus)) return false;
    if (std::abs(turns_about(loops, torus->centre, torus->axis)) > 0.5) return true;
    const Axes axes(torus->centre, face.frame);
    for (auto& points : loops) {
        for (Vec3& p : points) {
            const Local at = axes(p);
            p = {at.radius - torus->major, at.z, 0.0};
        }
    }
    return std::abs(turns_about(loops, {}, {0.0, 0.0, 1.0})) > 0.5;
}

// Check of a face. Loops are divided into segments, except whole circles far from all other loops.
class FaceCheck {
public:
    FaceCheck(const Part& part, std::uint32_t face, double tolerance_mm, double clear_mm)
        : part_(part),
          face_number_(face),
          face_(part.faces[face]),
          tolerance_(tolerance_mm),
          clear_(clear_mm),
          map_(part, face_) {}

    std::vector<Fault> faults(std::optional<double> area_mm2) {
        std::vector<Loop> circles;
        std::vector<FaceMap::Round> rounds;
        for (const Loop& loop : face_.loops) {
            if (const auto round = round_of(loop)) {
                circles.push_back(loop);
                rounds.push_back(*round);
            } else if (!divide(loop)) {
                return std::move(faults_);
            }
        }
        for (const std::size_t i : rounds_near_others(rounds, segments_, clear_)) {
            if (!divide(circles[i])) return std::move(faults_);
            rounds[i].deviation = 0.0;
        }
        for (const auto& round : rounds)
            miss_ = std::max(miss_, round.deviation);
        test_whole(area_mm2);
        return std::move(faults_);
    }

    /// The largest distance of an edge from the surface, mm.
    double miss() const { return miss_; }

private:
    bool is_plane() const { return std::holds_alternative<Plane>(face_.surface.form); }
    void report(std::string what) { faults_.push_back({face_number_, std::move(what)}); }

    // Returns the image on the map of a loop that is a whole circle with a radius of at least
    // kLeastSizeMm; otherwise no value. Counts the loop if the circle is an outline.
    std::optional<FaceMap::Round> round_of(const Loop& loop) {
        const auto circle = whole_circle(part_, loop);
        if (!circle || circle->radius < kLeastSizeMm) return std::nullopt;
        const auto round = map_.round_of(*circle);
        if (!round || !std::isfinite(round->centre.x + round->centre.y + round->deviation))
            return std::nullopt;
        const auto* cone = std::get_if<Cone>(&face_.surface.form);
        if (cone && dot(circle->start - cone->apex, cone->axis) < -tolerance_) return std::nullopt;
        if (const auto* plane = std::get_if<Plane>(&face_.surface.form);
            plane && dot(circle->axis, plane->normal) > 0.0)
            ++outlines_;
        return round;
    }

    // Divides a loop into segments. Returns false if an edge has no place on the map.
    bool divide(const Loop& loop) {
        const std::size_t first = segments_.size();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const EdgeUse &use = loop[i], &next = loop[(i + 1) % loop.size()];
            const Edge &edge = part_.edges[use.edge], &after = part_.edges[next.edge];
            if ((use.is_forward ? edge.to : edge.from) != (next.is_forward ? after.from : after.to))
                report("a loop is open");
            if (!divide(use)) return false;
        }
        const bool is_counted = whole_circle(part_, loop) && is_plane();
        if (!is_counted && twice_area(first) > 0.0) ++outlines_;
        return true;
    }

    bool divide(const EdgeUse& use) {
        const Edge& edge = part_.edges[use.edge];
        const std::uint32_t begin = use.is_forward ? edge.from : edge.to;
        const std::uint32_t end = use.is_forward ? edge.to : edge.from;
        const Track& track =
            tracks_.emplace_back(edge.curve, part_.vertices[edge.from], part_.vertices[edge.to]);
        const bool is_straight = std::holds_alternative<Line>(edge.curve) && map_.keeps_lines();
        const std::size_t steps = 4 * track.pieces();
        if (!(norm(track.at(1.0) - part_.vertices[edge.to]) <= tolerance_) ||
            !(norm(track.at(0.0) - part_.vertices[edge.from]) <= tolerance_))
            report("a curve misses its end");
        Vec3 last = part_.vertices[begin];
        Vec2 last_place = map_(last);
        ProjectionSeed seed;
        std::uint64_t last_name = begin;
        double last_at = 0.0;
        for (std::size_t k = 0; k <= steps; ++k) {
            const std::size_t step = use.is_forward ? k : steps - k, piece = step / 4;
            double at = track.start_of(piece);
            if (const std::size_t quarter = step % 4; quarter != 0)
                at += 0.25 * static_cast<double>(quarter) * (track.start_of(piece + 1) - at);
            const Vec3 p = k == steps ? part_.vertices[end] : track.at(at);
            const FaceMap::Place place = map_.place(p, seed);
            if (!std::isfinite(place.at.x + place.at.y + place.deviation)) {
                report("an edge is nowhere on the surface");
                return false;
            }
            test(last, p, place);
            if (k > 0) {
                const std::uint64_t name = k == steps ? end : ++inside_;
                segments_.push_back({last_place, place.at, last_name, name, &track, last_at, at,
                                     is_straight, use.edge});
                last_name = name;
                last_place = place.at;
            }
            last = p;
            last_at = at;
        }
        return true;
    }

    // Tests the point `p` of an edge, and the chord from `last` to `p`.
    void test(Vec3 last, Vec3 p, const FaceMap::Place& place) {
        miss_ = std::max(miss_, std::abs(place.deviation));
        if (map_.is_of_other_half(place.at, tolerance_))
            report("an edge is on the other half of the circle");
        if (const auto* cone = std::get_if<Cone>(&face_.surface.form);
            cone && dot(p - cone->apex, cone->axis) < -tolerance_)
            report("an edge is beyond the apex");
        if (passes_near_apex(face_.surface.form, last, p)) report("an edge misses the apex");
    }

    // Returns twice the area on the map inside the last loop, whose first segment is `first`.
    double twice_area(std::size_t first) const {
        double sum = 0.0;
        const Vec2 from = segments_[first].a;
        for (std::size_t i = first; i < segments_.size(); ++i) {
            const Vec2 a = segments_[i].a, b = segments_[i].b;
            sum += (a.x - from.x) * (b.y - from.y) - (a.y - from.y) * (b.x - from.x);
        }
        return sum;
    }

    // Tests the conditions on all loops together.
    void test_whole(std::optional<double> area_mm2) {
        if (miss_ > tolerance_) report("an edge is off the surface");
        if (is_plane() && outlines_ != 1) report("a plane does not have one outer loop");
        const double area = area_mm2 ? *area_mm2 : measure(part_, face_, face_.frame.origin).area;
        if (area <= 0.0) report("the area is not positive");
        if (is_without_end(part_, face_)) report("a closed band has a loop at one end only");
        auto edges = any_interfere(map_, std::move(segments_), clear_);
        if (!edges && is_plane()) edges = arcs_crossing_near_corner(part_, face_);
        if (edges) faults_.push_back({face_number_, kCrossOrTouch, {edges->begin(), edges->end()}});
    }

    const Part& part_;
    std::uint32_t face_number_;
    const Face& face_;
    double tolerance_, clear_;
    FaceMap map_;
    std::vector<Fault> faults_;
    std::vector<MapSegment> segments_;
    std::deque<Track> tracks_;
    int outlines_ = 0;  // Counter-clockwise loops.
    double miss_ = 0.0;
    std::uint64_t inside_ = std::uint64_t{1} << 32;  // Names of points between vertices.
};

}  // namespace

std::vector<Fault> faults_of(const Part& part, std::uint32_t face, double tolerance_mm,
                             double& miss_mm, double clear_mm, std::optional<double> area_mm2) {
    FaceCheck check(part, face, tolerance_mm, clear_mm);
    auto faults = check.faults(area_mm2);
    miss_mm = std::max(miss_mm, check.miss());
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
    for (const EdgeUse& use : uses_of(face)) {
        const Edge& edge = part.edges[use.edge];
        if (!std::holds_alternative<Line>(edge.curve)) return false;
        edges.push_back({edge.from, edge.to, part.vertices[edge.from], part.vertices[edge.to]});
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
        for (const EdgeUse& use : uses_of(part.faces[f])) {
            ++uses[use.edge];
            sum[use.edge] += use.is_forward ? 1 : -1;
        }
        const auto more = faults_of(part, f, tolerance_mm, part.miss_mm);
        faults.insert(faults.end(), more.begin(), more.end());
    }
    for (std::size_t e = 0; e < uses.size(); ++e) {
        if (uses[e] != 0 && (uses[e] != 2 || sum[e] != 0))
            faults.push_back({0, "an edge does not have two faces"});
    }
    return faults;
}

}  // namespace ncsim::brep
