// SPDX-License-Identifier: GPL-3.0-or-later
//
// A round body on its way: for models that would rather have that than its polytope.
#pragma once

#include "ncsim/cda/origin.h"
#include "ncsim/cda/vec.h"

namespace ncsim::cda {

/// What an upright round tool passes over as it moves straight ahead: a cylinder that ends below in
/// a disc (flat end mills), a quarter circle (ball nose: flat_radius 0; bull nose) or a cone
/// between the disc and the cylinder (drills, V-cutters). mm, frame W.
struct RoundSweep {
    double radius = 0.0;       ///< Of the cylinder.
    double height = 0.0;       ///< Of all of it.
    double flat_radius = 0.0;  ///< Of the disc at its lower end, at most `radius`; 0: none.
    double tip_height = 0.0;   ///< From the disc to the cylinder; 0: a flat end.
    /// Is it straight between the disc and the cylinder? Else a quarter circle: `tip_height` is
    /// radius - flat_radius.
    bool is_cone = false;
    Vec3 from, to;  ///< Its lowest point on its axis.
    Box bounds;     ///< Encloses what it passes over.
    Origin origin = kStockOrigin;
};

}  // namespace ncsim::cda
