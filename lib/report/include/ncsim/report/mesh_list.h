// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of a surface that stands in several of them.
#pragma once

#include "ncsim/cda/vec.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace ncsim::report {

struct MeshFile {
    std::string file;    ///< As seen from the list.
    std::string sha256;  ///< Of its bytes, in hexadecimal.
    cda::Box box;        ///< In W, mm.
    std::size_t faces = 0;
    std::size_t open_edges = 0;  ///< Of triangles, each with its partner in another file.
};

/// JSON, a file a line.
void write_mesh_list(std::ostream& out, const std::string& program, cda::Vec3 centre,
                     const std::vector<MeshFile>& files);

}  // namespace ncsim::report
