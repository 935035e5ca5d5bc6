// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/measure.h"

#include "ncsim/trig/angles.h"

#include "axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace ncsim::brep {

using trig::kRadiansPerDegree;

namespace {

using cda::cross;
using cda::dot;
using cda::norm;

// Gauss-Legendre on (0, 1): exact for polynomials of degree 15.
constexpr std::array<double, 4> kAbscissae{0.1834346424956498, 0.5255324099163290,
                                           0.7966664774136267, 0.9602898564975363};
constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                         0.1012285362903763};

template <typename F>
void integrate(const Track& track, const F& f) {
    const std::size_t pieces = track.pieces();
    for (std::size_t i = 0; i < pieces; ++i) {
        const double begin = track.start_of(i), width = track.start_of(i + 1) - begin;
        const double middle = begin + 0.5 * width;
        for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
            for (const double sign : {-1.0, 1.0}) {
                const double t = middle + sign * 0.5 * width * kAbscissae[k];
                f(0.5 * width * kWeights[k], track.at(t), track.derivative(t));
            }
        }
    }
}

// Integrals over the second parameter from a fixed start to where a point is: of the area, and of
// the volume of the cone from a point -w, in the frame of the surface, three times. What is left
// is an integral along the edges, over the angle around the axis (Green).
struct Below {
    double area = 0.0, volume = 0.0;
};

struct BelowCylinder {
    double radius;
    Vec3 w;
    Below operator()(const Local& p) const {
        const double side = radius + (w.x * p.x + w.y * p.y) / p.away;
        return {radius * p.z, radius * side * p.z};
    }
};

struct BelowCone {
    double slope;
    Vec3 w;
    Below operator()(const Local& p) const {
        const double half = 0.5 * p.z * p.z * slope;
        if (p.away <= 0.0) return {};
        return {half * std::sqrt(1.0 + slope * slope),
                half * ((w.x * p.x + w.y * p.y) / p.away - w.z * slope)};
    }
};

struct BelowSphere {
    double radius;
    Vec3 w;
    double pole;  // 1 or -1: from where on
    Below operator()(const Local& p) const {
        if (p.away <= 0.0) return {};
        const double s = p.z / radius, c = p.away / radius;
        const double angle = trig::angle_of(c, s) * kRadiansPerDegree;
        const double side = (w.x * p.x + w.y * p.y) / p.away;
        const double half_pi = pole * 0.5 * std::numbers::pi;
        const double r2 = radius * radius;
        return {r2 * (s - pole),
                r2 * (radius * (s - pole) + side * 0.5 * (angle - half_pi + s * c) +
                      0.5 * w.z * (s * s - 1.0))};
    }
};

struct BelowTorus {
    double major, minor;
    Vec3 w;
    double cut;  // degrees, where the angle around the tube jumps
    Below operator()(const Local& p) const {
        const double out = p.away - major;
        const double length = std::sqrt(out * out + p.z * p.z);
        const double s = p.z / length, c = out / length;
        double degrees = trig::angle_of(out, p.z);
        if (degrees < cut) degrees += 360.0;
        const double f = degrees * kRadiansPerDegree;
        const double a = (w.x * p.x + w.y * p.y) / p.away;
        return {minor * (major * f + minor * s),
                minor * (major * minor * f + major * (major + a) * s - major * w.z * c +
                         minor * minor * s + minor * (major + a) * 0.5 * (f + s * c) +
                         0.5 * minor * w.z * s * s)};
    }
};

// For each angle: how much area there is along a mm of the line, and how much volume.
struct BelowExtrusion {
    double radius;
    Vec3 w, lean;
    Below per_mm(const Local& p) const {
        const Vec3 out{p.x / p.away, p.y / p.away, 0.0};
        const Vec3 normal = cross(Vec3{-radius * out.y, radius * out.x, 0.0}, lean);
        return {norm(normal), dot(w + radius * out, normal)};
    }
    Below operator()(const Local& p) const {
        const Below b = per_mm(p);
        return {b.area * p.z, b.volume * p.z};
    }
};

// The angle around the axis that a step makes, per its parameter.
double turn(const Local& p, Vec3 step) {
    return (p.x * step.y - p.y * step.x) / (p.away * p.away);
}

template <typename B>
Measure around(const Part& part, const Face& face, const Axes& axes, const B& below) {
    Measure sum;
    constexpr double kAtTip = 1e-12;
    double turns = 0.0;
    // Where edges miss their ends, what is below all of a face that does not go round counts for
    // the angles of these gaps: it is left out, from where the first edge starts. Not where edges
    // come near the axis, and may pass half a turn there.
    constexpr double kClearOfAxis = 0.1, kMostGaps = 0.1;  // of the radius; rad
    std::optional<Local> start;
    Below whole;
    double nearest = std::numeric_limits<double>::infinity();
    for_edges(part, face, [&](const Track& track, double sign) {
        const Local begin = axes(track.at(0.0));
        if (!start) start = begin;
        nearest = std::min(nearest, begin.away);
        integrate(track, [&](double weight, Vec3 at, Vec3 derivative) {
            const Local p = axes(at);
            sum.length += weight * norm(derivative);
            nearest = std::min(nearest, p.away);
            if (p.away <= kAtTip) return;
            const double turned = sign * weight * turn(p, axes.turned(derivative));
            const Below b = below(p);
            turns += turned;
            sum.area -= turned * b.area;
            sum.volume -= turned * b.volume / 3.0;
            const double scale = start->away / p.away;
            const Below level = below({scale * p.x, scale * p.y, start->z, start->away});
            whole.area -= turned * level.area;
            whole.volume -= turned * level.volume / 3.0;
        });
    });
    // Cones have none, and begin at their apex.
    const double radius = radius_of(face.surface.form);
    if (radius > 0.0 && nearest > kClearOfAxis * radius && std::abs(turns) < kMostGaps) {
        sum.area -= whole.area;
        sum.volume -= whole.volume;
    }
    if (face.surface.is_hollow) sum.area = -sum.area;
    return sum;
}

double turns_about(const Part& part, const Face& face, const Axes& axes) {
    double sum = 0.0;
    for_edges(part, face, [&](const Track& track, double sign) {
        integrate(track, [&](double weight, Vec3 at, Vec3 derivative) {
            const Local p = axes(at);
            if (p.away > 0.0) sum += sign * weight * turn(p, axes.turned(derivative));
        });
    });
    return sum / (2.0 * std::numbers::pi);
}

// --- Domes ----------------------------------------------------------------------------------

// Over the angle of the circle, between edges; over that of the arc, from where it is level with
// its centre, by Gauss.
class OnDome {
public:
    OnDome(const Dome& dome, Vec3 apex) : dome_(dome), w_(dome.centre - apex) {}

    // For each angle of the circle: of area, of three times the volume, and of four times volume
    // times middle, as `moment` tells them.
    struct Sum {
        double area = 0.0, volume = 0.0;
        Vec3 moment;
    };
    Sum below(const DomePlace& place) const {
        constexpr double kPiece = 15.0;
        const double degrees = place.degrees();
        const int pieces = static_cast<int>(std::abs(degrees) / kPiece) + 1;
        const double width = degrees / pieces;
        const Vec3 around = cross(dome_.axis, place.out);
        Sum sum;
        for (int i = 0; i < pieces; ++i) {
            for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
                for (const double sign : {-1.0, 1.0}) {
                    const auto t = trig::sin_cos((i + 0.5 + 0.5 * sign * kAbscissae[k]) * width);
                    const Vec3 up = t.cos * dome_.ahead + t.sin * dome_.axis;
                    const Vec3 along = t.cos * dome_.axis - t.sin * dome_.ahead;
                    const Vec3 at = w_ + dome_.reach * up + dome_.radius * place.out;
                    const Vec3 normal = (0.5 * width * kRadiansPerDegree * kWeights[k] *
                                         dome_.reach * dome_.radius) *
                                        cross(around, along);
                    sum.area += width < 0.0 ? -norm(normal) : norm(normal);
                    sum.volume += dot(at, normal);
                    sum.moment = sum.moment + dot(at, normal) * at;
                }
            }
        }
        return sum;
    }

    // The angle of the circle that a step on the surface makes. None where it is not known, in the
    // corners of the half.
    double turn(const DomePlace& place, Vec3 step) const {
        const Vec3 around = cross(dome_.axis, place.out);
        const Vec3 across_arc = cross(place.along, cross(around, place.along));
        constexpr double kNowhere = 1e-12;
        const double slope = dot(around, across_arc);
        return slope > kNowhere ? dot(step, across_arc) / (dome_.radius * slope) : 0.0;
    }

private:
    Dome dome_;
    Vec3 w_;
};

// Over the angle of the circle against the way, between edges; over that of the way, from where it
// counts, by Gauss.
class OnCoil {
public:
    OnCoil(const Coil& coil, Vec3 apex) : coil_(coil), w_(coil.centre - apex) {}

    // As on a dome.
    using Sum = OnDome::Sum;
    Sum below(const CoilPlace& place) const {
        constexpr double kPiece = 15.0;
        const double degrees = place.turn / kRadiansPerDegree;
        const int pieces = static_cast<int>(std::abs(degrees) / kPiece) + 1;
        const double width = degrees / pieces;
        const Vec3 side = cross(coil_.axis, coil_.ahead), beside = cross(coil_.axis, place.way);
        const double out = dot(place.out, place.way), off = dot(place.out, beside);
        Sum sum;
        for (int i = 0; i < pieces; ++i) {
            for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
                for (const double sign : {-1.0, 1.0}) {
                    const double at_degrees = (i + 0.5 + 0.5 * sign * kAbscissae[k]) * width;
                    const auto t = trig::sin_cos(at_degrees);
                    const Vec3 up = t.cos * coil_.ahead + t.sin * side;
                    const Vec3 way = t.cos * side - t.sin * coil_.ahead;
                    const Vec3 outward = out * way - off * up;
                    const Vec3 at = w_ + coil_.reach * up +
                                    (coil_.lead * at_degrees * kRadiansPerDegree) * coil_.axis +
                                    coil_.radius * outward;
                    const Vec3 normal =
                        (0.5 * width * kRadiansPerDegree * kWeights[k] * coil_.radius) *
                        cross(cross(coil_.axis, outward),
                              coil_.reach * way + coil_.lead * coil_.axis);
                    const bool is_back = (width < 0.0) != (coil_.lead < 0.0);
                    sum.area += is_back ? -norm(normal) : norm(normal);
                    sum.volume += dot(at, normal);
                    sum.moment = sum.moment + dot(at, normal) * at;
                }
            }
        }
        return sum;
    }

    // The angle of the circle against the way that a step on the surface makes.
    double turn(const CoilPlace& place, Vec3 step) const {
        const Vec3 around = cross(coil_.axis, place.out);
        const double along = dot(step, coil_.axis) / coil_.lead;
        return dot(step - (along * coil_.reach) * place.way, around) / coil_.radius - along;
    }

private:
    Coil coil_;
    Vec3 w_;
};

// Over the angle of the way, between edges; over the height, from that of the centre.
class OnSpiral {
public:
    OnSpiral(const Spiral& spiral, Vec3 apex) : spiral_(spiral), w_(spiral.centre - apex) {}

    // As on a dome.
    using Sum = OnDome::Sum;
    Sum below(const SpiralPlace& place) const {
        const Vec3 start = w_ + (place.way - spiral_.centre) + spiral_.offset * place.out;
        const double area = place.speed * place.height;
        const double volume = area * dot(start, place.out);
        return {area, volume, volume * (start + (0.5 * place.height) * spiral_.axis)};
    }

    // The angle that a step on the surface makes.
    static double turn(const SpiralPlace& place, Vec3 step) {
        return dot(step, place.along) / place.speed;
    }

private:
    Spiral spiral_;
    Vec3 w_;
};

// Over the time, between edges; around the way, from below the tool, by the angle of the normal,
// which may turn fast where a ring goes nearly level: in pieces as small as it takes.
class OnEnvelope {
public:
    OnEnvelope(const Envelope& envelope, Vec3 apex) : sweep_(*envelope.sweep), apex_(apex) {}

    // As on a dome.
    using Sum = OnDome::Sum;
    Sum below(const Aspect& place) const {
        constexpr double kBelow = 180.0;
        constexpr int kDepth = 16;
        const Around at = brep::around(sweep_, place.passage);
        const double degrees = degrees_around(at, at.centre + place.normal);
        const auto whole = piece(place, at, kBelow, degrees);
        return in_pieces(place, at, kBelow, degrees, whole, kDepth);
    }

    // How much time a step on the surface takes, backwards.
    static double turn(const Aspect& place, Vec3 step) {
        return place.bend != 0.0 ? dot(place.drift, step) / place.bend : 0.0;
    }

private:
    static Sum plus(const Sum& a, const Sum& b) {
        return {a.area + b.area, a.volume + b.volume, a.moment + b.moment};
    }

    Sum in_pieces(const Aspect& place, const Around& at, double from, double to, const Sum& whole,
                  int depth) const {
        constexpr double kSame = 1e-11;
        const double middle = 0.5 * (from + to);
        const Sum first = piece(place, at, from, middle), second = piece(place, at, middle, to);
        const Sum sum = plus(first, second);
        if (depth == 0 || std::abs(sum.area - whole.area) <= kSame * std::abs(sum.area)) return sum;
        return plus(in_pieces(place, at, from, middle, first, depth - 1),
                    in_pieces(place, at, middle, to, second, depth - 1));
    }

    Sum piece(const Aspect& place, const Around& at, double from, double to) const {
        const double ring = sweep_.fillet().ring, radius = sweep_.fillet().radius;
        const double width = to - from;
        Sum sum;
        for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
            for (const double sign : {-1.0, 1.0}) {
                const auto angle = trig::sin_cos(from + 0.5 * (1.0 + sign * kAbscissae[k]) * width);
                const Vec3 n = angle.cos * at.up + angle.sin * at.side;
                const Vec3 on = angle.cos * at.side - angle.sin * at.up;
                Vec3 pace = radius * on;  // of the point, for each radian
                Vec3 p = at.centre + radius * n;
                if (ring > 0.0) {
                    const Vec3 axis = place.passage.axis;
                    const Vec3 level = n - dot(n, axis) * axis;
                    const double length = norm(level);
                    const Vec3 round = (1.0 / length) * cross(axis, level);
                    pace = pace + (ring * dot(on, round) / length) * round;
                    p = p + (ring / length) * level;
                }
                const Aspect there = aspect_at(sweep_, place.passage, p);
                const double ahead = there.bend / norm(there.drift);
                const double area =
                    0.5 * width * kRadiansPerDegree * kWeights[k] * norm(pace) * ahead;
                const Vec3 w = p - apex_;
                const double volume = area * dot(w, n);
                sum = plus(sum, {area, volume, volume * w});
            }
        }
        return sum;
    }

    const Sweep& sweep_;
    Vec3 apex_;
};

template <typename Form, typename On, typename Take>
void for_moved(const Part& part, const Face& face, const Form& form, const On& on,
               const Take& take) {
    for_edges(part, face, [&](const Track& track, double sign) {
        integrate(track, [&](double weight, Vec3 at, Vec3 derivative) {
            const auto place = place_on(form, at);
            take(weight * norm(derivative), sign * weight * on.turn(place, derivative), place);
        });
    });
}

template <typename Form, typename On>
Measure measure_moved(const Part& part, const Face& face, const Form& form, const On& on) {
    Measure sum;
    for_moved(part, face, form, on, [&](double length, double turned, const auto& place) {
        const auto b = on.below(place);
        sum.length += length;
        sum.area -= turned * b.area;
        sum.volume -= turned * b.volume / 3.0;
    });
    if (face.surface.is_hollow) sum.area = -sum.area;
    return sum;
}

template <typename Form, typename On>
Vec3 moment_of_moved(const Part& part, const Face& face, const Form& form, const On& on) {
    Vec3 sum;
    for_moved(part, face, form, on, [&](double, double turned, const auto& place) {
        sum = sum - turned * on.below(place).moment;
    });
    return sum;
}

Measure measure_plane(const Part& part, const Face& face, const Plane& plane, Vec3 apex) {
    Measure sum;
    Vec3 twice;
    for_edges(part, face, [&](const Track& track, double sign) {
        integrate(track, [&](double weight, Vec3 at, Vec3 derivative) {
            sum.length += weight * norm(derivative);
            twice = twice + (sign * weight) * cross(at - plane.origin, derivative);
        });
    });
    sum.area = 0.5 * dot(twice, plane.normal);
    sum.volume = sum.area * dot(plane.origin - apex, plane.normal) / 3.0;
    return sum;
}

// --- Middles --------------------------------------------------------------------------------

// The integral of w (w n) over a face, w from `apex`, n the form's normal: four times what the cone
// over it has of volume times middle. Over the second parameter by Gauss, which is exact for
// cylinders and cones.
struct Profile {
    double radius, height;  // of the point
    double out, up;         // of the normal
    double per;             // area for each radian and unit of the parameter
};

template <typename At>
Vec3 across_face(const Axes& axes, Vec3 apex, const Local& p, double from, double to, int pieces,
                 const At& at) {
    Vec3 sum;
    const Vec3 away = (1.0 / p.away) * (p.x * axes.x + p.y * axes.y);
    const double width = (to - from) / pieces;
    for (int i = 0; i < pieces; ++i) {
        const double middle = from + (i + 0.5) * width;
        for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
            for (const double sign : {-1.0, 1.0}) {
                const Profile f = at(middle + sign * 0.5 * width * kAbscissae[k]);
                const Vec3 w = axes.origin - apex + f.radius * away + f.height * axes.z;
                const Vec3 n = f.out * away + f.up * axes.z;
                sum = sum + (0.5 * width * kWeights[k] * f.per * dot(w, n)) * w;
            }
        }
    }
    return sum;
}

template <typename Inner>
Vec3 around_axis(const Part& part, const Face& face, const Axes& axes, const Inner& inner) {
    Vec3 sum;
    constexpr double kAtTip = 1e-12;
    for_edges(part, face, [&](const Track& track, double sign) {
        integrate(track, [&](double weight, Vec3 at, Vec3 derivative) {
            const Local p = axes(at);
            if (p.away <= kAtTip) return;
            sum = sum - (sign * weight * turn(p, axes.turned(derivative))) * inner(p);
        });
    });
    return sum;
}

Vec3 moment(const Part& part, const Face& face, Vec3 apex) {
    constexpr double kHalfTurn = 180.0;
    if (const auto* f = std::get_if<Plane>(&face.surface.form)) {
        Vec3 sum;  // of w, over the face
        for_edges(part, face, [&](const Track& track, double sign) {
            integrate(track, [&](double weight, Vec3 at, Vec3 derivative) {
                const Vec3 v = at - f->origin;
                const double twice = sign * weight * dot(cross(v, derivative), f->normal);
                sum = sum + twice * (0.5 * (f->origin - apex) + (1.0 / 3.0) * v);
            });
        });
        return (0.25 * dot(f->origin - apex, f->normal)) * sum;
    }
    const auto quarter = [](Vec3 v) { return 0.25 * v; };
    if (const auto* f = std::get_if<Cylinder>(&face.surface.form)) {
        const Axes axes(f->origin, face.frame);
        return quarter(around_axis(part, face, axes, [&](const Local& p) {
            return across_face(axes, apex, p, 0.0, p.z, 1, [&](double h) {
                return Profile{f->radius, h, 1.0, 0.0, f->radius};
            });
        }));
    }
    if (const auto* f = std::get_if<Cone>(&face.surface.form)) {
        const Axes axes(f->apex, face.frame);
        const double slant = std::sqrt(1.0 + f->slope * f->slope);
        return quarter(around_axis(part, face, axes, [&](const Local& p) {
            return across_face(axes, apex, p, 0.0, p.z, 1, [&](double h) {
                return Profile{f->slope * h, h, 1.0 / slant, -f->slope / slant,
                               f->slope * h * slant};
            });
        }));
    }
    const auto round = [](double major, double minor, double degrees) {
        const auto t = trig::sin_cos(degrees);
        const double radius = major + minor * t.cos;
        return Profile{radius, minor * t.sin, t.cos, t.sin, minor * radius * kRadiansPerDegree};
    };
    if (const auto* f = std::get_if<Sphere>(&face.surface.form)) {
        const Axes axes(f->centre, face.frame);
        const double turns = turns_about(part, face, axes);
        const double pole = (turns < -0.5) != face.surface.is_hollow ? -1.0 : 1.0;
        return quarter(around_axis(part, face, axes, [&](const Local& p) {
            const double to = trig::angle_of(p.away, p.z);
            return across_face(axes, apex, p, 0.5 * pole * kHalfTurn, to, 4,
                               [&](double angle) { return round(0.0, f->radius, angle); });
        }));
    }
    if (const auto* f = std::get_if<Extrusion>(&face.surface.form)) {
        const Axes axes(*f, face.frame);
        const BelowExtrusion below{f->radius, axes.upright(f->centre - apex), axes.lean};
        return quarter(around_axis(part, face, axes, [&](const Local& p) {
            const Vec3 start =
                f->centre - apex + (f->radius / p.away) * (p.x * axes.x + p.y * axes.y);
            return (below.per_mm(p).volume * p.z) * (start + (0.5 * p.z) * f->along);
        }));
    }
    if (const auto* f = std::get_if<Dome>(&face.surface.form))
        return quarter(moment_of_moved(part, face, *f, OnDome(*f, apex)));
    if (const auto* f = std::get_if<Coil>(&face.surface.form))
        return quarter(moment_of_moved(part, face, *f, OnCoil(*f, apex)));
    if (const auto* f = std::get_if<Spiral>(&face.surface.form))
        return quarter(moment_of_moved(part, face, *f, OnSpiral(*f, apex)));
    if (const auto* f = std::get_if<Envelope>(&face.surface.form))
        return quarter(moment_of_moved(part, face, *f, OnEnvelope(*f, apex)));
    const auto& f = std::get<Torus>(face.surface.form);
    const Axes axes(f.centre, face.frame);
    const double cut = cut_of(part, face, axes, f.major);
    return quarter(around_axis(part, face, axes, [&](const Local& p) {
        double to = trig::angle_of(p.away - f.major, p.z);
        if (to < cut) to += 2.0 * kHalfTurn;
        return across_face(axes, apex, p, cut, to, 6,
                           [&](double angle) { return round(f.major, f.minor, angle); });
    }));
}

// What a body adds up to about a point of it.
struct Sums {
    double volume = 0.0, area = 0.0;
    Vec3 moment;
};

Sums sums_of(const Part& part, const Solid& solid, Vec3 apex) {
    Sums sums;
    const auto add = [&](const Shell& shell) {
        for (const std::uint32_t f : shell) {
            const Face& face = part.faces[f];
            const Measure measured = measure(part, face, apex);
            sums.volume += measured.volume;
            sums.area += measured.area;
            sums.moment = sums.moment + moment(part, face, apex);
        }
    };
    add(solid.outside);
    for (const Shell& shell : solid.voids)
        add(shell);
    return sums;
}

Vec3 corner_of(const Part& part, const Solid& solid) {
    const Loop& loop = part.faces[solid.outside.front()].loops.front();
    return part.vertices[part.edges[loop.front().edge].from];
}

Mass mass(const Sums& sums, Vec3 apex) {
    if (sums.volume <= 0.0) return {sums.volume, sums.area, {}};
    return {sums.volume, sums.area, apex + (1.0 / sums.volume) * sums.moment};
}

}  // namespace

Measure measure(const Part& part, const Face& face, Vec3 apex) {
    if (const auto* f = std::get_if<Plane>(&face.surface.form))
        return measure_plane(part, face, *f, apex);
    if (const auto* f = std::get_if<Cylinder>(&face.surface.form)) {
        const Axes axes(f->origin, face.frame);
        return around(part, face, axes, BelowCylinder{f->radius, axes.turned(f->origin - apex)});
    }
    if (const auto* f = std::get_if<Cone>(&face.surface.form)) {
        const Axes axes(f->apex, face.frame);
        return around(part, face, axes, BelowCone{f->slope, axes.turned(f->apex - apex)});
    }
    if (const auto* f = std::get_if<Sphere>(&face.surface.form)) {
        const Axes axes(f->centre, face.frame);
        const double turns = turns_about(part, face, axes);
        const double pole = (turns < -0.5) != face.surface.is_hollow ? -1.0 : 1.0;
        return around(part, face, axes,
                      BelowSphere{f->radius, axes.turned(f->centre - apex), pole});
    }
    if (const auto* f = std::get_if<Extrusion>(&face.surface.form)) {
        const Axes axes(*f, face.frame);
        return around(part, face, axes,
                      BelowExtrusion{f->radius, axes.upright(f->centre - apex), axes.lean});
    }
    if (const auto* f = std::get_if<Dome>(&face.surface.form))
        return measure_moved(part, face, *f, OnDome(*f, apex));
    if (const auto* f = std::get_if<Coil>(&face.surface.form))
        return measure_moved(part, face, *f, OnCoil(*f, apex));
    if (const auto* f = std::get_if<Spiral>(&face.surface.form))
        return measure_moved(part, face, *f, OnSpiral(*f, apex));
    if (const auto* f = std::get_if<Envelope>(&face.surface.form))
        return measure_moved(part, face, *f, OnEnvelope(*f, apex));
    const auto& f = std::get<Torus>(face.surface.form);
    const Axes axes(f.centre, face.frame);
    return around(part, face, axes,
                  BelowTorus{f.major, f.minor, axes.turned(f.centre - apex),
                             cut_of(part, face, axes, f.major)});
}

double volume(const Part& part) {
    double sum = 0.0;
    const auto add = [&](const Shell& shell) {
        if (shell.empty()) return;
        const Loop& loop = part.faces[shell.front()].loops.front();
        const Vec3 apex = part.vertices[part.edges[loop.front().edge].from];
        for (const std::uint32_t f : shell)
            sum += measure(part, part.faces[f], apex).volume;
    };
    for (const Solid& solid : part.solids) {
        add(solid.outside);
        for (const Shell& shell : solid.voids)
            add(shell);
    }
    return sum;
}

Mass mass_of(const Part& part, const Solid& solid) {
    const Vec3 apex = corner_of(part, solid);
    return mass(sums_of(part, solid, apex), apex);
}

Mass mass_of(const Part& part) {
    if (part.solids.empty()) return {};
    const Vec3 apex = corner_of(part, part.solids.front());
    Sums all;
    for (const Solid& solid : part.solids) {
        const Sums sums = sums_of(part, solid, apex);
        all.volume += sums.volume;
        all.area += sums.area;
        all.moment = all.moment + sums.moment;
    }
    return mass(all, apex);
}

}  // namespace ncsim::brep
