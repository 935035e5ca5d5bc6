// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact of two surfaces. Decisions depend on the forms, never on the angle at a point: an angle
// cannot distinguish tangency from some crossings.
#pragma once

#include "ncsim/brep/curve.h"
#include "ncsim/brep/surface_forms.h"

#include <optional>
#include <span>
#include <vector>

namespace ncsim::brep {

/// Returns a third form that crosses both surfaces along their curve of tangency, usually the plane
/// in which the tool stood; no value if the surfaces are not tangent along a curve.
std::optional<Form> tangency_surface(const Form& a, const Form& b);

/// Returns the plane through the centre of a dome across a wall. `forms` must have the dome, a
/// level plane and an upright plane, both tangent to the dome. The position along the wall is
/// undetermined by these three forms; the returned plane determines it. No value for all other
/// forms.
std::optional<Form> corner_of_dome(std::span<const Form* const> forms);

/// Returns upright planes through points of tangency in a level plane of `forms`. Domes, coils,
/// extrusions and upright cylinders meet the level plane in circles. Two circles, at most one from
/// a cylinder, or such a circle and an upright plane may be tangent there, although the forms cross
/// elsewhere. Each returned plane contains both centres of two tangent circles, or the centre of a
/// circle, perpendicular to the tangent upright plane.
std::vector<Form> level_tangency_planes(std::span<const Form* const> forms);

/// Returns the curve in which two forms meet, if the curve has a name: a line, a circle or an
/// ellipse. `p` is a point on both forms, `q` another point of the curve, and the curve passes by
/// `near_to`. No value if the curve must be a spline.
std::optional<Curve> intersection_curve(const Form& a, const Form& b, Vec3 p, Vec3 q, Vec3 near_to);

/// Returns tangency_surface() if the surfaces are tangent at `p` and `q`, within the distance at
/// which they are apart by the rounding of programs; surfaces may also cross far from their
/// contact.
std::optional<Form> tangency_surface_at(const Form& a, const Form& b, Vec3 p, Vec3 q);

}  // namespace ncsim::brep
