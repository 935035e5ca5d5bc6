// SPDX-License-Identifier: GPL-3.0-or-later
//
// Integrals over swept surfaces: over the second parameter, from a fixed start to a point. The
// remaining integral runs along the edges of faces (Green's theorem).
#pragma once

#include "ncsim/base/angles.h"
#include "ncsim/brep/envelope.h"
#include "ncsim/brep/surface_forms.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ncsim::brep {

// Gauss-Legendre abscissae and weights on (-1, 1), each used on both sides of 0: exact for
// polynomials of degree 15.
inline constexpr std::array<double, 4> kAbscissae{0.1834346424956498, 0.5255324099163290,
                                                  0.7966664774136267, 0.9602898564975363};
inline constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873,
                                                0.2223810344533745, 0.1012285362903763};
// The same for degrees 7 and 3.
inline constexpr std::array<double, 2> kFewAbscissae{0.3399810435848563, 0.8611363115940526};
inline constexpr std::array<double, 2> kFewWeights{0.6521451548625461, 0.3478548451374538};
inline constexpr std::array<double, 1> kTwoAbscissae{0.5773502691896258};
inline constexpr std::array<double, 1> kTwoWeights{1.0};

// Integrals over the second parameter from a fixed start to a point: the area, and three times the
// volume of the cone from the apex, at -w in the frame of the surface. The remaining integral runs
// along the edges, over the angle around the axis (Green's theorem).
struct AreaAndVolume {
    double area = 0.0, volume = 0.0;
};

// Integrals on a dome: along edges over the angle of the circle; then over the angle of the arc,
// from the level of the arc's centre. Areas and moments use Gauss quadrature.
class DomeIntegrals {
public:
    DomeIntegrals(const Dome& dome, Vec3 apex) : dome_(dome), w_(dome.centre - apex) {}

    // Returns the area and three times the volume, per radian of the circle's angle.
    AreaAndVolume area_and_volume(const DomePlace& place) const {
        const Vec3 tangent = cross(dome_.axis, place.out);
        const double degrees = place.degrees(), per_degree = kRadiansPerDegree * per_radian();
        AreaAndVolume sum;
        in_pieces(degrees, 0.5 * kQuarterTurnDegrees, [&](double weight, const SinCos& t) {
            const double lean = t.sin * dot(tangent, dome_.ahead);
            sum.area += (weight * per_degree) * std::sqrt(std::max(0.0, 1.0 - lean * lean));
        });
        // Integral over t of the normal, around x (cos t axis - sin t ahead). The product of the
        // normal with the vector from the arc's centre is the same for all t.
        const Vec3 normal = place.sine * cross(tangent, dome_.axis) -
                            (1.0 - place.cosine) * cross(tangent, dome_.ahead);
        const double level = dome_.reach * dot(tangent, cross(dome_.axis, dome_.ahead));
        sum.volume = per_radian() * (dot(w_ + dome_.radius * place.out, normal) +
                                     level * degrees * kRadiansPerDegree);
        return sum;
    }

    // Returns the integral of w (w n), w from the apex: four times volume times centroid.
    Vec3 moment(const DomePlace& place) const {
        const Vec3 tangent = cross(dome_.axis, place.out);
        const double per_degree = kRadiansPerDegree * per_radian();
        Vec3 sum;
        in_pieces(place.degrees(), 0.5 * kQuarterTurnDegrees, [&](double weight, const SinCos& t) {
            const Vec3 up = t.cos * dome_.ahead + t.sin * dome_.axis;
            const Vec3 along = t.cos * dome_.axis - t.sin * dome_.ahead;
            const Vec3 at = w_ + dome_.reach * up + dome_.radius * place.out;
            sum = sum + (weight * per_degree * dot(at, cross(tangent, along))) * at;
        });
        return sum;
    }

    // Returns the change of the circle's angle for a step on the surface; 0 where undefined, in the
    // corners of the half.
    double turn(const DomePlace& place, Vec3 step) const {
        const Vec3 tangent = cross(dome_.axis, place.out);
        const Vec3 across_arc = cross(place.along, cross(tangent, place.along));
        const double slope = dot(tangent, across_arc);
        return slope > kUnitRounding ? dot(step, across_arc) / (dome_.radius * slope) : 0.0;
    }

private:
    double per_radian() const { return dome_.reach * dome_.radius; }

    // Integrates from 0 to `degrees`; weights are in degrees.
    template <typename Take>
    static void in_pieces(double degrees, double piece, const Take& take) {
        const int pieces = static_cast<int>(std::abs(degrees) / piece) + 1;
        const double width = degrees / pieces;
        std::array<SinCos, kAbscissae.size()> nodes;
        for (std::size_t k = 0; k < kAbscissae.size(); ++k)
            nodes[k] = sin_cos(0.5 * kAbscissae[k] * width);
        for (int i = 0; i < pieces; ++i) {
            const auto middle = sin_cos((i + 0.5) * width);
            for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
                for (const double sign : {-1.0, 1.0}) {
                    const double sine = sign * nodes[k].sin, cosine = nodes[k].cos;
                    take(0.5 * width * kWeights[k],
                         SinCos{middle.sin * cosine + middle.cos * sine,
                                middle.cos * cosine - middle.sin * sine});
                }
            }
        }
    }

    Dome dome_;
    Vec3 w_;
};

// Integrals on a coil: along edges over the angle of the circle relative to the path; then over the
// angle of the path, from t = 0. Moments use Gauss quadrature.
class CoilIntegrals {
public:
    CoilIntegrals(const Coil& coil, Vec3 apex)
        : coil_(coil), side_(cross(coil.axis, coil.ahead)), w_(coil.centre - apex) {}

    // Returns the same as for a dome. In the frame of the path, the normal is constant: lead times
    // the outward vector, minus the outward vector's component along the path times reach times the
    // axis.
    AreaAndVolume area_and_volume(const CoilPlace& place) const {
        const double out = dot(place.out, place.motion), lateral = across(place);
        const double cosine = dot(place.motion, side_), sine = -dot(place.motion, coil_.ahead);
        const Vec3 up = sine * coil_.ahead + (1.0 - cosine) * side_;
        const Vec3 tangent = sine * side_ - (1.0 - cosine) * coil_.ahead;
        const double even = coil_.lead * (coil_.radius - coil_.reach * lateral) -
                            out * coil_.reach * dot(w_, coil_.axis);
        const double turn = place.turn;
        const double steep = coil_.reach * out;
        return {coil_.radius * std::sqrt(coil_.lead * coil_.lead + steep * steep) *
                    (coil_.lead < 0.0 ? -turn : turn),
                coil_.radius * (coil_.lead * dot(w_, out * tangent - lateral * up) + even * turn -
                                0.5 * steep * coil_.lead * turn * turn)};
    }

    Vec3 moment(const CoilPlace& place) const {
        const double degrees = place.turn / kRadiansPerDegree;
        const int pieces = static_cast<int>(std::abs(degrees) / kQuarterTurnDegrees) + 1;
        const double width = degrees / pieces;
        const double out = dot(place.out, place.motion), lateral = across(place);
        Vec3 sum;
        for (int i = 0; i < pieces; ++i) {
            for (std::size_t k = 0; k < kAbscissae.size(); ++k) {
                for (const double sign : {-1.0, 1.0}) {
                    const double at_degrees = (i + 0.5 + 0.5 * sign * kAbscissae[k]) * width;
                    const auto t = sin_cos(at_degrees);
                    const Vec3 up = t.cos * coil_.ahead + t.sin * side_;
                    const Vec3 tangent = t.cos * side_ - t.sin * coil_.ahead;
                    const Vec3 outward = out * tangent - lateral * up;
                    const Vec3 at = w_ + coil_.reach * up +
                                    (coil_.lead * at_degrees * kRadiansPerDegree) * coil_.axis +
                                    coil_.radius * outward;
                    const Vec3 normal = coil_.lead * outward - (out * coil_.reach) * coil_.axis;
                    sum = sum + (0.5 * width * kRadiansPerDegree * kWeights[k] * coil_.radius *
                                 dot(at, normal)) *
                                    at;
                }
            }
        }
        return sum;
    }

    // Returns the change of the circle's angle relative to the path for a step on the surface.
    double turn(const CoilPlace& place, Vec3 step) const {
        const Vec3 tangent = cross(coil_.axis, place.out);
        const double along = dot(step, coil_.axis) / coil_.lead;
        return dot(step - (along * coil_.reach) * place.motion, tangent) / coil_.radius - along;
    }

private:
    double across(const CoilPlace& place) const {
        return dot(place.out, cross(coil_.axis, place.motion));
    }

    Coil coil_;
    Vec3 side_, w_;
};

// Integrals on a spiral: along edges over the angle of the path; then over the height, from the
// centre.
class SpiralIntegrals {
public:
    SpiralIntegrals(const Spiral& spiral, Vec3 apex) : spiral_(spiral), w_(spiral.centre - apex) {}

    // Returns the area and three times the volume, per radian of the path's angle.
    AreaAndVolume area_and_volume(const SpiralPlace& place) const {
        const double area = place.speed * place.height;
        return {area, area * dot(start_of(place), place.out)};
    }
    Vec3 moment(const SpiralPlace& place) const {
        return area_and_volume(place).volume *
               (start_of(place) + (0.5 * place.height) * spiral_.axis);
    }

    // Returns the change of the path's angle for a step on the surface.
    static double turn(const SpiralPlace& place, Vec3 step) {
        return dot(step, place.along) / place.speed;
    }

private:
    Vec3 start_of(const SpiralPlace& place) const {
        return w_ + (place.path_point - spiral_.centre) + spiral_.offset * place.out;
    }

    Spiral spiral_;
    Vec3 w_;
};

// Integrals on an envelope: along edges over the time; then across the path. Fillets are integrated
// from below the tool over the angle of the normal; because the angle may change fast where a torus
// moves nearly level, pieces are halved as often as needed. Flanks are integrated from their lower
// end.
class EnvelopeIntegrals {
public:
    EnvelopeIntegrals(const Envelope& envelope, Vec3 apex, bool is_rough)
        : sweep_(*envelope.sweep), apex_(apex), is_rough_(is_rough) {}

    // Area, three times the volume, and four times volume times centroid.
    struct Sum {
        double area = 0.0, volume = 0.0;
        Vec3 moment;
    };
    Sum area_and_volume(const ClosestPoint& place) const {
        const ToolFrame& tool = place.tool;
        if (const Flank* flank = sweep_.flank()) {
            const double to = place_across(sweep_, tool, place.foot);
            const FlankIntegrand on{sweep_, tool};
            return in_pieces(on, to < 0.0 ? -flank->length : flank->length, to);
        }
        if (sweep_.is_rim()) {
            const RimIntegrand on{sweep_, tool};
            return in_pieces(on, kHalfTurnDegrees, place_across(sweep_, tool, place.foot));
        }
        const FilletIntegrand on{sweep_, *sweep_.fillet(), tool, brep::path_frame(sweep_, tool)};
        return in_pieces(on, kHalfTurnDegrees, on.angle_of(place.normal));
    }

    // Returns the time of a step on the surface, with opposite sign.
    static double turn(const ClosestPoint& place, Vec3 step) {
        return place.bend != 0.0 ? dot(place.drift, step) / place.bend : 0.0;
    }

private:
    // Point of the characteristic, its closest point, and the speed along the characteristic.
    struct CharacteristicPoint {
        Vec3 p;
        ClosestPoint closest;
        double pace;
    };

    // Integrand by the angle of the normal, degrees.
    struct FilletIntegrand {
        const Sweep& sweep;
        const Fillet& fillet;
        const ToolFrame& tool;
        PathFrame at;
        double angle_of(Vec3 n) const {
            const double degrees = ncsim::angle_of(dot(n, at.up), dot(n, at.side));
            return degrees < 0.0 ? degrees + 360.0 : degrees;
        }
        CharacteristicPoint operator()(double degrees) const {
            if (fillet.centre_radius > 0.0 && tool.turn != Vec3{}) return turning(degrees);
            const auto angle = sin_cos(degrees);
            const Vec3 n = angle.cos * at.up + angle.sin * at.side;
            const Vec3 on = angle.cos * at.side - angle.sin * at.up;
            Vec3 pace = fillet.radius * on;  // per radian
            Vec3 p = at.centre + fillet.radius * n;
            if (fillet.centre_radius > 0.0) {
                const Vec3 axis = tool.axis;
                const Vec3 level = n - dot(n, axis) * axis;
                const double length = norm(level);
                const Vec3 round = (1.0 / length) * cross(axis, level);
                pace = pace + (fillet.centre_radius * dot(on, round) / length) * round;
                p = p + (fillet.centre_radius / length) * level;
            }
            return {p, closest_point_at(sweep, tool, p), kRadiansPerDegree * norm(pace)};
        }
        // Returns the stroke for a tool that turns. The speed is the inverse of the angle by which
        // the normal turns per mm along the characteristic, seen along the path.
        CharacteristicPoint turning(double degrees) const {
            const Vec3 p = point_with_normal(sweep, tool, degrees);
            const ClosestPoint there = closest_point_at(sweep, tool, p);
            const Vec3 n = there.normal, axis = tool.axis;
            const Vec3 along = normalized(cross(n, there.drift));
            const Vec3 out = normalized(n - dot(n, axis) * axis);
            const Vec3 round = cross(axis, out), profile = cross(round, n);
            const double radial = dot(n, out);
            const Vec3 turn =
                (dot(along, profile) / fillet.radius) * profile +
                (dot(along, round) * radial / (fillet.centre_radius + fillet.radius * radial)) *
                    round;
            const double up = dot(n, at.up), side = dot(n, at.side);
            const double turn_rate =
                (up * dot(turn, at.side) - side * dot(turn, at.up)) / (up * up + side * side);
            return {p, there, kRadiansPerDegree / std::abs(turn_rate)};
        }
    };

    // Integrand by the place across the path. The characteristic is perpendicular to the normal and
    // to the gradient of the rate. Its component along the profile has the speed of the place.
    struct FlankIntegrand {
        const Sweep& sweep;
        const ToolFrame& tool;
        CharacteristicPoint operator()(double across) const {
            const Vec3 p = point_across(sweep, tool, across);
            const ClosestPoint at = closest_point_at(sweep, tool, p);
            const Vec3 along = cross(at.normal, at.drift);
            const double rise = dot(at.normal, tool.axis);
            const Vec3 profile = tool.axis - rise * at.normal;
            return {p, at, norm(along) * norm(profile) / std::abs(dot(along, profile))};
        }
    };

    // Integrand by the angle about the axis, degrees.
    struct RimIntegrand {
        const Sweep& sweep;
        const ToolFrame& tool;
        CharacteristicPoint operator()(double degrees) const {
            const Vec3 p = point_across(sweep, tool, degrees);
            return {p, closest_point_at(sweep, tool, p),
                    kRadiansPerDegree * sweep.fillet()->centre_radius};
        }
    };

    static Sum plus(const Sum& a, const Sum& b) {
        return {a.area + b.area, a.volume + b.volume, a.moment + b.moment};
    }

    // Halves the interval until two rules agree. If the rule with few points is accurate to ε, the
    // rule with more points is accurate to about ε².
    template <typename On>
    Sum in_pieces(const On& on, double from, double to, int depth = 16) const {
        const Sum few = is_rough_ ? piece(on, from, to, kTwoAbscissae, kTwoWeights)
                                  : piece(on, from, to, kFewAbscissae, kFewWeights);
        const Sum sum = is_rough_ ? piece(on, from, to, kFewAbscissae, kFewWeights)
                                  : piece(on, from, to, kAbscissae, kWeights);
        const double near_enough = is_rough_ ? 3e-3 : 1e-6;
        if (depth == 0 || std::abs(sum.area - few.area) <= near_enough * std::abs(sum.area))
            return sum;
        const double middle = 0.5 * (from + to);
        return plus(in_pieces(on, from, middle, depth - 1), in_pieces(on, middle, to, depth - 1));
    }

    template <typename On, std::size_t N>
    Sum piece(const On& on, double from, double to, const std::array<double, N>& abscissae,
              const std::array<double, N>& weights) const {
        const double width = to - from;
        Sum sum;
        for (std::size_t k = 0; k < N; ++k) {
            for (const double sign : {-1.0, 1.0}) {
                const CharacteristicPoint stroke =
                    on(from + 0.5 * (1.0 + sign * abscissae[k]) * width);
                const ClosestPoint& there = stroke.closest;
                const double ahead = there.bend / norm(there.drift);
                const double area = 0.5 * width * weights[k] * stroke.pace * ahead;
                const Vec3 w = stroke.p - apex_;
                const double volume = area * dot(w, there.normal);
                sum = plus(sum, {area, volume, volume * w});
            }
        }
        return sum;
    }

    const Sweep& sweep_;
    Vec3 apex_;
    bool is_rough_;
};

}  // namespace ncsim::brep
