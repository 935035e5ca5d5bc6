// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed surfaces from STL files, binary or text: fixtures as CAD systems export them.
#pragma once

#include "ncsim/cda/mesh.h"

#include <string>

namespace ncsim::app {

/// Corners with the same coordinates become one; triangles without area that this leaves are
/// dropped. Lengths as in the file: mm. Throws std::runtime_error, naming the file, if it cannot be
/// read, is no STL, or its surface is not closed.
cda::TriangleMesh read_stl_file(const std::string& path);

}  // namespace ncsim::app
