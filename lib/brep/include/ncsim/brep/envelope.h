// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an element of a tool's profile leaves along a motion: the envelope of the surfaces that it
// turns into about the tool's axis, at all times. It touches each of them along its characteristic,
// where the tool moves neither into the material nor away from it (Chiou and Lee, Swept surface
// determination for five-axis numerical control machining, 2002). mm, frame W.
#pragma once

#include "ncsim/brep/sweep.h"

#include <memory>
#include <optional>

namespace ncsim::brep {

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
Aspect aspect_at(const Sweep& sweep, double t, Vec3 p);
/// The same without the time.
Aspect aspect_at(const Sweep& sweep, const Passage& at, Vec3 p);
/// At the time when it is nearest: the distance from the envelope is that from the element. Beyond
/// the ends the way goes on as it did.
Aspect place_on(const Envelope& envelope, Vec3 p);
/// The same from near that time on, as that of a place beside it: no other one is looked for.
Aspect place_on(const Envelope& envelope, Vec3 p, double near_time);

/// The last point of those that are looked at one after the other: when a tool was nearest to it,
/// and how that changes. The time of the next one, beside it, is looked for from there.
struct Beside {
    std::optional<double> time;
    Vec3 at, slope;
};
Aspect place_on(const Envelope& envelope, Vec3 p, Beside& beside);

/// Of the sine by which its normal rises against the axis.
Vec3 gradient_of_rise(const Sweep& sweep, const Aspect& aspect);

/// How high the element is there, above the tip: the centre of the ring, or the point on the axis
/// in which the normal of a flank ends.
double height_of_centre(const Sweep& sweep, const Aspect& aspect);

/// Places across the way, along the characteristic. Of fillets degrees around it, from `up` to
/// `side`, in [0, 360): 180 is below the tool, as a rule. Of flanks mm along the profile, from as
/// far below the lower end as it is long; negative to the right of the way.
double place_across(const Sweep& sweep, const Passage& passage, Vec3 p);
/// The point that is there.
Vec3 point_across(const Sweep& sweep, const Passage& passage, double place);
/// The point of the characteristic of a fillet whose normal is at such an angle, as seen along the
/// way.
Vec3 point_with_normal(const Sweep& sweep, const Passage& passage, double degrees);

/// Of a fillet: nothing of it is as steep as the tool's axis, so that it has an up and a down, and
/// a ring goes up all the way, or down, and its flat end level nowhere. Of a flank: it has a left
/// and a right somewhere at all times.
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
