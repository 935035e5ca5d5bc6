// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facets whose corners have been moved off their plane.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// A flat face with straight edges alone that is farther off its plane than polyhedra are (1e-4
/// mm), at one of its corners?
bool is_nonplanar(const Part& part, const Face& face);

/// Facets that are get the plane of all their corners, if they have one. Of others what is between
/// corners off the plane and their neighbours becomes triangles, each in its own plane, as round as
/// can be, and what is left stays in the plane that it had; seen from above all of them cover what
/// the facet did. Where its loops cross, seen so, it stays as it is. Faces are added at the end,
/// and to the shell that has the facet; of each of them: which one it was part of. O(n) for n edges
/// of a part in which nothing is warped, else O(n log n).
std::vector<std::uint32_t> triangulate_nonplanar_faces(Part& part);

}  // namespace ncsim::brep
