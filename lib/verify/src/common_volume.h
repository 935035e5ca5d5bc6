// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much two closed surfaces enclose in common.
#pragma once

#include "ncsim/cda/mesh.h"

#include <optional>

namespace ncsim::verify {

/// Volume (mm³) of the intersection of what the two closed, oriented surfaces enclose, neither of
/// which may cross itself; touching is allowed. Every decision is exact, so nothing is lost where
/// they are nearly in one plane, only rounding of the corners remains; so that there are no
/// coincidences, `b` is moved by 0.1 nm before, which is worth its area times that. Nothing, if
/// coincidences remain for all of a few such shifts. Expected O(n log n + pairs of triangles whose
/// boxes meet).
///
/// From the divergence theorem over the faces of the intersection, which are never put together:
/// each is known by the parts of its edges inside the other body and by the segments that the other
/// surface cuts out of it. In the spirit of Franklin, "Polygon properties calculated from the
/// vertex neighborhoods", 1987.
std::optional<double> common_volume(const cda::TriangleMesh& a, const cda::TriangleMesh& b);

}  // namespace ncsim::verify
