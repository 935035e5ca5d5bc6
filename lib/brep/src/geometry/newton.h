// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method for points that several surfaces have in common.
#pragma once

#include "ncsim/brep/surface_forms.h"

#include <span>

namespace ncsim::brep {

/// Moves `p` to a common point of all forms, the nearest as far as Newton's method finds that
/// point. If the forms have no common point, `p` moves as near to all forms as possible.
/// Returns: the largest distance from a form, mm.
double solve(std::span<const Form* const> forms, Vec3& p);
/// Does the same, starting from the state of the last point on each form.
double solve(std::span<const Form* const> forms, Vec3& p, std::span<ProjectionSeed> seeds);

}  // namespace ncsim::brep
