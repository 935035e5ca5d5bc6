// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed surfaces from files, as CAD systems export them: fixtures, designs.
#pragma once

#include "ncsim/cda/mesh.h"
#include "ncsim/setup/input.h"

#include <string>

namespace ncsim::setup {

/// Reads STL, binary or text, with lengths in mm, or binary glTF 2.0 (.glb; metres with y up, which
/// become millimetres with z up: what ncsim run --gltf writes comes back where it was). What it is,
/// its first bytes tell. Corners with the same coordinates become one; triangles without area that
/// this leaves are dropped.
///
/// Throws std::runtime_error, naming the file, if it cannot be read, is neither of them, uses what
/// is not understood (compressed meshes), or if its surface is not closed (every edge has as many
/// triangles on one side as on the other; surfaces may touch) or turned inside out.
cda::TriangleMesh read_mesh_file(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
