// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collision of a body with the material. A body collides if the body meets the stock and is not
// within the removed space, whether or not the body meets removed space as well. Source: thesis
// 5.2, corrected.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/base/vec3.h"
#include "ncsim/cda/cell.h"
#include "ncsim/cda/flat.h"

#include <optional>

namespace ncsim::cda {

/// Returns a point (mm) inside both the convex `body` and the material, the certificate of a
/// collision; empty if the two touch at most. Exact: body ∩ P ⊄ ∪ Ni.
std::optional<Vec3> collision(const FlatCda& part, const Cell& body);

/// The same for a body of any shape, given by a closed, oriented surface. Corners are rounded to
/// the lattice. The convex hull of the body is tested first. If the hull meets material, two tests
/// decide: the surface passes through that piece of material, or a ray from the piece shows that
/// the piece lies inside the body.
/// Returns: a point (mm) in the material and in the body or on the body's surface.
std::optional<Vec3> collision(const FlatCda& part, const TriangleMesh& body);

}  // namespace ncsim::cda
