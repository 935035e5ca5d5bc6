// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of a mesh in machine files, for links and fixtures.
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/setup/mesh_file.h"

#include "files/toml_reader.h"

#include <optional>
#include <string>

namespace ncsim::setup {

/// Mesh of a link or a fixture, in mm.
struct NamedMesh {
    SurfaceFile file;
    std::string place;     ///< Place of the key `mesh`.
    bool as_hull = false;  ///< True if the convex hull replaces the mesh.
};

/// Reads the keys `mesh`, or `stl`, `scale` and `hull` of a table; empty if no mesh is specified.
/// Files are relative to `folder`. A file without unit and without scale is in mm. A file whose
/// body would then be shorter than 5 mm is refused, because the unit is probably metres, and a body
/// of this size would never collide.
/// Throws: std::runtime_error with file, line and column.
std::optional<NamedMesh> read_mesh(const TomlReader& reader, const std::string& folder,
                                   InputSet& inputs, const TomlTable& table);

}  // namespace ncsim::setup
