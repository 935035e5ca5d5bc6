// SPDX-License-Identifier: GPL-3.0-or-later
//
// Let D be the distance from the element at the time t and n the gradient of D. The envelope is the
// set where D = 0 and dD/dt = 0. dD/dt = -n V, where V is the velocity of the point as fixed to the
// tool. So normals, the curvature of elements, and two derivatives of the path determine the
// envelope; the spin of the tool about its axis has no effect.
#include "ncsim/brep/envelope.h"

#include "ncsim/base/angles.h"

#include "geometry/ellipse.h"
#include "geometry/rim.h"
#include "geometry/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace ncsim::brep {

namespace {

Vec3 level(Vec3 v, Vec3 axis) {
    return v - dot(v, axis) * axis;
}

Vec3 middle_of(const Sweep& sweep, const ToolFrame& tool) {
    return tool.tip + lowest_centre(sweep) * tool.axis;
}

// Point in cylindrical coordinates about the tool's axis.
struct Seen {
    Seen(const ToolFrame& at, Vec3 p) {
        const Vec3 v = p - at.tip;
        height = dot(v, at.axis);
        const Vec3 radial = v - height * at.axis;
        radius = norm(radial);
        out = radius > 0.0 ? (1.0 / radius) * radial : Vec3{};
    }
    double height, radius;
    Vec3 out;  // Unit; zero on the axis.
};

// Returns the distance along the profile from the lower end, mm.
double place_along(const Flank& flank, const Seen& seen) {
    return (seen.height - flank.height) * flank.cosine - (seen.radius - flank.radius) * flank.sine;
}

// Contact of a flank with its envelope, at a place along the profile. `velocity` is the velocity of
// the axis point where the normal ends, without the component along the axis; out() returns the
// direction from the axis to the contact on either side. At the contact, the velocity of the point
// as fixed to the tool is perpendicular to the normal.
struct Contact {
    Contact(const Flank& flank, const ToolFrame& at, double along)
        : velocity(level(velocity_at(at, height_of_centre(flank, along)), at.axis)),
          right(cross(normalized(velocity), at.axis)),
          lean(-flank.sine * dot(at.speed, at.axis) / (flank.cosine * norm(velocity))) {}
    Vec3 out(bool is_right, Vec3 axis) const {
        const double ahead = std::clamp(lean, -1.0, 1.0), across = std::sqrt(1.0 - ahead * ahead);
        return ahead * cross(axis, right) + (is_right ? across : -across) * right;
    }
    Vec3 velocity, right;
    double lean;  // Cosine between the outward direction and the direction of motion.
};

// Returns the closest point on a straight path. Seen along the path, the circle of the fillet's
// centres is an ellipse; the envelope is offset from this ellipse by the radius.
ClosestPoint nearest_on(const Sweep& sweep, const StraightPath& path, Vec3 p) {
    const Fillet& fillet = *sweep.fillet();
    const double length = norm(path.along), lean = dot(path.along, path.axis);
    const Vec3 ahead = ((lean < 0.0 ? -1.0 : 1.0) / length) * path.along;
    const Vec3 x = normalized(cross(path.axis, ahead)), y = cross(ahead, x);
    const Vec3 start = path.from + fillet.height * path.axis, v = p - start;
    const EllipseFoot foot = foot_on_ellipse(
        fillet.centre_radius, fillet.centre_radius * std::abs(lean) / length, dot(v, x), dot(v, y));
    const Vec3 normal = foot.x * x + foot.y * y;
    const Vec3 centre =
        v - foot.distance * normal - fillet.centre_radius * normalized(level(normal, path.axis));
    ClosestPoint closest = closest_point_at(sweep, dot(centre, path.along) / (length * length), p);
    closest.deviation = foot.distance - fillet.radius;
    closest.normal = normal;
    closest.foot = p - closest.deviation * normal;
    return closest;
}

// Local minima of the distance among the samples, the nearest few: the distance at the sample, and
// the estimated time of the minimum.
struct Nearest {
    std::array<double, 4> time{}, deviation{};
    std::size_t count = 0;
    double least = std::numeric_limits<double>::infinity();
    void take(double when, double how_far) {
        least = std::min(least, how_far);
        if (count < time.size()) {
            time[count] = when;
            deviation[count++] = how_far;
            return;
        }
        double& farthest = *std::ranges::max_element(deviation);
        if (how_far >= farthest) return;
        time[static_cast<std::size_t>(&farthest - deviation.data())] = when;
        farthest = how_far;
    }
};

Nearest nearest_samples(const Sweep& sweep, Vec3 p) {
    const auto& samples = sweep.samples();
    const Fillet* fillet = sweep.fillet();
    // Fillets: the squared distance.
    const auto deviation = [&](const ToolFrame& at) {
        const Vec3 v = p - at.tip;
        const double height = dot(v, at.axis);
        const double radius = std::sqrt(std::max(0.0, dot(v, v) - height * height));
        if (!fillet) {
            const Flank& flank = *sweep.flank();
            return flank.cosine * (radius - flank.radius) + flank.sine * (height - flank.height);
        }
        const double beyond = radius - fillet->centre_radius, above = height - fillet->height;
        return beyond * beyond + above * above;
    };
    Nearest nearest;
    if (sweep.is_rim()) {
        for (const double when : rim_start_times(sweep, p))
            nearest.take(when, std::sqrt(deviation(sweep.at(when))));
        return nearest;
    }
    const double any = std::numeric_limits<double>::infinity();
    const double step = 1.0 / static_cast<double>(samples.size() - 1);
    double before = any, here = deviation(samples.front());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double after = i + 1 < samples.size() ? deviation(samples[i + 1]) : any;
        if (here <= before && here < after) {
            // Minimum of the parabola through three samples.
            const bool is_between = before < any && after < any;
            const double ahead =
                is_between ? 0.5 * (before - after) / ((before - here) + (after - here)) : 0.0;
            nearest.take((static_cast<double>(i) + ahead) * step, fillet ? std::sqrt(here) : here);
        }
        before = here;
        here = after;
    }
    // All samples are equally far.
    if (nearest.count == 0) nearest.take(0.0, fillet ? std::sqrt(here) : here);
    return nearest;
}

// Moves the closest point to a time so close that the tool's motion is linear in between.
// Requires: no rim, because `rate` has a different meaning for rims.
void advance(ClosestPoint& closest, double by, Vec3 p) {
    ToolFrame& at = closest.tool;
    at.tip = at.tip + by * at.speed;
    at.speed = at.speed + by * at.change;
    at.axis = at.axis + by * at.turn;
    at.turn = at.turn + by * at.bend;
    closest.t += by;
    closest.deviation += by * (closest.rate + 0.5 * by * closest.bend);
    closest.rate += by * closest.bend;
    closest.normal = closest.normal + by * closest.drift;
    closest.foot = p - closest.deviation * closest.normal;
}

// Newton's method, or a step downhill where Newton's method would go uphill. Known times before and
// after the nearest time bound the steps. Near the edge of a fold of the envelope, there may be no
// nearest time; the result is then the closest point at `when`.
ClosestPoint nearest_from(const Sweep& sweep, double when, Vec3 p) {
    const double any = std::numeric_limits<double>::infinity();
    const double longest = 1.0 / static_cast<double>(sweep.samples().size() - 1);
    double before = -any, after = any;
    ClosestPoint closest = closest_point_at(sweep, when, p);
    bool is_found = false;
    for (int i = 0; i < 40 && !is_found; ++i) {
        const double t = closest.t;
        (closest.rate > 0.0 ? after : before) = t;
        const double downhill = closest.rate > 0.0 ? -longest : longest;
        const double step = closest.bend > 0.0 ? -closest.rate / closest.bend : downhill;
        double next = t + std::clamp(step, -longest, longest);
        if (!(std::abs(next - t) > 0.01 * kUnitRounding)) return closest;
        const bool is_between = next > before && next < after;
        if (!is_between && before > -any && after < any) next = 0.5 * (before + after);
        // Changes with the square of a step this short are rounding errors, on paths with at most a
        // few turns.
        is_found = is_between && !sweep.is_rim() && std::abs(step) < 100.0 * kRounding;
        if (is_found) {
            advance(closest, step, p);
        } else {
            closest = closest_point_at(sweep, next, p);
        }
    }
    if (!is_found) closest = closest_point_at(sweep, when, p);
    return closest;
}

// Profile in the half plane of a point: distance, normal (outwards and along the axis), and angle
// of the normal per mm along the profile.
struct Shape {
    double deviation = 0.0, cosine = 0.0, sine = 0.0, bend = 0.0;
    bool is_known = true;
};

Shape shape_at(const Fillet& fillet, const Seen& seen) {
    const double beyond = seen.radius - fillet.centre_radius, above = seen.height - fillet.height;
    const double far = std::sqrt(beyond * beyond + above * above);
    if (!(far > 0.0)) return {.is_known = false};
    return {far - fillet.radius, beyond / far, above / far, 1.0 / far};
}

Shape shape_at(const Flank& flank, const Seen& seen) {
    const double deviation =
        flank.cosine * (seen.radius - flank.radius) + flank.sine * (seen.height - flank.height);
    return {deviation, flank.cosine, flank.sine, 0.0};
}

}  // namespace

ClosestPoint closest_point_at(const Sweep& sweep, double t, Vec3 p) {
    ClosestPoint closest = closest_point_at(sweep, sweep.at(t), p);
    closest.t = t;
    return closest;
}

ClosestPoint closest_point_at(const Sweep& sweep, const ToolFrame& at, Vec3 p) {
    if (sweep.is_rim()) return closest_point_on_rim(*sweep.fillet(), at, p);
    ClosestPoint closest;
    closest.tool = at;
    const Seen seen(at, p);
    const Shape shape =
        std::visit([&](const auto& which) { return shape_at(which, seen); }, sweep.meridian());
    if (!shape.is_known) return closest;
    const Vec3 n = shape.cosine * seen.out + shape.sine * at.axis;
    closest.deviation = shape.deviation;
    closest.normal = n;
    closest.foot = p - closest.deviation * n;
    // The tool rotates with the angular velocity a x a', which maps a vector v to (a v) a' - (a' v)
    // a.
    const Vec3 v = p - at.tip;
    const Vec3 speed = at.speed + seen.height * at.turn - dot(at.turn, v) * at.axis;
    const Vec3 change = at.change + seen.height * at.bend - dot(at.axis, at.speed) * at.turn +
                        (dot(at.turn, at.speed) - dot(at.bend, v)) * at.axis;
    closest.rate = -dot(n, speed);
    // Change of the normal with the point, along the profile and around the axis.
    const double curvature = seen.radius > 0.0 ? shape.cosine / seen.radius : 0.0;
    const Vec3 along = shape.cosine * at.axis - shape.sine * seen.out;
    const Vec3 level_speed = speed + closest.rate * n;
    closest.drift = shape.sine * at.turn - dot(at.turn, n) * at.axis - curvature * level_speed -
                    ((shape.bend - curvature) * dot(speed, along)) * along;
    closest.bend = -dot(closest.drift, speed) - dot(n, change);
    return closest;
}

ClosestPoint project_onto(const Envelope& envelope, Vec3 p) {
    const Sweep& sweep = *envelope.sweep;
    if (const auto* straight = std::get_if<StraightPath>(&sweep.path()))
        return nearest_on(sweep, *straight, p);
    // If the path returns, a different time may be as near at a sample and nearer between samples,
    // by at most half a step of the path. Times beyond the ends count less with increasing
    // distance.
    const Nearest nearest = nearest_samples(sweep, p);
    const double half = 0.5 * sweep.length_mm() / static_cast<double>(sweep.samples().size() - 1);
    // The surface swept by a rim may be near on both sides.
    const bool is_of_rim = sweep.is_rim();
    const auto far = [&](const ClosestPoint& closest) {
        return is_of_rim ? std::abs(closest.deviation) : closest.deviation;
    };
    std::optional<ClosestPoint> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < nearest.count; ++k) {
        if (nearest.deviation[k] > nearest.least + half) continue;
        const ClosestPoint closest = nearest_from(sweep, nearest.time[k], p);
        double deviation = far(closest);
        if (const double end = std::clamp(closest.t, 0.0, 1.0);
            nearest.count > 1 && closest.t != end) {
            const double beyond = std::abs(closest.t - end) * sweep.length_mm();
            deviation = far(closest_point_at(sweep, end, p)) + 0.25 * beyond;
        }
        if (deviation >= least) continue;
        least = deviation;
        best = closest;
    }
    return *best;
}

ClosestPoint project_onto(const Envelope& envelope, Vec3 p, double near_time) {
    const Sweep& sweep = *envelope.sweep;
    // A torus passes a point twice, in quick succession where the torus is nearly level.
    const bool is_of_torus = sweep.fillet() && !sweep.is_ball();
    if (is_of_torus || std::holds_alternative<StraightPath>(sweep.path()))
        return project_onto(envelope, p);
    return nearest_from(sweep, near_time, p);
}

ClosestPoint project_onto(const Envelope& envelope, Vec3 p, ProjectionSeed& seed) {
    // Faster changes are not extrapolated.
    const double later = std::clamp(dot(seed.slope, p - seed.at), -0.1, 0.1);
    const ClosestPoint closest =
        seed.time ? project_onto(envelope, p, *seed.time + later) : project_onto(envelope, p);
    seed = {closest.t, p, gradient_of_time(closest)};
    return closest;
}

Vec3 gradient_of_rise(const Sweep& sweep, const ClosestPoint& closest) {
    const ToolFrame& at = closest.tool;
    const Vec3 n = closest.normal;
    const Fillet* fillet = sweep.fillet();
    if (!fillet) return {};
    if (sweep.is_rim()) return gradient_of_rise_of_rim(*fillet, closest);
    const double rise = dot(n, at.axis), far = closest.deviation + fillet->radius;
    const Vec3 along = at.axis - rise * n;
    const double with_time = dot(closest.drift, at.axis) + dot(n, at.turn);
    return (1.0 / far) * along + with_time * gradient_of_time(closest);
}

double height_of_centre(const Sweep& sweep, const ClosestPoint& closest) {
    const Flank* flank = sweep.flank();
    if (!flank) return sweep.fillet()->height;
    return height_of_centre(*flank, place_along(*flank, Seen(closest.tool, closest.foot)));
}

namespace {

// Returns the angle around the path, from `up` to `side`, in [0, 360).
double degrees_around(const PathFrame& at, Vec3 p) {
    const Vec3 v = p - at.centre;
    const double degrees = angle_of(dot(v, at.up), dot(v, at.side));
    return degrees < 0.0 ? degrees + 360.0 : degrees;
}

// Returns the normal of a fillet's characteristic that looks like `across` (unit) along the path of
// the fillet's centre. The normal n meets the axis a of the tool at a different height than the
// centre. With e the outward direction, V the velocity of the centre, and R the radius of the
// circle of centres,
//
//     n V = R (n a) (e a'),
//
// so n is nearly perpendicular to the path if the tool turns slowly. The equation is solved by
// secants (Illinois).
Vec3 normal_across(const Fillet& fillet, const ToolFrame& tool, const PathFrame& at, Vec3 across) {
    const double speed = norm(velocity_at(tool, fillet.height));
    const double most = fillet.centre_radius * norm(tool.turn) / speed;
    if (!(most > 0.0 && most < 1.0)) return across;
    const auto normal = [&](double ahead) {
        return std::sqrt(1.0 - ahead * ahead) * across + ahead * at.ahead;
    };
    const auto deviation = [&](double ahead) {
        const Vec3 n = normal(ahead), out = normalized(level(n, tool.axis));
        return ahead - fillet.centre_radius * dot(n, tool.axis) * dot(out, tool.turn) / speed;
    };
    double low = -most, high = most, below = deviation(low), above = deviation(high);
    double ahead = 0.0, value = deviation(ahead);
    for (int i = 0; i < kMostSteps && std::abs(value) > 1e-16; ++i) {
        const bool is_low = value < 0.0;
        (is_low ? low : high) = ahead;
        (is_low ? below : above) = value;
        ahead = low - below * (high - low) / (above - below);
        value = deviation(ahead);
        // The retained end counts half.
        if ((value < 0.0) == is_low) (is_low ? above : below) *= 0.5;
    }
    return normal(ahead);
}

// Returns the point of a fillet at `degrees` around the path. The angle of the point grows with the
// angle of the point's normal; both angles are on the same side of `up` and down.
Vec3 point_around(const Sweep& sweep, const ToolFrame& tool, double degrees) {
    if (sweep.is_ball() || degrees == kHalfTurnDegrees)
        return point_with_normal(sweep, tool, degrees);
    const PathFrame at = path_frame(sweep, tool);
    double low = degrees < kHalfTurnDegrees ? 0.0 : kHalfTurnDegrees, high = low + kHalfTurnDegrees;
    // Secants (Illinois), and bisection where secants are slow.
    const auto deviation = [&](double normal) {
        return degrees_around(at, point_with_normal(sweep, tool, normal)) - degrees;
    };
    double below = (low == 0.0 ? 0.0 : kHalfTurnDegrees) - degrees,
           above = below + kHalfTurnDegrees;
    double normal = degrees;
    for (int i = 0; i < kMostSteps && high - low > 0.01 * kUnitRounding * kHalfTurnDegrees; ++i) {
        normal = i % 3 == 2 ? 0.5 * (low + high) : low - below * (high - low) / (above - below);
        if (!(normal > low && normal < high)) normal = 0.5 * (low + high);
        const double value = deviation(normal);
        if (value == 0.0) break;
        (value < 0.0 ? low : high) = normal;
        (value < 0.0 ? below : above) = value;
    }
    return point_with_normal(sweep, tool, normal);
}

}  // namespace

Vec3 point_with_normal(const Sweep& sweep, const ToolFrame& tool, double degrees) {
    const PathFrame at = path_frame(sweep, tool);
    const auto angle = sin_cos(degrees);
    const Fillet& fillet = *sweep.fillet();
    const Vec3 n = normal_across(fillet, tool, at, angle.cos * at.up + angle.sin * at.side);
    const Vec3 radial = fillet.centre_radius > 0.0
                            ? fillet.centre_radius * normalized(level(n, tool.axis))
                            : Vec3{};
    return at.centre + radial + fillet.radius * n;
}

double place_across(const Sweep& sweep, const ToolFrame& tool, Vec3 p) {
    const Flank* flank = sweep.flank();
    if (sweep.is_rim()) return place_on_rim(sweep, tool, p);
    if (!flank) return degrees_around(path_frame(sweep, tool), p);
    const double along = place_along(*flank, Seen(tool, p));
    const bool is_right = dot(p - tool.tip, Contact(*flank, tool, along).right) > 0.0;
    return is_right ? -(flank->length + along) : flank->length + along;
}

Vec3 point_across(const Sweep& sweep, const ToolFrame& tool, double place) {
    const Flank* flank = sweep.flank();
    if (sweep.is_rim()) return point_on_rim(sweep, tool, place);
    if (!flank) return point_around(sweep, tool, place);
    const double along = std::abs(place) - flank->length;
    const Vec3 out = Contact(*flank, tool, along).out(place < 0.0, tool.axis);
    return tool.tip + (flank->radius - along * flank->sine) * out +
           (flank->height + along * flank->cosine) * tool.axis;
}

bool has_across(const Sweep& sweep) {
    if (const Flank* flank = sweep.flank()) {
        const auto touches = [&](const ToolFrame& at, double along) {
            const Contact contact(*flank, at, along);
            return norm(contact.velocity) > kRounding && std::abs(contact.lean) < 1.0 - kLeastSine;
        };
        return std::ranges::all_of(sweep.samples(), [&](const ToolFrame& at) {
            return touches(at, 0.0) || touches(at, flank->length);
        });
    }
    // The flat end of a tool that turns must not be level anywhere: the parts of the end ahead of
    // and behind the level line would touch the envelope in two curves.
    const double centre_radius = sweep.fillet()->centre_radius;
    bool rises = false, falls = false;
    const bool is_usual = std::ranges::all_of(sweep.samples(), [&](const ToolFrame& at) {
        const Vec3 velocity = velocity_at(at, lowest_centre(sweep));
        const double lean = dot(velocity, at.axis), length = norm(velocity);
        const double least = std::max(kLeastSine * length, 1.1 * centre_radius * norm(at.turn));
        rises = rises || lean > -least;
        falls = falls || lean < least;
        return length > kRounding && std::abs(lean) < (1.0 - kLeastSine) * length;
    });
    return is_usual && (sweep.is_ball() || !rises || !falls);
}

bool is_at_pivot(const Sweep& sweep, const ClosestPoint& closest) {
    const Flank* flank = sweep.flank();
    if (!flank) return false;
    const ToolFrame& at = closest.tool;
    const Seen seen(at, closest.foot);
    const Contact contact(*flank, at, place_along(*flank, seen));
    return norm(contact.velocity) < seen.radius * norm(at.turn) + kRounding ||
           std::abs(contact.lean) > 1.0 - kLeastSine;
}

double largest_radius(const Sweep& sweep) {
    const Fillet* fillet = sweep.fillet();
    const double own = fillet ? fillet->centre_radius + fillet->radius : sweep.flank()->radius;
    if (const auto* round = std::get_if<HelixPath>(&sweep.path())) return round->reach + own;
    if (!fillet || std::holds_alternative<RotaryPath>(sweep.path())) return sweep.length_mm() + own;
    const ToolFrame start = sweep.at(0.0);
    const double lean = std::abs(dot(start.axis, normalized(start.speed)));
    return fillet->centre_radius / lean + fillet->radius;
}

bool is_same(const Meridian& a, const Meridian& b, double tolerance_mm) {
    const auto is_near = [&](double u, double v) { return std::abs(u - v) <= tolerance_mm; };
    if (a.index() != b.index()) return false;
    if (const auto* fillet = std::get_if<Fillet>(&a)) {
        const auto& other = std::get<Fillet>(b);
        return is_near(fillet->centre_radius, other.centre_radius) &&
               is_near(fillet->radius, other.radius);
    }
    const auto &flank = std::get<Flank>(a), &other = std::get<Flank>(b);
    const double deviation =
        flank.cosine * (other.radius - flank.radius) + flank.sine * (other.height - flank.height);
    return is_near(deviation, 0.0) && is_near(kPartMm * (flank.cosine - other.cosine), 0.0) &&
           is_near(kPartMm * (flank.sine - other.sine), 0.0);
}

bool is_same(const Envelope& a, const Envelope& b, double tolerance_mm) {
    if (!is_same(a.sweep->meridian(), b.sweep->meridian(), tolerance_mm)) return false;
    const auto first = path_frame(*a.sweep, a.sweep->at(0.0));
    const auto* line = std::get_if<StraightPath>(&a.sweep->path());
    if (line && std::holds_alternative<StraightPath>(b.sweep->path())) {
        const auto second = path_frame(*b.sweep, b.sweep->at(0.0));
        const Vec3 axis = a.sweep->at(0.0).axis, second_axis = b.sweep->at(0.0).axis;
        return norm(cross(axis, second_axis)) <= tolerance_mm / kPartMm &&
               norm(cross(first.ahead, second.ahead)) <= tolerance_mm / kPartMm &&
               norm(level(second.centre - first.centre, first.ahead)) <= tolerance_mm;
    }
    if (a.sweep->path().index() != b.sweep->path().index()) return false;
    // Both directions of a path are the same.
    const Vec3 start = middle_of(*b.sweep, b.sweep->at(0.0));
    const bool is_back =
        norm(middle_of(*a.sweep, a.sweep->at(1.0)) - start) < norm(first.centre - start);
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const ToolFrame p = a.sweep->at(t), q = b.sweep->at(is_back ? 1.0 - t : t);
        if (norm(middle_of(*a.sweep, p) - middle_of(*b.sweep, q)) > tolerance_mm ||
            norm(p.axis - q.axis) > tolerance_mm / kPartMm)
            return false;
    }
    return true;
}

}  // namespace ncsim::brep
