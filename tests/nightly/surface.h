// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a surface of polygons or triangles says about itself, computed the obvious way.
#pragma once

#include "nightly/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ncsim::nightly {

struct Surface {
    std::vector<Vec> vertices;
    /// Of faces, outlines and holes alike; indices of vertices.
    std::vector<std::vector<std::uint32_t>> loops;
};

/// Does each directed edge stand once, and once in the other direction?
bool is_closed(const Surface& surface);

/// mm³, by the divergence theorem.
double enclosed_volume(const Surface& surface);

/// How often a surface of triangles goes round the point: 1 inside, 0 outside. Oosterom and
/// Strackee, The Solid Angle of a Plane Triangle, 1983.
double winding_number(const Surface& triangles, const Vec& p);

}  // namespace ncsim::nightly
