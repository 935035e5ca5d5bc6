// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surface of the material in the plane of a cut.
#pragma once

#include "ncsim/mesh/open_mesh.h"

#include "render/surface.h"
#include "render/visibility.h"

namespace ncsim::exporter {

/// Returns the hatched surface in `plane`.
inline Surface cut_surface(const ScreenMap& map, const mesh::CutPlane& plane, LinearColour colour,
                           Pattern hatch) {
    Surface surface;
    surface.n_C = map.direction_in_camera(plane.normal);
    surface.offset = dot(surface.n_C, map.point_in_camera(plane.offset * plane.normal));
    surface.colour = colour;
    surface.pattern = hatch;
    return surface;
}

}  // namespace ncsim::exporter
