// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of spline surfaces. mm, frame W.
#pragma once

#include "ncsim/brep/spline_surface.h"

#include <array>

namespace ncsim::brep {

/// A point of a patch with its derivatives.
struct PatchPoint {
    Vec3 at, by_around, by_along;
};

/// Returns the point at the parameters, which are limited to the patch.
PatchPoint point_of(const Patch& patch, double around, double along);

}  // namespace ncsim::brep
