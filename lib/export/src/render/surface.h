// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a renderer knows about a flat face once it is drawn: its plane, its colour, and, if it
// stands for a piece of something round, how that is bent. The graphics library only decides which
// surface is seen at which sample; shading and lines are computed from this table (deferred
// shading), so they are the same for both renderers.
#pragma once

#include "ncsim/cda/vec.h"

#include "render/palette.h"

#include <array>
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
    /// Of a round one, 1 + the index of how its normals go; 0: it is flat.
    std::uint32_t bend = 0;
};

/// How the normals of a triangle go from corner to corner. Frame C.
class Bend {
public:
    /// `n_C`: unit, in the corners; zero in one that has none, from where those of the others go.
    Bend(const std::array<cda::Vec3, 3>& corners_C, const std::array<cda::Vec3, 3>& n_C);

    /// In its point nearest to `p_C`, which lies in its plane; unit.
    cda::Vec3 normal_at(cda::Vec3 p_C) const;

private:
    cda::Vec3 corner_, to_second_, to_third_;  // a point's shares of both sides: dot products
    cda::Vec3 n_, towards_second_, towards_third_;
};

/// What is drawn.
struct SurfaceTable {
    std::vector<Surface> surfaces;
    std::vector<Bend> bends;
};

/// Number of a surface in the table; 0 is the background, surface i has the number i + 1.
using SurfaceId = std::uint32_t;
inline constexpr SurfaceId kBackground = 0;

}  // namespace ncsim::exporter
