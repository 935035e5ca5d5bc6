// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces that a renderer draws: the plane and the colour of a flat face and, for a facet of a
// round surface, the change of its normal; for a triangle with distances, the change of these. The
// renderer only decides which surface is seen at which sample. Shading and lines are computed from
// this table (deferred shading), so they are the same for both renderers.
#pragma once

#include "ncsim/base/vec3.h"

#include "render/palette.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::exporter {

/// Colour of the points of a surface.
enum class Pattern : std::uint8_t {
    Plain,      ///< Surface::colour.
    Depth,      ///< The colour of the height of each point.
    Distance,   ///< The colour of the distance of each point from the design.
    PartHatch,  ///< Surface::colour without light, with lines at 45° in the plane of the cut.
    BodyHatch,  ///< The same, with lines across those of PartHatch.
};

/// Plane and colour of a drawn face. Lengths are in mm, in the camera frame C: x to the right, y
/// up, z towards the eye, the target at the origin.
struct Surface {
    Vec3 n_C;             ///< Unit normal, out of the material, towards the eye.
    double offset = 0.0;  ///< n_C · x == offset on the surface.
    LinearColour colour;  ///< Colour of the material without light.
    Pattern pattern = Pattern::Plain;
    bool is_line = false;  ///< True: drawn over the part, without light and edges.
    /// True: darker in recesses, and makes recesses (RecessShade).
    bool has_shade = false;
    /// 1 + the index of the Bend of a round surface; 0: flat.
    std::uint32_t bend = 0;
    /// For Pattern::Distance, the index of the Ramp.
    std::uint32_t ramp = 0;
};

/// Shares of the second and the third corner of a triangle in its points, in the camera frame C.
class CornerShares {
public:
    explicit CornerShares(const std::array<Vec3, 3>& corners_C);

    /// Returns the shares in the point of the triangle nearest to `p_C`.
    /// Requires: `p_C` is in the plane of the triangle.
    std::pair<double, double> at(Vec3 p_C) const;

private:
    // Dot products with the last two give a point's shares of both sides.
    Vec3 corner_, to_second_, to_third_;
};

/// Interpolated normals of a triangle, in the camera frame C.
class Bend {
public:
    /// `n_C` are unit normals in the corners; zero for a corner without a normal, near which the
    /// normals of the remaining corners count.
    Bend(const std::array<Vec3, 3>& corners_C, const std::array<Vec3, 3>& n_C);

    /// Returns the unit normal at the point of the triangle nearest to `p_C`.
    /// Requires: `p_C` is in the plane of the triangle.
    Vec3 normal_at(Vec3 p_C) const;

private:
    CornerShares shares_;
    Vec3 n_, towards_second_, towards_third_;
};

/// Interpolated distances (mm) of the points of a triangle from the design.
class Ramp {
public:
    Ramp(const std::array<Vec3, 3>& corners_C, const std::array<double, 3>& values)
        : shares_(corners_C), values_(values) {}

    /// Returns the distance at the point of the triangle nearest to `p_C`.
    /// Requires: `p_C` is in the plane of the triangle.
    double value_at(Vec3 p_C) const;

private:
    CornerShares shares_;
    std::array<double, 3> values_;
};

/// Surfaces of a picture.
struct SurfaceTable {
    std::vector<Surface> surfaces;
    std::vector<Bend> bends;
    std::vector<Ramp> ramps;
};

/// Number of a surface in the table; 0 is the background, surface i has the number i + 1.
using SurfaceId = std::uint32_t;
inline constexpr SurfaceId kBackground = 0;

}  // namespace ncsim::exporter
