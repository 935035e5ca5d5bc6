// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where two surfaces meet in no curve that has a name.
#pragma once

#include "ncsim/brep/curve.h"
#include "ncsim/brep/surface.h"

#include <optional>
#include <vector>

namespace ncsim::brep {

/// A spline along both forms, which cross, within 1e-5 mm of either, tested in four places between
/// any two knots. `points` tell the way: the first and the last are its ends and on both forms,
/// others are near. Nothing if they touch somewhere on it, or the way is lost.
std::optional<Spline> spline_between(const Form& a, const Form& b, const std::vector<Vec3>& points);

}  // namespace ncsim::brep
