// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does a body meet the material? Thesis 5.2, mended: a body that meets the stock and is not
// within what was milled collides, whether or not it meets milled space as well.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/flat.h"
#include "ncsim/cda/mesh.h"
#include "ncsim/cda/vec.h"

#include <optional>

namespace ncsim::cda {

/// A point (mm) inside both the convex `body` and the material: the certificate of a collision.
/// Nothing if they touch at most. Exact: body ∩ P ⊄ ∪ Ni.
std::optional<Vec3> collision(const FlatCda& part, const Cell& body);

/// The same for a body of any shape, given by its closed, oriented surface (corners are rounded to
/// the lattice). First its convex hull; where that meets material, whether the body itself does:
/// its surface passes through the piece of material, or a ray from the piece tells that it lies
/// inside. The certificate is in the material and in the body or on its surface.
std::optional<Vec3> collision(const FlatCda& part, const TriangleMesh& body);

}  // namespace ncsim::cda
