// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools on their way, and elements of their profiles, which turn about the axes. mm, frame W.
#pragma once

#include "ncsim/cda/vec.h"

#include <array>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

namespace ncsim::brep {

using cda::Vec3;

/// A tool on its way, at a time t, from 0 at the start to 1 at the end: where its tip is, and where
/// its axis points (unit), with their first and second derivatives by t.
struct Passage {
    Vec3 tip, speed, change;
    Vec3 axis, turn, bend;
};

/// The tip is at from + t along, the axis stays as it is.
struct StraightWay {
    Vec3 from, along, axis;
    bool operator==(const StraightWay&) const = default;
};

/// The tip is at centre + (reach + growth w) (cos w ahead + sin w side) + lead w about, with w = t
/// swept and side = about x ahead; the axis stays as it is.
struct RoundWay {
    Vec3 centre, about, ahead;  ///< Of the start; both unit, at right angles.
    double reach = 0.0;
    double growth = 0.0, lead = 0.0;  ///< mm for each radian.
    double swept = 0.0;               ///< Radians, counter-clockwise about `about`.
    Vec3 axis;
    bool operator==(const RoundWay&) const = default;
};

/// Any way on which the axis may turn, from kBeyondEnds before t = 0 to as much after 1: what the
/// powers of s count for, from the 0th on, in X, Y, Z of the tip and of the axis; s goes from -1 to
/// 1 in that time.
struct TurningWay {
    std::vector<std::array<double, 6>> powers;
    bool operator==(const TurningWay&) const = default;
};
inline constexpr double kBeyondEnds = 0.25;

/// Where the tip of a tool is, and its axis.
struct TipAndAxis {
    Vec3 tip, axis;
};
/// The way through `pose`, a function of t from -kBeyondEnds on. Nothing where it misses what it
/// goes through between by more than 1e-9 mm, as turns of about a whole one do. 66 calls.
std::optional<TurningWay> turning_way(const std::function<TipAndAxis(double)>& pose);
Passage passage(const TurningWay& way, double t);

using ToolWay = std::variant<StraightWay, RoundWay, TurningWay>;

/// A piece of a circle: what turns about the axis is a piece of a ring, or of a ball. Radius of the
/// ring and height above the tip of its centre; radius of the circle, 0 of the rim of a flat end.
struct Fillet {
    double ring = 0.0, height = 0.0, radius = 0.0;
    bool operator==(const Fillet&) const = default;
};

/// A straight piece: what turns about the axis is a piece of a cylinder, or of a cone. Radius and
/// height above the tip of its lower end; its normal, outwards and along the axis, unit; how long
/// it is.
struct Flank {
    double radius = 0.0, height = 0.0;
    double cosine = 1.0, sine = 0.0;
    double length = 0.0;
    bool operator==(const Flank&) const = default;
};

using Meridian = std::variant<Fillet, Flank>;

/// An element on its way. Flanks on straight ways leave planes, which are no envelopes.
class Sweep {
public:
    Sweep(const Meridian& meridian, const ToolWay& way);

    const Meridian& meridian() const { return meridian_; }
    const Fillet* fillet() const { return std::get_if<Fillet>(&meridian_); }
    const Flank* flank() const { return std::get_if<Flank>(&meridian_); }
    /// A ball: of its fillet no ring is left.
    bool is_ball() const { return fillet() && fillet()->ring <= 0.0; }
    bool is_rim() const { return fillet() && fillet()->radius <= 0.0; }
    const ToolWay& way() const { return way_; }
    Passage at(double t) const;
    /// Some, at equal steps from 0 to 1, near enough to find the nearest one between them.
    const std::vector<Passage>& samples() const { return samples_; }
    double length_mm() const { return length_; }  ///< Of the way of the tip, nearly.

    bool operator==(const Sweep& o) const { return meridian_ == o.meridian_ && way_ == o.way_; }

private:
    Meridian meridian_;
    ToolWay way_;
    std::vector<Passage> samples_;
    double length_ = 0.0;
};

/// How an element looks from a point at one time.
struct Aspect {
    Passage passage;
    double t = 0.0;
    Vec3 foot;          ///< The point of it that is nearest.
    double off = 0.0;   ///< The distance from it, negative inside, mm.
    Vec3 normal;        ///< Unit, of it where it is nearest: the gradient of `off`.
    double rate = 0.0;  ///< The derivative of `off` by t,
    Vec3 drift;         ///< its gradient,
    double bend = 0.0;  ///< and its derivative by t.
};
/// The gradient of `t` of the nearest aspect.
Vec3 gradient_of_time(const Aspect& aspect);

/// Above the tip: of the point on the axis in which the normal ends that is so far along a flank.
double height_of_centre(const Flank& flank, double along);
/// The same of its lower end; of a fillet of the ring's centre.
double lowest_centre(const Sweep& sweep);

/// Directions around the way of the ring's centre, or of the lower end of a flank: `up` is where
/// the tool's axis points, across the way.
struct Around {
    Vec3 centre, ahead, up, side;  ///< Unit, right-handed in this order, but for the centre.
};
Around around(const Sweep& sweep, const Passage& passage);
/// Where the point of the axis goes that is at such a height above the tip, mm for all of the way.
Vec3 velocity_at(const Passage& passage, double height);

}  // namespace ncsim::brep
