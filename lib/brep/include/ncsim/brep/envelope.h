// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an element of a tool's profile leaves along a motion: the envelope of the surfaces that it
// turns into about the tool's axis, at all times. It touches each of them along its characteristic,
// where the tool moves neither into the material nor away from it (Chiou and Lee, Swept surface
// determination for five-axis numerical control machining, 2002). mm, frame W.
#pragma once

#include "ncsim/cda/vec.h"

#include <array>
#include <functional>
#include <memory>
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
/// ring and height above the tip of its centre; radius of the circle.
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

/// Sweeps do not change: envelopes of one share it.
struct Envelope {
    std::shared_ptr<const Sweep> sweep;
    bool operator==(const Envelope& o) const { return *sweep == *o.sweep; }
};

/// All points at which the element, at one time, moves neither towards them nor away: it crosses
/// the envelope, and the element of that time, along their common characteristic. Faces do not lie
/// on it.
struct Characteristic {
    Envelope of;
    double t = 0.0;
    bool operator==(const Characteristic&) const = default;
};

/// All points for which the normal of the envelope where it is nearest rises against the tool's
/// axis by the angle with this sine: it crosses the envelope in what one point of the profile
/// leaves. Faces do not lie on it.
struct Trail {
    Envelope of;
    double rise = 0.0;
    bool operator==(const Trail&) const = default;
};

/// How the element looks from a point at one time.
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
Aspect aspect_at(const Sweep& sweep, double t, Vec3 p);
/// The same without the time.
Aspect aspect_at(const Sweep& sweep, const Passage& at, Vec3 p);
/// At the time when it is nearest: the distance from the envelope is that from the element. Beyond
/// the ends the way goes on as it did.
Aspect place_on(const Envelope& envelope, Vec3 p);

/// The gradient of `t` of the nearest aspect.
Vec3 gradient_of_time(const Aspect& aspect);
/// Of the sine by which its normal rises against the axis.
Vec3 gradient_of_rise(const Sweep& sweep, const Aspect& aspect);

/// Directions around the way of the ring's centre, or of the lower end of a flank: `up` is where
/// the tool's axis points, across the way.
struct Around {
    Vec3 centre, ahead, up, side;  ///< Unit, right-handed in this order, but for the centre.
};
Around around(const Sweep& sweep, const Passage& passage);
/// Where the point of the axis goes that is at such a height above the tip, mm for all of the way.
Vec3 velocity_at(const Passage& passage, double height);
/// How high the element is there, above the tip: the centre of the ring, or the point on the axis
/// in which the normal of a flank ends.
double height_of_centre(const Sweep& sweep, const Aspect& aspect);

/// Places across the way, along the characteristic. Of fillets degrees around it, from `up` to
/// `side`, in [0, 360): 180 is below the tool, as a rule. Of flanks mm along the profile, from as
/// far below the lower end as it is long; negative to the right of the way.
double place_across(const Sweep& sweep, const Passage& passage, Vec3 p);
/// The point that is there: of balls on any way, of rings while the axis does not turn.
Vec3 point_across(const Sweep& sweep, const Passage& passage, double place);
/// The point of the characteristic of a fillet whose normal is at such an angle.
Vec3 point_with_normal(const Sweep& sweep, const Passage& passage, double degrees);

/// Of a fillet: nothing of it is as steep as the tool's axis, so that it has an up and a down. Of a
/// flank: it has a left and a right somewhere at all times.
bool has_across(const Sweep& sweep);
/// Of a flank: the tool pivots about a point near there, so that left becomes right.
bool is_at_pivot(const Sweep& sweep, const Aspect& aspect);

/// The largest radius of curvature, nearly.
double largest_radius(const Sweep& sweep);

/// Are they the same piece of the tool, or go on as such?
bool is_same(const Meridian& a, const Meridian& b, double tolerance_mm);
/// Do they leave the same, whatever the times?
bool is_same(const Envelope& a, const Envelope& b, double tolerance_mm);

}  // namespace ncsim::brep
