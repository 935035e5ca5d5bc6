// SPDX-License-Identifier: GPL-3.0-or-later
#include "recognise/face_groups.h"

#include "ncsim/base/disjoint_sets.h"

#include "geometry/contact.h"
#include "geometry/envelope_contact.h"
#include "geometry/tolerances.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace ncsim::brep {

namespace {

// Largest deviation of the normals of an absorbed facet, as a chord.
constexpr double kMostTurnOfNeighbours = 0.6;
// Chord of any two directions.
constexpr double kAnyTurn = 2.0;
// A lune one error lower than the edge in its place is at most this many errors off the adjacent
// pipes: four times as far from the pipe as from the plane between both, plus the corners of hulls,
// which lie farther out.
constexpr double kLuneErrors = 6.0;

// Returns the largest thickness of the material between two planes, or two nearly coaxial
// cylinders, that face away from each other, mm; negative if there is no material. Empty for all
// other surfaces.
std::optional<double> thickness_between(const Surface& a, const Surface& b) {
    if (const auto* one = std::get_if<Plane>(&a.form), *two = std::get_if<Plane>(&b.form);
        one && two) {
        if (norm(one->normal + two->normal) > kParallelAngle) return std::nullopt;
        return -distance(a.form, two->origin);
    }
    const auto *one = std::get_if<Cylinder>(&a.form), *two = std::get_if<Cylinder>(&b.form);
    if (!one || !two || a.is_hollow == b.is_hollow ||
        norm(cross(one->axis, two->axis)) > kParallelAngle)
        return std::nullopt;
    const Vec3 separation = two->origin - one->origin;
    const double deviation = norm(separation - dot(separation, one->axis) * one->axis);
    return (a.is_hollow ? two->radius - one->radius : one->radius - two->radius) + deviation;
}

// Returns the direction of the tool's path near `p`, from a surface that crosses a pipe, a flank or
// the envelope of a torus.
Vec3 path_direction(const Form& across, Vec3 p) {
    if (const auto* plane = std::get_if<Plane>(&across)) return plane->normal;
    const auto& characteristic = std::get<Characteristic>(across);
    const ClosestPoint at = closest_point_at(*characteristic.of.sweep, characteristic.t, p);
    const Vec3 velocity = velocity_at(at.tool, height_of_centre(*characteristic.of.sweep, at));
    // Lunes of turning balls are adjacent to the strips of the tool's side and follow the side.
    const Fillet* fillet = characteristic.of.sweep->fillet();
    const bool is_with_side =
        !fillet || (fillet->centre_radius <= 0.0 && is_of_turning_tool(characteristic.of));
    return normalized(is_with_side ? radial_vector({}, at.tool.axis, velocity) : velocity);
}

// Returns the torus of the corner radius in the pose in which the tool's flat end lies in the plane
// `flat`; empty if the path has no such pose.
std::optional<Torus> adjacent_torus(const Plane& flat, const Envelope& moved) {
    const Fillet* fillet = moved.sweep->fillet();
    if (!fillet || moved.sweep->is_rim() || fillet->centre_radius <= fillet->radius)
        return std::nullopt;
    std::vector<double> times{0.0, 1.0};
    if (const auto* path = std::get_if<StraightPath>(&moved.sweep->path())) {
        const double deviation = dot(flat.origin - path->from, flat.normal) - fillet->height;
        times = {(deviation + fillet->radius) / dot(path->along, flat.normal)};
    }
    for (const double t : times) {
        const ToolFrame at = moved.sweep->at(t);
        const Vec3 centre = path_frame(*moved.sweep, at).centre;
        const bool is_its = dot(at.axis, flat.normal) > 0.0 && is_parallel(at.axis, flat.normal) &&
                            is_near(distance(flat, centre), fillet->radius);
        if (is_its) return Torus{centre, at.axis, fillet->centre_radius, fillet->radius};
    }
    return std::nullopt;
}

}  // namespace

void Groups::gather() {
    DisjointSets sets(mesh_.size());
    for (const HalfEdge& h : mesh_.edges()) {
        const std::uint32_t other = mesh_.edges()[h.twin].facet;
        if (h.facet < other && mesh_[h.facet].label == mesh_[other].label)
            sets.unite(h.facet, other);
    }
    groups_.clear();
    group_of_.assign(mesh_.size(), kNone);
    std::vector<std::uint32_t> end;  // end of each group, in facets_
    for (std::uint32_t i = 0; i < mesh_.size(); ++i) {
        const std::uint32_t root = sets.find(i);
        if (group_of_[root] == kNone) {
            group_of_[root] = static_cast<std::uint32_t>(groups_.size());
            groups_.push_back({mesh_[i].label, {}, 0.0, mesh_[i].label != mesh_[i].own});
            end.push_back(0);
        }
        group_of_[i] = group_of_[root];
        groups_[group_of_[i]].area += mesh_[i].area;
        ++end[group_of_[i]];
    }
    facets_.resize(mesh_.size());
    std::uint32_t begin = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        groups_[g].facets = std::span(facets_).subspan(begin, end[g]);
        begin = std::exchange(end[g], begin) + begin;
    }
    for (std::uint32_t i = 0; i < mesh_.size(); ++i)
        facets_[end[group_of_[i]]++] = i;
    find_neighbours();
}

// Sorts the half-edges by group and then by neighbour, and sums the lengths of common boundaries.
void Groups::find_neighbours() {
    struct Adjacency {
        std::uint32_t beyond, edge;
        auto operator<=>(const Adjacency&) const = default;
    };
    const auto& edges = mesh_.edges();
    std::vector<std::uint32_t> end(groups_.size() + 1, 0);
    std::vector<std::uint32_t> boundary;
    boundary.reserve(edges.size());
    for (std::uint32_t h = 0; h < edges.size(); ++h) {
        if (!is_boundary(h)) continue;
        boundary.push_back(h);
        ++end[group_at(h) + 1];
    }
    for (std::size_t g = 0; g < groups_.size(); ++g)
        end[g + 1] += end[g];
    std::vector<Adjacency> met(boundary.size());
    // Each begin becomes the end of its group, which is the begin of the next.
    for (const std::uint32_t h : boundary)
        met[end[group_at(h)]++] = {opposite_group(h), h};
    first_.assign(1, 0);
    neighbours_.clear();
    std::uint32_t begin = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        const std::span mine = std::span(met).subspan(begin, end[g] - begin);
        begin = end[g];
        std::ranges::sort(mine);
        for (const Adjacency& one : mine) {
            const bool is_next =
                neighbours_.size() == first_.back() || neighbours_.back().first != one.beyond;
            if (is_next) neighbours_.emplace_back(one.beyond, 0.0);
            neighbours_.back().second += mesh_.length(one.edge);
        }
        first_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
    }
}

bool Groups::unify() {
    bool any = false;
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
        if (mesh_[groups_[g].facets.front()].is_final) continue;
        for (const auto& [n, shared] : neighbours(g)) {
            if (mesh_[groups_[n].facets.front()].is_final) continue;
            const bool is_smaller = std::pair(groups_[g].area, g) < std::pair(groups_[n].area, n);
            if (!is_smaller || groups_[g].surface == groups_[n].surface) continue;
            if (!is_same(surface_of(g), surface_of(n), kTangencyGapMm)) continue;
            relabel(g, groups_[n].surface);
            any = true;
            break;
        }
    }
    any = absorb_lunes() || any;
    any = absorb_ledges() || any;
    any = absorb_fins() || any;
    if (any) return true;
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
        const Group& group = groups_[g];
        const Facet& first = mesh_[group.facets.front()];
        if ((group.is_analytic && !is_of_turning_tool(form_of(g))) || first.may_be_true ||
            first.is_final)
            continue;
        const double boundary_length = perimeter(g);
        if (2.0 * group.area >= 2.0 * error_of(g) * boundary_length) continue;
        const bool is_of_rounding = 2.0 * group.area < kTangencyGapMm * boundary_length;
        // The normal of a group that is narrower than its error is arbitrary.
        any = absorb(g, 1.5, kMostTurnOfNeighbours) ||
              absorb(g, 2.0, is_of_rounding ? kAnyTurn : 1.0) || any;
    }
    return any;
}

// Absorbs lunes at small bends of the path. A ball or a corner radius leaves a lune between two
// pipes, and a side leaves a strip between two flanks. Extended, the pipes meet in the plane
// between both, slightly higher than the lune. If the bend is small, facets are wider than the lune
// and leave gaps in it. Pipes may be curved: envelopes.
bool Groups::absorb_lunes() {
    bool any = false;
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
        const std::vector<Pipe> pipes = adjacent_pipes(g);
        if (pipes.size() < 2) continue;
        // With the angle t between both paths, pipes meet at 1 / cos(t / 2) times the radius.
        double cosine = 1.0;
        for (const std::uint32_t i : groups_[g].facets) {
            for (const Pipe& one : pipes) {
                for (const Pipe& other : pipes)
                    cosine = std::min(
                        cosine, std::abs(dot(path_direction(one.across, mesh_[i].centroid),
                                             path_direction(other.across, mesh_[i].centroid))));
            }
        }
        const double lower = radius_of(form_of(g)) * (std::sqrt(2.0 / (1.0 + cosine)) - 1.0);
        // A larger difference may be material of another kind.
        if (lower > std::max(5.0 * kLeastSizeMm, error_of(g))) continue;
        const auto longest = std::ranges::max_element(pipes, {}, &Pipe::shared);
        // Another pipe, or the same pipe on both sides of its end, may be adjacent by chance.
        if (!lies_on(g, longest->group, kLuneErrors, kMostTurnOfNeighbours)) continue;
        relabel(g, groups_[longest->group].surface);
        mitred_mm_ = std::max(mitred_mm_, lower);
        any = true;
    }
    return any;
}

// Returns the adjacent pipes that begin or end where the ball, side or corner radius of group `g`
// stood.
std::vector<Groups::Pipe> Groups::adjacent_pipes(std::uint32_t g) const {
    const auto* ball = std::get_if<Sphere>(&form_of(g));
    const auto* side = std::get_if<Cylinder>(&form_of(g));
    const auto* torus = std::get_if<Torus>(&form_of(g));
    if (!groups_[g].is_analytic || (!ball && !side && !torus)) return {};
    std::vector<Pipe> pipes;
    std::optional<Vec3> axis;
    for (const auto& [n, shared] : neighbours(g)) {
        const auto* envelope = std::get_if<Envelope>(&form_of(n));
        if (!envelope) continue;
        const auto t = ball    ? end_at(*envelope, ball->centre)
                       : torus ? end_at(*envelope, torus->centre)
                               : end_on_axis(*envelope, side->origin, side->axis);
        if (!t) continue;
        pipes.push_back({n, shared, Characteristic{*envelope, *t}});
        axis = envelope->sweep->at(*t).axis;
    }
    for (const auto& [n, shared] : neighbours(g)) {
        // A straight pipe. A cylinder about the tool's axis is the side of the tool.
        const auto* pipe = std::get_if<Cylinder>(&form_of(n));
        if (!ball || !pipe || (axis && is_parallel(pipe->axis, *axis))) continue;
        const auto across = tangency_surface(form_of(g), form_of(n));
        if (across) pipes.push_back({n, shared, *across});
    }
    return pipes;
}

// Absorbs ledges. Hulls of a tool on a helix have corners at all heights and leave narrow level
// ledges on the wall.
bool Groups::absorb_ledges() {
    bool any = false;
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
        if (mesh_[groups_[g].facets.front()].is_final) continue;
        const double boundary_length = perimeter(g);
        if (2.0 * groups_[g].area > 0.5 * error_of(g) * boundary_length) continue;
        for (const auto& [n, shared] : neighbours(g)) {
            if (shared < 0.7 * boundary_length || !groups_[n].is_analytic) continue;
            if (mesh_[groups_[n].facets.front()].label != groups_[n].surface ||
                groups_[n].area < groups_[g].area || !lies_on(g, n, 2.0, kAnyTurn))
                continue;
            relabel(g, groups_[n].surface);
            any = true;
            break;
        }
    }
    return any;
}

// Absorbs fins. Two coincident walls that face away from each other have no material between them;
// facets left a fin because the paths repeat with rounding. The fin gets the surface of the face
// below.
bool Groups::absorb_fins() {
    bool any = false;
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
        for (const auto& [n, shared] : neighbours(g)) {
            if (n < g || !absorb_fin(g, n)) continue;
            any = true;
            break;
        }
    }
    return any;
}

bool Groups::absorb_fin(std::uint32_t g, std::uint32_t n) {
    const auto thickness = thickness_between(surface_of(g), surface_of(n));
    const auto is_changed = [&](std::uint32_t i) {
        const Facet& first = mesh_[groups_[i].facets.front()];
        return first.is_final || first.label != groups_[i].surface;
    };
    const double error = std::max(error_of(g), error_of(n));
    if (!groups_[g].is_analytic || !groups_[n].is_analytic || !thickness ||
        *thickness > kTangencyGapMm || *thickness < -error)
        return false;
    // The fin includes its upper facets.
    std::set<std::uint32_t> fin{g, n}, adjacent;
    for (const std::uint32_t side : {g, n}) {
        for (const auto& [m, shared] : neighbours(side)) {
            if (2.0 * groups_[m].area < error * perimeter(m)) fin.insert(m);
        }
    }
    for (const std::uint32_t i : fin) {
        if (is_changed(i)) return false;
        for (const auto& [m, shared] : neighbours(i)) {
            if (!fin.contains(m)) adjacent.insert(m);
        }
    }
    if (adjacent.size() != 1 || is_changed(*adjacent.begin()) || is_facet(*adjacent.begin()))
        return false;
    for (const std::uint32_t i : fin)
        relabel(i, groups_[*adjacent.begin()].surface);
    return true;
}

bool Groups::insert_strips() {
    std::vector<bool> is_removed(groups_.size(), false);  // reassigned to a torus
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::optional<Torus>> tori;
    bool any = false;
    const std::size_t edges = mesh_.edges().size();
    for (std::uint32_t h = 0; h < edges; ++h) {
        const std::uint32_t g = group_at(h);
        const std::uint32_t n = opposite_group_past_strips(h);
        if (n == g || n == kNone || is_removed[g]) continue;
        const auto* flat = std::get_if<Plane>(&form_of(g));
        const auto* moved = std::get_if<Envelope>(&form_of(n));
        if (!flat || !moved || !groups_[g].is_analytic) continue;
        const auto [entry, is_new] = tori.try_emplace({g, n});
        if (is_new) entry->second = adjacent_torus(*flat, *moved);
        const std::optional<Torus>& torus = entry->second;
        if (!torus) continue;
        const Surface corner{*torus, true};
        // A polygon has a wider flat end than the profile.
        const bool is_beyond =
            is_new && std::ranges::all_of(groups_[g].facets, [&](auto i) {
                const Facet& facet = mesh_[i];
                return norm(radial_vector(torus->centre, torus->axis, facet.centroid)) >
                           torus->major &&
                       !facet.was_demoted && !facet.was_reassigned &&
                       mesh_.fits(facet, corner, 1.5 * facet.error_mm, kMostTurnOfNeighbours);
            });
        if (is_beyond) {
            for (const std::uint32_t i : groups_[g].facets)
                mesh_.reassign_label(i, mesh_.number_of(corner));
            is_removed[g] = any = true;
            continue;
        }
        if (!runs_around_torus(h, *torus)) continue;
        const std::vector<std::uint32_t> chain = chain_from(h);
        if (chain.empty()) continue;
        mesh_.insert_strip(chain, mesh_.number_of(corner));
        any = true;
    }
    return any;
}

// True if the half-edge runs around the flat end inside the torus; other edges belong to a face at
// the same height.
bool Groups::runs_around_torus(std::uint32_t h, const Torus& torus) const {
    const Vec3 from = mesh_.point(mesh_.edges()[h].from), to = mesh_.point(mesh_.to(h));
    const Vec3 middle = 0.5 * (from + to);
    return dot(cross(torus.axis, to - from), radial_vector(torus.centre, torus.axis, middle)) <
               0.0 &&
           std::abs(distance(torus, middle)) <= 3.0 * error_of(group_at(h));
}

// Returns the group on the other side of a half-edge; kNone for a strip inserted since gather().
std::uint32_t Groups::opposite_group_past_strips(std::uint32_t h) const {
    const std::uint32_t facet = mesh_.edges()[mesh_.edges()[h].twin].facet;
    return facet < group_of_.size() ? group_of_[facet] : kNone;
}

// Returns all consecutive half-edges between the same two groups, beginning with `h`; empty if the
// boundary is closed, does not begin with `h`, or has a strip whose label was removed.
std::vector<std::uint32_t> Groups::chain_from(std::uint32_t h) const {
    const std::uint32_t beyond = opposite_group(h);
    if (opposite_group_past_strips(boundary_before(h)) == beyond) return {};
    std::vector<std::uint32_t> chain;
    for (std::uint32_t n = h; opposite_group_past_strips(n) == beyond; n = next_boundary(n)) {
        const HalfEdge& edge = mesh_.edges()[n];
        if (mesh_[edge.facet].is_strip || mesh_[mesh_.edges()[edge.twin].facet].is_strip) return {};
        chain.push_back(n);
    }
    return chain;
}

bool Groups::demote_neighbours_of_tori() {
    bool any = false;
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
        const bool may_not = std::holds_alternative<Torus>(form_of(g)) ||
                             std::holds_alternative<Coil>(form_of(g)) ||
                             std::holds_alternative<Dome>(form_of(g)) ||
                             std::holds_alternative<Envelope>(form_of(g)) || is_flat_ramp(g);
        if (!groups_[g].is_analytic || !may_not) continue;
        bool is_beside = false, is_unknown = false;
        for (const auto& [n, shared] : neighbours(g)) {
            is_beside = is_beside || is_facet(n);
            is_unknown = is_unknown || (is_facet(n) && mesh_[groups_[n].facets.front()].is_unknown);
        }
        if (!is_beside) continue;
        if (is_unknown && std::holds_alternative<Envelope>(form_of(g))) {
            for (const std::uint32_t i : groups_[g].facets) {
                if (!mesh_.replace_envelope_label(i)) mesh_.mark_unknown(i);
            }
        } else {
            demote_to_facets(g, false);
        }
        any = true;
    }
    return any;
}

// True if the ramp rises by less than the error of facets.
bool Groups::is_flat_ramp(std::uint32_t g) const {
    const auto* ramp = std::get_if<Extrusion>(&form_of(g));
    return ramp && ramp->radius * std::abs(dot(ramp->along, ramp->axis)) < 2.0 * error_of(g);
}

void Groups::relabel(std::uint32_t g, std::uint32_t surface) {
    for (const std::uint32_t i : groups_[g].facets)
        mesh_.label(i, surface);
}

// Absorbs the group into the neighbour with the longest common boundary on whose surface the group
// lies. Neighbours that changed in this round do not count. Returns false if there is none.
bool Groups::absorb(std::uint32_t g, double errors, double most_turn) {
    std::uint32_t best = kNone;
    double longest = 0.0;
    for (const auto& [n, shared] : neighbours(g)) {
        if (shared <= longest || !groups_[n].is_analytic ||
            mesh_[groups_[n].facets.front()].label != groups_[n].surface)
            continue;
        if (!lies_on(g, n, errors, most_turn)) continue;
        longest = shared;
        best = n;
    }
    if (best == kNone) return false;
    relabel(g, groups_[best].surface);
    return true;
}

// Merges two adjacent planes that differ by the rounding of programs, because the material between
// both has no width. The smaller plane gets the surface of the larger plane, or conversely if
// tangencies would be lost. Returns the merged group.
std::optional<std::uint32_t> Groups::merge_into_wall(std::uint32_t g) {
    const auto is_wall = [&](std::uint32_t n) {
        return groups_[n].is_analytic && std::holds_alternative<Plane>(form_of(n)) &&
               mesh_[groups_[n].facets.front()].label == groups_[n].surface;
    };
    if (!is_wall(g)) return std::nullopt;
    std::optional<std::uint32_t> joined;
    // Facets of a wall are off by the error of the tool's polygon, which may be the same for the
    // other wall, so only the difference counts. A facet that was merged before is compared by its
    // first wall.
    const auto lies_on_other = [&](std::uint32_t one, std::uint32_t other) {
        const Form& form = form_of(other);
        return std::ranges::all_of(groups_[one].facets, [&](std::uint32_t i) {
            const Form& original = mesh_.surface(mesh_[i].plain).form;
            const Form& own = std::holds_alternative<Plane>(original) ? original : form_of(one);
            return norm(std::get<Plane>(own).normal - std::get<Plane>(form).normal) <= kLeastSine &&
                   std::ranges::all_of(mesh_.corners_of(i), [&](Vec3 p) {
                       return std::abs(distance(form, p) - distance(own, p)) <= kTangencyGapMm;
                   });
        });
    };
    // Surfaces tangent to the removed plane must be tangent to the kept plane.
    const auto keeps_touching = [&](std::uint32_t removed, std::uint32_t kept) {
        return std::ranges::all_of(neighbours(removed), [&](const auto& neighbour) {
            const Form& round = form_of(neighbour.first);
            return !groups_[neighbour.first].is_analytic || std::holds_alternative<Plane>(round) ||
                   !tangency_surface(form_of(removed), round) ||
                   tangency_surface(form_of(kept), round);
        });
    };
    const auto join = [&](std::uint32_t n) {
        if (n == g || !is_wall(n) || groups_[n].surface == groups_[g].surface) return false;
        const bool is_larger = std::pair(groups_[n].area, n) > std::pair(groups_[g].area, g);
        std::uint32_t removed = is_larger ? g : n, kept = is_larger ? n : g;
        const auto is_removable = [&] {
            return lies_on_other(removed, kept) && keeps_touching(removed, kept);
        };
        if (!is_removable()) std::swap(removed, kept);
        if (!is_removable()) return false;
        // A merge must not be reversed.
        if (!walls_.emplace(groups_[removed].facets.front(), groups_[kept].surface).second)
            return false;
        relabel(removed, groups_[kept].surface);
        joined = removed;
        return true;
    };
    for (const auto& [n, shared] : neighbours(g)) {
        if (join(n) ||
            std::ranges::any_of(neighbours(n), [&](const auto& next) { return join(next.first); }))
            break;
    }
    return joined;
}

// True if the facets of group `g` lie on the surface of group `n` within `errors` times the error.
bool Groups::lies_on(std::uint32_t g, std::uint32_t n, double errors, double most_turn) const {
    return std::ranges::all_of(groups_[g].facets, [&](std::uint32_t i) {
        const Facet& facet = mesh_[i];
        const double most = errors * std::max(facet.error_mm, error_of(n));
        return mesh_.fits(facet, surface_of(n), most, most_turn);
    });
}

// Returns the recognised groups among `groups`; if there are none, the nearest recognised groups
// within three steps, because those moved the corners.
std::vector<std::uint32_t> Groups::adjacent_analytic_groups(
    std::vector<std::uint32_t> groups) const {
    for (int step = 0;; ++step) {
        std::vector<std::uint32_t> found = groups;
        std::erase_if(found, [&](std::uint32_t g) { return !groups_[g].is_analytic; });
        if (!found.empty() || step == 3) return found;
        for (const std::uint32_t g : std::vector(groups)) {
            for (const auto& [n, shared] : neighbours(g))
                groups.push_back(n);
        }
        sort_unique(groups);
    }
}

bool Groups::relabel(const Failures& failures, Strictness strictness) {
    bool any = false;
    std::set<std::uint32_t> done;
    for (const Failure& failure : failures) {
        // The smallest group that can be changed comes first.
        std::vector<std::uint32_t> order = adjacent_analytic_groups(failure.groups);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(groups_[a].area, a) < std::pair(groups_[b].area, b);
        });
        order.erase(std::unique(order.begin(), order.end()), order.end());
        if (order.empty()) continue;
        const auto has_changed = [&](std::uint32_t g) { return done.contains(g); };
        const auto is_next_to_changed = [&](std::uint32_t g) {
            return has_changed(g) || std::ranges::any_of(neighbours(g), [&](const auto& neighbour) {
                       return has_changed(neighbour.first);
                   });
        };
        if (!failure.is_of_corner && std::ranges::any_of(failure.groups, is_next_to_changed)) {
            any = true;
            continue;
        }
        if (strictness == Strictness::Low && failure.edge != kNone && release_label(failure.edge)) {
            done.insert(failure.groups.begin(), failure.groups.end());
            any = true;
            continue;
        }
        if (strictness == Strictness::Full) {
            done.insert(order.begin(), order.end());
            for (const std::uint32_t g : order)
                demote_to_facets(g, true);
            any = true;
            continue;
        }
        if (std::ranges::any_of(order, has_changed)) {
            any = true;
            continue;
        }
        const bool absorbed = std::ranges::any_of(order, [&](std::uint32_t g) {
            const auto joined = merge_into_wall(g);
            if (!joined && (!may_be_absorbed(g) || !absorb(g, 3.0, kMostTurnOfNeighbours)))
                return false;
            done.insert(joined.value_or(g));
            return true;
        });
        any = true;
        if (absorbed) continue;
        const std::uint32_t g = order.front();
        done.insert(g);
        // A group without any width may have any normal; the faces on both sides meet there.
        if (failure.is_thin && g == failure.groups.front() && absorb(g, 3.0, kAnyTurn)) continue;
        demote_to_facets(g, strictness == Strictness::High);
    }
    return any;
}

// Assigns a facet at the corner to the surface of the tool at rest. Facets between two poses of a
// turning tool begin before the first pose and may reach beyond the envelope.
bool Groups::release_label(std::uint32_t edge) {
    std::vector<std::uint32_t> fan;
    std::uint32_t h = edge;
    do {
        fan.push_back(mesh_.edges()[h].facet);
        h = mesh_.edges()[mesh_.edges()[h].twin].next;
    } while (h != edge);
    for (const std::uint32_t i : fan) {
        const Facet& facet = mesh_[i];
        const Form& form = mesh_.surface(facet.label).form;
        if (facet.was_reassigned || facet.is_final || !std::holds_alternative<Envelope>(form))
            continue;
        for (const std::uint32_t j : fan) {
            const Surface& other = mesh_.surface(mesh_[j].label);
            if (std::holds_alternative<Envelope>(other.form) || mesh_[j].label == mesh_[j].own ||
                !tangency_surface(form, other.form) ||
                !mesh_.fits(facet, other, kLuneErrors * facet.error_mm, kMostTurnOfNeighbours))
                continue;
            mesh_.reassign_label(i, mesh_[j].label);
            return true;
        }
    }
    return false;
}

// True if the group is smaller than an intended face.
bool Groups::may_be_absorbed(std::uint32_t g) const {
    const double width = std::sqrt(8.0 * kLargeRadius * error_of(g));
    return 2.0 * groups_[g].area < width * perimeter(g);
}

// Removes the labels of a group. Facets of an envelope first get the best other surface, unless
// `for_good`.
void Groups::demote_to_facets(std::uint32_t g, bool for_good) {
    const bool is_envelope = std::holds_alternative<Envelope>(form_of(g));
    for (const std::uint32_t i : groups_[g].facets) {
        if (is_envelope && !for_good && mesh_.replace_envelope_label(i)) continue;
        if (for_good) {
            mesh_.fix_as_facet(i);
        } else {
            mesh_.demote_to_facets(i);
        }
    }
}

double Groups::perimeter(std::uint32_t g) const {
    double sum = 0.0;
    for (const auto& [n, shared] : neighbours(g))
        sum += shared;
    return sum;
}

}  // namespace ncsim::brep
