// SPDX-License-Identifier: GPL-3.0-or-later
#include "chains.h"

#include "ncsim/trig/angles.h"

#include "contact.h"
#include "spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

namespace ncsim::brep {

namespace {

using cda::cross;
using cda::dot;
using cda::norm;

constexpr double kPoint = 1e-7;
constexpr double kRounded = 2e-7;
constexpr int kTip = -1;  // no number of edges

// A use of a chain in a loop.
struct ChainUse {
    std::uint32_t chain;
    bool is_forward;
};

// The angle by which points go round an axis, degrees, signed.
double turned(const std::vector<Vec3>& points, Vec3 centre, Vec3 axis) {
    double sum = 0.0;
    const Vec3 x = across(axis), y = cross(axis, x);
    std::optional<double> last;
    for (const Vec3& p : points) {
        const double angle = trig::angle_of(dot(p - centre, x), dot(p - centre, y));
        if (last) {
            const double step = angle - *last;
            sum += step - 360.0 * std::floor(step / 360.0 + 0.5);
        }
        last = angle;
    }
    return sum;
}

}  // namespace

void Chains::trace() {
    chains_.clear();
    vertices_.clear();
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
        if (degree[v] == 2 && (is_tip(h) || is_bend(h, degree) || is_beside_facet(h)))
            degree[v] = kTip;
        if (degree[v] == 2) continue;
        const std::uint32_t number = vertex_at(v);
        vertices_[number].edge = h;
        vertices_[number].groups.push_back(groups_.group_at(h));
        vertices_[number].groups.push_back(groups_.group_beyond(h));
    }
    chain_of_.assign(mesh_.edges().size(), kNone);
    const auto follow = [&](std::uint32_t first, bool is_closed) {
        Chain chain;
        chain.left = groups_.group_at(first);
        chain.right = groups_.group_beyond(first);
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
        std::sort(v.groups.begin(), v.groups.end());
        v.groups.erase(std::unique(v.groups.begin(), v.groups.end()), v.groups.end());
    }
}

bool Chains::is_beside_facet(std::uint32_t h) const {
    return groups_.is_facet(groups_.group_at(h)) || groups_.is_facet(groups_.group_beyond(h));
}

// Where a surface passes through the apex of a cone, their edge has a corner.
bool Chains::is_tip(std::uint32_t h) const {
    const std::uint32_t one = groups_.group_at(h), other = groups_.group_beyond(h);
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

// Where the edge of two ramps that meet has a corner: the one of its points that is nearest to it,
// its ends left out.
bool Chains::is_bend(std::uint32_t h, const std::vector<int>& degree) const {
    const std::uint32_t one = groups_.group_at(h), other = groups_.group_beyond(h);
    const Vec3 p = mesh_.point(mesh_.edges()[h].from);
    const auto corner = corner_of_bend(groups_.form_of(one), groups_.form_of(other), p);
    if (!corner || norm(p - *corner) >= reach({one, other})) return false;
    const auto is_farther = [&](std::uint32_t beside) {
        const Vec3 q = mesh_.point(beside);
        if (degree[beside] != 2) return dot(*corner - q, p - q) > 0.0;
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
    if (chain.is_flipped) return {vertices_[chain.from].at, vertices_[chain.to].at};
    std::vector<Vec3> points;
    for (const std::uint32_t h : chain.edges)
        points.push_back(mesh_.point(mesh_.edges()[h].from));
    points.push_back(mesh_.point(mesh_.to(chain.edges.back())));
    return points;
}

void Chains::solve() {
    for (std::uint32_t i = 0, corners = static_cast<std::uint32_t>(vertices_.size()); i < corners;
         ++i) {
        bool has_failed = !solve_vertex(vertices_[i]);
        if ((has_failed || is_bend_elsewhere(vertices_[i])) && split(i, spokes_at(vertices_[i])))
            has_failed = false;
        Vertex& v = vertices_[i];
        v.has_failed = has_failed;
        if (v.has_failed) failures_.push_back({v.groups, true});
    }
    if (!failures_.empty()) return;
    // One may turn another one round.
    constexpr int kMostPasses = 4;
    for (int pass = 0; pass < kMostPasses; ++pass) {
        if (!flip_reversed()) break;
    }
    for (std::uint32_t c = 0, before = static_cast<std::uint32_t>(chains_.size()); c < before; ++c)
        bend(c);
    for (std::uint32_t c = 0; c < chains_.size(); ++c)
        pass_to_wall(c);
    for (Chain& chain : chains_)
        solve_chain(chain);
}

// Where a boundary goes on from its corner, of the surfaces beside it; unit.
Vec3 Chains::direction_of(std::uint32_t h) const {
    constexpr double kSteep = 1e-3;
    const Vec3 p = mesh_.point(mesh_.edges()[h].from), way = mesh_.point(mesh_.to(h)) - p;
    const Vec3 along = cross(outward(groups_.surface_of(groups_.group_at(h)), p),
                             outward(groups_.surface_of(groups_.group_beyond(h)), p));
    if (norm(along) < kSteep) return cda::normalized(way);
    return cda::normalized(dot(along, way) < 0.0 ? -along : along);
}

// The boundaries that meet in a vertex, clockwise, as they go out from it.
std::vector<Chains::Spoke> Chains::spokes_at(const Vertex& v) const {
    std::vector<Spoke> spokes;
    if (v.edge == kNone) return spokes;
    std::uint32_t h = v.edge;
    do {
        if (groups_.is_boundary(h)) {
            const std::uint32_t chain = chain_of_[h];
            spokes.push_back({chain, chains_[chain].edges.front() == h, groups_.group_at(h),
                              groups_.group_beyond(h), direction_of(h)});
        }
        h = mesh_.edges()[mesh_.edges()[h].twin].next;
    } while (h != v.edge);
    return spokes;
}

// Where more than three faces have a corner in common that their surfaces have not, two boundaries
// go on from one corner and the others from another one, and between both is an edge. Which ones is
// told by the faces beside that edge: their loops turn as much as they did in the one corner.
bool Chains::split(std::uint32_t number, const std::vector<Spoke>& spokes) {
    const Vertex before = vertices_[number];
    constexpr std::size_t kFewest = 4, kMost = 7;
    constexpr double kShortest = 1e-5;  // mm; less than readers can tell
    const std::size_t count = spokes.size();
    // Near the tip of a cone, corners are elsewhere too easily.
    const bool may_not = std::ranges::any_of(before.groups, [&](std::uint32_t g) {
        return groups_.is_facet(g) || std::holds_alternative<Cone>(groups_.form_of(g));
    });
    if (count < kFewest || count > kMost || before.groups.size() != count || may_not) return false;
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
        if (!solve_vertex(choice.near) || !solve_vertex(choice.far)) continue;
        const Vec3 way = choice.far.at - choice.near.at;
        choice.length = norm(way);
        if (choice.length <= kShortest || (best && best->length <= choice.length)) continue;
        // The one or the other is the corner of a bend, or is going to have it.
        const auto is_at = [&](const Vertex& v) { return norm(v.at - *bend) <= kPoint; };
        if (bend && !is_at(choice.near) && !is_at(choice.far) && !is_bend_elsewhere(choice.far))
            continue;
        const auto goes_on = [&](std::uint32_t g, Vec3 in, Vec3 between, Vec3 on) {
            constexpr double kRounding = 1.0;  // degrees
            const Vec3 n = outward(groups_.surface_of(g), before.at);
            const auto turn = [&](Vec3 u, Vec3 v) {
                return trig::angle_of(dot(u, v), dot(n, cross(u, v)));
            };
            return std::abs(turn(in, between) + turn(between, on) - turn(in, on)) < kRounding;
        };
        if (goes_on(b.right, -b.direction, way, c.direction) &&
            goes_on(a.left, -d.direction, -way, a.direction))
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
    // From the other corner it is on the other side.
    rest.push_back({static_cast<std::uint32_t>(chains_.size()), false, right, left,
                    cda::normalized(best->near.at - best->far.at)});
    make(number, other, left, right);
    vertices_[number] = std::move(best->near);
    vertices_.push_back(std::move(best->far));
    if (is_bend_elsewhere(vertices_[other])) split(other, rest);
    return true;
}

// Nearer than a facet is wide.
bool Chains::is_bend_elsewhere(const Vertex& v) const {
    const auto corner = bend_at(v);
    const double off = corner ? norm(*corner - v.at) : 0.0;
    return off > kPoint && off < 0.25 * reach(v.groups);
}

void Chains::make(std::uint32_t from, std::uint32_t to, std::uint32_t left, std::uint32_t right) {
    Chain made;
    made.left = left;
    made.right = right;
    made.from = from;
    made.to = to;
    made.is_flipped = made.is_made = true;
    chains_.push_back(std::move(made));
}

// Where the edge of two ramps has a corner that is nearer to its end than facets are wide.
void Chains::bend(std::uint32_t number) {
    const Chain& chain = chains_[number];
    const Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
    if (chain.is_closed || chain.is_made || from.has_failed || to.has_failed) return;
    const auto corner =
        corner_of_bend(groups_.form_of(chain.left), groups_.form_of(chain.right), from.at, to.at);
    if (!corner) return;
    Vertex between{*corner, {chain.left, chain.right}};
    std::sort(between.groups.begin(), between.groups.end());
    const auto added = static_cast<std::uint32_t>(vertices_.size());
    // The piece of the circle is the short one.
    const bool is_at_start = norm(*corner - from.at) < norm(*corner - to.at);
    if (is_at_start) {
        make(chain.from, added, chain.left, chain.right);
        chains_[number].from = added;
    } else {
        make(added, chain.to, chain.left, chain.right);
        chains_[number].to = added;
    }
    vertices_.push_back(std::move(between));
    chains_.back().beside = number;
    chains_.back().is_before = is_at_start;
}

// Beside the circle in which two ramps meet may be the wall that the tool left where it stood.
// Where facets of that are large, its edge ends where that of the ramps does. Then the circle, from
// there to the corner of the bend, is an edge of the wall and of one of the ramps, and the edge of
// the other one and the wall starts in the corner.
void Chains::pass_to_wall(std::uint32_t number) {
    Chain& bent = chains_[number];
    if (bent.is_closed || !std::holds_alternative<Extrusion>(groups_.form_of(bent.left)) ||
        !std::holds_alternative<Extrusion>(groups_.form_of(bent.right)))
        return;
    for (const auto& [corner, end] : {std::pair(bent.from, bent.to), {bent.to, bent.from}}) {
        if (vertices_[corner].groups.size() != 2 || vertices_[end].groups.size() < 4) continue;
        const Vec3 to = vertices_[corner].at, at = vertices_[end].at;
        const auto curve =
            meet(groups_.form_of(bent.left), groups_.form_of(bent.right), at, to, 0.5 * (at + to));
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
                return std::abs(dot(p - circle->centre, circle->axis)) < kTouchMm &&
                       std::abs(distance(groups_.form_of(wall), p)) < kTouchMm;
            };
            const auto* round = std::get_if<Cylinder>(&groups_.form_of(wall));
            if (!round || groups_.is_facet(wall) || !is_on(at) || !is_on(to) || !is_on(beyond) ||
                norm(cross(round->axis, circle->axis)) > kFlat)
                continue;
            const double first = turned({at, to}, circle->centre, circle->axis);
            const double rest = turned({to, beyond}, circle->centre, circle->axis);
            if (first * rest <= 0.0 || std::abs(first + rest) > 180.0) continue;
            its_end = corner;
            (is_left ? bent.left : bent.right) = wall;
            bent.is_flipped = true;
            bent.beside = kNone;
            return;
        }
    }
}

// Where the corners of four faces almost meet, large facets may have them in the wrong order: of
// the chain between two of the faces, what should be its end comes first. Then it is the other two
// that meet. With A on the left, B on the right, C behind and D ahead, the chain ran from A, B, C
// to A, B, D; now it runs from A, C, D to B, C, D, with D on its left.
bool Chains::flip_reversed() {
    std::vector<std::array<std::uint32_t, 3>> at(vertices_.size(), {kNone, kNone, kNone});
    for (std::uint32_t c = 0; c < chains_.size(); ++c) {
        for (const std::uint32_t v : {chains_[c].from, chains_[c].to}) {
            const auto place = std::ranges::find(at[v], kNone);
            if (place != at[v].end()) *place = c;
        }
    }
    bool any = false;
    for (std::uint32_t c = 0; c < chains_.size(); ++c)
        any = flip(c, at) || any;
    return any;
}

bool Chains::flip(std::uint32_t number, std::vector<std::array<std::uint32_t, 3>>& at) {
    Chain& chain = chains_[number];
    Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
    if (chain.is_closed || chain.is_flipped || chain.from == chain.to) return false;
    if (from.groups.size() != 3 || to.groups.size() != 3) return false;
    if (from.has_failed || to.has_failed) return false;
    const Vec3 way = to.at - from.at;
    if (dot(way, way_of(chain)) >= 0.0 || norm(way) <= kPoint) return false;
    const std::uint32_t a = chain.left, b = chain.right;
    const auto third = [&](const Vertex& v) {
        for (const std::uint32_t g : v.groups) {
            if (g != a && g != b) return g;
        }
        return kNone;
    };
    const std::uint32_t c = third(from), d = third(to);
    if (c == kNone || d == kNone || c == d) return false;
    for (const std::uint32_t g : {a, b, c, d}) {
        if (groups_.is_facet(g)) return false;
    }
    if (groups_[c].surface == groups_[d].surface) return false;
    const auto sorted = [](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
        std::vector<std::uint32_t> three{p, q, r};
        std::sort(three.begin(), three.end());
        return three;
    };
    Vertex first{from.at, sorted(a, c, d), 0.0}, second{to.at, sorted(b, c, d), 0.0};
    if (!solve_vertex(first) || !solve_vertex(second)) return false;
    // Of the four chains around, one at each end changes it.
    const auto other = [&](std::uint32_t v, std::uint32_t g, std::uint32_t h) {
        for (const std::uint32_t e : at[v]) {
            if (e == number || e == kNone) continue;
            const Chain& beside = chains_[e];
            if ((beside.left == g && beside.right == h) || (beside.left == h && beside.right == g))
                return e;
        }
        return kNone;
    };
    const std::uint32_t up = other(chain.to, a, d), down = other(chain.from, b, c);
    if (up == kNone || down == kNone || other(chain.to, b, d) == kNone ||
        other(chain.from, a, c) == kNone || up == down)
        return false;
    const auto is_loop = [&](std::uint32_t e) { return chains_[e].from == chains_[e].to; };
    if (is_loop(up) || is_loop(down)) return false;
    std::ranges::replace(at[chain.to], up, kNone);
    std::ranges::replace(at[chain.from], down, up);
    *std::ranges::find(at[chain.to], kNone) = down;
    for (const auto& [e, old, now] :
         {std::tuple(up, chain.to, chain.from), std::tuple(down, chain.from, chain.to)}) {
        Chain& beside = chains_[e];
        (beside.from == old ? beside.from : beside.to) = now;
    }
    from = std::move(first);
    to = std::move(second);
    chain.left = d;
    chain.right = c;
    chain.is_flipped = true;
    return true;
}

// Where a chain goes in the polyhedron.
Vec3 Chains::way_of(const Chain& chain) const {
    return mesh_.point(mesh_.to(chain.edges.back())) -
           mesh_.point(mesh_.edges()[chain.edges.front()].from);
}

void Chains::solve_chain(Chain& chain) {
    const Form &a = groups_.form_of(chain.left), &b = groups_.form_of(chain.right);
    Vertex &from = vertices_[chain.from], &to = vertices_[chain.to];
    chain.has_failed = from.has_failed || to.has_failed;
    if (chain.has_failed) return;
    const bool is_loop = chain.from == chain.to;
    std::vector<Vec3> points = points_of(chain);
    if (!is_loop && norm(to.at - from.at) <= kPoint) {
        // A circle that ends where it begins, or nothing?
        if (norm(points[points.size() / 2] - from.at) < reach({chain.left, chain.right})) {
            chain.has_vanished = true;
            return;
        }
    }
    if (groups_.is_facet(chain.left) || groups_.is_facet(chain.right)) {
        if (is_loop) return fail(chain);
        chain.curve = Line{};
        return;
    }
    const Vec3 middle = points.size() > 2 ? points[points.size() / 2] : 0.5 * (from.at + to.at);
    std::optional<Curve> curve = meet(a, b, from.at, to.at, middle);
    const bool is_straight = curve && std::holds_alternative<Line>(*curve);
    if (is_straight) {
        // A line that comes back is none; nor is one the other way.
        const bool is_back =
            !chain.is_flipped && dot(to.at - from.at, points.back() - points.front()) < 0.0;
        if (is_loop || (is_back && norm(to.at - from.at) > kPoint)) return fail(chain);
        chain.curve = Line{};
        return;
    }
    if (!curve) {
        points.front() = from.at;
        points.back() = to.at;
        // Where they touch, what crosses both tells where.
        const std::optional<Form> touching = touch(a, b);
        const Form& second = touching ? *touching : b;
        const Form& first = std::holds_alternative<Coil>(a) && touching ? b : a;
        auto spline = spline_between(first, second, points);
        // Where facets are large, corners of the polygon may lie beyond its true ends.
        if (!spline && !is_loop && (chain.is_flipped || dot(to.at - from.at, way_of(chain)) > 0.0))
            spline = spline_between(first, second, {from.at, to.at});
        if (!spline) return fail(chain);
        chain.curve = std::move(*spline);
        return;
    }
    auto* circle = std::get_if<Circle>(&*curve);
    auto* ellipse = std::get_if<Ellipse>(&*curve);
    const Vec3 centre = circle ? circle->centre : ellipse->centre;
    Vec3& axis = circle ? circle->axis : ellipse->axis;
    const double rough = turned(points, centre, axis);
    if (is_loop && std::abs(rough) < 180.0) return fail(chain);
    if (rough < 0.0) axis = -axis;
    if (chain.is_closed) {
        // Anywhere: where CAD begins to unroll.
        const Vec3 x = across(axis);
        from.at =
            circle ? centre + circle->radius * x : centre + ellipse->major_radius * ellipse->major;
        from.miss = std::max(std::abs(distance(a, from.at)), std::abs(distance(b, from.at)));
    }
    // Near the corner of a bend facets do not tell which way: the shorter one.
    const bool is_at_bend = from.groups.size() == 2 || to.groups.size() == 2;
    if (!is_loop && is_at_bend && std::abs(rough) < 90.0 &&
        Track(*curve, from.at, to.at).sweep_degrees() > 270.0) {
        axis = -axis;
        chain.curve = std::move(*curve);
        return;
    }
    if (!is_loop) {
        const Track track(*curve, from.at, to.at);
        // Of the two circles in which a plane meets a ring, each end may be on one.
        if (norm(track.at(1.0) - to.at) > kTouchMm) return fail(chain);
        const double sweep = track.sweep_degrees();
        // All but a whole turn: it goes back by the rest.
        if (std::abs(sweep - std::abs(rough)) > std::abs(sweep - 360.0 + std::abs(rough)) &&
            std::abs(sweep - std::abs(rough)) > 180.0)
            return fail(chain);
    }
    // Circles that ought to touch in a corner but are rounded cross on both sides of it. Splines
    // have their ends there, and one direction.
    const auto is_rounded = [](const Vertex& v) { return v.is_touch && v.miss > kRounded; };
    if (!is_loop && circle && (is_rounded(from) || is_rounded(to))) {
        points.front() = from.at;
        points.back() = to.at;
        if (auto spline = spline_between(a, b, points)) *curve = std::move(*spline);
    }
    chain.curve = std::move(*curve);
}

// Out of the loops that had it, into those that it is between now.
void Chains::put_flipped(std::uint32_t number, std::vector<std::vector<Loop>>& all,
                         std::vector<Left>& left) const {
    const Chain& chain = chains_[number];
    std::vector<std::uint32_t> before;
    if (!chain.is_made) {
        const std::uint32_t h = chain.edges.front();
        before = {groups_.group_at(h), groups_.group_beyond(h)};
    }
    for (const std::uint32_t g : before) {
        for (Loop& loop : all[g])
            std::erase_if(loop, [&](const EdgeUse& use) { return use.edge == number; });
        std::erase_if(all[g], [](const Loop& loop) { return loop.empty(); });
    }
    if (chain.has_vanished) return;
    for (const auto& [g, is_forward] :
         {std::pair(chain.left, true), std::pair(chain.right, false)}) {
        if (chain.beside != kNone) {
            for (Loop& loop : all[g]) {
                const auto at = std::ranges::find(loop, chain.beside, &EdgeUse::edge);
                if (at == loop.end()) continue;
                loop.insert(is_forward != chain.is_before ? at + 1 : at, {number, is_forward});
            }
            continue;
        }
        if (!put({g, {number, is_forward}}, all[g], true) && chain.is_made)
            left.push_back({g, {number, is_forward}});
    }
}

// Into a gap: that has both its ends, or one of them, and then others follow.
bool Chains::put(const Left& one, std::vector<Loop>& loops, bool has_both) const {
    const auto begin_of = [&](const EdgeUse& use) {
        return use.is_forward ? chains_[use.edge].from : chains_[use.edge].to;
    };
    const auto end_of = [&](const EdgeUse& use) {
        return use.is_forward ? chains_[use.edge].to : chains_[use.edge].from;
    };
    for (Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const EdgeUse &before = loop[i], &next = loop[(i + 1) % loop.size()];
            const bool begins = end_of(before) == begin_of(one.use);
            const bool ends = end_of(one.use) == begin_of(next);
            const bool is_gap = end_of(before) != begin_of(next);
            if (has_both ? !begins || !ends : !is_gap || !(begins || ends)) continue;
            loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, one.use);
            return true;
        }
    }
    return false;
}

std::vector<std::vector<Loop>> Chains::loops() const {
    const auto first_of = [&](ChainUse use) {
        const Chain& c = chains_[use.chain];
        return use.is_forward ? c.edges.front() : mesh_.edges()[c.edges.back()].twin;
    };
    const auto last_of = [&](ChainUse use) {
        const Chain& c = chains_[use.chain];
        return use.is_forward ? c.edges.back() : mesh_.edges()[c.edges.front()].twin;
    };
    std::vector<std::vector<Loop>> all(groups_.size());
    std::vector<bool> seen(2 * chains_.size(), false);
    for (std::uint32_t i = 0; i < 2 * chains_.size(); ++i) {
        if (seen[i] || chains_[i / 2].is_made) continue;
        ChainUse use{i / 2, i % 2 == 0};
        const std::uint32_t g = groups_.group_at(first_of(use));
        Loop loop;
        for (;;) {
            seen[2 * use.chain + (use.is_forward ? 0 : 1)] = true;
            if (!chains_[use.chain].has_vanished) loop.push_back({use.chain, use.is_forward});
            const std::uint32_t next = groups_.next_boundary(last_of(use));
            use = {chain_of_[next], chains_[chain_of_[next]].edges.front() == next};
            if (seen[2 * use.chain + (use.is_forward ? 0 : 1)]) break;
        }
        if (!loop.empty()) all[g].push_back(std::move(loop));
    }
    std::vector<Left> left;
    for (const bool goes_on : {true, false}) {
        for (std::uint32_t c = 0; c < chains_.size(); ++c) {
            if (chains_[c].is_flipped && (chains_[c].beside != kNone) == goes_on)
                put_flipped(c, all, left);
        }
    }
    // One after the other.
    while (std::erase_if(left, [&](const Left& one) { return put(one, all[one.group], false); }) >
           0) {
    }
    return all;
}

}  // namespace ncsim::brep
