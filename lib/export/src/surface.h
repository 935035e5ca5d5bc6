// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a renderer knows about a flat face once it is drawn: its plane and its colour. The
// graphics library only decides which surface is seen at which sample; shading and lines are
// computed from this table (deferred shading), so they are the same for both renderers.
#pragma once

#include "ncsim/cda/vec.h"

#include "palette.h"

#include <cstdint>
#include <vector>

namespace ncsim::exporter {

/// Lengths in mm, in the camera's frame C: x to the right, y up, z towards the eye, the
/// target at the origin.
struct Surface {
    cda::Vec3 n_C;          ///< Unit, out of the material, towards the eye.
    double offset = 0.0;    ///< n_C · x == offset on the surface.
    LinearColour colour;    ///< Of the material, before any light.
    bool by_depth = false;  ///< The colour depends on the height of each point instead.
    bool is_line = false;   ///< Drawn over the part: neither light nor edges.
};

/// Number of a surface in the table; 0 is the background, surface i has the number i + 1.
using SurfaceId = std::uint32_t;
inline constexpr SurfaceId kBackground = 0;

}  // namespace ncsim::exporter
