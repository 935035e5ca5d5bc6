// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part from which convex bodies at random were cut: no two of its planes are parallel, nothing is
// where a person would have put it.
#pragma once

#include "ncsim/cda/flat.h"
#include "ncsim/export/provenance.h"

namespace ncsim::exporter::test {

/// 40 × 30 × 10 less forty polytopes of up to twelve faces each. Always the same.
cda::FlatCda polytope_part();
/// Line i for the i-th of them, five tools by turns.
Provenance provenance_of_polytope_part();

}  // namespace ncsim::exporter::test
