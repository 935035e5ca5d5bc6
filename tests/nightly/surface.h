// SPDX-License-Identifier: GPL-3.0-or-later
//
// Properties of a surface of polygons or triangles, computed by simple methods.
#pragma once

#include "nightly/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ncsim::nightly {

struct Surface {
    std::vector<Vec> vertices;
    /// Vertex indices of outlines and holes of all faces.
    std::vector<std::vector<std::uint32_t>> loops;
};

/// True if each directed edge occurs once, and once in the opposite direction.
bool is_closed(const Surface& surface);

/// Returns the enclosed volume by the divergence theorem, mm³.
double enclosed_volume(const Surface& surface);

/// Returns the winding number of a triangle surface about the point: 1 inside, 0 outside.
/// Source: Oosterom and Strackee, The Solid Angle of a Plane Triangle, 1983.
double winding_number(const Surface& triangles, const Vec& p);

}  // namespace ncsim::nightly
