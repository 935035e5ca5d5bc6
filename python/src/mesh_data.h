// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surface of a part as triangles, with the motion that cut each of them.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/mesh/provenance.h"

#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::python {

/// Triangles of a part, mm. All lists have an element for each triangle of `mesh`.
struct MeshData {
    TriangleMesh mesh;
    std::vector<std::uint32_t> lines;  ///< Line of the program that cut the triangle; 0: the stock.
    std::vector<std::uint32_t> tools;  ///< Number of the tool; 0: the stock.
    double volume = 0.0, area = 0.0;   ///< mm³, mm²
    std::uint32_t shells = 0;          ///< Number of closed surfaces.
    unsigned threads = 0;
    std::string assumed;  ///< Provenance::assumed.
};

/// Triangulates `boundary`.
MeshData mesh_data(const cda::Boundary& boundary, const mesh::Provenance& provenance,
                   unsigned threads);

/// Adds the class Mesh to `module`.
void define_mesh(pybind11::module_& module);

}  // namespace ncsim::python
