// SPDX-License-Identifier: GPL-3.0-or-later
//
// A round body on its way: for models that would rather have that than its polytope.
#pragma once

#include "ncsim/cda/origin.h"
#include "ncsim/cda/vec.h"

namespace ncsim::cda {

/// What an upright cylinder passes over as it moves straight ahead: with a flat lower end, or with
/// a half ball there. mm, frame W.
struct RoundSweep {
    double radius = 0.0;
    double height = 0.0;   ///< Of all of it, the half ball included.
    bool is_ball = false;  ///< Is its lower end a half ball?
    Vec3 from, to;         ///< Its lowest point on its axis.
    Box bounds;            ///< Encloses what it passes over.
    Origin origin = kStockOrigin;
};

}  // namespace ncsim::cda
