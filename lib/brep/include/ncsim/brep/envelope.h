// SPDX-License-Identifier: GPL-3.0-or-later
//
// Envelope that an element of a tool's profile leaves along a motion. The element generates a
// surface of revolution about the tool's axis. The envelope touches that surface at each time along
// its characteristic, where the tool moves neither into the material nor away. mm, frame W.
// Source: Chiou and Lee, Swept surface determination for five-axis numerical control machining,
// 2002.
#pragma once

#include "ncsim/brep/profile_sweep.h"

#include <memory>
#include <optional>

namespace ncsim::brep {

/// Envelope of a sweep. Sweeps are immutable, so copies share the sweep.
struct Envelope {
    std::shared_ptr<const Sweep> sweep;
    bool operator==(const Envelope& o) const { return *sweep == *o.sweep; }
};

/// Surface of all points towards which the element at time `t` moves with speed 0. The surface
/// crosses the envelope, and the element at `t`, along their common characteristic. No face lies on
/// it.
struct Characteristic {
    Envelope of;
    double t = 0.0;
    bool operator==(const Characteristic&) const = default;
};

/// Surface of all points for which the envelope's normal at the nearest point makes an angle with
/// the tool's axis whose cosine is `rise`. The surface crosses the envelope along the trail of one
/// point of the profile. No face lies on it.
struct Trail {
    Envelope of;
    double rise = 0.0;
    bool operator==(const Trail&) const = default;
};

/// Returns the point of the element at time `t` that is closest to `p`, with distance and
/// derivatives.
ClosestPoint closest_point_at(const Sweep& sweep, double t, Vec3 p);
/// Returns the same for the tool position `at`; ClosestPoint::t stays 0.
ClosestPoint closest_point_at(const Sweep& sweep, const ToolFrame& at, Vec3 p);
/// Returns the closest point at the time when the element is nearest to `p`: the distance from the
/// envelope is the distance from the element at that time. The path is continued beyond its ends.
ClosestPoint project_onto(const Envelope& envelope, Vec3 p);
/// Returns the same, searched from `near_time` alone, the time of a nearby point. Straight paths,
/// and fillets other than balls, are searched as a whole.
ClosestPoint project_onto(const Envelope& envelope, Vec3 p, double near_time);

/// State for projecting consecutive points onto an envelope: the last point, the time when the tool
/// was nearest to it, and the gradient of that time. The search for the next point starts at the
/// extrapolated time.
struct ProjectionSeed {
    std::optional<double> time;
    Vec3 at, slope;
};
ClosestPoint project_onto(const Envelope& envelope, Vec3 p, ProjectionSeed& seed);

/// Returns the gradient of the sine by which the normal rises against the axis, per mm; zero for
/// flanks.
Vec3 gradient_of_rise(const Sweep& sweep, const ClosestPoint& closest);

/// Returns the height above the tip of the centre of the fillet's arc, or of the axis point at
/// which the normal of a flank in `closest.foot` ends, mm.
double height_of_centre(const Sweep& sweep, const ClosestPoint& closest);

/// Returns the coordinate of `p` across the path, along the characteristic.
/// - Fillets: degrees around the path, from `up` to `side` of path_frame(), in [0, 360); 180 is
/// usually
///   below the tool.
/// - Rims: degrees about the tool's axis (place_on_rim()).
/// - Flanks: flank length plus the distance from the lower end along the profile, mm; negative to
///   the right of the path.
double place_across(const Sweep& sweep, const ToolFrame& tool, Vec3 p);
/// Returns the point with the coordinate `place` of place_across().
Vec3 point_across(const Sweep& sweep, const ToolFrame& tool, double place);
/// Returns the point of a fillet's characteristic whose normal is at `degrees` around the path,
/// seen along the path.
Vec3 point_with_normal(const Sweep& sweep, const ToolFrame& tool, double degrees);

/// True if place_across() is well defined at all samples of the sweep.
/// - Fillets: the path is nowhere nearly parallel to the tool's axis. Unless the fillet is a ball,
///   the path also rises or falls everywhere, and the flat end is level nowhere.
/// - Flanks: the lower or the upper end has a contact on the left and on the right at each sample.
bool has_across(const Sweep& sweep);
/// True if the tool pivots about a point near the foot of a flank, where left becomes right.
bool is_at_pivot(const Sweep& sweep, const ClosestPoint& closest);

/// Returns the largest radius of curvature, nearly, mm.
double largest_radius(const Sweep& sweep);

/// True if both elements are arcs of equal radii, at any height, or segments of the same line of a
/// profile.
bool is_same(const Meridian& a, const Meridian& b, double tolerance_mm);
/// True if both sweeps leave the same surface, irrespective of direction and times.
bool is_same(const Envelope& a, const Envelope& b, double tolerance_mm);

}  // namespace ncsim::brep
