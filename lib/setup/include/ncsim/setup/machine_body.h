// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/machine/chain.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::setup {

/// A link of a machine; one without triangles has a name only.
struct MachineBody {
    std::string link;
    std::string parent;                   ///< Which link carries it; empty: the bed.
    std::optional<machine::Joint> joint;  ///< Between both, as it moves this one.
    cda::TriangleMesh mesh;               ///< Closed; machine coordinates with all joints at 0, mm.
    std::array<std::uint8_t, 3> colour{170, 178, 190};  ///< sRGB.
    bool is_transparent = false;                        ///< In pictures.
    /// What moves it, from the bed on: each joint as it moves the link itself.
    machine::Chain moved_by;
    double clearance_mm = 0.0;   ///< All else is to stay this far away.
    double deflection_mm = 0.0;  ///< How far the mesh may be from what its file means.
    std::string mesh_at{};       ///< Where the mesh was told: "mill.toml:12:1".
    bool as_hull = false;        ///< What it may meet is asked of its convex hull.
    std::string assumed{};       ///< Assumptions of the run that wrote the mesh; empty: none.
};

/// Its corners with the joints at `values`, machine coordinates.
std::vector<cda::Vec3> corners_at(const MachineBody& body, const machine::Values& values);

/// A place of the machine as the part has it that `moved_by` moves: where it was with all joints at
/// 0.
cda::Vec3 on_part(const machine::Chain& moved_by, const machine::Values& values, cda::Vec3 p_M);

}  // namespace ncsim::setup
