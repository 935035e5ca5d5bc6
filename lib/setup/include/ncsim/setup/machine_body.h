// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of a machine's links.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/machine/chain.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::setup {

/// A link of a machine. A link without triangles has a name only.
struct MachineBody {
    std::string link;
    std::string parent;                   ///< Link that carries this link; empty for the bed.
    std::optional<machine::Joint> joint;  ///< Joint between both links, as a motion of this link.
    TriangleMesh mesh;                    ///< Closed; machine coordinates with all joints at 0, mm.
    std::array<std::uint8_t, 3> colour{170, 178, 190};  ///< sRGB.
    bool is_transparent = false;                        ///< In pictures.
    /// Joints that move the link, from the bed on, each as a motion of the link.
    machine::Chain moved_by;
    double clearance_mm = 0.0;  ///< Least distance from all further bodies.
    /// Largest distance between the mesh and the body that its file describes.
    double deflection_mm = 0.0;
    std::string mesh_at{};  ///< Place where the mesh was specified: "mill.toml:12:1".
    bool as_hull = false;   ///< True if the convex hull replaces the mesh in collision checks.
    std::string assumed{};  ///< Assumptions of the run that wrote the mesh; empty if none.
};

/// Returns the body's corners with the joints at `values`, in machine coordinates, mm.
std::vector<Vec3> corners_at(const MachineBody& body, const machine::Values& values);

/// Returns the point of the part that is at `p_M`, machine coordinates, with the joints at
/// `values`: its position with all joints at 0. `moved_by` moves the part.
Vec3 on_part(const machine::Chain& moved_by, const machine::Values& values, Vec3 p_M);

}  // namespace ncsim::setup
