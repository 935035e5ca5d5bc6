// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volume of the intersection of two closed surfaces.
#pragma once

#include "ncsim/base/triangle_mesh.h"

#include <optional>

namespace ncsim::verify {

/// Returns the volume (mm³) of the intersection of two bodies with closed, oriented surfaces;
/// touching is allowed. Every decision is exact, so nearly coplanar faces lose nothing; only the
/// rounding of corners remains. To avoid coincidences, `b` is shifted by 0.1 nm, which changes the
/// result by at most its area times the shift. Empty if coincidences remain for all of four shifts.
///
/// Method: divergence theorem over the faces of the intersection, which are not constructed. Each
/// face is given by the parts of its edges inside the opposite body and by the segments that the
/// opposite surface cuts out of the face.
/// Requires: neither surface crosses itself.
/// Cost: expected O(n log n + pairs of triangles whose boxes meet).
/// Source: after Franklin, "Polygon properties calculated from the vertex neighborhoods", 1987.
std::optional<double> common_volume(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace ncsim::verify
