// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions of the vertices of chains, on all adjacent surfaces.
#include "geometry/contact.h"
#include "geometry/envelope_contact.h"
#include "geometry/newton.h"
#include "geometry/path_corners.h"
#include "geometry/tolerances.h"
#include "recognise/chains.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace ncsim::brep {

namespace {

// Moves `p` to an apex of a cone that lies on all surfaces. Newton's method does not find an apex,
// because a cone has no normal there.
bool move_to_apex(const std::vector<const Form*>& forms, Vec3& p) {
    for (const Form* form : forms) {
        const auto* cone = std::get_if<Cone>(form);
        if (!cone || norm(p - cone->apex) > 0.3) continue;
        const bool all = std::ranges::all_of(
            forms, [&](const Form* f) { return std::abs(distance(*f, cone->apex)) < kFlat; });
        if (!all) continue;
        p = cone->apex;
        return true;
    }
    return false;
}

// Moves `p` to an apex within the rounding of programs, because OpenCASCADE takes such corners for
// the apex.
void snap_to_apex(const std::vector<const Form*>& forms, Vec3& p) {
    for (const Form* form : forms) {
        const auto* cone = std::get_if<Cone>(form);
        if (cone && norm(p - cone->apex) <= kTangencyGapMm) p = cone->apex;
    }
}

// Returns the largest vector, over all envelopes of turning tools, by which the place of `p` on the
// envelope lies beyond an end of the path, mm.
Vec3 overshoot(const std::vector<const Form*>& forms, Vec3 p) {
    Vec3 most;
    for (const Form* form : forms) {
        if (!is_of_turning_tool(*form)) continue;
        const auto* envelope = std::get_if<Envelope>(form);
        const ClosestPoint place = project_onto(*envelope, p);
        const Vec3 beyond = (place.t - std::clamp(place.t, 0.0, 1.0)) *
                            velocity_at(place.tool, height_of_centre(*envelope->sweep, place));
        if (norm(beyond) > norm(most)) most = beyond;
    }
    return most;
}

// Moves `p` to the second solution if it lies beyond the end of a path. A surface that crosses an
// envelope nearly along the path meets it twice.
void move_onto_path(const std::vector<const Form*>& forms, Vec3& p) {
    const Vec3 beyond = overshoot(forms, p);
    if (norm(beyond) <= kTangencyGapMm) return;
    for (const double times : {2.0, 4.0}) {
        Vec3 other = p - times * beyond;
        if (brep::solve(forms, other) > kTangencyGapMm ||
            norm(overshoot(forms, other)) > kTangencyGapMm)
            continue;
        p = other;
        return;
    }
}

// At a corner of the path of a ball, the surfaces before and after it meet in two curves at small
// angles. Moves `p` near the curve of the corner, unless another of the surfaces does not meet this
// curve: where the ball crosses its path elsewhere, the other curve is the right one.
void move_to_mitre(std::vector<const Form*> forms, std::size_t count, Vec3& p) {
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            const auto plane = rough_mitre_plane(*forms[i], *forms[j]);
            if (!plane) continue;
            const Form mitre = *plane;
            forms.push_back(&mitre);
            Vec3 moved = p;
            if (brep::solve(forms, moved) <= kTangencyGapMm) {
                p = moved;
                return;
            }
            forms.pop_back();
        }
    }
}

// True if no two planes are parallel within the rounding of programs.
bool are_askew(std::span<const Form* const> planes) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            const Vec3 one = std::get<Plane>(*planes[i]).normal;
            if (norm(cross(one, std::get<Plane>(*planes[j]).normal)) < 3.0 * kLeastSine)
                return false;
        }
    }
    return true;
}

// Returns the distance of `p` from a polyline, mm.
double distance_from(const std::vector<Vec3>& points, Vec3 p) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 from = points[i - 1], along = points[i] - from;
        const double square = dot(along, along);
        const double t = square > 0.0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0.0;
        least = std::min(least, norm(p - from - t * along));
    }
    return least;
}

}  // namespace

// Returns the largest distance between a corner of the polygon and the true corner, mm.
double Chains::reach(const std::vector<std::uint32_t>& groups) const {
    double radius = kLargeRadius, error = 0.0;
    for (const std::uint32_t g : groups) {
        radius = std::max(radius, radius_of(groups_.form_of(g)));
        error = std::max(error, groups_.error_of(g));
    }
    return 5.0 * std::sqrt(2.0 * radius * error) + 4.0 * error + kFlat;
}

// True if the circle of a bend lies in the level face or wall `g`. `near` is a corner of the
// polyhedron.
bool Chains::has_bend(std::uint32_t g, Vec3 corner, Vec3 near) const {
    const Form& form = groups_.form_of(g);
    const auto is_on = [&](Vec3 p, double most) { return std::abs(distance(form, p)) < most; };
    if (groups_.is_facet(g)) return false;
    if (std::holds_alternative<Plane>(form)) return is_on(corner, kFlat) && is_on(near, kFlat);
    return std::holds_alternative<Cylinder>(form) && is_on(corner, kFlat) &&
           is_on(near, groups_.error_of(g));
}

// Returns the corner of the edge of two ramps among the faces of `v`: without a third face, or with
// a third face in which the circle of the bend lies, so that all three meet in the whole circle.
std::optional<Vec3> Chains::bend_at(const Vertex& v) const {
    for (std::size_t i = 0; i < v.groups.size(); ++i) {
        for (std::size_t j = i + 1; j < v.groups.size(); ++j) {
            const auto corner =
                corner_of_bend(groups_.form_of(v.groups[i]), groups_.form_of(v.groups[j]), v.at);
            if (!corner || norm(*corner - v.at) >= reach(v.groups)) continue;
            if (v.groups.size() == 2) return corner;
            const bool has_circle = std::ranges::any_of(v.groups, [&](std::uint32_t g) {
                return g != v.groups[i] && g != v.groups[j] && has_bend(g, *corner, v.at);
            });
            if (has_circle &&
                largest_distance({groups_[v.groups[i]].surface, groups_[v.groups[j]].surface},
                                 *corner) <= kTangencyGapMm)
                return corner;
        }
    }
    return std::nullopt;
}

bool Chains::solve_vertex(Vertex& v, const std::vector<std::vector<Vec3>>& lines) const {
    if (std::ranges::any_of(v.groups, [&](std::uint32_t g) { return groups_.is_facet(g); }))
        return solve_next_to_facets(v);
    // Surfaces that are tangent in one place may cross in another. A vertex that does not lie on
    // the curve of tangency is usually farther from the curve than two facets are wide.
    const double near = reach(v.groups);
    return solve_vertex(v, lines, near) || solve_vertex(v, lines, 0.4 * near);
}

bool Chains::solve_vertex(Vertex& v, const std::vector<std::vector<Vec3>>& lines,
                          double near_tangency) const {
    const Vec3 start = v.at;
    std::vector<std::uint32_t> numbers;
    bool all_flat = true;
    for (const std::uint32_t g : v.groups) {
        numbers.push_back(groups_[g].surface);
        all_flat = all_flat && std::holds_alternative<Plane>(groups_.form_of(g));
    }
    sort_unique(numbers);
    std::vector<const Form*> forms;
    forms.reserve(numbers.size());
    for (const std::uint32_t n : numbers)
        forms.push_back(&mesh_.surface(n).form);
    if (const auto corner = bend_at(v); corner && forms.size() <= 3) {
        v.at = *corner;
        v.miss = largest_distance(numbers, v.at);
        return true;
    }
    const std::size_t count = forms.size();
    std::vector<Form> touching;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            if (auto t = tangency_surface(*forms[i], *forms[j]);
                t && std::abs(distance(*t, start)) <= near_tangency) {
                touching.push_back(*t);
                v.is_tangency = true;
            }
            if (auto t = mitre_plane(*forms[i], *forms[j], v.at)) touching.push_back(*t);
        }
    }
    if (auto across = corner_of_dome(forms)) touching.push_back(*across);
    for (Form& across : level_tangency_planes(forms))
        touching.push_back(std::move(across));
    for (const Form& t : touching)
        forms.push_back(&t);
    if (!move_to_apex(forms, v.at)) {
        move_to_mitre(forms, count, v.at);
        brep::solve(forms, v.at);
        move_onto_path(forms, v.at);
        snap_to_apex(forms, v.at);
        // Tangent curved surfaces leave a rest of rounding, which must not be off the planes.
        for (const std::uint32_t n : numbers) {
            if (const auto* plane = std::get_if<Plane>(&mesh_.surface(n).form))
                v.at = v.at - distance(*plane, v.at) * plane->normal;
        }
    }
    if (touching.size() == 3 && count == 3) move_to_parting(v, start, numbers);
    move_to_ellipse(v, start);
    move_to_crossing(v, start, numbers);
    v.miss = largest_distance(numbers, v.at);
    double deviation = norm(v.at - start);
    for (const std::vector<Vec3>& line : lines)
        deviation = std::min(deviation, distance_from(line, v.at));
    // Planes at small angles meet far away for a small change, unless they are parallel within
    // rounding.
    const bool is_far = all_flat && are_askew(std::span(forms).first(count));
    if (v.miss <= kTangencyGapMm && deviation <= (is_far ? 2.0 : 1.0) * reach(v.groups))
        return true;
    v.at = start;
    v.miss = largest_distance(numbers, v.at);
    return false;
}

// Solves the vertex, or returns the previous solution if no adjacent group has changed.
bool Chains::solve_corner(Vertex& v) {
    const auto is_analytic = [&](std::uint32_t g) { return groups_[g].is_analytic; };
    if (v.edge == kNone || std::ranges::none_of(v.groups, is_analytic)) {
        const bool is_solved = solve_vertex(v);
        v.is_bend_elsewhere = is_bend_elsewhere(v);
        return is_solved;
    }
    cached_corners_.resize(mesh_.corners());
    std::vector<CachedCorner>& all = cached_corners_[mesh_.edges()[v.edge].from];
    const auto key = [&](std::uint32_t g) {
        return std::pair(groups_[g].surface, groups_[g].facets.front());
    };
    auto cached = std::ranges::find_if(all, [&](const CachedCorner& corner) {
        return std::ranges::equal(v.groups, corner.surfaces, {}, key);
    });
    const bool was_tangency = std::exchange(v.is_tangency, false);
    if (cached == all.end()) {
        if (all.size() == 32) all.clear();
        CachedCorner found;
        found.is_solved = solve_vertex(v);
        std::ranges::transform(v.groups, std::back_inserter(found.surfaces), key);
        found.at = v.at;
        found.miss = v.miss;
        found.is_tangency = v.is_tangency;
        found.is_bend_elsewhere = is_bend_elsewhere(v);
        cached = all.insert(all.end(), std::move(found));
    }
    v.at = cached->at;
    v.miss = cached->miss;
    v.is_tangency = was_tangency || cached->is_tangency;
    v.is_bend_elsewhere = cached->is_bend_elsewhere;
    return cached->is_solved;
}

// True if the first facet of the ramp lies above `p`.
bool Chains::is_above(std::uint32_t ramp, Vec3 p) const {
    const auto& form = std::get<Extrusion>(groups_.form_of(ramp));
    return dot(mesh_[groups_[ramp].facets.front()].centroid - p, form.axis) > 0.0;
}

// Moves a vertex of two ramps and a wall to the ellipse of the bend. In a valley or on a ridge, the
// wall next to one ramp is tangent to it from the circle of the bend on. The other ramp crosses
// both in this circle and a second time in the ellipse of the bend, which has the corner of all
// three.
void Chains::move_to_ellipse(Vertex& v, Vec3 start) const {
    if (v.groups.size() != 3) return;
    for (std::size_t i = 0; i < 3; ++i) {
        const Form& wall = groups_.form_of(v.groups[i]);
        const Form& one = groups_.form_of(v.groups[(i + 1) % 3]);
        const Form& other = groups_.form_of(v.groups[(i + 2) % 3]);
        if (!std::holds_alternative<Plane>(wall) || !std::holds_alternative<Extrusion>(one) ||
            !std::holds_alternative<Extrusion>(other))
            continue;
        const auto first = tangency_surface(wall, one), second = tangency_surface(wall, other);
        if (first.has_value() == second.has_value()) continue;
        const auto ellipse = ellipse_of_bend(one, other, v.at);
        if (!ellipse ||
            is_above(v.groups[(i + 1) % 3], v.at) != is_above(v.groups[(i + 2) % 3], v.at))
            continue;
        const std::array<const Form*, 3> planes{&wall, first ? &*first : &*second, &*ellipse};
        Vec3 p = v.at;
        if (brep::solve(planes, p) > kTangencyGapMm || norm(p - start) > reach(v.groups) ||
            std::abs(distance(one, p)) > kTangencyGapMm ||
            std::abs(distance(other, p)) > kTangencyGapMm)
            continue;
        v.at = p;
        return;
    }
}

// Moves a vertex of three surfaces that are tangent in a common circle to the point of the circle
// in which two grooves part. A ball that leaves a full circle along a line, or along another arc,
// goes on tangentially, and the ridge between both grooves begins in this point.
void Chains::move_to_parting(Vertex& v, Vec3 start,
                             const std::vector<std::uint32_t>& numbers) const {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto point = crossing_of_grooves(mesh_.surface(numbers[i]).form,
                                               mesh_.surface(numbers[(i + 1) % 3]).form, start);
        if (!point || norm(*point - start) > reach(v.groups) ||
            largest_distance(numbers, *point) > kTangencyGapMm)
            continue;
        v.at = *point;
        return;
    }
}

// Moves the vertex to a crossing nearby. Surfaces that are tangent within rounding may cross on
// both sides of the tangency.
void Chains::move_to_crossing(Vertex& v, Vec3 start,
                              const std::vector<std::uint32_t>& numbers) const {
    if (v.edge == kNone || !crossed_.contains(mesh_.edges()[v.edge].from)) return;
    std::vector<const Form*> forms;
    forms.reserve(numbers.size());
    for (const std::uint32_t n : numbers)
        forms.push_back(&mesh_.surface(n).form);
    Vec3 p = start;
    brep::solve(forms, p);
    if (largest_distance(numbers, p) <= kFlat && norm(p - v.at) > kLeastAxisDistance) v.at = p;
}

// Solves a vertex with adjacent facets: it stays, or moves to the common point of the recognised
// surfaces if that is within the error of the facets.
bool Chains::solve_next_to_facets(Vertex& v) const {
    std::vector<const Form*> forms;
    double error = 0.0;
    bool is_flat = true;
    for (const std::uint32_t g : v.groups) {
        error = std::max(error, groups_.error_of(g));
        is_flat = is_flat && !groups_[g].is_analytic;
        if (!groups_.is_facet(g)) forms.push_back(&groups_.form_of(g));
    }
    if (is_flat) return true;
    const auto deviation = [&](Vec3 p) {
        double most = 0.0;
        for (const std::uint32_t g : v.groups)
            most = std::max(most, std::abs(distance(groups_.form_of(g), p)));
        return most;
    };
    if (forms.size() > 1 || (forms.size() == 1 && deviation(v.at) > kFacetSlack * error)) {
        std::vector<Form> touching;
        for (std::size_t i = 0; i < forms.size(); ++i) {
            for (std::size_t j = i + 1; j < forms.size(); ++j) {
                if (auto t = tangency_surface(*forms[i], *forms[j])) touching.push_back(*t);
                if (auto t = mitre_plane(*forms[i], *forms[j], v.at)) touching.push_back(*t);
            }
        }
        for (const Form& t : touching)
            forms.push_back(&t);
        Vec3 p = v.at;
        if (brep::solve(forms, p) <= kTangencyGapMm && norm(p - v.at) <= reach(v.groups) &&
            deviation(p) <= kFacetSlack * error) {
            v.at = p;
            return true;
        }
    }
    return deviation(v.at) <= kFacetSlack * error;
}

double Chains::largest_distance(const std::vector<std::uint32_t>& surfaces, Vec3 p) const {
    double most = 0.0;
    for (const std::uint32_t n : surfaces)
        most = std::max(most, std::abs(distance(mesh_.surface(n).form, p)));
    return most;
}

}  // namespace ncsim::brep
