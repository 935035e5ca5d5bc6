// SPDX-License-Identifier: GPL-3.0-or-later
//
// Answers that every model derives from the boundary.
#include "ncsim/cda/workpiece.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/base/triangle_tree.h"
#include "ncsim/cda/triangulate.h"

#include <array>
#include <vector>

namespace ncsim::cda {

void WorkpieceModel::record_surface(SurfaceRecorder& recorder) const {
    const Boundary surface = boundary();
    const TriangleMesh mesh = triangulate(surface);
    // A single cell, with a hash that is unique to this state.
    std::vector<SurfaceRecorder::Cell> cells(1);
    cells[0].hash = extended({}, recorder.states());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const BoundaryFace& face = surface.faces[mesh.face[t]];
        std::array<Vec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = mesh.vertices[mesh.triangles[t][i]];
        cells[0].polygons.add(recorder.grid(), face.normal, face.origin, corners);
    }
    recorder.begin_state();
    recorder.replace_region(0, cells);
}

bool WorkpieceModel::contains(Vec3 point) const {
    const TriangleMesh mesh = triangulate(boundary());
    return TriangleTree(mesh).contains(point);
}

}  // namespace ncsim::cda
