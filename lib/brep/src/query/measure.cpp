// SPDX-License-Identifier: GPL-3.0-or-later
//
// Areas, volumes and first moments of faces, as integrals along the edges.
#include "ncsim/brep/measure.h"

#include "ncsim/base/angles.h"

#include "geometry/swept_integrals.h"
#include "geometry/tolerances.h"
#include "topology/axes.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <type_traits>

namespace ncsim::brep {

namespace {

template <std::size_t N, typename F>
void integrate_piece(const Track& track, double begin, double width,
                     const std::array<double, N>& abscissae, const std::array<double, N>& weights,
                     const F& f) {
    const double middle = begin + 0.5 * width;
    for (std::size_t k = 0; k < N; ++k) {
        for (const double sign : {-1.0, 1.0}) {
            const double t = middle + sign * 0.5 * width * abscissae[k];
            const Track::Step step = track.step(t);
            f(0.5 * width * weights[k], step.at, step.derivative);
        }
    }
}

// Calls `piece` for each piece of a track with a rule of quadrature. Splines have so many knots
// that the integrand between knots is of degree 3 to about 1e-9.
template <typename Piece>
void for_pieces(const Track& track, Exactness exactness, const Piece& piece) {
    const std::size_t pieces = track.pieces();
    for (std::size_t i = 0; i < pieces; ++i) {
        const double begin = track.start_of(i), width = track.start_of(i + 1) - begin;
        if (track.is_spline() && exactness == Exactness::Rough) {
            piece(begin, width, kTwoAbscissae, kTwoWeights);
        } else if (track.is_spline()) {
            piece(begin, width, kFewAbscissae, kFewWeights);
        } else {
            piece(begin, width, kAbscissae, kWeights);
        }
    }
}

template <typename F>
void integrate(const Track& track, const F& f, Exactness exactness = Exactness::Full) {
    for_pieces(track, exactness,
               [&](double begin, double width, const auto& abscissae, const auto& weights) {
                   integrate_piece(track, begin, width, abscissae, weights, f);
               });
}

// Integrates `f` along a level circle. The integrand is of degree 3 at most in cosine and sine, so
// pieces of 45 degrees are exact to the last bit.
template <typename F>
void integrate_round(const Track& track, const F& f) {
    const auto pieces =
        static_cast<std::size_t>(track.sweep_degrees() / (0.5 * kQuarterTurnDegrees + kRounding)) +
        1;
    const double width = 1.0 / static_cast<double>(pieces);
    for (std::size_t i = 0; i < pieces; ++i)
        integrate_piece(track, static_cast<double>(i) * width, width, kAbscissae, kWeights, f);
}

// Integrates `f` along an edge of a plane. Along a line, the integrand is of degree 2 at most.
template <typename F>
void integrate_level(const Track& track, const F& f) {
    if (track.circle()) return integrate_round(track, f);
    if (!track.is_straight()) return integrate(track, f);
    integrate_piece(track, 0.0, 1.0, kTwoAbscissae, kTwoWeights, f);
}

// Integrates over an edge of a surface of revolution.
template <typename F>
void integrate_around(const Track& track, const Axes& axes, const F& f) {
    const Circle* circle = track.circle();
    const auto is_level = [&] {
        return norm(cross(circle->axis, axes.z)) <= kUnitRounding &&
               norm(cross(circle->centre - axes.origin, axes.z)) <= kRounding;
    };
    if (circle && is_level()) return integrate_round(track, f);
    integrate(track, f);
}

struct CylinderIntegrals {
    double radius;
    Vec3 w;
    AreaAndVolume operator()(const Local& p) const {
        const double side = radius + (w.x * p.x + w.y * p.y) / p.radius;
        return {radius * p.z, radius * side * p.z};
    }
};

struct ConeIntegrals {
    double slope;
    Vec3 w;
    AreaAndVolume operator()(const Local& p) const {
        const double half = 0.5 * p.z * p.z * slope;
        if (p.radius <= 0.0) return {};
        return {half * std::sqrt(1.0 + slope * slope),
                half * ((w.x * p.x + w.y * p.y) / p.radius - w.z * slope)};
    }
};

struct SphereIntegrals {
    double radius;
    Vec3 w;
    double pole;  // 1 or -1: pole from which the integral starts
    AreaAndVolume operator()(const Local& p) const {
        if (p.radius <= 0.0) return {};
        const double s = p.z / radius, c = p.radius / radius;
        const double angle = angle_of(c, s) * kRadiansPerDegree;
        const double side = (w.x * p.x + w.y * p.y) / p.radius;
        const double half_pi = pole * 0.5 * std::numbers::pi;
        const double r2 = radius * radius;
        return {r2 * (s - pole),
                r2 * (radius * (s - pole) + side * 0.5 * (angle - half_pi + s * c) +
                      0.5 * w.z * (s * s - 1.0))};
    }
};

struct TorusIntegrals {
    TorusIntegrals(const Torus& torus, Vec3 apex, double from)
        : surface(torus), major(torus.major), minor(torus.minor), w(apex), cut(from) {}
    Torus surface;
    double major, minor;
    Vec3 w;
    double cut;  // degrees, where the angle around the tube jumps
    // A spindle is integrated from its tip, which may be a corner.
    AreaAndVolume operator()(const Local& p) const {
        const double out = p.radius - major;
        const double length = std::sqrt(out * out + p.z * p.z);
        const double a = (w.x * p.x + w.y * p.y) / p.radius;
        const double degrees = cut + degrees_from(cut, surface, p);
        const AreaAndVolume all =
            area_and_volume(degrees * kRadiansPerDegree, p.z / length, out / length, a);
        if (!is_spindle(surface)) return all;
        const auto tip = sin_cos(cut);
        const AreaAndVolume before = area_and_volume(cut * kRadiansPerDegree, tip.sin, tip.cos, a);
        return {all.area - before.area, all.volume - before.volume};
    }
    AreaAndVolume area_and_volume(double f, double s, double c, double a) const {
        return {minor * (major * f + minor * s),
                minor * (major * minor * f + major * (major + a) * s - major * w.z * c +
                         minor * minor * s + minor * (major + a) * 0.5 * (f + s * c) +
                         0.5 * minor * w.z * s * s)};
    }
};

// Per angle: area and volume along a mm of the line.
struct ExtrusionIntegrals {
    double radius;
    Vec3 w, lean;
    AreaAndVolume per_mm(const Local& p) const {
        const Vec3 out{p.x / p.radius, p.y / p.radius, 0.0};
        const Vec3 normal = cross(Vec3{-radius * out.y, radius * out.x, 0.0}, lean);
        return {norm(normal), dot(w + radius * out, normal)};
    }
    AreaAndVolume operator()(const Local& p) const {
        const AreaAndVolume b = per_mm(p);
        return {b.area * p.z, b.volume * p.z};
    }
};

// Returns the change of the angle around the axis by a step, per unit of the parameter.
double turn(const Local& p, Vec3 step) {
    return (p.x * step.y - p.y * step.x) / (p.radius * p.radius);
}

template <typename B>
Measure measure_revolved(const Part& part, const Face& face, const Axes& axes, const B& below) {
    Measure sum;
    double turns = 0.0;
    double nearest = std::numeric_limits<double>::infinity();
    const auto for_angles = [&](const auto& take) {
        for_edges(part, face, [&](const Track& track, double sign) {
            integrate_around(track, axes, [&](double weight, Vec3 at, Vec3 derivative) {
                const Local p = axes(at);
                const bool is_tip = p.radius <= kUnitRounding;
                take(p, is_tip ? 0.0 : sign * weight * turn(p, axes.oblique_components(derivative)),
                     weight * norm(derivative));
            });
        });
    };
    for_angles([&](const Local& p, double turned, double length) {
        sum.length += length;
        nearest = std::min(nearest, p.radius);
        if (turned == 0.0) return;
        const AreaAndVolume b = below(p);
        turns += turned;
        sum.area -= turned * b.area;
        sum.volume -= turned * b.volume / 3.0;
    });
    // The edges of a face may miss their ends, so the angles have gaps. On a face that does not go
    // round, each gap counts with the whole integral below the face; this share is subtracted, at
    // the level of the first edge's start. The correction does not apply to edges near the axis,
    // which may pass half a turn there, and to cones, which have no radius and begin at their apex.
    const double radius = radius_of(face.surface.form);
    if (radius > 0.0 && nearest > 0.1 * radius && std::abs(turns) < 0.1 &&
        std::abs(turns) > 0.01 * kUnitRounding) {
        const EdgeUse& first = face.loops.front().front();
        const Edge& edge = part.edges[first.edge];
        const Local start = axes(track_of(part, edge).at(0.0));
        for_angles([&](const Local& p, double turned, double) {
            if (turned == 0.0) return;
            const double scale = start.radius / p.radius;
            const AreaAndVolume level = below({scale * p.x, scale * p.y, start.z, start.radius});
            sum.area += turned * level.area;
            sum.volume += turned * level.volume / 3.0;
        });
    }
    if (face.surface.is_hollow) sum.area = -sum.area;
    return sum;
}

double turns_about(const Part& part, const Face& face, const Axes& axes) {
    double sum = 0.0;
    for_edges(part, face, [&](const Track& track, double sign) {
        integrate_around(track, axes, [&](double weight, Vec3 at, Vec3 derivative) {
            const Local p = axes(at);
            if (p.radius > 0.0) sum += sign * weight * turn(p, axes.oblique_components(derivative));
        });
    });
    return sum / (2.0 * std::numbers::pi);
}

// --- Surfaces of circles and tools in motion ------------------------------------------------

// Integrates over the time along an edge of an envelope. Near a fold of the envelope, times along
// edges change like square roots, and points that are off by rounding give inaccurate times. Pieces
// are halved there, and the time that remains missing is distributed evenly.
class TimeIntegral {
public:
    TimeIntegral(const Track& track, const Envelope& envelope)
        : track_(track), envelope_(envelope) {}

    // Calls `take` with the length, the time with opposite sign, and the closest point.
    template <typename Take>
    void operator()(Exactness exactness, const Take& take) {
        for_pieces(track_, exactness,
                   [&](double begin, double width, const auto& abscissae, const auto& weights) {
                       const auto all = steps(begin, width, abscissae, weights);
                       const double left = exactness == Exactness::Full || is_at_fold(all)
                                               ? left_of(all, begin, width)
                                               : 0.0;
                       take_all(all, left, begin, width, 12, take);
                   });
    }

private:
    struct Step {
        double length, time;
        ClosestPoint place;
    };

    template <std::size_t N>
    std::array<Step, 2 * N> steps(double begin, double width,
                                  const std::array<double, N>& abscissae,
                                  const std::array<double, N>& weights) {
        std::array<Step, 2 * N> all;
        std::size_t i = 0;
        integrate_piece(track_, begin, width, abscissae, weights,
                        [&](double weight, Vec3 at, Vec3 derivative) {
                            const ClosestPoint place = project_onto(envelope_, at, seed_);
                            all[i++] = {weight * norm(derivative),
                                        weight * EnvelopeIntegrals::turn(place, derivative), place};
                        });
        return all;
    }

    // True if the piece is near a fold: the closer the fold, the smaller is the second derivative
    // of the distance by time.
    template <std::size_t N>
    static bool is_at_fold(const std::array<Step, N>& all) {
        const auto [least, most] =
            std::ranges::minmax(all, {}, [](const Step& step) { return step.place.bend; });
        return least.place.bend < 0.25 * most.place.bend;
    }

    template <std::size_t N>
    double left_of(const std::array<Step, N>& all, double begin, double width) {
        double left = time_at(begin) - time_at(begin + width);
        for (const Step& step : all)
            left -= step.time;
        return left;
    }

    template <std::size_t N, typename Take>
    void take_all(const std::array<Step, N>& all, double left, double begin, double width,
                  int halves, const Take& take) {
        if (halves > 0 && !(std::abs(left) <= 100.0 * kRounding)) {
            const double half = 0.5 * width;
            for (const double start : {begin, begin + half}) {
                const auto finer = steps(start, half, kAbscissae, kWeights);
                take_all(finer, left_of(finer, start, half), start, half, halves - 1, take);
            }
            return;
        }
        for (const Step& step : all)
            take(step.length, step.time + left / static_cast<double>(N), step.place);
    }

    double time_at(double t) { return project_onto(envelope_, track_.at(t), seed_).t; }

    const Track& track_;
    const Envelope& envelope_;
    ProjectionSeed seed_;
};

template <typename Form, typename On, typename Take>
void integrate_swept(const Part& part, const Face& face, const Form& form, const On& on,
                     Exactness exactness, const Take& take) {
    for_edges(part, face, [&](const Track& track, double sign) {
        if constexpr (std::is_same_v<Form, Envelope>) {
            TimeIntegral over_times(track, form);
            over_times(exactness, [&](double length, double time, const ClosestPoint& place) {
                take(length, sign * time, place);
            });
        } else {
            integrate(track, [&](double weight, Vec3 at, Vec3 derivative) {
                const auto place = project_onto(form, at);
                take(weight * norm(derivative), sign * weight * on.turn(place, derivative), place);
            });
        }
    });
}

template <typename Form, typename On>
Measure measure_swept(const Part& part, const Face& face, const Form& form, const On& on,
                      Exactness exactness = Exactness::Full) {
    Measure sum;
    integrate_swept(part, face, form, on, exactness,
                    [&](double length, double turned, const auto& place) {
                        const auto b = on.area_and_volume(place);
                        sum.length += length;
                        sum.area -= turned * b.area;
                        sum.volume -= turned * b.volume / 3.0;
                    });
    if (face.surface.is_hollow) sum.area = -sum.area;
    return sum;
}

template <typename Form, typename On>
Vec3 swept_moment(const Part& part, const Face& face, const Form& form, const On& on) {
    Vec3 sum;
    integrate_swept(
        part, face, form, on, Exactness::Full,
        [&](double, double turned, const auto& place) { sum = sum - turned * on.moment(place); });
    return sum;
}

Measure measure_plane(const Part& part, const Face& face, const Plane& plane, Vec3 apex) {
    Measure sum;
    Vec3 twice;
    for_edges(part, face, [&](const Track& track, double sign) {
        integrate_level(track, [&](double weight, Vec3 at, Vec3 derivative) {
            sum.length += weight * norm(derivative);
            twice = twice + (sign * weight) * cross(at - plane.origin, derivative);
        });
    });
    sum.area = 0.5 * dot(twice, plane.normal);
    sum.volume = sum.area * dot(plane.origin - apex, plane.normal) / 3.0;
    return sum;
}

// --- Middles --------------------------------------------------------------------------------

// Geometry for the integral of w (w n) over a face, with w from `apex` and n the form's normal. The
// integral is four times volume times centroid of the cone over the face. The second parameter uses
// Gauss quadrature.
struct Profile {
    double radius, height;  // of the point
    double out, up;         // of the normal
    double per;             // area per radian and unit of the parameter
};

Vec3 across_face(const Axes& axes, Vec3 apex, const Local& p, const Profile& f) {
    const Vec3 radial = (1.0 / p.radius) * (p.x * axes.x + p.y * axes.y);
    const Vec3 w = axes.origin - apex + f.radius * radial + f.height * axes.z;
    const Vec3 n = f.out * radial + f.up * axes.z;
    return (f.per * dot(w, n)) * w;
}

// Integrates w (w n) along the axis up to `p`. The integrand is linear in the height, on cones
// cubic in total, so two points are exact.
template <typename At>
Vec3 up_face(const Axes& axes, Vec3 apex, const Local& p, const At& at) {
    Vec3 sum;
    for (const double sign : {-1.0, 1.0}) {
        const double height = 0.5 * (1.0 + sign * kTwoAbscissae[0]) * p.z;
        sum = sum + 0.5 * p.z * across_face(axes, apex, p, at(height));
    }
    return sum;
}

template <typename At>
Vec3 surface_moment(const Axes& axes, Vec3 apex, const Local& p, double from, double to, int pieces,
                    const At& at) {
    Vec3 sum;
    const double width = (to - from) / pieces;
    for (int i = 0; i < pieces; ++i) {
        const double middle = from + (i + 0.5) * width;
        for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
            for (const double sign : {-1.0, 1.0})
                sum = sum + 0.5 * width * kWeights[k] *
                                across_face(axes, apex, p,
                                            at(middle + sign * 0.5 * width * kAbscissae[k]));
        }
    }
    return sum;
}

template <typename Inner>
Vec3 edge_moment(const Part& part, const Face& face, const Axes& axes, const Inner& inner) {
    Vec3 sum;
    for_edges(part, face, [&](const Track& track, double sign) {
        integrate_around(track, axes, [&](double weight, Vec3 at, Vec3 derivative) {
            const Local p = axes(at);
            if (p.radius <= kUnitRounding) return;
            sum = sum - (sign * weight * turn(p, axes.oblique_components(derivative))) * inner(p);
        });
    });
    return sum;
}

// Returns volume times centroid of the cone from `apex` over the face.
// Requires: no envelope; for envelopes, see sums_of().
Vec3 moment(const Part& part, const Face& face, Vec3 apex) {
    if (const auto* f = std::get_if<Plane>(&face.surface.form)) {
        Vec3 sum;  // Integral of w over the face.
        for_edges(part, face, [&](const Track& track, double sign) {
            integrate_level(track, [&](double weight, Vec3 at, Vec3 derivative) {
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
        return quarter(edge_moment(part, face, axes, [&](const Local& p) {
            return up_face(axes, apex, p, [&](double h) {
                return Profile{f->radius, h, 1.0, 0.0, f->radius};
            });
        }));
    }
    if (const auto* f = std::get_if<Cone>(&face.surface.form)) {
        const Axes axes(f->apex, face.frame);
        const double slant = std::sqrt(1.0 + f->slope * f->slope);
        return quarter(edge_moment(part, face, axes, [&](const Local& p) {
            return up_face(axes, apex, p, [&](double h) {
                return Profile{f->slope * h, h, 1.0 / slant, -f->slope / slant,
                               f->slope * h * slant};
            });
        }));
    }
    const auto round = [](double major, double minor, double degrees) {
        const auto t = sin_cos(degrees);
        const double radius = major + minor * t.cos;
        return Profile{radius, minor * t.sin, t.cos, t.sin, minor * radius * kRadiansPerDegree};
    };
    if (const auto* f = std::get_if<Sphere>(&face.surface.form)) {
        const Axes axes(f->centre, face.frame);
        const double turns = turns_about(part, face, axes);
        const double pole = (turns < -0.5) != face.surface.is_hollow ? -1.0 : 1.0;
        return quarter(edge_moment(part, face, axes, [&](const Local& p) {
            const double to = angle_of(p.radius, p.z);
            return surface_moment(axes, apex, p, 0.5 * pole * kHalfTurnDegrees, to, 2,
                                  [&](double angle) { return round(0.0, f->radius, angle); });
        }));
    }
    if (const auto* f = std::get_if<Extrusion>(&face.surface.form)) {
        const Axes axes(*f, face.frame);
        const ExtrusionIntegrals below{f->radius, axes.rectangular_components(f->centre - apex),
                                       axes.lean};
        return quarter(edge_moment(part, face, axes, [&](const Local& p) {
            const Vec3 start =
                f->centre - apex + (f->radius / p.radius) * (p.x * axes.x + p.y * axes.y);
            return (below.per_mm(p).volume * p.z) * (start + (0.5 * p.z) * f->along);
        }));
    }
    if (const auto* f = std::get_if<Dome>(&face.surface.form))
        return quarter(swept_moment(part, face, *f, DomeIntegrals(*f, apex)));
    if (const auto* f = std::get_if<Coil>(&face.surface.form))
        return quarter(swept_moment(part, face, *f, CoilIntegrals(*f, apex)));
    if (const auto* f = std::get_if<Spiral>(&face.surface.form))
        return quarter(swept_moment(part, face, *f, SpiralIntegrals(*f, apex)));
    const auto& f = std::get<Torus>(face.surface.form);
    const Axes axes(f.centre, face.frame);
    const double cut = cut_of(part, face, axes, f);
    return quarter(edge_moment(part, face, axes, [&](const Local& p) {
        return surface_moment(axes, apex, p, cut, cut + degrees_from(cut, f, p), 4,
                              [&](double angle) { return round(f.major, f.minor, angle); });
    }));
}

// Volume, area and first moment of a body about an apex.
struct Sums {
    double volume = 0.0, area = 0.0;
    Vec3 moment;
};

Sums sums_of(const Part& part, const Face& face, Vec3 apex) {
    const auto* envelope = std::get_if<Envelope>(&face.surface.form);
    if (!envelope) {
        const Measure measured = measure(part, face, apex);
        return {measured.volume, measured.area, moment(part, face, apex)};
    }
    // Integrals across an envelope take long, and serve all three sums.
    Sums sums;
    const EnvelopeIntegrals on(*envelope, apex, false);
    integrate_swept(part, face, *envelope, on, Exactness::Full,
                    [&](double, double turned, const ClosestPoint& place) {
                        const EnvelopeIntegrals::Sum below = on.area_and_volume(place);
                        sums.volume -= turned * below.volume / 3.0;
                        sums.area -= turned * below.area;
                        sums.moment = sums.moment - 0.25 * turned * below.moment;
                    });
    if (face.surface.is_hollow) sums.area = -sums.area;
    return sums;
}

Sums sums_of(const Part& part, const Solid& solid, Vec3 apex) {
    Sums all;
    for_shells(solid, [&](const Shell& shell) {
        for (const std::uint32_t f : shell) {
            const Sums sums = sums_of(part, part.faces[f], apex);
            all.volume += sums.volume;
            all.area += sums.area;
            all.moment = all.moment + sums.moment;
        }
    });
    return all;
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

Measure measure(const Part& part, const Face& face, Vec3 apex, Exactness exactness) {
    if (const auto* f = std::get_if<Plane>(&face.surface.form))
        return measure_plane(part, face, *f, apex);
    if (const auto* f = std::get_if<Cylinder>(&face.surface.form)) {
        const Axes axes(f->origin, face.frame);
        return measure_revolved(
            part, face, axes,
            CylinderIntegrals{f->radius, axes.oblique_components(f->origin - apex)});
    }
    if (const auto* f = std::get_if<Cone>(&face.surface.form)) {
        const Axes axes(f->apex, face.frame);
        return measure_revolved(part, face, axes,
                                ConeIntegrals{f->slope, axes.oblique_components(f->apex - apex)});
    }
    if (const auto* f = std::get_if<Sphere>(&face.surface.form)) {
        const Axes axes(f->centre, face.frame);
        const double turns = turns_about(part, face, axes);
        const double pole = (turns < -0.5) != face.surface.is_hollow ? -1.0 : 1.0;
        return measure_revolved(
            part, face, axes,
            SphereIntegrals{f->radius, axes.oblique_components(f->centre - apex), pole});
    }
    if (const auto* f = std::get_if<Extrusion>(&face.surface.form)) {
        const Axes axes(*f, face.frame);
        return measure_revolved(
            part, face, axes,
            ExtrusionIntegrals{f->radius, axes.rectangular_components(f->centre - apex),
                               axes.lean});
    }
    if (const auto* f = std::get_if<Dome>(&face.surface.form))
        return measure_swept(part, face, *f, DomeIntegrals(*f, apex));
    if (const auto* f = std::get_if<Coil>(&face.surface.form))
        return measure_swept(part, face, *f, CoilIntegrals(*f, apex));
    if (const auto* f = std::get_if<Spiral>(&face.surface.form))
        return measure_swept(part, face, *f, SpiralIntegrals(*f, apex));
    if (const auto* f = std::get_if<Envelope>(&face.surface.form))
        return measure_swept(part, face, *f,
                             EnvelopeIntegrals(*f, apex, exactness == Exactness::Rough), exactness);
    const auto& f = std::get<Torus>(face.surface.form);
    const Axes axes(f.centre, face.frame);
    return measure_revolved(
        part, face, axes,
        TorusIntegrals(f, axes.oblique_components(f.centre - apex), cut_of(part, face, axes, f)));
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
    for (const Solid& solid : part.solids)
        for_shells(solid, add);
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
