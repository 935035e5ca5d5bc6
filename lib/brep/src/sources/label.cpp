// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fit of facets to candidate surfaces. Comparisons are written so that a distance that is not a
// number, as of degenerate surfaces from a file, does not fit.
#include "sources/label.h"

#include "geometry/envelope_contact.h"
#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ncsim::brep {

namespace {

// Errors up to which facets belong to a peak: they continue beyond the tip by the width of a
// polygon's side.
constexpr double kPeakSlack = 3.0;

// Returns the deviation of the face's normal from the surface, as a mean over the corners.
double turn_at_corners(const FlatFace& face, const Surface& surface) {
    double sum = 0.0, corners = 0.0;
    for (const auto& loop : face.loops) {
        for (const std::uint32_t v : loop) {
            sum += norm(face.normal - outward(surface, face.points[v]));
            corners += 1.0;
        }
    }
    return sum / corners;
}

// True if the midpoints of the edges are on the surface, too. The ends alone may be on the surface
// by chance, as for a wall that comes down to the foot of a floor.
bool has_edges_on(const FlatFace& face, const Surface& surface, double most) {
    return std::ranges::all_of(face.loops, [&](const std::vector<std::uint32_t>& loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec3 a = face.points[loop[i]], b = face.points[loop[(i + 1) % loop.size()]];
            if (!(std::abs(distance(surface.form, 0.5 * (a + b))) <= most)) return false;
        }
        return true;
    });
}

bool is_flank(const Form& form) {
    const auto* envelope = std::get_if<Envelope>(&form);
    return envelope && envelope->sweep->flank();
}

// True if the surface comes to a tip in the material, and the face may be at the tip: on a spindle,
// not farther from the axis than a side of a polygon is wide.
bool is_at_peak(const FlatFace& face, const Surface& surface, double error) {
    if (std::holds_alternative<Cone>(surface.form)) return !surface.is_hollow;
    const auto* torus = std::get_if<Torus>(&surface.form);
    if (!torus || !is_spindle(*torus)) return false;
    const double side = std::sqrt(8.0 * torus->minor * error);
    return std::ranges::any_of(face.loops, [&](const std::vector<std::uint32_t>& loop) {
        return std::ranges::any_of(loop, [&](std::uint32_t v) {
            return norm(radial_vector(torus->centre, torus->axis, face.points[v])) <= side;
        });
    });
}

// Returns the radius of a blunt tip. A hill inside an arc of a cutter that widens comes to a tip;
// polygons in place of the cutter leave a tip as wide as half of their sides.
double blunt_of(const FlatFace& face, const Cone& cone, double most) {
    double widest = 0.0;
    for (const auto& loop : face.loops) {
        for (const std::uint32_t v : loop)
            widest = std::max(widest, norm(radial_vector(cone.apex, cone.axis, face.points[v])));
    }
    return 0.5 * std::sqrt(8.0 * widest * most / kPeakSlack);
}

// Returns how far `p` is beyond the end of an envelope's path, mm; infinity where the tool pivots
// and there is no envelope. Beyond the end, the envelope is continued although a different motion,
// or no motion, follows.
double beyond_end(const Form& form, Vec3 p) {
    const auto* envelope = std::get_if<Envelope>(&form);
    if (!envelope || std::holds_alternative<StraightPath>(envelope->sweep->path())) return 0.0;
    const ClosestPoint closest = project_onto(*envelope, p);
    if (is_at_pivot(*envelope->sweep, closest)) return std::numeric_limits<double>::infinity();
    const Vec3 velocity = velocity_at(closest.tool, height_of_centre(*envelope->sweep, closest));
    return std::abs(closest.t - std::clamp(closest.t, 0.0, 1.0)) * norm(velocity);
}

// Returns the largest distance beyond an end at which facets still belong to the surface. Facets
// between two poses of a turning tool are as wide as the sides of polygons in its place, and may
// begin by this width before the first pose.
double farthest_beyond(const Form& form, double error) {
    if (!is_of_turning_tool(form)) return error;
    const Sweep& sweep = *std::get<Envelope>(form).sweep;
    const Fillet* fillet = sweep.fillet();
    const double radius = fillet ? fillet->centre_radius + fillet->radius : sweep.flank()->radius;
    return std::sqrt(8.0 * radius * error);
}

}  // namespace

double area_of(const std::vector<std::vector<std::uint32_t>>& loops, std::span<const Vec3> points,
               Vec3 normal, Vec3& centroid) {
    const Vec3 apex = points[loops[0][0]];
    double sum = 0.0;
    Vec3 moment;
    for (const auto& loop : loops) {
        const Vec3 a = points[loop[0]] - apex;
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            const Vec3 b = points[loop[i]] - apex;
            const Vec3 c = points[loop[i + 1]] - apex;
            const double part = 0.5 * dot(cross(b - a, c - a), normal);
            sum += part;
            moment = moment + (part / 3.0) * (a + b + c);
        }
    }
    centroid = sum > 0.0 ? apex + (1.0 / sum) * moment : apex;
    return sum;
}

bool fits(const FlatFace& face, const Surface& surface, double most, double most_turn,
          double* score) {
    // The direction is compared at the centroid. If the centroid is off the surface (for a torus:
    // the bottom of a round groove), the direction is compared at the corners. The distance of the
    // corners is tested first, because a floor between walls may have thousands of corners.
    const auto [deviation, gradient] = evaluate(surface.form, face.centroid);
    const bool is_on = std::abs(deviation) <= most;
    double turn =
        is_on ? norm(face.normal - (surface.is_hollow ? -gradient : gradient)) : most_turn;
    if (!(turn <= most_turn)) return false;
    double farthest = 0.0;
    const auto* cone = std::get_if<Cone>(&surface.form);
    const double blunt = cone && !surface.is_hollow ? blunt_of(face, *cone, most) : 0.0;
    for (const auto& loop : face.loops) {
        for (const std::uint32_t v : loop) {
            const Vec3 p = face.points[v];
            const bool is_at_tip =
                cone && blunt > 0.0 && norm(radial_vector(cone->apex, cone->axis, p)) < blunt;
            const double here = is_at_tip ? std::max(most, blunt) : most;
            const double off_here = std::abs(distance(surface.form, p));
            farthest = std::max(farthest, std::min(off_here, most));
            if (!(off_here <= here)) return false;
            if (cone && dot(p - cone->apex, cone->axis) < -here) return false;
        }
    }
    if (!is_on) turn = turn_at_corners(face, surface);
    if (!(turn <= most_turn) || (!is_on && !has_edges_on(face, surface, most))) return false;
    if (score) *score = turn + 0.1 * farthest / most;
    return true;
}

const CandidateSurface* best_of(const FlatFace& face, std::span<const CandidateSurface> candidates,
                                double error, double most_turn, double& best, bool with_envelopes) {
    // A facet on a plane of the tool belongs to the plane, because ramps may be flatter than
    // errors. Surfaces along which the tool moved are preferred to those at rest, except beyond the
    // ends of paths.
    const CandidateSurface* chosen = nullptr;
    const auto take = [&](const CandidateSurface& candidate, double score) {
        if (candidate.is_at_rest) score += 0.05;
        if (score >= best - kRounding) return;
        best = score;
        chosen = &candidate;
    };
    for (const CandidateSurface& candidate : candidates) {
        if (std::holds_alternative<Plane>(candidate.surface.form) &&
            fits(face, candidate.surface, kFlat, 0.1 * kParallelAngle))
            take(candidate, -1.0);
    }
    if (chosen) return chosen;
    // The score is at least the deviation of the normal, so larger deviations are not examined.
    // Forms on which the nearest point must be searched come last.
    for (const bool are_moved : {false, true}) {
        for (const CandidateSurface& candidate : candidates) {
            const Form& form = candidate.surface.form;
            const bool is_coil = std::holds_alternative<Coil>(form);
            const bool is_envelope = std::holds_alternative<Envelope>(form);
            const bool is_moved = is_coil || is_envelope || std::holds_alternative<Dome>(form);
            if (is_moved != are_moved || (is_envelope && !with_envelopes)) continue;
            if (candidate.place && !candidate.place->overlaps({face.centroid, face.centroid}))
                continue;
            if (candidate.ends && (distance((*candidate.ends)[0], face.centroid) < 0.0 ||
                                   distance((*candidate.ends)[1], face.centroid) >= 0.0))
                continue;
            if (candidate.below_side &&
                std::abs(dot(*candidate.below_side, face.normal)) <= 0.1 * kParallelAngle)
                continue;
            double score = 0.0;
            // Corners of adjacent hulls may lie farther out than corners of the tool's polygon.
            // Coils: corners next to walls lie both beyond the wall and below the floor. Flanks:
            // the hull of two poses of a turning tool adds about as much as the tool's polygon is
            // off.
            const double slack = is_coil                                      ? 2.0
                                 : is_flank(form)                             ? 3.0
                                 : is_at_peak(face, candidate.surface, error) ? kPeakSlack
                                                                              : 1.5;
            if (!fits(face, candidate.surface, slack * error, std::min(most_turn, best), &score))
                continue;
            const double beyond = is_moved ? beyond_end(form, face.centroid) : 0.0;
            if (beyond > farthest_beyond(form, error)) continue;
            const bool is_before = beyond > 0.0 && is_of_turning_tool(form);
            take(candidate, is_before ? score + 0.1 : score);
        }
    }
    return chosen;
}

}  // namespace ncsim::brep
