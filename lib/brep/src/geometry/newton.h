// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points that surfaces have in common.
#pragma once

#include "ncsim/brep/surface.h"

#include <span>

namespace ncsim::brep {

/// Moves `p` to a point of all forms, the nearest as far as Newton's method finds it. Where they
/// have none in common, as near to all of them as may be. Returns the largest distance.
double solve(std::span<const Form* const> forms, Vec3& p);
/// The same beside the last point of each form.
double solve(std::span<const Form* const> forms, Vec3& p, std::span<Beside> beside);

}  // namespace ncsim::brep
