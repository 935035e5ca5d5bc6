// SPDX-License-Identifier: GPL-3.0-or-later
//
// Let D be the distance from the element at the time t and n the gradient of D. The envelope is the
// set where D = 0 and dD/dt = 0. dD/dt = -n V, where V is the velocity of the point as fixed to the
// tool. So normals, the curvature of elements, and two derivatives of the path determine the
// envelope; the spin of the tool about its axis has no effect.
#include "ncsim/brep/envelope.h"

#include "ncsim/trig/angles.h"

#include "geometry/ellipse.h"
#include "geometry/rim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace ncsim::brep {

using cda::cross;
using cda::dot;
using cda::norm;
using cda::normalized;
using trig::kRadiansPerDegree;

namespace {

// Lengths below this are rounding errors, mm.
constexpr double kNoLength = 1e-9;
// Length over which directions count, mm.
constexpr double kPart = 100.0;

Vec3 level(Vec3 v, Vec3 axis) {
    return v - dot(v, axis) * axis;
}

Vec3 middle_of(const Sweep& sweep, const ToolFrame& passage) {
    return passage.tip + lowest_centre(sweep) * passage.axis;
}

// Point in cylindrical coordinates about the tool's axis.
struct Seen {
    Seen(const ToolFrame& at, Vec3 p) {
        const Vec3 v = p - at.tip;
        height = dot(v, at.axis);
        const Vec3 away = v - height * at.axis;
        radius = norm(away);
        out = radius > 0.0 ? (1.0 / radius) * away : Vec3{};
    }
    double height, radius;
    Vec3 out;  // Unit; zero on the axis.
};

// Returns the distance along the profile from the lower end, mm.
double place_along(const Flank& flank, const Seen& seen) {
    return (seen.height - flank.height) * flank.cosine - (seen.radius - flank.radius) * flank.sine;
}

// Contact of a flank with its envelope, at a place along the profile. `way` is the velocity of the
// axis point where the normal ends, without the component along the axis; out() returns the
// direction from the axis to the contact on either side. At the contact, the velocity of the point
// as fixed to the tool is perpendicular to the normal.
struct Contact {
    Contact(const Flank& flank, const ToolFrame& at, double along)
        : way(level(velocity_at(at, height_of_centre(flank, along)), at.axis)),
          right(cross(normalized(way), at.axis)),
          lean(-flank.sine * dot(at.speed, at.axis) / (flank.cosine * norm(way))) {}
    Vec3 out(bool is_right, Vec3 axis) const {
        const double ahead = std::clamp(lean, -1.0, 1.0), across = std::sqrt(1.0 - ahead * ahead);
        return ahead * cross(axis, right) + (is_right ? across : -across) * right;
    }
    Vec3 way, right;
    double lean;  // Cosine between the outward direction and the direction of motion.
};

// Returns the nearest aspect on a straight path. Seen along the path, the circle of the fillet's
// centres is an ellipse; the envelope is offset from this ellipse by the radius.
ClosestPoint nearest_on(const Sweep& sweep, const StraightWay& way, Vec3 p) {
    const Fillet& fillet = *sweep.fillet();
    const double length = norm(way.along), lean = dot(way.along, way.axis);
    const Vec3 ahead = ((lean < 0.0 ? -1.0 : 1.0) / length) * way.along;
    const Vec3 x = normalized(cross(way.axis, ahead)), y = cross(ahead, x);
    const Vec3 start = way.from + fillet.height * way.axis, v = p - start;
    const EllipseFoot foot =
        foot_on_ellipse(fillet.ring, fillet.ring * std::abs(lean) / length, dot(v, x), dot(v, y));
    const Vec3 normal = foot.x * x + foot.y * y;
    const Vec3 centre =
        v - foot.distance * normal - fillet.ring * normalized(level(normal, way.axis));
    ClosestPoint aspect = aspect_at(sweep, dot(centre, way.along) / (length * length), p);
    aspect.off = foot.distance - fillet.radius;
    aspect.normal = normal;
    aspect.foot = p - aspect.off * normal;
    return aspect;
}

// Local minima of the distance among the samples, the nearest few: the distance at the sample, and
// the estimated time of the minimum.
struct Nearest {
    static constexpr std::size_t kMost = 4;
    std::array<double, kMost> time{}, off{};
    std::size_t count = 0;
    double least = std::numeric_limits<double>::infinity();
    void take(double when, double how_far) {
        least = std::min(least, how_far);
        if (count < kMost) {
            time[count] = when;
            off[count++] = how_far;
            return;
        }
        double& farthest = *std::ranges::max_element(off);
        if (how_far >= farthest) return;
        time[static_cast<std::size_t>(&farthest - off.data())] = when;
        farthest = how_far;
    }
};

Nearest nearest_samples(const Sweep& sweep, Vec3 p) {
    const auto& samples = sweep.samples();
    const Fillet* fillet = sweep.fillet();
    // Fillets: the squared distance.
    const auto off = [&](const ToolFrame& at) {
        const Vec3 v = p - at.tip;
        const double height = dot(v, at.axis);
        const double radius = std::sqrt(std::max(0.0, dot(v, v) - height * height));
        if (!fillet) {
            const Flank& flank = *sweep.flank();
            return flank.cosine * (radius - flank.radius) + flank.sine * (height - flank.height);
        }
        const double beyond = radius - fillet->ring, above = height - fillet->height;
        return beyond * beyond + above * above;
    };
    Nearest nearest;
    if (sweep.is_rim()) {
        for (const double when : starts_on_rim(sweep, p))
            nearest.take(when, std::sqrt(off(sweep.at(when))));
        return nearest;
    }
    constexpr double kAny = std::numeric_limits<double>::infinity();
    const double step = 1.0 / static_cast<double>(samples.size() - 1);
    double before = kAny, here = off(samples.front());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double after = i + 1 < samples.size() ? off(samples[i + 1]) : kAny;
        if (here <= before && here < after) {
            // Minimum of the parabola through three samples.
            const bool is_between = before < kAny && after < kAny;
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

// Moves the aspect to a time so close that the tool's motion is linear in between.
// Requires: no rim, because `rate` has a different meaning for rims.
void advance(ClosestPoint& aspect, double by, Vec3 p) {
    ToolFrame& at = aspect.passage;
    at.tip = at.tip + by * at.speed;
    at.speed = at.speed + by * at.change;
    at.axis = at.axis + by * at.turn;
    at.turn = at.turn + by * at.bend;
    aspect.t += by;
    aspect.off += by * (aspect.rate + 0.5 * by * aspect.bend);
    aspect.rate += by * aspect.bend;
    aspect.normal = aspect.normal + by * aspect.drift;
    aspect.foot = p - aspect.off * aspect.normal;
}

// Newton's method, or a step downhill where Newton's method would go uphill. Known times before and
// after the nearest time bound the steps. Near the edge of a fold of the envelope, there may be no
// nearest time; the result is then the aspect at `when`.
ClosestPoint nearest_from(const Sweep& sweep, double when, Vec3 p) {
    constexpr int kMostSteps = 40;
    constexpr double kNoTime = 1e-14, kAnyTime = std::numeric_limits<double>::infinity();
    // Changes with the square of a step this short are rounding errors, on paths with at most a few
    // turns.
    constexpr double kShort = 1e-7;
    const double longest = 1.0 / static_cast<double>(sweep.samples().size() - 1);
    double before = -kAnyTime, after = kAnyTime;
    ClosestPoint aspect = aspect_at(sweep, when, p);
    bool is_found = false;
    for (int i = 0; i < kMostSteps && !is_found; ++i) {
        const double t = aspect.t;
        (aspect.rate > 0.0 ? after : before) = t;
        const double downhill = aspect.rate > 0.0 ? -longest : longest;
        const double step = aspect.bend > 0.0 ? -aspect.rate / aspect.bend : downhill;
        double next = t + std::clamp(step, -longest, longest);
        if (!(std::abs(next - t) > kNoTime)) return aspect;
        const bool is_between = next > before && next < after;
        if (!is_between && before > -kAnyTime && after < kAnyTime) next = 0.5 * (before + after);
        is_found = is_between && !sweep.is_rim() && std::abs(step) < kShort;
        if (is_found) {
            advance(aspect, step, p);
        } else {
            aspect = aspect_at(sweep, next, p);
        }
    }
    if (!is_found) aspect = aspect_at(sweep, when, p);
    return aspect;
}

// Profile in the half plane of a point: distance, normal (outwards and along the axis), and angle
// of the normal per mm along the profile.
struct Shape {
    double off = 0.0, cosine = 0.0, sine = 0.0, bend = 0.0;
    bool is_known = true;
};

Shape shape_at(const Fillet& fillet, const Seen& seen) {
    const double beyond = seen.radius - fillet.ring, above = seen.height - fillet.height;
    const double far = std::sqrt(beyond * beyond + above * above);
    if (!(far > 0.0)) return {.is_known = false};
    return {far - fillet.radius, beyond / far, above / far, 1.0 / far};
}

Shape shape_at(const Flank& flank, const Seen& seen) {
    const double off =
        flank.cosine * (seen.radius - flank.radius) + flank.sine * (seen.height - flank.height);
    return {off, flank.cosine, flank.sine, 0.0};
}

}  // namespace

ClosestPoint aspect_at(const Sweep& sweep, double t, Vec3 p) {
    ClosestPoint aspect = aspect_at(sweep, sweep.at(t), p);
    aspect.t = t;
    return aspect;
}

ClosestPoint aspect_at(const Sweep& sweep, const ToolFrame& at, Vec3 p) {
    if (sweep.is_rim()) return aspect_of_rim(*sweep.fillet(), at, p);
    ClosestPoint aspect;
    aspect.passage = at;
    const Seen seen(at, p);
    const Shape shape =
        std::visit([&](const auto& which) { return shape_at(which, seen); }, sweep.meridian());
    if (!shape.is_known) return aspect;
    const Vec3 n = shape.cosine * seen.out + shape.sine * at.axis;
    aspect.off = shape.off;
    aspect.normal = n;
    aspect.foot = p - aspect.off * n;
    // The tool rotates with the angular velocity a x a', which maps a vector v to (a v) a' - (a' v)
    // a.
    const Vec3 v = p - at.tip;
    const Vec3 speed = at.speed + seen.height * at.turn - dot(at.turn, v) * at.axis;
    const Vec3 change = at.change + seen.height * at.bend - dot(at.axis, at.speed) * at.turn +
                        (dot(at.turn, at.speed) - dot(at.bend, v)) * at.axis;
    aspect.rate = -dot(n, speed);
    // Change of the normal with the point, along the profile and around the axis.
    const double around = seen.radius > 0.0 ? shape.cosine / seen.radius : 0.0;
    const Vec3 along = shape.cosine * at.axis - shape.sine * seen.out;
    const Vec3 level_speed = speed + aspect.rate * n;
    aspect.drift = shape.sine * at.turn - dot(at.turn, n) * at.axis - around * level_speed -
                   ((shape.bend - around) * dot(speed, along)) * along;
    aspect.bend = -dot(aspect.drift, speed) - dot(n, change);
    return aspect;
}

ClosestPoint place_on(const Envelope& envelope, Vec3 p) {
    const Sweep& sweep = *envelope.sweep;
    if (const auto* straight = std::get_if<StraightWay>(&sweep.way()))
        return nearest_on(sweep, *straight, p);
    // If the path returns, a different time may be as near at a sample and nearer between samples,
    // by at most half a step of the path. Times beyond the ends count less with increasing
    // distance.
    constexpr double kBeyondEnd = 0.25;
    const Nearest nearest = nearest_samples(sweep, p);
    const double half = 0.5 * sweep.length_mm() / static_cast<double>(sweep.samples().size() - 1);
    // The surface swept by a rim may be near on both sides.
    const bool is_of_rim = sweep.is_rim();
    const auto far = [&](const ClosestPoint& aspect) {
        return is_of_rim ? std::abs(aspect.off) : aspect.off;
    };
    std::optional<ClosestPoint> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < nearest.count; ++k) {
        if (nearest.off[k] > nearest.least + half) continue;
        const ClosestPoint aspect = nearest_from(sweep, nearest.time[k], p);
        double off = far(aspect);
        if (const double end = std::clamp(aspect.t, 0.0, 1.0);
            nearest.count > 1 && aspect.t != end) {
            const double beyond = std::abs(aspect.t - end) * sweep.length_mm();
            off = far(aspect_at(sweep, end, p)) + kBeyondEnd * beyond;
        }
        if (off >= least) continue;
        least = off;
        best = aspect;
    }
    return *best;
}

ClosestPoint place_on(const Envelope& envelope, Vec3 p, double near_time) {
    const Sweep& sweep = *envelope.sweep;
    // A torus passes a point twice, in quick succession where the torus is nearly level.
    const bool is_of_ring = sweep.fillet() && !sweep.is_ball();
    if (is_of_ring || std::holds_alternative<StraightWay>(sweep.way()))
        return place_on(envelope, p);
    return nearest_from(sweep, near_time, p);
}

ClosestPoint place_on(const Envelope& envelope, Vec3 p, ProjectionSeed& beside) {
    constexpr double kFarthest = 0.1;  // Faster changes are not extrapolated.
    const double later = std::clamp(dot(beside.slope, p - beside.at), -kFarthest, kFarthest);
    const ClosestPoint aspect =
        beside.time ? place_on(envelope, p, *beside.time + later) : place_on(envelope, p);
    beside = {aspect.t, p, gradient_of_time(aspect)};
    return aspect;
}

Vec3 gradient_of_rise(const Sweep& sweep, const ClosestPoint& aspect) {
    const ToolFrame& at = aspect.passage;
    const Vec3 n = aspect.normal;
    const Fillet* fillet = sweep.fillet();
    if (!fillet) return {};
    if (sweep.is_rim()) return gradient_of_rise_of_rim(*fillet, aspect);
    const double rise = dot(n, at.axis), far = aspect.off + fillet->radius;
    const Vec3 along = at.axis - rise * n;
    const double with_time = dot(aspect.drift, at.axis) + dot(n, at.turn);
    return (1.0 / far) * along + with_time * gradient_of_time(aspect);
}

double height_of_centre(const Sweep& sweep, const ClosestPoint& aspect) {
    const Flank* flank = sweep.flank();
    if (!flank) return sweep.fillet()->height;
    return height_of_centre(*flank, place_along(*flank, Seen(aspect.passage, aspect.foot)));
}

namespace {

// Returns the angle around the path, from `up` to `side`, in [0, 360).
double degrees_around(const Around& at, Vec3 p) {
    const Vec3 v = p - at.centre;
    const double degrees = trig::angle_of(dot(v, at.up), dot(v, at.side));
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
Vec3 normal_across(const Fillet& fillet, const ToolFrame& passage, const Around& at, Vec3 across) {
    const double speed = norm(velocity_at(passage, fillet.height));
    const double most = fillet.ring * norm(passage.turn) / speed;
    if (!(most > 0.0 && most < 1.0)) return across;
    const auto normal = [&](double ahead) {
        return std::sqrt(1.0 - ahead * ahead) * across + ahead * at.ahead;
    };
    const auto off = [&](double ahead) {
        const Vec3 n = normal(ahead), out = normalized(level(n, passage.axis));
        return ahead - fillet.ring * dot(n, passage.axis) * dot(out, passage.turn) / speed;
    };
    constexpr int kMostSecants = 60;
    constexpr double kNoSine = 1e-16;
    double low = -most, high = most, below = off(low), above = off(high);
    double ahead = 0.0, value = off(ahead);
    for (int i = 0; i < kMostSecants && std::abs(value) > kNoSine; ++i) {
        const bool is_low = value < 0.0;
        (is_low ? low : high) = ahead;
        (is_low ? below : above) = value;
        ahead = low - below * (high - low) / (above - below);
        value = off(ahead);
        // The retained end counts half.
        if ((value < 0.0) == is_low) (is_low ? above : below) *= 0.5;
    }
    return normal(ahead);
}

// Returns the point of a fillet at `degrees` around the path. The angle of the point grows with the
// angle of the point's normal; both angles are on the same side of `up` and down.
Vec3 point_around(const Sweep& sweep, const ToolFrame& passage, double degrees) {
    constexpr double kHalf = 180.0;
    if (sweep.is_ball() || degrees == kHalf) return point_with_normal(sweep, passage, degrees);
    const Around at = around(sweep, passage);
    double low = degrees < kHalf ? 0.0 : kHalf, high = low + kHalf;
    constexpr int kMostSecants = 60;
    constexpr double kNoAngle = 1e-14;
    // Secants (Illinois), and bisection where secants are slow.
    const auto off = [&](double normal) {
        return degrees_around(at, point_with_normal(sweep, passage, normal)) - degrees;
    };
    double below = (low == 0.0 ? 0.0 : kHalf) - degrees, above = below + kHalf;
    double normal = degrees;
    for (int i = 0; i < kMostSecants && high - low > kNoAngle * kHalf; ++i) {
        normal = i % 3 == 2 ? 0.5 * (low + high) : low - below * (high - low) / (above - below);
        if (!(normal > low && normal < high)) normal = 0.5 * (low + high);
        const double value = off(normal);
        if (value == 0.0) break;
        (value < 0.0 ? low : high) = normal;
        (value < 0.0 ? below : above) = value;
    }
    return point_with_normal(sweep, passage, normal);
}

}  // namespace

Vec3 point_with_normal(const Sweep& sweep, const ToolFrame& passage, double degrees) {
    const Around at = around(sweep, passage);
    const auto angle = trig::sin_cos(degrees);
    const Fillet& fillet = *sweep.fillet();
    const Vec3 n = normal_across(fillet, passage, at, angle.cos * at.up + angle.sin * at.side);
    const Vec3 ring = fillet.ring > 0.0 ? fillet.ring * normalized(level(n, passage.axis)) : Vec3{};
    return at.centre + ring + fillet.radius * n;
}

double place_across(const Sweep& sweep, const ToolFrame& passage, Vec3 p) {
    const Flank* flank = sweep.flank();
    if (sweep.is_rim()) return place_on_rim(sweep, passage, p);
    if (!flank) return degrees_around(around(sweep, passage), p);
    const double along = place_along(*flank, Seen(passage, p));
    const bool is_right = dot(p - passage.tip, Contact(*flank, passage, along).right) > 0.0;
    return is_right ? -(flank->length + along) : flank->length + along;
}

Vec3 point_across(const Sweep& sweep, const ToolFrame& passage, double place) {
    const Flank* flank = sweep.flank();
    if (sweep.is_rim()) return point_on_rim(sweep, passage, place);
    if (!flank) return point_around(sweep, passage, place);
    const double along = std::abs(place) - flank->length;
    const Vec3 out = Contact(*flank, passage, along).out(place < 0.0, passage.axis);
    return passage.tip + (flank->radius - along * flank->sine) * out +
           (flank->height + along * flank->cosine) * passage.axis;
}

bool has_across(const Sweep& sweep) {
    constexpr double kSteepest = 0.999, kFlattest = 1e-3;
    if (const Flank* flank = sweep.flank()) {
        const auto touches = [&](const ToolFrame& at, double along) {
            const Contact contact(*flank, at, along);
            return norm(contact.way) > kNoLength && std::abs(contact.lean) < kSteepest;
        };
        return std::ranges::all_of(sweep.samples(), [&](const ToolFrame& at) {
            return touches(at, 0.0) || touches(at, flank->length);
        });
    }
    // The flat end of a tool that turns must not be level anywhere: the parts of the end ahead of
    // and behind the level line would touch the envelope in two curves.
    constexpr double kClear = 1.1;
    const double ring = sweep.fillet()->ring;
    bool rises = false, falls = false;
    const bool is_usual = std::ranges::all_of(sweep.samples(), [&](const ToolFrame& at) {
        const Vec3 way = velocity_at(at, lowest_centre(sweep));
        const double lean = dot(way, at.axis), length = norm(way);
        const double least = std::max(kFlattest * length, kClear * ring * norm(at.turn));
        rises = rises || lean > -least;
        falls = falls || lean < least;
        return length > kNoLength && std::abs(lean) < kSteepest * length;
    });
    return is_usual && (sweep.is_ball() || !rises || !falls);
}

bool is_at_pivot(const Sweep& sweep, const ClosestPoint& aspect) {
    const Flank* flank = sweep.flank();
    if (!flank) return false;
    const ToolFrame& at = aspect.passage;
    const Seen seen(at, aspect.foot);
    const Contact contact(*flank, at, place_along(*flank, seen));
    constexpr double kSteepest = 0.999;
    return norm(contact.way) < seen.radius * norm(at.turn) + kNoLength ||
           std::abs(contact.lean) > kSteepest;
}

double largest_radius(const Sweep& sweep) {
    const Fillet* fillet = sweep.fillet();
    const double own = fillet ? fillet->ring + fillet->radius : sweep.flank()->radius;
    if (const auto* round = std::get_if<RoundWay>(&sweep.way())) return round->reach + own;
    if (!fillet || std::holds_alternative<RotaryPath>(sweep.way())) return sweep.length_mm() + own;
    const ToolFrame start = sweep.at(0.0);
    const double lean = std::abs(dot(start.axis, normalized(start.speed)));
    return fillet->ring / lean + fillet->radius;
}

bool is_same(const Meridian& a, const Meridian& b, double tolerance_mm) {
    const auto near = [&](double u, double v) { return std::abs(u - v) <= tolerance_mm; };
    if (a.index() != b.index()) return false;
    if (const auto* fillet = std::get_if<Fillet>(&a)) {
        const auto& other = std::get<Fillet>(b);
        return near(fillet->ring, other.ring) && near(fillet->radius, other.radius);
    }
    const auto &flank = std::get<Flank>(a), &other = std::get<Flank>(b);
    const double off =
        flank.cosine * (other.radius - flank.radius) + flank.sine * (other.height - flank.height);
    return near(off, 0.0) && near(kPart * (flank.cosine - other.cosine), 0.0) &&
           near(kPart * (flank.sine - other.sine), 0.0);
}

bool is_same(const Envelope& a, const Envelope& b, double tolerance_mm) {
    if (!is_same(a.sweep->meridian(), b.sweep->meridian(), tolerance_mm)) return false;
    const auto first = around(*a.sweep, a.sweep->at(0.0));
    const auto* line = std::get_if<StraightWay>(&a.sweep->way());
    if (line && std::holds_alternative<StraightWay>(b.sweep->way())) {
        const auto second = around(*b.sweep, b.sweep->at(0.0));
        const Vec3 axis = a.sweep->at(0.0).axis, second_axis = b.sweep->at(0.0).axis;
        return norm(cross(axis, second_axis)) <= tolerance_mm / kPart &&
               norm(cross(first.ahead, second.ahead)) <= tolerance_mm / kPart &&
               norm(level(second.centre - first.centre, first.ahead)) <= tolerance_mm;
    }
    if (a.sweep->way().index() != b.sweep->way().index()) return false;
    // Both directions of a path are the same.
    const Vec3 start = middle_of(*b.sweep, b.sweep->at(0.0));
    const bool is_back =
        norm(middle_of(*a.sweep, a.sweep->at(1.0)) - start) < norm(first.centre - start);
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const ToolFrame p = a.sweep->at(t), q = b.sweep->at(is_back ? 1.0 - t : t);
        if (norm(middle_of(*a.sweep, p) - middle_of(*b.sweep, q)) > tolerance_mm ||
            norm(p.axis - q.axis) > tolerance_mm / kPart)
            return false;
    }
    return true;
}

}  // namespace ncsim::brep
