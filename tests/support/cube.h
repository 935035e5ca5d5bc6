// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle mesh of a cube.
#pragma once

#include "ncsim/base/triangle_mesh.h"

namespace ncsim::test {

/// Returns a cube of 1 mm with two triangles per face: bottom, top, and the four sides in order.
inline TriangleMesh cube() {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                      {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    mesh.face = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
    return mesh;
}

}  // namespace ncsim::test
