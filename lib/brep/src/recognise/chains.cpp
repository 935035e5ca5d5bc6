// SPDX-License-Identifier: GPL-3.0-or-later
#include "recognise/chains.h"

#include "ncsim/base/angles.h"

#include "geometry/contact.h"
#include "geometry/envelope_contact.h"
#include "geometry/intersection_spline.h"
#include "geometry/path_corners.h"
#include "geometry/tolerances.h"
#include "topology/angular_extent.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace ncsim::brep {

namespace {

constexpr int kTip = -1;  // in place of a number of edges

// Returns the curve from `from` to `to` along the circle in which two surfaces are tangent. The
// surfaces are so close to each other there that a corner on both surfaces within the rounding of
// programs may be farther from the circle.
std::optional<Spline> spline_along_circle(const Form& a, const Form& b, Vec3 from, Vec3 to,
                                          std::vector<Vec3> points) {
    const auto touching = tangency_surface(a, b);
    if (!touching) return std::nullopt;
    points.front() = from;
    points.back() = to;
    auto spline = intersection_spline(a, *touching, points);
    if (!spline) spline = intersection_spline(a, *touching, {from, to});
    return spline;
}

// Returns the plane, nearly, in which the edge of a ball's surfaces before and after a corner of
// the path lies if both ends of the edge do.
std::optional<Form> mitre_of(const Form& a, const Form& b, Vec3 from, Vec3 to) {
    const auto plane = rough_mitre_plane(a, b);
    const auto is_there = [&](Vec3 p) { return std::abs(distance(*plane, p)) <= kTangencyGapMm; };
    return plane && is_there(from) && is_there(to) ? std::optional<Form>(*plane) : std::nullopt;
}

// Returns the edge of such surfaces at a bend that is too small to determine where they cross: a
// curve in the plane of the corner on one surface, within rounding of the other one.
std::optional<Spline> spline_in_mitre(const Form& a, const Form& b, const Form& mitre,
                                      const std::vector<Vec3>& points) {
    auto spline = intersection_spline(a, mitre, points);
    if (!spline) return std::nullopt;
    const Curve curve = *spline;
    const Track track(curve, points.front(), points.back());
    for (int i = 1; i < kSamples; ++i) {
        if (std::abs(distance(b, track.at(static_cast<double>(i) / kSamples))) > kTangencyGapMm)
            return std::nullopt;
    }
    return spline;
}

// Returns the arc of `circle` between corners that are off the circle. The circle on a cylinder has
// the cylinder's radius.
Spline arc_between(Circle circle, const Form& a, const Form& b, Vec3 from, Vec3 to) {
    for (const Form* form : {&a, &b}) {
        const auto* wall = std::get_if<Cylinder>(form);
        if (wall && is_near(wall->radius, circle.radius)) circle.radius = wall->radius;
    }
    return arc_spline(circle, from, to);
}

// Adds `key` to `all`. True if the key was added since the last trace.
template <typename Key>
bool is_new(const Key& key, std::set<Key>& all, std::set<Key>& now) {
    if (all.insert(key).second) now.insert(key);
    return now.contains(key);
}

}  // namespace

void Chains::trace() {
    chains_.clear();
    joined_since_trace_.clear();
    crossed_since_trace_.clear();
    vertices_.clear();
    mitred_mm_ = 0.0;
    vertex_of_.assign(mesh_.corners(), kNone);
    std::vector<int> degree(mesh_.corners(), 0);
    std::vector<std::uint32_t> boundary;
    for (std::uint32_t h = 0; h < mesh_.edges().size(); ++h) {
        if (!groups_.is_boundary(h)) continue;
        boundary.push_back(h);
        ++degree[mesh_.edges()[h].from];
    }
    for (const std::uint32_t h : boundary) {
        const std::uint32_t v = mesh_.edges()[h].from;
        if (degree[v] == 2 && (is_tip(h) || is_bend(h, degree) || is_next_to_facet(h)))
            degree[v] = kTip;
        if (degree[v] == 2) continue;
        // The next boundary has the group on the right.
        Vertex& vertex = vertices_[vertex_at(v)];
        vertex.edge = h;
        if (vertex.groups.empty())
            vertex.groups.reserve(static_cast<std::size_t>(std::max(degree[v], 2)));
        vertex.groups.push_back(groups_.group_at(h));
    }
    chain_of_.assign(mesh_.edges().size(), kNone);
    const auto follow = [&](std::uint32_t first, bool is_closed) {
        Chain chain;
        chain.left = groups_.group_at(first);
        chain.right = groups_.opposite_group(first);
        chain.is_closed = is_closed;
        const auto number = static_cast<std::uint32_t>(chains_.size());
        std::uint32_t h = first;
        for (;;) {
            chain.edges.push_back(h);
            chain_of_[h] = number;
            chain_of_[mesh_.edges()[h].twin] = number;
            if (degree[mesh_.to(h)] != 2) break;
            h = groups_.next_boundary(h);
            if (h == first) break;
        }
        chain.from = vertex_at(mesh_.edges()[first].from);
        chain.to = vertex_at(mesh_.to(chain.edges.back()));
        for (const std::uint32_t v : {chain.from, chain.to}) {
            if (!is_closed) continue;
            vertices_[v].groups = {chain.left, chain.right};
        }
        chains_.push_back(std::move(chain));
    };
    for (const std::uint32_t h : boundary) {
        if (chain_of_[h] == kNone && degree[mesh_.edges()[h].from] != 2) follow(h, false);
    }
    for (const std::uint32_t h : boundary) {
        if (chain_of_[h] == kNone) follow(h, true);
    }
    for (Vertex& v : vertices_) {
        sort_unique(v.groups);
    }
}

bool Chains::is_next_to_facet(std::uint32_t h) const {
    return groups_.is_facet(groups_.group_at(h)) || groups_.is_facet(groups_.opposite_group(h));
}

// True if a surface passes through the apex of a cone; the edge of both has a corner there.
bool Chains::is_tip(std::uint32_t h) const {
    const std::uint32_t one = groups_.group_at(h), other = groups_.opposite_group(h);
    for (const auto& [g, n] : {std::pair(one, other), std::pair(other, one)}) {
        const auto* cone = std::get_if<Cone>(&groups_.form_of(g));
        if (!cone) continue;
        const double error = groups_.error_of(g);
        if (norm(mesh_.point(mesh_.edges()[h].from) - cone->apex) < 4.0 * error &&
            std::abs(distance(groups_.form_of(n), cone->apex)) < kFlat)
            return true;
    }
    return false;
}

// True if the start of `h` is the point of the edge of two ramps that is nearest to the corner of
// their bend, without the ends of the edge.
bool Chains::is_bend(std::uint32_t h, const std::vector<int>& degree) const {
    const std::uint32_t one = groups_.group_at(h), other = groups_.opposite_group(h);
    const Vec3 p = mesh_.point(mesh_.edges()[h].from);
    const auto corner = corner_of_bend(groups_.form_of(one), groups_.form_of(other), p);
    if (!corner || norm(p - *corner) >= reach({one, other})) return false;
    const auto is_farther = [&](std::uint32_t neighbour) {
        const Vec3 q = mesh_.point(neighbour);
        if (degree[neighbour] != 2) return dot(*corner - q, p - q) > 0.0;
        return norm(p - *corner) <= norm(q - *corner);
    };
    return is_farther(mesh_.to(h)) &&
           is_farther(mesh_.to(groups_.next_boundary(mesh_.edges()[h].twin)));
}

std::uint32_t Chains::vertex_at(std::uint32_t v) {
    std::uint32_t& number = vertex_of_[v];
    if (number == kNone) {
        number = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back({mesh_.point(v), {}, 0.0});
        vertices_.back().start = mesh_.point(v);
    }
    return number;
}

std::vector<Vec3> Chains::points_of(const Chain& chain) const {
    if (chain.is_flipped || chain.is_direction_fixed)
        return {vertices_[chain.from].at, vertices_[chain.to].at};
    std::vector<Vec3> points;
    for (const std::uint32_t h : chain.edges)
        points.push_back(mesh_.point(mesh_.edges()[h].from));
    points.push_back(mesh_.point(mesh_.to(chain.edges.back())));
    return points;
}

// Returns the middle point of the chain.
Vec3 Chains::middle_of(const Chain& chain) const {
    if (chain.is_flipped || chain.is_direction_fixed) return vertices_[chain.to].at;
    const std::size_t i = (chain.edges.size() + 1) / 2;
    return mesh_.point(i < chain.edges.size() ? mesh_.edges()[chain.edges[i]].from
                                              : mesh_.to(chain.edges.back()));
}

void Chains::solve() {
    std::vector<std::uint32_t> narrow;  // corners that only widen() finds
    for (std::uint32_t i = 0, corners = static_cast<std::uint32_t>(vertices_.size()); i < corners;
         ++i) {
        bool has_failed = !solve_corner(vertices_[i]);
        if (has_failed || vertices_[i].is_bend_elsewhere ||
            (vertices_[i].miss > kPointError && is_of_turning_tools(vertices_[i]))) {
            const std::vector<Spoke> spokes = spokes_at(vertices_[i]);
            const bool is_ahead = !has_failed && is_bend_ahead(vertices_[i], spokes);
            if (!is_ahead && split(i, spokes)) has_failed = false;
        }
        Vertex& v = vertices_[i];
        v.has_failed = has_failed;
        if (!v.has_failed) continue;
        if (tangent_sides(v)) {
            narrow.push_back(i);
        } else {
            failures_.push_back({v.groups, true, false, v.edge});
        }
    }
    if (!failures_.empty()) return;
    widen(narrow);
    if (!failures_.empty()) return;
    join_same_corners();
    // A flip may reverse an adjacent chain.
    for (int pass = 0; pass < 4; ++pass) {
        if (!flip_reversed()) break;
    }
    for (std::uint32_t c = 0, before = static_cast<std::uint32_t>(chains_.size()); c < before; ++c)
        bend(c);
    for (std::uint32_t c = 0; c < chains_.size(); ++c)
        move_to_wall(c);
    for (const Chain& chain : chains_) {
        if (!chain.edges.empty() && chain.from != chain.to && joined_.contains(corners_of(chain)) &&
            is_rounded_off(chain))
            join_ends(chain);
    }
    align_on_generators();
    for (Vertex& v : vertices_)
        v.at = snapped(v, v.at);
    for (Chain& chain : chains_)
        solve_chain(chain);
    if (failures_.empty()) join_vanished();
}

// Aligns vertices along generators of cylinders. Where walls are tangent within rounding, corners
// above each other differ sideways by as much, and OpenCASCADE finds the wire open. All vertices
// connected by such edges move onto the line through the vertex with the smallest miss, within the
// tolerance of vertices.
void Chains::align_on_generators() {
    std::vector<std::uint32_t> above(vertices_.size());
    std::iota(above.begin(), above.end(), 0U);
    const auto root = [&](std::uint32_t v) {
        while (above[v] != v)
            v = above[v] = above[above[v]];
        return v;
    };
    std::map<std::uint32_t, Vec3> axes;  // of roots
    for (const Chain& chain : chains_) {
        if (chain.has_vanished || chain.is_closed || chain.from == chain.to) continue;
        const Form &a = groups_.form_of(chain.left), &b = groups_.form_of(chain.right);
        const auto* wall = std::get_if<Cylinder>(&a);
        if (!wall) wall = std::get_if<Cylinder>(&b);
        if (!wall || groups_.is_facet(chain.left) || groups_.is_facet(chain.right)) continue;
        const Vec3 along = vertices_[chain.to].at - vertices_[chain.from].at;
        const double lateral = norm(cross(along, wall->axis));
        if (lateral <= kReaderMm || lateral > kLeastSizeMm ||
            std::abs(dot(along, wall->axis)) <= lateral || !tangency_surface(a, b))
            continue;
        const std::uint32_t one = root(chain.from), other = root(chain.to);
        above[std::max(one, other)] = std::min(one, other);
        axes[std::min(one, other)] = wall->axis;
    }
    if (axes.empty()) return;
    std::map<std::uint32_t, std::vector<std::uint32_t>> all;
    for (std::uint32_t v = 0; v < vertices_.size(); ++v)
        all[root(v)].push_back(v);
    for (const auto& [first, axis] : axes) {
        if (root(first) != first) continue;
        const auto& lined = all[first];
        const Vec3 base = vertices_[*std::ranges::min_element(lined, {}, [&](std::uint32_t v) {
                              return vertices_[v].miss;
                          })].at;
        for (const std::uint32_t i : lined) {
            Vertex& v = vertices_[i];
            const Vec3 p = base + dot(v.at - base, axis) * axis;
            std::vector<std::uint32_t> surfaces;
            for (const std::uint32_t g : v.groups)
                surfaces.push_back(groups_[g].surface);
            if (largest_distance(surfaces, p) <= kTangencyGapMm) v.at = p;
        }
    }
}

// Merges the ends of chains that vanished although their ends are farther apart than one point.
void Chains::join_vanished() {
    std::set<std::uint32_t> moved;
    for (const Chain& chain : chains_) {
        if (!chain.has_vanished || chain.edges.empty() || chain.from == chain.to ||
            norm(vertices_[chain.to].at - vertices_[chain.from].at) <= kReaderMm ||
            !is_rounded_off(chain))
            continue;
        join_ends(chain);
        moved.insert({chain.from, chain.to});
    }
    for (Chain& chain : chains_) {
        if (!chain.has_vanished && (moved.contains(chain.from) || moved.contains(chain.to)))
            solve_chain(chain);
    }
}

// Moves both ends to the end that is nearer to all adjacent surfaces, then onto the planes. Coils
// do not count: edges on coils are splines, which can end at any point, unlike circles and lines.
void Chains::join_ends(const Chain& chain) {
    Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
    std::vector<const Form*> forms;
    for (const Vertex* v : {&from, &to}) {
        for (const std::uint32_t g : v->groups)
            forms.push_back(&groups_.form_of(g));
    }
    const auto miss = [&](Vec3 p) {
        double most = 0.0;
        for (const Form* form : forms) {
            if (!std::holds_alternative<Coil>(*form))
                most = std::max(most, std::abs(distance(*form, p)));
        }
        return most;
    };
    Vec3 at = miss(to.at) < miss(from.at) ? to.at : from.at;
    for (const Form* form : forms) {
        if (const auto* plane = std::get_if<Plane>(form))
            at = at - distance(*plane, at) * plane->normal;
    }
    from.at = to.at = snapped(to, snapped(from, at));
}

// Returns `p`, moved into the planes from snap_to_circle().
Vec3 Chains::snapped(const Vertex& v, Vec3 p) const {
    if (v.edge == kNone) return p;
    const std::uint32_t corner = mesh_.edges()[v.edge].from;
    for (auto one = snap_circles_.lower_bound({corner, 0}); one != snap_circles_.end(); ++one) {
        if (one->first != corner) break;
        if (const auto* plane = std::get_if<Plane>(&mesh_.surface(one->second).form))
            p = p - distance(*plane, p) * plane->normal;
    }
    return p;
}

bool Chains::is_of_turning_tools(const Vertex& v) const {
    return std::ranges::any_of(
        v.groups, [&](std::uint32_t g) { return is_of_turning_tool(groups_.form_of(g)); });
}

std::pair<std::uint32_t, std::uint32_t> Chains::corners_of(const Chain& chain) const {
    return std::minmax(mesh_.edges()[chain.edges.front()].from, mesh_.to(chain.edges.back()));
}

bool Chains::is_rounded_off(const Chain& chain) const {
    const Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
    const auto is_on = [&](const Vertex& v, Vec3 p) {
        return std::ranges::all_of(v.groups, [&](std::uint32_t g) {
            const Form& form = groups_.form_of(g);
            const bool is_pointed =
                std::holds_alternative<Plane>(form) || std::holds_alternative<Cylinder>(form) ||
                std::holds_alternative<Cone>(form) || std::holds_alternative<Coil>(form);
            return is_pointed && !groups_.is_facet(g) &&
                   std::abs(distance(form, p)) <= kLeastSizeMm;
        });
    };
    return norm(to.at - from.at) <= kTangencyGapMm && is_on(from, to.at) && is_on(to, from.at);
}

bool Chains::add_crossing(std::uint32_t one, std::uint32_t other) {
    bool any = false;
    for (const std::uint32_t i : {chains_[one].from, chains_[one].to}) {
        if (i != chains_[other].from && i != chains_[other].to) continue;
        if (!vertices_[i].is_tangency || vertices_[i].edge == kNone) continue;
        const std::uint32_t corner = mesh_.edges()[vertices_[i].edge].from;
        if (!is_new(corner, crossed_, crossed_since_trace_)) continue;
        cached_corners_[corner].clear();
        any = true;
    }
    return any;
}

bool Chains::snap_to_circle(std::uint32_t of_circle, std::uint32_t vertex) {
    const auto circle = std::ranges::find_if(
        chains_, [&](const Chain& chain) { return chain.is_closed && chain.from == of_circle; });
    const Vertex& v = vertices_[vertex];
    if (circle == chains_.end() || v.edge == kNone) return false;
    bool any = false;
    for (const std::uint32_t g : {circle->left, circle->right}) {
        const auto* plane = std::get_if<Plane>(&groups_.form_of(g));
        if (!plane || std::abs(distance(*plane, v.at)) <= kReaderMm) continue;
        any = snap_circles_.insert({mesh_.edges()[v.edge].from, groups_[g].surface}).second || any;
    }
    return any;
}

bool Chains::join_corners(std::uint32_t group) {
    bool any = false;
    for (const Chain& chain : chains_) {
        if ((chain.left != group && chain.right != group) || chain.edges.empty() ||
            chain.is_flipped || chain.has_failed || chain.has_vanished || chain.from == chain.to ||
            !is_rounded_off(chain))
            continue;
        any = is_new(corners_of(chain), joined_, joined_since_trace_) || any;
    }
    return any;
}

std::optional<Spline> Chains::spline_of(const Chain& chain, const Form& first, const Form& second,
                                        const std::vector<Vec3>& points) {
    if (chain.edges.empty()) return intersection_spline(first, second, points);
    const std::uint32_t left = groups_[chain.left].surface, right = groups_[chain.right].surface;
    // There are two splines of an edge: of both faces, and of one face and the tangency surface.
    const bool is_itself = &second == &groups_.form_of(chain.right);
    CachedSpline& cached = cached_splines_[2 * chain.edges.front() + (is_itself ? 0 : 1)];
    if (cached.left != left || cached.right != right || cached.points != points)
        cached = {left, right, points, intersection_spline(first, second, points)};
    return cached.spline;
}

// True if the chain is no longer than the rounding of programs and was not in the polyhedron, so
// its direction is unknown.
bool Chains::is_of_rounding(const Chain& chain) const {
    const Vec3 from = vertices_[chain.from].at;
    return norm(vertices_[chain.to].at - from) <= kTangencyGapMm &&
           norm(middle_of(chain) - from) < reach({chain.left, chain.right});
}

// True if the points of a chain between vertices at the same place go around a whole circle.
bool Chains::is_whole_turn(const Chain& chain) const {
    const Form &a = groups_.form_of(chain.left), &b = groups_.form_of(chain.right);
    const std::vector<Vec3> points = points_of(chain);
    if (groups_.is_facet(chain.left) || groups_.is_facet(chain.right) || points.size() < 4)
        return false;
    const Vec3 at = vertices_[chain.from].at;
    const auto curve = intersection_curve(a, b, at, at, points[points.size() / 2]);
    const auto* circle = curve ? std::get_if<Circle>(&*curve) : nullptr;
    return circle && std::abs(winding_angle(points, circle->centre, circle->axis)) > 270.0;
}

void Chains::solve_chain(Chain& chain) {
    const Form &a = groups_.form_of(chain.left), &b = groups_.form_of(chain.right);
    if (chain.has_vanished) return;
    Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
    chain.has_failed = from.has_failed || to.has_failed;
    if (chain.has_failed) return;
    const bool is_loop = chain.from == chain.to;
    if (is_loop) {
        // A loop around needles vanishes.
        const std::vector<Vec3> points = points_of(chain);
        const auto is_there = [&](Vec3 p) { return norm(p - points.front()) < kFlat; };
        if (std::ranges::all_of(points, is_there)) {
            chain.has_vanished = true;
            return;
        }
    }
    const bool is_point = !is_loop && norm(to.at - from.at) <= kReaderMm;
    if (is_point && norm(middle_of(chain) - from.at) < reach({chain.left, chain.right}) &&
        !is_whole_turn(chain))
        return vanish(chain);
    if (groups_.is_facet(chain.left) || groups_.is_facet(chain.right)) {
        if (is_loop) return fail(chain);
        chain.curve = Line{};
        return;
    }
    std::vector<Vec3> points = points_of(chain);
    const Vec3 middle = points.size() > 2 ? points[points.size() / 2] : 0.5 * (from.at + to.at);
    std::optional<Curve> curve = intersection_curve(a, b, from.at, to.at, middle);
    const bool is_straight = curve && std::holds_alternative<Line>(*curve);
    if (is_straight) {
        // A line cannot return to its start, nor run against the direction in the polyhedron.
        const bool is_back =
            !chain.is_flipped && dot(to.at - from.at, points.back() - points.front()) < 0.0;
        if (is_loop || (is_back && norm(to.at - from.at) > kReaderMm))
            return !is_loop && is_of_rounding(chain) ? vanish(chain) : fail(chain);
        chain.curve = Line{};
        return;
    }
    if (!curve) {
        points.front() = from.at;
        points.back() = to.at;
        const std::optional<Form> mitre = mitre_of(a, b, from.at, to.at);
        if (mitre) {
            // Corners of polygons may lead to the other curve in which the surfaces meet.
            const auto& plane = std::get<Plane>(*mitre);
            for (std::size_t i = 1; i + 1 < points.size(); ++i)
                points[i] = points[i] - distance(plane, points[i]) * plane.normal;
        }
        // If the surfaces are tangent, the tangency surface determines the curve.
        const std::optional<Form> touching = tangency_surface_at(a, b, from.at, to.at);
        const Form& second = touching ? *touching : b;
        const bool is_moved =
            std::holds_alternative<Coil>(a) || std::holds_alternative<Envelope>(a);
        const Form& first = is_moved && touching ? b : a;
        auto spline = spline_of(chain, first, second, points);
        // If facets are large, corners of the polygon may lie beyond the true ends.
        if (!spline && !is_loop &&
            (chain.is_flipped || dot(to.at - from.at, path_direction(chain)) > 0.0))
            spline = intersection_spline(first, second, {from.at, to.at});
        if (!spline && mitre && !is_loop) spline = spline_in_mitre(a, b, *mitre, points);
        if (!spline) return is_of_rounding(chain) ? vanish(chain) : fail(chain);
        chain.curve = std::move(*spline);
        // The edge of two straight pipes has no lune if no facet shows one.
        const double lower = depth_of_lune(a, b, Track(chain.curve, from.at, to.at));
        const double error = std::max(groups_.error_of(chain.left), groups_.error_of(chain.right));
        if (lower > std::max(5.0 * kLeastSizeMm, error)) return fail(chain);
        mitred_mm_ = std::max(mitred_mm_, lower);
        return;
    }
    auto* circle = std::get_if<Circle>(&*curve);
    auto* ellipse = circle ? nullptr : &std::get<Ellipse>(*curve);
    const Vec3 centre = circle ? circle->centre : ellipse->centre;
    Vec3& axis = circle ? circle->axis : ellipse->axis;
    const double rough = winding_angle(points, centre, axis);
    if (is_loop && std::abs(rough) < 180.0) return fail(chain);
    if (rough < 0.0) axis = -axis;
    if (chain.is_closed) {
        // The start is where OpenCASCADE's parameter begins.
        const Vec3 x = any_perpendicular(axis);
        from.at =
            circle ? centre + circle->radius * x : centre + ellipse->major_radius * ellipse->major;
        from.miss = std::max(std::abs(distance(a, from.at)), std::abs(distance(b, from.at)));
    }
    // Near the corner of a bend, facets do not show the direction; the shorter arc is right.
    const bool is_at_bend = from.groups.size() == 2 || to.groups.size() == 2;
    if (!is_loop && is_at_bend && std::abs(rough) < 90.0 &&
        Track(*curve, from.at, to.at).sweep_degrees() > 270.0) {
        axis = -axis;
        chain.curve = std::move(*curve);
        return;
    }
    if (is_point && std::abs(rough) > 180.0) {
        chain.curve = std::move(*curve);
        return;
    }
    if (!is_loop) {
        const Track track(*curve, from.at, to.at);
        // A plane meets a torus in two circles, and each end may be on another one.
        if (norm(track.at(1.0) - to.at) > kTangencyGapMm) {
            auto spline = spline_along_circle(a, b, from.at, to.at, points);
            if (!spline) return fail(chain);
            chain.curve = std::move(*spline);
            return;
        }
        const double sweep = track.sweep_degrees();
        // Nearly a whole turn means that the arc runs backwards.
        if (std::abs(sweep - std::abs(rough)) > std::abs(sweep - 360.0 + std::abs(rough)) &&
            std::abs(sweep - std::abs(rough)) > 180.0) {
            return is_of_rounding(chain) ? vanish(chain) : fail(chain);
        }
    }
    // Circles that should be tangent in a corner cross on both sides of the corner after rounding;
    // splines end in the corner, with one direction. Three faces that miss their corner are tangent
    // there, whatever their forms are.
    const auto is_rounded = [](const Vertex& v) {
        return (v.is_tangency || v.groups.size() == 3) && v.miss > kReaderMm;
    };
    if (!is_loop && circle && (is_rounded(from) || is_rounded(to)))
        *curve = arc_between(*circle, a, b, from.at, to.at);
    chain.curve = std::move(*curve);
}

}  // namespace ncsim::brep
