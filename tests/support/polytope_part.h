// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part from which random convex bodies are cut: no two of its planes are parallel, and no
// position is regular.
#pragma once

#include "ncsim/cda/flat.h"
#include "ncsim/mesh/provenance.h"

namespace ncsim::test {

/// Returns 40 × 30 × 10 mm less forty polytopes of up to twelve faces each, the same in every call.
cda::FlatCda polytope_part();
/// Returns line i for polytope i, with five tools in turn.
mesh::Provenance provenance_of_polytope_part();

}  // namespace ncsim::test
