// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sweep of a round body, for models that use the sweep directly instead of a polytope.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/origin.h"

namespace ncsim::cda {

/// The volume that an upright round tool covers on a straight motion. The tool is a cylinder that
/// ends below in a disc (flat end mill), a quarter circle (ball end mill with `flat_radius` 0, or
/// bull-nose end mill) or a cone between disc and cylinder (drill, V-cutter). In mm, workpiece
/// frame.
struct RoundSweep {
    double radius = 0.0;  ///< Radius of the cylinder.
    double height = 0.0;  ///< Height of the whole tool.
    /// Radius of the disc at the lower end, at most `radius`; 0: no disc.
    double flat_radius = 0.0;
    double tip_height = 0.0;  ///< Height from the disc to the cylinder; 0: a flat end.
    /// True if the profile between disc and cylinder is a straight line. Otherwise the profile is a
    /// quarter circle, and `tip_height` is radius - flat_radius.
    bool is_cone = false;
    Vec3 from, to;  ///< Positions of the tip.
    Box bounds;     ///< Box around the volume.
    Origin origin = kStockOrigin;
};

}  // namespace ncsim::cda
