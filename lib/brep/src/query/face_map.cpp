// SPDX-License-Identifier: GPL-3.0-or-later
#include "query/face_map.h"

#include "ncsim/base/angles.h"

#include "geometry/tolerances.h"
#include "topology/angular_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::brep {

namespace {

Vec2 point_of(const Sweep& sweep, const ClosestPoint& place) {
    const double across = place_across(sweep, place.tool, place.foot);
    const Fillet* fillet = sweep.fillet();
    const double scale =
        fillet ? (fillet->centre_radius + fillet->radius) * kRadiansPerDegree : 1.0;
    return {scale * across, sweep.length_mm() * place.t};
}

Vec2 out(const Local& p, double radius) {
    return {radius * p.x / p.radius, radius * p.y / p.radius};
}

}  // namespace

FaceMap::FaceMap(const Part& part, const Face& face)
    : form_(&face.surface.form), axes_(axes_of(face, face.frame.origin)) {
    if (is_straight_up()) {
        low_ = std::numeric_limits<double>::infinity();
        for_edges(part, face, [&](const Track& track, double) {
            for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                const Local p = local(track.at(t));
                low_ = std::min(low_, p.z);
                // The x axis points away from the face; a fifth of the radius is clear of rounding.
                faces_one_way_ = faces_one_way_ && p.x < -0.2 * p.radius;
            }
        });
        low_ -= 2.0 * radius_of(*form_);
    } else if (const auto* c = std::get_if<Cone>(form_)) {
        axes_.origin = c->apex;
    } else if (const auto* s = std::get_if<Sphere>(form_)) {
        // Integral along the loops, exact for arcs and therefore independent of the division.
        Vec3 sum;
        double length = 0.0;
        for_edges(part, face, [&](const Track& track, double) {
            for (const double t : {0.0, 0.25, 0.5, 0.75}) {
                const double chord = norm(track.at(t + 0.25) - track.at(t));
                sum = sum + chord * (track.at(t + 0.125) - s->centre);
                length += chord;
            }
        });
        // Loops nearly in a plane through the centre do not determine the side of the face; then
        // the axis of the frame is the middle.
        Vec3 middle = normalized(sum);
        if (norm(sum) < 0.025 * length * s->radius) middle = face.frame.axis;
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

FaceMap::Place FaceMap::place(Vec3 p, ProjectionSeed& seed) const {
    const auto* envelope = std::get_if<Envelope>(form_);
    if (!envelope) return {(*this)(p), distance(*form_, p)};
    const ClosestPoint closest = project_onto(*envelope, p, seed);
    return {point_of(*envelope->sweep, closest), closest.deviation};
}

Vec2 FaceMap::operator()(Vec3 at) const {
    // Angles count from the middle of the half of the circle, which turns with the path.
    if (const auto* c = std::get_if<Coil>(form_)) {
        const CoilPlace place = project_onto(*c, at);
        const double x = ahead_ * dot(place.out, place.motion);
        const double y = ahead_ * dot(place.out, cross(c->axis, place.motion));
        return {c->radius * angle_of(x, y) * kRadiansPerDegree, c->reach * place.turn};
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
    if (is_straight_up()) return faces_one_way_ ? Vec2{p.y, p.z} : out(p, p.z - low_);
    if (const auto* s = std::get_if<Sphere>(form_)) {
        const double scale = 2.0 * s->radius / std::max(1e-9 * s->radius, s->radius + p.z);
        return {scale * p.x, scale * p.y};
    }
    const auto& t = std::get<Torus>(*form_);
    const double angle = degrees_from(cut_, t, p) * kRadiansPerDegree;
    if (!is_spindle(t)) return out(p, t.minor * (1.0 + angle));
    return p.radius > 0.0 ? out(p, t.minor * angle) : Vec2{0.0, 0.0};
}

std::optional<FaceMap::Round> FaceMap::round_of(const WholeCircle& circle) const {
    const double deviation = std::abs(distance(*form_, circle.start));
    if (std::holds_alternative<Plane>(*form_)) {
        const double slope = norm(cross(circle.axis, axes_.z));
        if (slope > kRounding) return std::nullopt;
        const Local centre = axes_(circle.centre);
        return Round{{centre.x, centre.y}, circle.radius, deviation + 2.0 * circle.radius * slope};
    }
    const bool is_annulus = std::holds_alternative<Cylinder>(*form_) && !faces_one_way_;
    if ((!is_annulus && !is_cone()) || !circle.is_about(axes_.origin, axes_.z)) return std::nullopt;
    const double radius = is_annulus ? axes_(circle.centre).z - low_ : circle.radius;
    return Round{{0.0, 0.0}, radius, deviation};
}

bool FaceMap::is_of_other_half(Vec2 at, double tolerance_mm) const {
    const auto* coil = std::get_if<Coil>(form_);
    return coil &&
           std::abs(at.x) > kQuarterTurnDegrees * kRadiansPerDegree * coil->radius + tolerance_mm;
}

bool FaceMap::keeps_lines() const {
    return std::holds_alternative<Plane>(*form_) || std::holds_alternative<Cone>(*form_) ||
           std::holds_alternative<Spiral>(*form_) ||
           (is_straight_up() && faces_one_way_ && !std::holds_alternative<Dome>(*form_));
}

Local FaceMap::local(Vec3 p) const {
    const auto* dome = std::get_if<Dome>(form_);
    return dome ? local_on(*dome, axes_, p) : axes_(p);
}

}  // namespace ncsim::brep
