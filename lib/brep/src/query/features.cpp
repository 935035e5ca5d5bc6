// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recognition of features by the faces around cylinders and planes.
#include "ncsim/brep/features.h"

#include "ncsim/base/angles.h"
#include "ncsim/brep/frames.h"
#include "ncsim/brep/measure.h"

#include "geometry/no_index.h"
#include "geometry/tolerances.h"
#include "topology/angular_extent.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

namespace ncsim::brep {

namespace {

struct Span {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    double length() const { return high - low; }
    bool overlaps(const Span& other) const { return low < other.high && other.low < high; }
    Span common(const Span& other) const {
        return {std::max(low, other.low), std::min(high, other.high)};
    }
};

// True if the segment from `a` to `b` passes through the triangle.
bool pierces(Vec3 a, Vec3 b, const TriangleCorners& t) {
    const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
    const double before = dot(n, a - t[0]), behind = dot(n, b - t[0]);
    if ((before > 0.0) == (behind > 0.0)) return false;
    const Vec3 p = a + (before / (before - behind)) * (b - a);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 side = t[(i + 1) % 3] - t[i];
        if (dot(cross(n, side), p - t[i]) < 0.0) return false;
    }
    return true;
}

class Measurer {
public:
    Measurer(const Part& part, const TriangleTree& between)
        : part_(part), between_(between), beside_(sides_of_edges(part)) {}

    Features operator()() {
        for (const Solid& solid : part_.solids) {
            for_shells(solid, [&](const Shell& shell) { take(shell); });
        }
        measure_walls();
        sort(features_.bores);
        sort(features_.bosses);
        sort(features_.countersinks);
        sort(features_.chamfers);
        sort(features_.corners);
        sort(features_.floors);
        std::ranges::stable_sort(features_.distances, {}, [](const Distance& d) {
            return std::tuple(!d.is_void, d.mm, d.from.x, d.from.y, d.from.z, d.to.x, d.to.y);
        });
        return std::move(features_);
    }

private:
    // Sorts by the first motion that cut the feature, then by position in X, Y, Z.
    template <typename Feature>
    static void sort(std::vector<Feature>& features) {
        std::ranges::stable_sort(features, [](const Feature& a, const Feature& b) {
            const Vec3 p = place(a), q = place(b);
            return std::tuple(first(a), p.x, p.y, p.z) < std::tuple(first(b), q.x, q.y, q.z);
        });
    }
    template <typename Feature>
    static std::uint32_t first(const Feature& f) {
        return f.origins.empty() ? 0 : static_cast<std::uint32_t>(f.origins.front());
    }
    static Vec3 place(const Bore& b) { return b.mouth; }
    static Vec3 place(const Boss& b) { return b.foot; }
    static Vec3 place(const Countersink& c) { return c.mouth; }
    static Vec3 place(const Chamfer& c) { return c.at; }
    static Vec3 place(const Corner& c) { return c.on_axis; }
    static Vec3 place(const Floor& f) { return f.box.min; }

    void take(const Shell& shell) {
        for (const std::uint32_t f : shell) {
            const Face& face = part_.faces[f];
            if (face.is_facet) {
                ++features_.facets;
                features_.facet_area += std::abs(measure(part_, face, face.frame.origin).area);
            } else if (const auto* cylinder = std::get_if<Cylinder>(&face.surface.form)) {
                take_cylinder(f, *cylinder);
            } else if (const auto* cone = std::get_if<Cone>(&face.surface.form)) {
                if (!take_countersink(f, *cone)) take_chamfer(f, cone);
            } else if (const auto* plane = std::get_if<Plane>(&face.surface.form)) {
                planes_.push_back(f);
                take_chamfer(f, nullptr);
                if (plane->normal.z > 1.0 - kRounding) take_floor(f, *plane);
            }
        }
    }

    // --- Cylinders --------------------------------------------------------------------------

    // End of a cylinder: position along the axis, and kinds of the faces beyond.
    struct Rim {
        Span along;
        bool is_opening = false, is_closing = false;
        std::uint32_t beyond = kNone;  // The face beyond with the least index.
    };

    void take_cylinder(std::uint32_t f, const Cylinder& form) {
        const Face& face = part_.faces[f];
        Vec3 up = form.axis;
        if (up.z < -kRounding || (std::abs(up.z) <= kRounding && up.x + up.y < 0.0)) up = -up;
        const auto loops = points_along(part_, face);
        Span along;
        for (const auto& points : loops) {
            for (const Vec3& p : points)
                along.add(dot(p - form.origin, up));
        }
        const AngularExtent round = angular_extent(loops, form.origin, up, any_perpendicular(up));
        const double covers = round.is_full_turn ? 360.0 : 360.0 - round.gap;
        if (covers <= 180.0 + kPointError) {
            features_.corners.push_back({form.radius, face.surface.is_hollow, covers,
                                         form.origin + 0.5 * (along.low + along.high) * up, up,
                                         face.origins});
            return;
        }
        if (!face.surface.is_hollow) {
            features_.bosses.push_back({form.origin + along.low * up, up, 2.0 * form.radius,
                                        along.length(), covers, face.origins});
            return;
        }
        features_.bores.push_back(bore(f, form, up, along, covers));
    }

    // Returns the end of a cylinder or cone about the axis through `origin` in direction `out`,
    // with the faces beyond its edges there. `slant` is the cosine of the angle between the axis
    // and the lines of the surface.
    Rim rim(std::uint32_t f, Vec3 origin, Vec3 out, double slant = 1.0) const {
        Rim rim;
        const Face& face = part_.faces[f];
        for (std::size_t i = 0; i < face.loops.size(); ++i) {
            for (const EdgeUse& use : face.loops[i]) {
                const Edge& edge = part_.edges[use.edge];
                const Track track = track_of(part_, edge);
                const Vec3 p = track.at(0.5);
                const Vec3 along = (use.is_forward ? 1.0 : -1.0) * track.derivative(0.5);
                // The face is on the left of the edges.
                const Vec3 inwards = cross(outward(face.surface, p), normalized(along));
                // Edges at the sides of the face run nearly along the axis.
                if (dot(inwards, out) > -0.2 * slant) continue;
                for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
                    rim.along.add(dot(track.at(t) - origin, out));
                const std::uint32_t beyond = beside_[use.edge][use.is_forward ? 1 : 0];
                if (beyond == kNone) continue;
                rim.beyond = std::min(rim.beyond, beyond);
                (opens(beyond, p, out) ? rim.is_opening : rim.is_closing) = true;
            }
        }
        return rim;
    }

    // True if a face that begins where a bore ends leads out of the bore; false if the face closes
    // the bore.
    bool opens(std::uint32_t beyond, Vec3 p, Vec3 out) const {
        const Surface& surface = part_.faces[beyond].surface;
        const double looks = dot(outward(surface, p), out);
        if (std::abs(looks) > kPointError) return looks > 0.0;
        // The face continues the cylinder smoothly; a hollow face narrows.
        return !surface.is_hollow;
    }

    Bore bore(std::uint32_t f, const Cylinder& form, Vec3 up, const Span& along,
              double covers) const {
        Bore bore;
        bore.diameter = 2.0 * form.radius;
        bore.covers_degrees = covers;
        bore.origins = part_.faces[f].origins;
        Rim top = rim(f, form.origin, up), bottom = rim(f, form.origin, -up);
        // A bore that is closed above and open below was cut from below.
        const bool is_upside_down = top.is_closing && bottom.is_opening && !bottom.is_closing;
        if (is_upside_down) std::swap(top, bottom);
        bore.axis = is_upside_down ? -up : up;
        const double highest = is_upside_down ? -along.low : along.high;
        const double lowest = is_upside_down ? -along.high : along.low;
        bore.mouth = form.origin + highest * bore.axis;
        bore.depth = highest - lowest;
        if (top.along.length() > kPointError) bore.mouth_slants_by = top.along.length();
        bore.end = end_of(bore, bottom);
        return bore;
    }

    BoreEnd end_of(Bore& bore, const Rim& bottom) const {
        if (bottom.is_opening) return bottom.is_closing ? BoreEnd::Other : BoreEnd::Through;
        if (bottom.beyond == kNone) return BoreEnd::Other;
        const Face& beyond = part_.faces[bottom.beyond];
        const Form& form = beyond.surface.form;
        if (const auto* plane = std::get_if<Plane>(&form)) {
            if (dot(plane->normal, bore.axis) < 1.0 - kRounding) return BoreEnd::Other;
            return beyond.loops.size() > 1 ? BoreEnd::Shoulder : BoreEnd::Flat;
        }
        const auto depth_of = [&](Vec3 p) { return dot(bore.mouth - p, bore.axis); };
        if (const auto* cone = std::get_if<Cone>(&form)) {
            if (norm(cross(cone->axis, bore.axis)) > kPointError) return BoreEnd::Other;
            bore.tip_angle_degrees = 2.0 * half_angle_rad(*cone) * 180.0 / std::numbers::pi;
            if (!has_tip(part_, beyond)) return BoreEnd::Shoulder;
            bore.tip_depth = depth_of(cone->apex);
            return BoreEnd::Cone;
        }
        if (const auto* sphere = std::get_if<Sphere>(&form)) {
            if (beyond.loops.size() > 1) return BoreEnd::Other;
            bore.tip_depth = depth_of(sphere->centre) + sphere->radius;
            return BoreEnd::Ball;
        }
        return std::holds_alternative<Torus>(form) ? BoreEnd::Rounded : BoreEnd::Other;
    }

    // --- Cones and chamfers -----------------------------------------------------------------

    // Adds the cone if the cone is a countersink. The tip of a drilled bore is not, because the
    // wide end continues in the bore.
    bool take_countersink(std::uint32_t f, const Cone& cone) {
        const Face& face = part_.faces[f];
        if (!face.surface.is_hollow) return false;
        const auto loops = points_along(part_, face);
        const AngularExtent round =
            angular_extent(loops, cone.apex, cone.axis, any_perpendicular(cone.axis));
        const double covers = round.is_full_turn ? 360.0 : 360.0 - round.gap;
        if (covers <= 180.0 + kPointError) return false;
        const double slant = 1.0 / std::sqrt(1.0 + cone.slope * cone.slope);
        const Rim mouth = rim(f, cone.apex, cone.axis, slant);
        if (!mouth.is_opening || mouth.is_closing) return false;
        Countersink sink;
        sink.axis = cone.axis;
        sink.mouth = cone.apex + mouth.along.high * cone.axis;
        sink.diameter = 2.0 * cone.slope * mouth.along.high;
        sink.has_tip = has_tip(part_, face);
        Span along;
        for (const auto& points : loops) {
            for (const Vec3& p : points)
                along.add(dot(p - cone.apex, cone.axis));
        }
        sink.depth = mouth.along.high - (sink.has_tip ? 0.0 : along.low);
        sink.angle_degrees = 2.0 * half_angle_rad(cone) * 180.0 / std::numbers::pi;
        sink.covers_degrees = covers;
        sink.origins = face.origins;
        features_.countersinks.push_back(std::move(sink));
        return true;
    }

    // Convex edge of a face.
    struct ConvexEdge {
        Vec3 at, along;  // middle of the edge, and its direction there
        Vec3 normal;     // of the face beyond
        double length = 0.0;
    };

    // Returns the edges at which the angle inside the material is between 90° and 180°.
    std::vector<ConvexEdge> blunt_edges(const Face& face) const {
        std::vector<ConvexEdge> edges;
        for (const EdgeUse& use : uses_of(face)) {
            const std::uint32_t beyond = beside_[use.edge][use.is_forward ? 1 : 0];
            if (beyond == kNone || part_.faces[beyond].is_facet) continue;
            const Edge& edge = part_.edges[use.edge];
            const Track track = track_of(part_, edge);
            const Vec3 p = track.at(0.5);
            const Vec3 along = normalized((use.is_forward ? 1.0 : -1.0) * track.derivative(0.5));
            const Vec3 own = outward(face.surface, p);
            const Vec3 other = outward(part_.faces[beyond].surface, p);
            const double cosine = dot(own, other);
            if (dot(cross(own, along), other) > -kPointError || cosine < kPointError) continue;
            double length = 0.0;
            for (int i = 0; i < kSamples / 2; ++i)
                length += norm(track.at((i + 1.0) / (0.5 * kSamples)) -
                               track.at(i * 1.0 / (0.5 * kSamples)));
            edges.push_back({p, along, other, length});
        }
        return edges;
    }

    // Adds the face if it has blunt edges to a level face and to an upright face. `cone` is null
    // for a plane.
    void take_chamfer(std::uint32_t f, const Cone* cone) {
        const Face& face = part_.faces[f];
        const std::vector<ConvexEdge> edges = blunt_edges(face);
        std::optional<Chamfer> best;
        for (const ConvexEdge& level : edges) {
            if (std::abs(level.normal.z) < 1.0 - kRounding) continue;
            for (const ConvexEdge& upright : edges) {
                if (std::abs(upright.normal.z) > kPointError) continue;
                const auto chamfer = chamfer_between(face, cone, level, upright);
                if (chamfer && (!best || chamfer->length > best->length)) best = chamfer;
            }
        }
        if (!best) return;
        best->origins = face.origins;
        features_.chamfers.push_back(std::move(*best));
    }

    static std::optional<Chamfer> chamfer_between(const Face& face, const Cone* cone,
                                                  const ConvexEdge& level,
                                                  const ConvexEdge& upright) {
        Chamfer chamfer;
        chamfer.height = std::abs(level.at.z - upright.at.z);
        if (cone) {
            if (std::abs(cone->axis.z) < 1.0 - kRounding) return std::nullopt;
            chamfer.width = chamfer.height * cone->slope;
        } else {
            // Edges at the ends of a chamfer are not parallel to the edges along it.
            if (norm(cross(level.along, upright.along)) > kLeastSine) return std::nullopt;
            chamfer.width = std::abs(dot(level.at - upright.at, upright.normal));
        }
        if (chamfer.width < kPointError || chamfer.height < kPointError) return std::nullopt;
        const Vec3 own = outward(face.surface, level.at);
        chamfer.angle_degrees = angle_of(dot(own, level.normal), norm(cross(own, level.normal)));
        chamfer.length = std::max(level.length, upright.length);
        chamfer.at = level.at;
        return chamfer;
    }

    // --- Floors -----------------------------------------------------------------------------

    void take_floor(std::uint32_t f, const Plane& plane) {
        const Face& face = part_.faces[f];
        Floor floor;
        floor.z = plane.origin.z;
        floor.area = measure(part_, face, plane.origin).area;
        floor.origins = face.origins;
        for (const auto& points : points_along(part_, face)) {
            for (const Vec3& p : points)
                floor.box.add(p);
        }
        floor.is_closed = std::ranges::all_of(face.loops.front(), [&](const EdgeUse& use) {
            return rises_next_to(use, {0, 0, 1});
        });
        features_.floors.push_back(std::move(floor));
    }

    // True if the face beyond the edge rises from the edge.
    bool rises_next_to(const EdgeUse& use, Vec3 up) const {
        const std::uint32_t beyond = beside_[use.edge][use.is_forward ? 1 : 0];
        if (beyond == kNone) return false;
        const Edge& edge = part_.edges[use.edge];
        const Track track = track_of(part_, edge);
        const Vec3 p = track.at(0.5);
        const Vec3 along = (use.is_forward ? -1.0 : 1.0) * track.derivative(0.5);
        const Surface& surface = part_.faces[beyond].surface;
        const double rise = dot(cross(outward(surface, p), normalized(along)), up);
        return std::abs(rise) > kPointError ? rise > 0.0 : surface.is_hollow;
    }

    // --- Distances --------------------------------------------------------------------------

    // Planar face in the coordinates of its direction.
    struct Wall {
        std::uint32_t face = 0;
        double at = 0.0;  // Position along the normal of the direction.
        Span u, v;
        std::vector<std::vector<Vec3>> loops;
    };
    struct Direction {
        Vec3 n, u, v;
        std::vector<Wall> ahead, back;  // Walls whose normal is along n, and against n.
    };

    void measure_walls() {
        std::vector<Direction> directions;
        for (const std::uint32_t f : planes_) {
            Vec3 n = std::get<Plane>(part_.faces[f].surface.form).normal;
            const bool is_back = std::tuple(n.z, n.y, n.x) < std::tuple(-n.z, -n.y, -n.x);
            if (is_back) n = -n;
            auto found = std::ranges::find_if(
                directions, [&](const Direction& d) { return norm(d.n - n) < kRounding; });
            if (found == directions.end()) {
                const Vec3 u = any_perpendicular(n);
                directions.push_back({n, u, cross(n, u), {}, {}});
                found = directions.end() - 1;
                // A part whose walls all have different directions cannot be measured.
                if (directions.size() > 2000) return give_up();
            }
            Wall wall;
            wall.face = f;
            wall.at = dot(std::get<Plane>(part_.faces[f].surface.form).origin, n);
            wall.loops = points_along(part_, part_.faces[f]);
            for (const auto& points : wall.loops) {
                for (const Vec3& p : points) {
                    wall.u.add(dot(p, found->u));
                    wall.v.add(dot(p, found->v));
                }
            }
            (is_back ? found->back : found->ahead).push_back(std::move(wall));
        }
        std::size_t pairs = 0;
        for (const Direction& d : directions)
            pairs += d.ahead.size() * d.back.size();
        if (pairs > 1'000'000) return give_up();
        for (const Direction& d : directions) {
            for (const bool is_void : {true, false})
                measure_between(d, is_void);
        }
    }

    void give_up() {
        features_.has_too_many_walls = true;
        features_.distances.clear();
    }

    // Adds distances between walls that face along the direction and walls that face against the
    // direction: across void if the former are behind the latter, otherwise across material.
    void measure_between(const Direction& d, bool is_void) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, Distance> found;
        const auto nearest = [&](const Wall& wall, const std::vector<Wall>& others, bool is_ahead) {
            std::vector<std::pair<double, const Wall*>> order;
            for (const Wall& other : others) {
                const double gap = (other.at - wall.at) * (is_ahead == is_void ? 1.0 : -1.0);
                if (gap > kPointError && wall.u.overlaps(other.u) && wall.v.overlaps(other.v))
                    order.emplace_back(gap, &other);
            }
            std::ranges::stable_sort(order, {}, [](const auto& o) { return o.first; });
            for (const auto& [gap, other] : order) {
                const auto key = std::minmax(wall.face, other->face);
                if (found.contains(key)) return;
                const auto place = opposite(d, wall, *other);
                if (!place) continue;
                Distance distance{gap, is_void, place->first, place->second, {}};
                std::set<cda::Origin> origins;
                for (const std::uint32_t f : {wall.face, other->face})
                    origins.insert(part_.faces[f].origins.begin(), part_.faces[f].origins.end());
                distance.origins.assign(origins.begin(), origins.end());
                found.emplace(key, std::move(distance));
                return;
            }
        };
        for (const Wall& wall : d.ahead)
            nearest(wall, d.back, true);
        for (const Wall& wall : d.back)
            nearest(wall, d.ahead, false);
        // Material between the same two planes is listed once: a plate has a single thickness, even
        // if its faces are split.
        std::vector<Distance*> listed;
        for (auto& entry : found) {
            Distance& distance = entry.second;
            const auto same = std::ranges::find_if(listed, [&](const Distance* other) {
                return !is_void && std::abs(other->mm - distance.mm) < kPointError &&
                       std::abs(dot(other->from + other->to - distance.from - distance.to, d.n)) <
                           kPointError;
            });
            if (same == listed.end()) {
                listed.push_back(&distance);
                continue;
            }
            auto& origins = (*same)->origins;
            origins.insert(origins.end(), distance.origins.begin(), distance.origins.end());
            sort_unique(origins);
        }
        for (Distance* distance : listed)
            features_.distances.push_back(std::move(*distance));
    }

    // Returns a point of each wall, opposite each other, with a free line between.
    std::optional<std::pair<Vec3, Vec3>> opposite(const Direction& d, const Wall& a,
                                                  const Wall& b) const {
        const Span u = a.u.common(b.u), v = a.v.common(b.v);
        // The middle is tried first.
        for (const double s : {0.5, 0.3, 0.7, 0.1, 0.9}) {
            for (const double t : {0.5, 0.3, 0.7, 0.1, 0.9}) {
                const double x = u.low + s * u.length(), y = v.low + t * v.length();
                if (!holds(d, a, x, y) || !holds(d, b, x, y)) continue;
                const Vec3 foot = x * d.u + y * d.v;
                const Vec3 from = foot + a.at * d.n, to = foot + b.at * d.n;
                if (is_clear(from, to)) return std::pair(from, to);
            }
        }
        return std::nullopt;
    }

    // True if the point is in the face, according to the turns of the loops around the point.
    static bool holds(const Direction& d, const Wall& wall, double x, double y) {
        double turn = 0.0;
        for (const auto& points : wall.loops) {
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Vec3 p = points[i], q = points[(i + 1) % points.size()];
                const double a = dot(p, d.u) - x, b = dot(p, d.v) - y;
                const double c = dot(q, d.u) - x, e = dot(q, d.v) - y;
                turn += angle_of(a * c + b * e, a * e - b * c);
            }
        }
        return std::abs(turn) > 180.0;
    }

    bool is_clear(Vec3 from, Vec3 to) const {
        // The ends are moved off the walls, which the polyhedron has in the same place except for
        // rounding.
        const double length = norm(to - from);
        if (length <= 4.0 * kLeastSizeMm) return true;
        const Vec3 step = (kLeastSizeMm / length) * (to - from);
        const Vec3 a = from + step, b = to - step;
        bool clear = true;
        between_.visit([&](const Box& box) { return clear && meets_segment(box, a, b); },
                       [&](std::uint32_t t) {
                           if (clear && pierces(a, b, corners_of(between_.mesh(), t)))
                               clear = false;
                       });
        return clear;
    }

    const Part& part_;
    const TriangleTree& between_;
    // Faces on both sides of each edge: forward, backward.
    std::vector<std::array<std::uint32_t, 2>> beside_;
    std::vector<std::uint32_t> planes_;
    Features features_;
};

}  // namespace

std::string_view name_of(BoreEnd end) {
    switch (end) {
        case BoreEnd::Through: return "through";
        case BoreEnd::Flat: return "flat";
        case BoreEnd::Shoulder: return "shoulder";
        case BoreEnd::Cone: return "cone";
        case BoreEnd::Ball: return "ball";
        case BoreEnd::Rounded: return "rounded";
        case BoreEnd::Other: break;
    }
    return "other";
}

Features features_of(const Part& part, const TriangleTree& between) {
    return Measurer(part, between)();
}

}  // namespace ncsim::brep
