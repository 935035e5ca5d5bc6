// SPDX-License-Identifier: GPL-3.0-or-later
//
// Corrections of the order of corners. Where facets are larger than the distances between true
// corners, the polyhedron has the corners in another order, or one corner instead of two, so chains
// separate other groups than in the polyhedron.
#include "ncsim/base/angles.h"

#include "geometry/contact.h"
#include "geometry/envelope_contact.h"
#include "geometry/intersection_spline.h"
#include "geometry/newton.h"
#include "geometry/path_corners.h"
#include "geometry/tolerances.h"
#include "recognise/chains.h"
#include "topology/angular_extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

namespace ncsim::brep {

// Returns the unit direction in which the boundary `h` leaves its corner, from the surfaces on both
// sides.
Vec3 Chains::direction_of(std::uint32_t h) const {
    const Vec3 p = mesh_.point(mesh_.edges()[h].from), step = mesh_.point(mesh_.to(h)) - p;
    const Vec3 along = cross(outward(groups_.surface_of(groups_.group_at(h)), p),
                             outward(groups_.surface_of(groups_.opposite_group(h)), p));
    if (norm(along) < kLeastSine) return normalized(step);
    return normalized(dot(along, step) < 0.0 ? -along : along);
}

// Returns the boundaries that meet in a vertex, clockwise, leading outwards.
std::vector<Chains::Spoke> Chains::spokes_at(const Vertex& v) const {
    std::vector<Spoke> spokes;
    if (v.edge == kNone) return spokes;
    std::uint32_t h = v.edge;
    do {
        if (groups_.is_boundary(h)) {
            const std::uint32_t chain = chain_of_[h];
            spokes.push_back({chain, chains_[chain].edges.front() == h, groups_.group_at(h),
                              groups_.opposite_group(h), direction_of(h)});
        }
        h = mesh_.edges()[mesh_.edges()[h].twin].next;
    } while (h != v.edge);
    return spokes;
}

// Divides a vertex of more than three faces whose surfaces have no common point: two consecutive
// boundaries keep the vertex, the others get a new one, and a new chain connects both. Of all
// choices for which the loops of the faces next to the new chain turn as much as before, the
// shortest new chain is taken. Returns false if there is none.
bool Chains::split(std::uint32_t number, const std::vector<Spoke>& spokes) {
    const Vertex before = vertices_[number];
    const std::size_t count = spokes.size();
    // Near the apex of a cone, wrong corners are found too easily.
    const bool may_not = std::ranges::any_of(before.groups, [&](std::uint32_t g) {
        return groups_.is_facet(g) || std::holds_alternative<Cone>(groups_.form_of(g));
    });
    if (count < 4 || count > 7 || before.groups.size() != count || may_not) return false;
    const auto at = [&](std::size_t i) -> const Spoke& { return spokes[i % count]; };
    struct Choice {
        double length;
        std::size_t first;
        Vertex near, far;
    };
    const std::optional<Vec3> bend = bend_at(before);
    std::optional<Choice> best;
    for (std::size_t i = 0; i < count; ++i) {
        const Spoke &a = at(i), &b = at(i + 1), &c = at(i + 2), &d = at(i + count - 1);
        Choice choice{0.0, i, before, before};
        choice.near.at = choice.far.at = before.start;
        choice.near.groups = {b.right, a.right, a.left};
        std::sort(choice.near.groups.begin(), choice.near.groups.end());
        std::erase(choice.far.groups, a.right);
        if (!solve_corner(choice.near) || !solve_corner(choice.far)) continue;
        const Vec3 step = choice.far.at - choice.near.at;
        choice.length = norm(step);
        if (choice.length <= 10.0 * kPointError || (best && best->length <= choice.length))
            continue;
        // One of both vertices must be the corner of a bend, now or later.
        const auto is_at = [&](const Vertex& v) { return norm(v.at - *bend) <= kReaderMm; };
        if (bend && !is_at(choice.near) && !is_at(choice.far) && !is_bend_elsewhere(choice.far))
            continue;
        // With four faces, each corner has a face that is not adjacent to the new chain.
        if (count == 4 &&
            is_past_tangency({b.right, a.left}, a.right, c.right, choice.near.at, choice.far.at)
                .value_or(false))
            continue;
        const auto goes_on = [&](std::uint32_t g, Vec3 in, Vec3 between, Vec3 on) {
            const Vec3 n = outward(groups_.surface_of(g), before.at);
            const auto turn = [&](Vec3 u, Vec3 v) {
                return angle_of(dot(u, v), dot(n, cross(u, v)));
            };
            return std::abs(turn(in, between) + turn(between, on) - turn(in, on)) < 1.0;  // degrees
        };
        if (goes_on(b.right, -b.direction, step, c.direction) &&
            goes_on(a.left, -d.direction, -step, a.direction))
            best = choice;
    }
    if (!best) return false;
    const auto other = static_cast<std::uint32_t>(vertices_.size());
    std::vector<Spoke> rest;
    for (std::size_t i = best->first + 2; i < best->first + count; ++i) {
        Chain& chain = chains_[at(i).chain];
        (at(i).is_start ? chain.from : chain.to) = other;
        rest.push_back(at(i));
    }
    const std::uint32_t left = at(best->first + 1).right, right = at(best->first).left;
    // Seen from the new vertex, left and right are exchanged.
    rest.push_back({static_cast<std::uint32_t>(chains_.size()), false, right, left,
                    normalized(best->near.at - best->far.at)});
    add_chain(number, other, left, right);
    vertices_[number] = std::move(best->near);
    vertices_.push_back(std::move(best->far));
    if (is_bend_elsewhere(vertices_[other])) split(other, rest);
    return true;
}

// True if the corner of a bend is next to the vertex, nearer than a facet is wide.
bool Chains::is_bend_elsewhere(const Vertex& v) const {
    const auto corner = bend_at(v);
    const double deviation = corner ? norm(*corner - v.at) : 0.0;
    return deviation > kReaderMm && deviation < 0.25 * reach(v.groups);
}

// True if the corner of a bend lies ahead on a boundary between two ramps: a point of their edge,
// but a corner of no other faces.
bool Chains::is_bend_ahead(const Vertex& v, const std::vector<Spoke>& spokes) const {
    return std::ranges::any_of(spokes, [&](const Spoke& spoke) {
        const auto corner =
            corner_of_bend(groups_.form_of(spoke.left), groups_.form_of(spoke.right), v.at);
        return corner && dot(*corner - v.at, spoke.direction) > kReaderMm;
    });
}

void Chains::add_chain(std::uint32_t from, std::uint32_t to, std::uint32_t left,
                       std::uint32_t right) {
    Chain made;
    made.left = left;
    made.right = right;
    made.from = from;
    made.to = to;
    made.is_flipped = made.is_inserted = true;
    chains_.push_back(std::move(made));
}

// True if a third face cuts the chain off between the vertex `other` and the corner of the bend,
// `corner`. Then moves the vertex `end` to the point in which the three faces meet, on the ellipse
// on the side of `other`.
bool Chains::ends_before(const Chain& chain, std::uint32_t other, std::uint32_t end, Vec3 corner) {
    Vertex& v = vertices_[end];
    const Form &a = groups_.form_of(chain.left), &b = groups_.form_of(chain.right);
    const Vec3 begin = vertices_[other].at;
    const auto mitre = mitre_plane(a, b, begin);
    if (v.groups.size() != 3 || !mitre) return false;
    for (const std::uint32_t g : v.groups) {
        if (g == chain.left || g == chain.right || groups_.is_facet(g)) continue;
        const Form& third = groups_.form_of(g);
        if ((distance(third, begin) > 0.0) == (distance(third, corner) > 0.0)) return false;
        const std::array<const Form*, 4> forms{&a, &b, &third, &*mitre};
        Vec3 p = v.at;
        if (brep::solve(forms, p) > kTangencyGapMm || norm(p - v.start) > reach(v.groups))
            return false;
        v.at = p;
        return true;
    }
    return false;
}

// Divides the edge of two grooves in the point in which both are tangent, if a ball crossed its own
// path there. Corners of facets are near that point. Returns false if there is no such point.
bool Chains::split_at_crossing(std::uint32_t number) {
    const Chain& chain = chains_[number];
    const Form &a = groups_.form_of(chain.left), &b = groups_.form_of(chain.right);
    const std::vector<Vec3> points = points_of(chain);
    const double near = reach({chain.left, chain.right});
    const auto is_at = [](const Vertex& v, Vec3 p) { return norm(v.at - p) <= kTangencyGapMm; };
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const auto crossing = crossing_of_grooves(a, b, points[i]);
        if (!crossing) return false;
        const double far = norm(*crossing - points[i]);
        const bool is_nearest =
            far <= norm(*crossing - points[i - 1]) && far <= norm(*crossing - points[i + 1]);
        if (far >= near || !is_nearest || is_at(vertices_[chain.from], *crossing) ||
            is_at(vertices_[chain.to], *crossing))
            continue;
        divide(number, i, *crossing);
        return true;
    }
    return false;
}

// Divides the chain at the start of its i-th half-edge. The new vertex is at `at`.
void Chains::divide(std::uint32_t number, std::size_t i, Vec3 at) {
    const auto added = static_cast<std::uint32_t>(chains_.size());
    const auto vertex = static_cast<std::uint32_t>(vertices_.size());
    Chain rest = chains_[number];
    vertices_.push_back({at, {rest.left, rest.right}});
    std::ranges::sort(vertices_.back().groups);
    const auto begin = rest.edges.begin() + static_cast<std::ptrdiff_t>(i);
    chains_[number].edges.assign(rest.edges.begin(), begin);
    chains_[number].to = vertex;
    rest.edges.erase(rest.edges.begin(), begin);
    rest.from = vertex;
    for (const std::uint32_t h : rest.edges) {
        chain_of_[h] = added;
        chain_of_[mesh_.edges()[h].twin] = added;
    }
    chains_.push_back(std::move(rest));
    bend(added);
}

// Divides the edge of two ramps at the corner of the bend if facets are wider than the distance
// from the corner to an end of the edge. Divides the edge of two pipes where the edge changes from
// the first ellipse of the pipes to the second.
void Chains::bend(std::uint32_t number) {
    const Chain& chain = chains_[number];
    const Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
    if (chain.is_closed || chain.is_inserted || from.has_failed || to.has_failed) return;
    const Vec3 past = mesh_.point(mesh_.edges()[chain.edges[chain.edges.size() / 2]].from);
    const auto corner = corner_of_bend(groups_.form_of(chain.left), groups_.form_of(chain.right),
                                       from.at, to.at, past);
    if (!corner) {
        if (!chain.is_flipped && split_at_crossing(number)) return;
        const auto hinge = hinge_of(groups_.form_of(chain.left), groups_.form_of(chain.right),
                                    from.at, past, to.at);
        if (!hinge || chain.is_flipped) return;
        // Most curves pass the point smoothly.
        std::vector<Vec3> points = points_of(chain);
        points.front() = from.at;
        points.back() = to.at;
        if (spline_of(chain, groups_.form_of(chain.left), groups_.form_of(chain.right), points))
            return;
        chains_[number].is_direction_fixed = true;
        return split_at(number, *hinge, true);
    }
    if (ends_before(chain, chain.from, chain.to, *corner) ||
        ends_before(chain, chain.to, chain.from, *corner))
        return;
    // The corner belongs to the nearer end.
    const bool is_at_start = norm(*corner - from.at) < norm(*corner - to.at);
    if (const auto* pipe = std::get_if<Cylinder>(&groups_.form_of(chain.left))) {
        // A ball leaves the tip of a lune at a bend of two pipes. The tip is nearer to the middle
        // of the bend than the ellipse that takes its place.
        const Vec3 middle = *corner - radial_vector(pipe->origin, pipe->axis, *corner);
        const double lower = norm((is_at_start ? from.at : to.at) - middle) - pipe->radius;
        const double near = reach({chain.left, chain.right});
        const bool passes_corner = std::ranges::any_of(
            points_of(chain), [&](Vec3 p) { return norm(p - *corner) <= near; });
        if (!passes_corner) {
            if (lower > std::max(5.0 * kLeastSizeMm, groups_.error_of(chain.left))) return;
            mitred_mm_ = std::max(mitred_mm_, lower);
        }
    }
    split_at(number, *corner, is_at_start);
}

// Inserts a vertex at `corner` into the chain, and a new chain from the vertex to the start
// (`is_at_start`) or the end.
void Chains::split_at(std::uint32_t number, Vec3 corner, bool is_at_start) {
    const Chain chain = chains_[number];
    Vertex between{corner, {chain.left, chain.right}};
    std::sort(between.groups.begin(), between.groups.end());
    const auto added = static_cast<std::uint32_t>(vertices_.size());
    if (is_at_start) {
        add_chain(chain.from, added, chain.left, chain.right);
        chains_[number].from = added;
    } else {
        add_chain(added, chain.to, chain.left, chain.right);
        chains_[number].to = added;
    }
    vertices_.push_back(std::move(between));
    chains_.back().neighbour = number;
    chains_.back().is_before = is_at_start;
}

// Moves the end of a chain of a wall to the corner of a bend. Two ramps meet in a circle; the wall
// that the tool left where it stood may run along this circle. If the wall's facets are large, the
// edge of wall and ramp ends where the edge of the two ramps ends. Then the circle up to the corner
// is an edge of the wall and one ramp, and the edge of the wall and the other ramp begins in the
// corner.
void Chains::move_to_wall(std::uint32_t number) {
    Chain& bent = chains_[number];
    if (bent.is_closed || !std::holds_alternative<Extrusion>(groups_.form_of(bent.left)) ||
        !std::holds_alternative<Extrusion>(groups_.form_of(bent.right)))
        return;
    for (const auto& [corner, end] : {std::pair(bent.from, bent.to), {bent.to, bent.from}}) {
        if (vertices_[corner].groups.size() != 2 || vertices_[end].groups.size() < 4) continue;
        const Vec3 to = vertices_[corner].at, at = vertices_[end].at;
        const auto curve = intersection_curve(groups_.form_of(bent.left),
                                              groups_.form_of(bent.right), at, to, 0.5 * (at + to));
        const auto* circle = curve ? std::get_if<Circle>(&*curve) : nullptr;
        if (!circle) continue;
        for (const Spoke& spoke : spokes_at(vertices_[end])) {
            Chain& along = chains_[spoke.chain];
            if (spoke.chain == number || along.is_closed ||
                (along.from == end) == (along.to == end))
                continue;
            const bool is_left = along.left == bent.left || along.right == bent.left;
            const bool is_right = along.left == bent.right || along.right == bent.right;
            if (is_left == is_right) continue;
            const std::uint32_t ramp = is_left ? bent.left : bent.right;
            const std::uint32_t wall = along.left == ramp ? along.right : along.left;
            std::uint32_t& its_end = along.from == end ? along.from : along.to;
            const Vec3 beyond = vertices_[along.from == end ? along.to : along.from].at;
            const auto is_on = [&](Vec3 p) {
                return std::abs(dot(p - circle->centre, circle->axis)) < kTangencyGapMm &&
                       std::abs(distance(groups_.form_of(wall), p)) < kTangencyGapMm;
            };
            const auto* round = std::get_if<Cylinder>(&groups_.form_of(wall));
            if (!round || groups_.is_facet(wall) || !is_on(at) || !is_on(to) || !is_on(beyond) ||
                norm(cross(round->axis, circle->axis)) > kFlat)
                continue;
            const double first = winding_angle({at, to}, circle->centre, circle->axis);
            const double rest = winding_angle({to, beyond}, circle->centre, circle->axis);
            if (first * rest <= 0.0 || std::abs(first + rest) > 180.0) continue;
            its_end = corner;
            (is_left ? bent.left : bent.right) = wall;
            bent.is_flipped = true;
            bent.neighbour = kNone;
            return;
        }
    }
}

// Merges vertices with the same faces at the same point, and closes pinches. Facets between two
// poses of a turning tool may be needles, so the polyhedron may have two corners in place of a
// single corner. Where faces meet in a single curve, the material between the faces is reduced to
// points on the curve without area.
void Chains::join_same_corners() {
    for (const Chain& chain : chains_) {
        const bool is_same = chain.from != chain.to && !chain.is_closed &&
                             is_of_turning_tools(vertices_[chain.from]) &&
                             vertices_[chain.to].groups == vertices_[chain.from].groups &&
                             norm(vertices_[chain.to].at - vertices_[chain.from].at) <= kReaderMm;
        if (is_same) join(chain.to, chain.from);
    }
    // An upper bound, because vanished chains still count.
    std::vector<int> ends(vertices_.size(), 0);
    for (const Chain& chain : chains_) {
        ++ends[chain.from];
        ++ends[chain.to];
    }
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
        // A vertex with two ends only divides an edge.
        if (ends[v] <= 2 || vertices_[v].groups.size() != 2 || !is_of_turning_tools(vertices_[v]))
            continue;
        if (const auto beyond = close_pinch(v)) ends[*beyond] += ends[v];
    }
}

// Moves all ends at `removed` to `kept`.
void Chains::join(std::uint32_t removed, std::uint32_t kept) {
    for (Chain& chain : chains_) {
        const bool was_point = chain.from == chain.to;
        if (chain.from == removed) chain.from = kept;
        if (chain.to == removed) chain.to = kept;
        if (chain.from == chain.to && !was_point) chain.has_vanished = true;
    }
}

std::optional<std::uint32_t> Chains::close_pinch(std::uint32_t v) {
    const auto length = [&](const Chain& chain) {
        double sum = 0.0;
        for (const std::uint32_t h : chain.edges)
            sum += mesh_.length(h);
        return sum;
    };
    const Chain* shortest = nullptr;
    int ends = 0;
    for (const Chain& chain : chains_) {
        if (chain.is_closed || chain.has_vanished || (chain.from != v && chain.to != v)) continue;
        ends += chain.from == chain.to ? 2 : 1;
        if (chain.from != chain.to && (!shortest || length(chain) < length(*shortest)))
            shortest = &chain;
    }
    if (ends <= 2 || !shortest) return std::nullopt;
    const std::uint32_t beyond = shortest->from == v ? shortest->to : shortest->from;
    join(v, beyond);
    for (Chain& chain : chains_) {
        // A loop around a needle vanishes.
        if (chain.from == beyond && chain.to == beyond && !chain.is_closed &&
            length(chain) < reach({chain.left, chain.right}))
            chain.has_vanished = true;
    }
    return beyond;
}

// Returns the chains at each vertex, at most three.
Chains::ChainsAt Chains::chains_at() const {
    ChainsAt at(vertices_.size(), {kNone, kNone, kNone});
    for (std::uint32_t c = 0; c < chains_.size(); ++c) {
        if (chains_[c].has_vanished) continue;
        for (const std::uint32_t v : {chains_[c].from, chains_[c].to}) {
            auto* const place = std::ranges::find(at[v], kNone);
            if (place != at[v].end()) *place = c;
        }
    }
    return at;
}

// Returns the two of three faces that are tangent to the third, a plane; empty if there are none.
std::optional<std::array<std::uint32_t, 2>> Chains::tangent_sides(const Vertex& v) const {
    if (v.groups.size() != 3) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = v.groups[i], b = v.groups[(i + 1) % 3], c = v.groups[(i + 2) % 3];
        if (groups_.is_facet(a) || groups_.is_facet(b) || groups_.is_facet(c)) return std::nullopt;
        if (std::holds_alternative<Plane>(groups_.form_of(c)) &&
            tangency_surface(groups_.form_of(a), groups_.form_of(c)) &&
            tangency_surface(groups_.form_of(b), groups_.form_of(c)))
            return std::array{a, b};
    }
    return std::nullopt;
}

// Inserts a wall between the two faces of each vertex in `narrow` by flipping the chain between
// both faces. A wall next to a move that is shorter than a facet is wide ends where both poses of
// the tool have facets in a common plane. On the true surfaces the wall continues between both
// faces.
void Chains::widen(const std::vector<std::uint32_t>& narrow) {
    if (narrow.empty()) return;
    ChainsAt at = chains_at();
    for (const std::uint32_t v : narrow) {
        const auto sides = tangent_sides(vertices_[v]);
        const bool is_wide = sides && std::ranges::any_of(std::array(at[v]), [&](std::uint32_t c) {
                                 if (c == kNone) return false;
                                 const Chain& chain = chains_[c];
                                 const bool is_between =
                                     (chain.left == (*sides)[0] && chain.right == (*sides)[1]) ||
                                     (chain.left == (*sides)[1] && chain.right == (*sides)[0]);
                                 return is_between && flip(c, at, 1);
                             });
        if (!is_wide && vertices_[v].has_failed)
            failures_.push_back({vertices_[v].groups, true, false, vertices_[v].edge});
    }
}

// Flips chains whose ends are in reverse order: where the corners of four faces nearly coincide,
// large facets may have them in the wrong order. Returns true if a chain was flipped.
bool Chains::flip_reversed() {
    ChainsAt at = chains_at();
    bool any = false;
    for (std::uint32_t c = 0; c < chains_.size(); ++c) {
        // At most three consecutive chains are flipped.
        if (is_reversed(chains_[c])) any = flip(c, at, 3) || any;
    }
    return any;
}

bool Chains::is_reversed(Chain& chain) const {
    if (chain.is_closed || chain.has_vanished) return false;
    const Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
    const Vec3 step = to.at - from.at;
    // A later flip may have moved the end.
    if (chain.is_flipped) return dot(step, chain.direction) < 0.0;
    if (from.has_failed || to.has_failed || norm(step) <= kReaderMm) return false;
    if (from.groups.size() == 3 && to.groups.size() == 3) {
        const auto third = [&](const Vertex& v) {
            return *std::ranges::find_if(
                v.groups, [&](std::uint32_t g) { return g != chain.left && g != chain.right; });
        };
        const auto beyond =
            is_past_tangency({chain.left, chain.right}, third(from), third(to), from.at, to.at);
        chain.is_direction_fixed = beyond.has_value() && !*beyond;
        if (beyond) return *beyond;
    }
    return dot(step, path_direction(chain)) < 0.0;
}

// True if a piece of the curve from `from` to `to`, with the faces `behind` and `ahead` beyond its
// ends, lies on the wrong side of a tangency curve. Where the profile of a tool passes from a side
// to a corner radius, both faces end in a tangency curve. At a bend of the path two such faces meet
// two further faces in a single curve, and each point of the curve must lie on the right side of
// both tangency curves. Empty if the faces at the ends are not tangent to `sides`.
std::optional<bool> Chains::is_past_tangency(const std::array<std::uint32_t, 2>& sides,
                                             std::uint32_t behind, std::uint32_t ahead, Vec3 from,
                                             Vec3 to) const {
    std::optional<bool> is_beyond;
    for (const std::uint32_t g : sides) {
        for (const auto& [n, other] : {std::pair(behind, to), {ahead, from}}) {
            if (groups_.is_facet(g) || groups_.is_facet(n)) continue;
            const auto touching = tangency_surface(groups_.form_of(g), groups_.form_of(n));
            const auto* trail = touching ? std::get_if<Trail>(&*touching) : nullptr;
            const auto* one = std::get_if<Envelope>(&groups_.form_of(g));
            const auto* two = std::get_if<Envelope>(&groups_.form_of(n));
            if (!trail || !one || !two) continue;
            // A fillet is usually below its flank.
            const Sweep& round = one->sweep->fillet() ? *one->sweep : *two->sweep;
            const Sweep& side = one->sweep->fillet() ? *two->sweep : *one->sweep;
            const bool is_below = round.fillet()->height <= side.flank()->height + kTangencyGapMm;
            const bool should_be_above = one->sweep->flank() ? is_below : !is_below;
            const double above = distance(*touching, other);
            if (std::abs(above) <= kReaderMm) continue;
            is_beyond = is_beyond.value_or(false) || (above > 0.0) != should_be_above;
        }
    }
    return is_beyond;
}

// Returns the faces and chains around the chain; empty unless both ends have three faces, all four
// faces differ, and none is a facet.
std::optional<Chains::Crossing> Chains::crossing_at(std::uint32_t number,
                                                    const ChainsAt& at) const {
    const Chain& chain = chains_[number];
    const Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
    const bool is_for_good = chain.is_flipped && chain.direction == Vec3{};
    if (chain.is_closed || is_for_good || chain.from == chain.to) return std::nullopt;
    if (from.groups.size() != 3 || to.groups.size() != 3) return std::nullopt;
    Crossing crossing{chain.left, chain.right};
    const auto third = [&](const Vertex& v) {
        for (const std::uint32_t g : v.groups) {
            if (g != chain.left && g != chain.right) return g;
        }
        return kNone;
    };
    const std::uint32_t a = chain.left, b = chain.right, c = third(from), d = third(to);
    if (c == kNone || d == kNone || groups_[c].surface == groups_[d].surface) return std::nullopt;
    for (const std::uint32_t g : {a, b, c, d}) {
        if (groups_.is_facet(g)) return std::nullopt;
    }
    const auto other = [&](std::uint32_t v, std::uint32_t g, std::uint32_t h) {
        for (const std::uint32_t e : at[v]) {
            if (e == number || e == kNone) continue;
            const Chain& neighbour = chains_[e];
            if ((neighbour.left == g && neighbour.right == h) ||
                (neighbour.left == h && neighbour.right == g))
                return e;
        }
        return kNone;
    };
    crossing.behind = c;
    crossing.ahead = d;
    crossing.from_left = other(chain.from, a, c);
    crossing.from_right = other(chain.from, b, c);
    crossing.to_left = other(chain.to, a, d);
    crossing.to_right = other(chain.to, b, d);
    const std::array ends{crossing.from_left, crossing.from_right, crossing.to_left,
                          crossing.to_right};
    if (std::ranges::find(ends, kNone) != ends.end()) return std::nullopt;
    const auto is_loop = [&](std::uint32_t e) { return chains_[e].from == chains_[e].to; };
    if (crossing.from_right == crossing.to_left || is_loop(crossing.from_right) ||
        is_loop(crossing.to_left))
        return std::nullopt;
    return crossing;
}

// True if all groups are walls that are wider than their error. Narrower ones may vanish.
bool Chains::are_walls(const std::vector<std::uint32_t>& groups) const {
    return std::ranges::all_of(groups, [&](std::uint32_t g) {
        const Form& form = groups_.form_of(g);
        return (std::holds_alternative<Plane>(form) || std::holds_alternative<Cylinder>(form)) &&
               2.0 * groups_[g].area > groups_.error_of(g) * groups_.perimeter(g);
    });
}

// Flips the chain: with A on the left, B on the right, C behind and D ahead, the chain from ABC to
// ABD becomes a chain from ACD to BCD with D on the left. If three of the surfaces have no common
// point (a wall, its round end and a second wall), flips the next chain as well, up to `most`
// chains. Returns false, without changes, if no solution was found.
bool Chains::flip(std::uint32_t number, ChainsAt& at, int most) {
    const std::optional<Crossing> crossing = crossing_at(number, at);
    if (!crossing) return false;
    Chain& chain = chains_[number];
    Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
    const std::uint32_t up = crossing->to_left, down = crossing->from_right;
    // Starts at the corners of the polyhedron, because corners of surfaces that do not meet may be
    // far away.
    const auto solved = [&](Vec3 start, std::uint32_t side,
                            const std::array<std::uint32_t, 2>& sides) {
        Vertex v{start, {side, crossing->behind, crossing->ahead}};
        std::sort(v.groups.begin(), v.groups.end());
        v.start = start;
        v.has_failed =
            !solve_vertex(v, {points_of(chains_[sides[0]]), points_of(chains_[sides[1]])});
        return v;
    };
    Vertex first = solved(from.start, crossing->left, {up, crossing->from_left});
    Vertex second = solved(to.start, crossing->right, {down, crossing->to_right});
    const bool is_whole = !first.has_failed && !second.has_failed;
    const Vertex& missing = first.has_failed ? first : second;
    if (first.has_failed && second.has_failed) return false;
    if (!is_whole && (most <= 1 || !missing.is_tangency || !are_walls(missing.groups)))
        return false;

    const std::array<std::pair<std::uint32_t, Chain>, 3> chains_before{
        {{number, chain}, {up, chains_[up]}, {down, chains_[down]}}};
    const std::array<std::pair<std::uint32_t, Vertex>, 2> before{
        {{chain.from, from}, {chain.to, to}}};
    const std::array<std::array<std::uint32_t, 3>, 2> at_before{at[chain.from], at[chain.to]};
    // At each end, one of the two adjacent chains moves to the other end.
    std::ranges::replace(at[chain.to], up, kNone);
    std::ranges::replace(at[chain.from], down, up);
    *std::ranges::find(at[chain.to], kNone) = down;
    for (const auto& [e, old, now] :
         {std::tuple(up, chain.to, chain.from), std::tuple(down, chain.from, chain.to)}) {
        Chain& neighbour = chains_[e];
        (neighbour.from == old ? neighbour.from : neighbour.to) = now;
    }
    const std::uint32_t nowhere = first.has_failed ? chain.from : chain.to;
    from = std::move(first);
    to = std::move(second);
    chain.left = crossing->ahead;
    chain.right = crossing->behind;
    chain.is_flipped = true;
    chain.direction = is_whole ? to.at - from.at : Vec3{};
    if (is_whole) return true;
    // Chains between tangent surfaces stay.
    for (const std::uint32_t e : std::array(at[nowhere])) {
        if (e == number || e == kNone ||
            tangency_surface(groups_.form_of(chains_[e].left), groups_.form_of(chains_[e].right)))
            continue;
        if (flip(e, at, most - 1)) return true;
    }
    for (const auto& [e, was] : chains_before)
        chains_[e] = was;
    for (std::size_t i = 0; i < before.size(); ++i) {
        vertices_[before[i].first] = before[i].second;
        at[before[i].first] = at_before[i];
    }
    return false;
}

// Returns the vector from start to end of the chain in the polyhedron.
Vec3 Chains::path_direction(const Chain& chain) const {
    return mesh_.point(mesh_.to(chain.edges.back())) -
           mesh_.point(mesh_.edges()[chain.edges.front()].from);
}

}  // namespace ncsim::brep
