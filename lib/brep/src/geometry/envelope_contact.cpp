// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tangency of envelopes, by the kind of the second surface.
#include "geometry/envelope_contact.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ncsim::brep {

namespace {

// Returns the form that crosses an envelope along the characteristic of time `t`; for a ball, a
// plane.
Form plane_across_path(const Envelope& envelope, double t) {
    const Sweep& sweep = *envelope.sweep;
    if (!sweep.is_ball()) return Characteristic{envelope, t};
    const PathFrame at = path_frame(sweep, sweep.at(t));
    return Plane{at.centre, at.ahead};
}

// True if sweep `b` at time `s` continues sweep `a` at time `t` smoothly. Fillets are compared by
// the direction of their centre, flanks by the directions of both ends.
bool continues(const Sweep& a, double t, const Sweep& b, double s) {
    const Flank* flank = a.flank();
    const auto* fillet = a.fillet();
    if (!flank && !fillet) return false;
    const bool is_upright = flank && flank->sine == 0.0;
    const auto path_direction = [&](const ToolFrame& tool, double height) {
        const Vec3 velocity = velocity_at(tool, height);
        return normalized(is_upright ? radial_vector({}, tool.axis, velocity) : velocity);
    };
    const ToolFrame at = a.at(t), there = b.at(s);
    const auto is_same_direction = [&](double height) {
        return is_parallel(path_direction(at, height), path_direction(there, height));
    };
    const double height = flank ? flank->height : fillet->height;
    return is_parallel(at.axis, there.axis) && is_same_direction(height) &&
           (!flank || is_same_direction(height + flank->length));
}

// True if both sweeps have the same path, in either direction.
bool is_same_path(const Sweep& a, const Sweep& b) {
    if (a.path().index() != b.path().index()) return false;
    const auto is_same = [&](double t, double s) {
        const ToolFrame at = a.at(t), there = b.at(s);
        return is_near(norm(at.tip - there.tip), 0.0) && is_parallel(at.axis, there.axis);
    };
    const auto all = [&](auto other) {
        return is_same(0.0, other(0.0)) && is_same(0.5, other(0.5)) && is_same(1.0, other(1.0));
    };
    return all([](double t) { return t; }) || all([](double t) { return 1.0 - t; });
}

// Returns the cosine between the wall's normal and the tool's axis, if the tool moves along the
// wall and the cosine is constant.
std::optional<double> rise_along(const Plane& wall, const Sweep& sweep) {
    const Vec3 start = path_frame(sweep, sweep.at(0.0)).centre;
    const double rise = dot(wall.normal, sweep.at(0.0).axis);
    for (const double t : {0.25, 0.5, 0.75, 1.0}) {
        const ToolFrame at = sweep.at(t);
        if (!is_near(dot(path_frame(sweep, at).centre - start, wall.normal), 0.0) ||
            std::abs(dot(wall.normal, at.axis) - rise) > kParallelAngle)
            return std::nullopt;
    }
    return rise;
}

struct EnvelopeTangency {
    using Answer = std::optional<Form>;
    const Envelope& b;

    // Walls along a path on which the tool keeps its inclination to the wall.
    Answer operator()(const Plane& a) const {
        const Sweep& sweep = *b.sweep;
        const Fillet* fillet = sweep.fillet();
        if (!fillet) return {};
        const ToolFrame start = sweep.at(0.0);
        const double deviation = distance(a, path_frame(sweep, start).centre);
        const Vec3 level = a.normal - dot(a.normal, start.axis) * start.axis;
        if (!is_near(std::abs(deviation), fillet->centre_radius * norm(level) + fillet->radius))
            return {};
        const Vec3 n = deviation > 0.0 ? -a.normal : a.normal;
        if (const auto* path = std::get_if<StraightPath>(&sweep.path())) {
            if (std::abs(dot(a.normal, path->along)) > kParallelAngle * norm(path->along))
                return {};
            const Vec3 at = path_frame(sweep, start).centre +
                            fillet->centre_radius * normalized(n - dot(n, start.axis) * start.axis);
            return Plane{at, normalized(cross(a.normal, path->along))};
        }
        const auto rise = rise_along(a, sweep);
        if (!rise) return {};
        return Trail{b, deviation > 0.0 ? -*rise : *rise};
    }
    // The walls on both sides of a helix; the straight continuation of a ball's path; a flank at
    // rest.
    Answer operator()(const Cylinder& a) const {
        const Sweep& sweep = *b.sweep;
        if (const Flank* flank = sweep.flank()) {
            if (std::abs(flank->sine) > kParallelAngle || !is_near(a.radius, flank->radius))
                return {};
            const auto end = end_on_axis(b, a.origin, a.axis);
            if (!end) return {};
            return plane_across_path(b, *end);
        }
        const Fillet& fillet = *sweep.fillet();
        const auto* path = std::get_if<HelixPath>(&sweep.path());
        const bool is_about = path && is_parallel(path->about, path->axis) && path->growth == 0.0;
        if (is_about && is_parallel(a.axis, path->about) &&
            is_near(norm(radial_vector(path->centre, path->about, a.origin)), 0.0)) {
            const double out = fillet.centre_radius + fillet.radius;
            if (is_near(a.radius, path->reach + out) ||
                is_near(a.radius, std::abs(path->reach - out)))
                return Trail{b, 0.0};
            return {};
        }
        if (fillet.centre_radius > 0.0 || !is_near(a.radius, fillet.radius)) return {};
        for (const double t : {0.0, 1.0}) {
            const PathFrame at = path_frame(sweep, sweep.at(t));
            if (is_parallel(at.ahead, a.axis) &&
                is_near(norm(radial_vector(a.origin, a.axis, at.centre)), 0.0))
                return plane_across_path(b, t);
        }
        return {};
    }
    // A flank at rest at an end of the path.
    Answer operator()(const Cone& a) const {
        const Flank* flank = b.sweep->flank();
        if (!flank) return {};
        const auto end = end_on_axis(b, a.apex, a.axis);
        if (!end) return {};
        const ToolFrame at = b.sweep->at(*end);
        const double sign = dot(at.axis, a.axis) > 0.0 ? 1.0 : -1.0;
        const double slope = -sign * flank->sine / flank->cosine;
        const Vec3 origin = at.tip + flank->height * at.axis;
        const double height = dot(origin - a.apex, a.axis);
        if (std::abs(slope - a.slope) > kParallelAngle || !is_near(a.slope * height, flank->radius))
            return {};
        return plane_across_path(b, *end);
    }
    Answer operator()(const Sphere& a) const {
        if (!b.sweep->is_ball() || !is_near(a.radius, b.sweep->fillet()->radius)) return {};
        const auto t = end_at(b, a.centre);
        if (!t) return {};
        return plane_across_path(b, *t);
    }
    Answer operator()(const Torus& a) const {
        const Fillet* fillet = b.sweep->fillet();
        if (!fillet || !is_near(a.minor, fillet->radius) ||
            !is_near(a.major, fillet->centre_radius))
            return {};
        const auto t = end_at(b, a.centre);
        if (!t || !is_parallel(a.axis, b.sweep->at(*t).axis)) return {};
        return plane_across_path(b, *t);
    }
    // The path continues smoothly; or the profile does, for the same tool on the same path.
    Answer operator()(const Envelope& a) const {
        const Sweep &one = *a.sweep, &other = *b.sweep;
        if (one.flank() && other.fillet()) return side_of(b, *one.flank(), one);
        if (one.fillet() && other.flank()) return side_of(a, *other.flank(), other);
        if (!is_same(one.meridian(), other.meridian(), kTangencyGapMm)) return {};
        for (const double t : {0.0, 1.0}) {
            const auto s = end_at(b, path_frame(one, one.at(t)).centre);
            if (s && continues(one, t, other, *s)) return plane_across_path(b, *s);
        }
        return {};
    }
    template <typename A>
    Answer operator()(const A&) const {
        return {};
    }

private:
    static Answer side_of(const Envelope& round, const Flank& flank, const Sweep& side) {
        const Fillet& fillet = *round.sweep->fillet();
        const double deviation = flank.cosine * (fillet.centre_radius - flank.radius) +
                                 flank.sine * (fillet.height - flank.height);
        if (!is_near(deviation, -fillet.radius) || !is_same_path(*round.sweep, side)) return {};
        return Trail{round, flank.sine};
    }
};

}  // namespace

namespace {

// Returns the direction, forwards or backwards, in which a ball of `radius` passed the point
// `centre` if it left `form`.
std::optional<Vec3> direction_of_ball(const Form& form, double radius, Vec3 centre) {
    if (const auto* pipe = std::get_if<Cylinder>(&form)) {
        const double off = norm(radial_vector(pipe->origin, pipe->axis, centre));
        if (is_near(pipe->radius, radius) && is_near(off, 0.0)) return pipe->axis;
    } else if (const auto* ring = std::get_if<Torus>(&form)) {
        const Vec3 out = radial_vector(ring->centre, ring->axis, centre);
        const double height = dot(centre - ring->centre, ring->axis);
        if (is_near(ring->minor, radius) && is_near(norm(out), ring->major) && is_near(height, 0.0))
            return normalized(cross(ring->axis, out));
    } else if (const auto* envelope = std::get_if<Envelope>(&form)) {
        const Sweep& sweep = *envelope->sweep;
        const auto t = end_at(*envelope, centre);
        if (sweep.is_ball() && is_near(sweep.fillet()->radius, radius) && t)
            return path_frame(sweep, sweep.at(*t)).ahead;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Plane> rough_mitre_plane(const Form& a, const Form& b) {
    const auto* curved = std::get_if<Envelope>(&a);
    const Form& other = curved ? b : a;
    if (!curved) curved = std::get_if<Envelope>(&b);
    if (!curved || !curved->sweep->is_ball() ||
        !std::holds_alternative<HelixPath>(curved->sweep->path()))
        return std::nullopt;
    for (const double t : {0.0, 1.0}) {
        const PathFrame at = path_frame(*curved->sweep, curved->sweep->at(t));
        const auto along = direction_of_ball(other, curved->sweep->fillet()->radius, at.centre);
        if (!along || is_parallel(*along, at.ahead)) continue;
        const Vec3 ahead = dot(*along, at.ahead) < 0.0 ? -*along : *along;
        return Plane{at.centre, normalized(at.ahead + ahead)};
    }
    return std::nullopt;
}

double depth_of_lune(const Form& a, const Form& b, const Track& edge) {
    const auto corner = rough_mitre_plane(a, b);
    if (!corner) return 0.0;
    const Envelope* curved = std::get_if<Envelope>(&a);
    if (!curved) curved = std::get_if<Envelope>(&b);
    double depth = 0.0;
    for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vec3 p = edge.at(s);
        const double t = project_onto(*curved, p).t;
        if (t != std::clamp(t, 0.0, 1.0))
            depth = std::max(depth, norm(p - corner->origin) - curved->sweep->fillet()->radius);
    }
    return depth;
}

std::optional<double> end_at(const Envelope& envelope, Vec3 centre) {
    const Sweep& sweep = *envelope.sweep;
    std::vector<double> times{0.0, 1.0};
    if (const auto* path = std::get_if<StraightPath>(&sweep.path())) {
        const Vec3 start = path_frame(sweep, sweep.at(0.0)).centre;
        times = {dot(centre - start, path->along) / dot(path->along, path->along)};
    }
    for (const double t : times) {
        if (is_near(norm(path_frame(sweep, sweep.at(t)).centre - centre), 0.0)) return t;
    }
    return std::nullopt;
}

std::optional<double> end_on_axis(const Envelope& envelope, Vec3 origin, Vec3 axis) {
    for (const double t : {0.0, 1.0}) {
        const ToolFrame at = envelope.sweep->at(t);
        if (is_parallel(at.axis, axis) && is_near(norm(radial_vector(origin, axis, at.tip)), 0.0))
            return t;
    }
    return std::nullopt;
}

std::optional<Vec3> hinge_of(const Form& a, const Form& b, Vec3 from, Vec3 past, Vec3 to) {
    const auto *one = std::get_if<Envelope>(&a), *other = std::get_if<Envelope>(&b);
    if (!one || !other || !is_of_turning_tool(a) || !one->sweep->is_ball() ||
        !other->sweep->is_ball())
        return std::nullopt;
    for (const double t : {0.0, 1.0}) {
        const PathFrame at = path_frame(*one->sweep, one->sweep->at(t));
        const auto s = end_at(*other, at.centre);
        if (!s) continue;
        const Vec3 ahead = path_frame(*other->sweep, other->sweep->at(*s)).ahead;
        if (is_parallel(at.ahead, ahead)) return std::nullopt;
        Vec3 out = normalized(cross(at.ahead, ahead));
        if (dot(past - at.centre, out) < 0.0) out = -out;
        const Vec3 hinge = at.centre + one->sweep->fillet()->radius * out;
        const Vec3 between = dot(at.ahead, ahead) < 0.0 ? at.ahead - ahead : at.ahead + ahead;
        const Vec3 along = normalized(cross(between, out));
        const double behind = dot(from - hinge, along), before = dot(to - hinge, along);
        if (behind * before >= 0.0 ||
            std::min(std::abs(behind), std::abs(before)) < kLeastAxisDistance)
            return std::nullopt;
        return hinge;
    }
    return std::nullopt;
}

bool is_of_turning_tool(const Form& form) {
    const auto* envelope = std::get_if<Envelope>(&form);
    return envelope && std::holds_alternative<RotaryPath>(envelope->sweep->path());
}

std::optional<Form> envelope_tangency_surface(const Form& a, const Envelope& b) {
    return std::visit(EnvelopeTangency{b}, a);
}

}  // namespace ncsim::brep
