// SPDX-License-Identifier: GPL-3.0-or-later
#include "heal/tangent_holes.h"

#include "ncsim/base/angles.h"
#include "ncsim/base/vec2.h"
#include "ncsim/brep/frames.h"

#include "geometry/tolerances.h"
#include "heal/non_simple_faces.h"
#include "topology/angular_extent.h"
#include "topology/edge_splitter.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::brep {

namespace {

// Unit direction in which an edge leaves a corner, and change of the direction along the first
// piece of the edge's track: at most 15 degrees of an arc.
struct StartTangent {
    Vec3 direction, bend;
    bool is_round = false;
};

StartTangent start_tangent(const Part& part, const EdgeUse& use) {
    const Edge& edge = part.edges[use.edge];
    const Track track = track_of(part, edge);
    const auto direction = [&](double t) {
        const Vec3 along = normalized(track.derivative(t));
        return use.is_forward ? along : -along;
    };
    const std::size_t pieces = track.pieces();
    const double start = use.is_forward ? 0.0 : 1.0;
    const double after = use.is_forward ? track.start_of(1) : track.start_of(pieces - 1);
    return {direction(start), direction(after) - direction(start),
            !std::holds_alternative<Line>(edge.curve)};
}

// Returns the two edges of a loop that meet at the start of use `i`, directed away from that
// corner.
std::array<EdgeUse, 2> edges_at(const Loop& loop, std::size_t i) {
    return {loop[i], reversed_use(loop[(i + loop.size() - 1) % loop.size()])};
}

// True if a curved edge of `one` at the start of use `i` and a curved edge of `other` at the start
// of use `j` leave the corner in the same direction and bend to the same side.
bool narrows_to_cusp(const Part& part, const Loop& one, std::size_t i, const Loop& other,
                     std::size_t j) {
    for (const EdgeUse& first : edges_at(one, i)) {
        const StartTangent a = start_tangent(part, first);
        for (const EdgeUse& second : edges_at(other, j)) {
            const StartTangent b = start_tangent(part, second);
            if (a.is_round && b.is_round && norm(a.direction - b.direction) < kLeastSine &&
                dot(a.bend, b.bend) > 0.0)
                return true;
        }
    }
    return false;
}

// Hole that touches the outline in a cusp.
struct TangentHole {
    std::size_t hole;                 // index of the loop in the face
    std::size_t of_outline, of_hole;  // uses that begin in the common corner
};

// Returns the first hole that has a single corner in common with the outline, with a cusp there.
std::optional<TangentHole> find_tangent_hole(const Part& part, const Face& face) {
    std::vector<std::pair<std::uint32_t, std::size_t>> corners;
    for (std::size_t i = 0; i < face.loops.front().size(); ++i)
        corners.emplace_back(begin_of(part, face.loops.front()[i]), i);
    std::sort(corners.begin(), corners.end());
    for (std::size_t hole = 1; hole < face.loops.size(); ++hole) {
        const Loop& loop = face.loops[hole];
        std::vector<TangentHole> common;
        for (std::size_t j = 0; j < loop.size(); ++j) {
            const std::uint32_t v = begin_of(part, loop[j]);
            const auto at = std::ranges::lower_bound(corners, std::pair(v, std::size_t{0}));
            if (at != corners.end() && at->first == v) common.push_back({hole, at->second, j});
        }
        if (common.size() == 1 && narrows_to_cusp(part, face.loops.front(), common[0].of_outline,
                                                  loop, common[0].of_hole))
            return common[0];
    }
    return std::nullopt;
}

// Projection of a face along its axis, with loops as polygons, as CAD readers draw them. The
// polygons contain the corners of the loops.
class Drawing {
public:
    Drawing(const Part& part, const Face& face) : face_(face) {
        for (const auto& points : points_along(part, face)) {
            auto& loop = loops_.emplace_back();
            for (const Vec3 p : points)
                loop.push_back(project(p));
        }
    }

    // True if the straight line between two points lies inside the face, and no loop has a point
    // within 0.01 mm of the line, except at both ends.
    bool is_clear(Vec3 from, Vec3 to) const {
        const double near = 10.0 * kLeastSizeMm;
        const Vec2 a = project(from), b = project(to);
        const double length = norm(to - from);
        for (int i = 1; i < kSamples / 2; ++i) {
            const double t = static_cast<double>(i) / (0.5 * kSamples);
            if (!has_inside({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)})) return false;
        }
        for (const auto& loop : loops_) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Vec2 p = seen(a, b, length, loop[i]);
                const Vec2 q = seen(a, b, length, loop[(i + 1) % loop.size()]);
                if (!is_end(p, length) && p.x > -near && p.x < length + near &&
                    std::abs(p.y) < near)
                    return false;
                if ((p.y > 0.0) == (q.y > 0.0) || is_end(p, length) || is_end(q, length)) continue;
                const double x = p.x + (q.x - p.x) * p.y / (p.y - q.y);
                if (x > 0.0 && x < length) return false;
            }
        }
        return true;
    }

private:
    Vec2 project(Vec3 p) const {
        const Vec3 v = p - face_.frame.origin;
        return {dot(v, face_.frame.x), dot(v, cross(face_.frame.axis, face_.frame.x))};
    }

    // Returns the coordinates of `p` along the line from `a` to `b`, and to the left of the line.
    static Vec2 seen(Vec2 a, Vec2 b, double length, Vec2 p) {
        const double x = (b.x - a.x) / length, y = (b.y - a.y) / length;
        return {(p.x - a.x) * x + (p.y - a.y) * y, (p.y - a.y) * x - (p.x - a.x) * y};
    }

    static bool is_end(Vec2 p, double length) {
        return std::abs(p.y) < kPointError &&
               (std::abs(p.x) < kPointError || std::abs(p.x - length) < kPointError);
    }

    bool has_inside(Vec2 at) const {
        bool is_inside = false;
        for (const auto& loop : loops_) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Vec2 p = loop[i], q = loop[(i + 1) % loop.size()];
                if ((p.y > at.y) == (q.y > at.y)) continue;
                if (at.x < p.x + (q.x - p.x) * (at.y - p.y) / (q.y - p.y)) is_inside = !is_inside;
            }
        }
        return is_inside;
    }

    const Face& face_;
    std::vector<std::vector<Vec2>> loops_;
};

// Point of a loop at which a cut may end: start of the edge of `use`, or the middle of this edge.
struct CutEnd {
    Vec3 at;
    std::size_t use = 0;
    bool is_middle = false;
};

// Returns all corners of a loop except the first, and the middles of curved edges if `has_middles`.
std::vector<CutEnd> cut_ends(const Part& part, const Loop& loop, bool has_middles) {
    std::vector<CutEnd> places;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (i > 0) places.push_back({part.vertices[begin_of(part, loop[i])], i});
        if (!has_middles) continue;
        if (const auto halves = split_edge(part, part.edges[loop[i].edge]))
            places.push_back({halves->middle, i, true});
    }
    return places;
}

// Line from the outline to the hole, along which a planar face is split.
struct Cut {
    CutEnd from, to;
};

// Returns the shortest cut inside the face between `outline` and `hole`, except at the first
// corners of both.
std::optional<Cut> shortest_cut(const Part& part, const Face& face, const Loop& outline,
                                const Loop& hole, bool has_middles) {
    const Drawing drawing(part, face);
    std::optional<Cut> best;
    double shortest = std::numeric_limits<double>::infinity();
    const std::vector<CutEnd> ends = cut_ends(part, hole, has_middles);
    for (const CutEnd& from : cut_ends(part, outline, has_middles)) {
        for (const CutEnd& to : ends) {
            const double length = norm(to.at - from.at);
            if (length >= shortest || !drawing.is_clear(from.at, to.at)) continue;
            shortest = length;
            best = {from, to};
        }
    }
    return best;
}

Loop rotate_to_use(Loop loop, std::size_t i) {
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i), loop.end());
    return loop;
}

// Returns the uses of `one` before `i`, then `edge`, then the uses of `other` from `j` on.
Loop join_along(const Loop& one, std::size_t i, const EdgeUse& edge, const Loop& other,
                std::size_t j) {
    Loop loop(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(i));
    loop.push_back(edge);
    loop.insert(loop.end(), other.begin() + static_cast<std::ptrdiff_t>(j), other.end());
    return loop;
}

enum class SplitResult : std::uint8_t { None, AtMidpoints, AtLine };

// Splits a planar face at its first tangent hole. AtMidpoints: only curved edges were halved, which
// makes corners at the ends of a line; the next call splits the face.
SplitResult split_at_tangent_hole(Part& part, std::uint32_t f) {
    const Face face = part.faces[f];
    const auto tangent_hole = find_tangent_hole(part, face);
    if (!tangent_hole) return SplitResult::None;
    const Loop outline = rotate_to_use(face.loops.front(), tangent_hole->of_outline);
    const Loop hole = rotate_to_use(face.loops[tangent_hole->hole], tangent_hole->of_hole);
    const auto cut = shortest_cut(part, face, outline, hole, false);
    if (!cut) {
        const auto other = shortest_cut(part, face, outline, hole, true);
        if (!other) return SplitResult::None;
        EdgeSplitter halving(part);
        if (other->from.is_middle) halving.halve(outline[other->from.use].edge);
        if (other->to.is_middle) halving.halve(hole[other->to.use].edge);
        halving.finish();
        return SplitResult::AtMidpoints;
    }
    const std::size_t i = cut->from.use, j = cut->to.use;
    const auto edge = static_cast<std::uint32_t>(part.edges.size());
    part.edges.push_back({begin_of(part, outline[i]), begin_of(part, hole[j]), Line{}});
    Face one = face, other = face;
    one.loops = {join_along(outline, i, {edge, true}, hole, j)};
    other.loops = {join_along(hole, j, {edge, false}, outline, i)};
    for (std::size_t l = 1; l < face.loops.size(); ++l) {
        if (l == tangent_hole->hole) continue;
        Face& enclosing = encloses(part, one, one.loops.front(), face.loops[l]) ? one : other;
        enclosing.loops.push_back(face.loops[l]);
    }
    one.frame = frame_for(part, one);
    other.frame = frame_for(part, other);
    part.faces[f] = std::move(one);
    append_face(part, f, std::move(other));
    return SplitResult::AtLine;
}

// Place at which an arc of a planar face is divided, near a corner at which the arc is tangent to a
// sharper arc.
struct Cusp {
    std::uint32_t edge = 0;
    double at = 0.0;  // share of the edge up to this place
};

// Direction and curvature of an arc at a corner.
struct ArcEnd {
    EdgeUse use;
    Vec3 direction;     // unit, away from the corner
    Vec3 curvature;     // change of the direction, 1/mm
    double turn = 0.0;  // turn of the whole arc with the curvature at the corner, rad
};

ArcEnd arc_end_of(const Part& part, const EdgeUse& use) {
    const Edge& edge = part.edges[use.edge];
    const Track track = track_of(part, edge);
    const auto direction = [&](double t) {
        const Vec3 along = normalized(track.derivative(use.is_forward ? t : 1.0 - t));
        return use.is_forward ? along : -along;
    };
    const Vec3 first = direction(0.0);
    const double speed = norm(track.derivative(use.is_forward ? 0.0 : 1.0));
    const Vec3 turn = 100.0 * (direction(0.01) - first);
    return {use, first, (1.0 / speed) * turn, norm(turn)};
}

std::vector<Cusp> cusps_of(const Part& part, const Face& face) {
    // CAD readers draw an arc as chords of equal length. The chords of two arcs that are tangent at
    // a corner cross if the first chord of the flatter arc turns by more than the first chord of
    // the sharper arc. If an angle limits the chords, a chord turns by up to 17 degrees. So an arc
    // of 4 degrees is divided off the flatter arc at the corner, and an arc of 1 degree off the arc
    // of 4 degrees; CAD readers with a smaller angle also divide these arcs. Arcs of less than 2
    // degrees stay whole.
    std::vector<std::pair<std::uint32_t, EdgeUse>> leaving;
    for (const EdgeUse& use : uses_of(face)) {
        if (is_straight(part.edges[use.edge])) continue;
        leaving.emplace_back(begin_of(part, use), use);
        leaving.emplace_back(end_of(part, use), reversed_use(use));
    }
    std::ranges::stable_sort(leaving, {}, [](const auto& one) { return one.first; });
    std::vector<Cusp> cusps;
    for (std::size_t i = 0; i < leaving.size(); ++i) {
        for (std::size_t j = i + 1; j < leaving.size() && leaving[j].first == leaving[i].first;
             ++j) {
            if (leaving[i].second.edge == leaving[j].second.edge) continue;
            ArcEnd flat = arc_end_of(part, leaving[i].second);
            ArcEnd sharp = arc_end_of(part, leaving[j].second);
            if (norm(flat.direction - sharp.direction) > kLeastSine ||
                dot(flat.curvature, sharp.curvature) <= 0.0)
                continue;
            if (norm(flat.curvature) > norm(sharp.curvature)) std::swap(flat, sharp);
            if (flat.turn < 2.0 * kRadiansPerDegree) continue;
            const double first = flat.turn < 8.0 * kRadiansPerDegree ? 1.0 : 4.0;  // degrees
            const double share = first * kRadiansPerDegree / flat.turn;
            cusps.push_back({flat.use.edge, flat.use.is_forward ? share : 1.0 - share});
        }
    }
    return cusps;
}

// Generator along which a conical face is split: from the closed circle that the rest of the loop
// touches in a corner to the middle of an edge of that rest.
struct ConeCut {
    std::size_t loop = 0, circle = 0, use = 0;  // indices of the loop, of the circle and the edge
    double at_circle = 0.5;                     // share of the circle up to the generator
};

// Returns the shortest generator inside the face; no value if there is none.
std::optional<ConeCut> cone_cut_of(const Part& part, const Face& face) {
    const auto& cone = std::get<Cone>(face.surface.form);
    const auto is_closed = [&](const EdgeUse& use) {
        const Edge& edge = part.edges[use.edge];
        return edge.from == edge.to && std::holds_alternative<Circle>(edge.curve);
    };
    for (std::size_t l = 0; l < face.loops.size(); ++l) {
        const Loop& loop = face.loops[l];
        const auto round = std::ranges::find_if(loop, is_closed);
        if (loop.size() < 2 || round == loop.end()) continue;
        ConeCut cut{l, static_cast<std::size_t>(round - loop.begin())};
        const Edge& edge = part.edges[round->edge];
        const auto& circle = std::get<Circle>(edge.curve);
        const Vec3 start = part.vertices[edge.from] - circle.centre;
        const Vec3 side = cross(circle.axis, start);
        const Track track = track_of(part, edge);
        const Drawing drawing(part, face);
        std::optional<ConeCut> best;
        double shortest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (i == cut.circle || is_closed(loop[i])) continue;
            const auto halves = split_edge(part, part.edges[loop[i].edge]);
            if (!halves) continue;
            const Vec3 out = halves->middle - cone.apex;
            double share = angle_of(dot(out, start), dot(out, side)) / kTurnDegrees;
            if (share < 0.0) share += 1.0;
            if (share < 0.02 || share > 0.98) continue;
            const Vec3 at = track.at(share);
            const double length = norm(at - halves->middle);
            // Projected along the axis, because the lines of `drawing` must lie in its plane.
            const auto seen = [&](Vec3 p) { return p - dot(p - cone.apex, cone.axis) * cone.axis; };
            if (length >= shortest || !drawing.is_clear(seen(at), seen(halves->middle))) continue;
            shortest = length;
            best = ConeCut{l, cut.circle, i, share};
        }
        if (best) return best;
    }
    return std::nullopt;
}

// Splits a face whose only loop is `l` along a line between the vertices `from` and `to`.
void split_along(Part& part, std::uint32_t f, std::size_t l, std::uint32_t from, std::uint32_t to) {
    const Face face = part.faces[f];
    const Loop& loop = face.loops[l];
    const auto begins_at = [&](std::uint32_t v) {
        return [&part, v](const EdgeUse& use) { return begin_of(part, use) == v; };
    };
    const auto first = std::ranges::find_if(loop, begins_at(from));
    Loop rotated(first, loop.end());
    rotated.insert(rotated.end(), loop.begin(), first);
    const auto second = std::ranges::find_if(rotated, begins_at(to));
    const auto edge = static_cast<std::uint32_t>(part.edges.size());
    part.edges.push_back({from, to, Line{}});
    Face one = face, other = face;
    one.loops = {Loop(rotated.begin(), second)};
    one.loops.front().push_back({edge, false});
    other.loops = {Loop(second, rotated.end())};
    other.loops.front().push_back({edge, true});
    one.frame = frame_for(part, one);
    other.frame = frame_for(part, other);
    part.faces[f] = std::move(one);
    append_face(part, f, std::move(other));
}

}  // namespace

bool touches_base_circle(const Part& part, const Face& face) {
    if (!std::holds_alternative<Cone>(face.surface.form)) return false;
    return std::ranges::any_of(face.loops, [&](const Loop& loop) {
        return loop.size() > 1 && std::ranges::any_of(loop, [&](const EdgeUse& use) {
                   const Edge& edge = part.edges[use.edge];
                   return edge.from == edge.to;
               });
    });
}

bool can_split_on_generator(const Part& part, const Face& face) {
    return face.loops.size() == 1 && cone_cut_of(part, face).has_value();
}

void split_cones_at_base_circle(Part& part) {
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        if (!touches_base_circle(part, part.faces[f]) ||
            !can_split_on_generator(part, part.faces[f]))
            continue;
        const ConeCut cut = *cone_cut_of(part, part.faces[f]);
        const Loop& loop = part.faces[f].loops[cut.loop];
        const auto on_circle = static_cast<std::uint32_t>(part.vertices.size());
        EdgeSplitter halving(part);
        halving.halve(loop[cut.circle].edge, cut.at_circle);
        halving.halve(loop[cut.use].edge);
        halving.finish();
        split_along(part, f, cut.loop, on_circle, on_circle + 1);
    }
}

void split_arcs_at_cusps(Part& part) {
    // Four passes: an arc is divided twice at each end, and a pass divides each edge once.
    bool any = true;
    for (int i = 0; i < 4 && any; ++i) {
        any = false;
        EdgeSplitter halving(part);
        for (const Face& face : part.faces) {
            if (!std::holds_alternative<Plane>(face.surface.form)) continue;
            for (const Cusp& cusp : cusps_of(part, face))
                any = halving.divide(cusp.edge, cusp.at) || any;
        }
        halving.finish();
    }
}

void split_faces_at_tangent_holes(Part& part) {
    // New faces are examined, too, because each may have further tangent holes.
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
        const bool may_have = std::holds_alternative<Plane>(part.faces[f].surface.form) &&
                              part.faces[f].loops.size() > 1;
        if (!may_have) continue;
        // Two halvings in succession end the search: the new corners of the first gave no line.
        bool has_halves = false;
        for (SplitResult parted = split_at_tangent_hole(part, f); parted != SplitResult::None;
             parted = split_at_tangent_hole(part, f)) {
            if (parted == SplitResult::AtMidpoints && has_halves) break;
            has_halves = parted == SplitResult::AtMidpoints;
        }
    }
}

}  // namespace ncsim::brep
