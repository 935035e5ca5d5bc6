// SPDX-License-Identifier: GPL-3.0-or-later
//
// List of the files of a surface that is split into several files.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace ncsim::report {

/// A file of the list.
struct MeshFile {
    std::string file;    ///< Path relative to the list.
    std::string sha256;  ///< Digest of the bytes, in hexadecimal.
    Box box;             ///< Extents in W, mm.
    std::size_t faces = 0;
    std::size_t open_edges = 0;  ///< Edges of triangles whose partner is in another file.
};

/// Writes JSON, a line for each file.
void write_mesh_list(std::ostream& out, const std::string& program, Vec3 centre,
                     const std::vector<MeshFile>& files);

}  // namespace ncsim::report
