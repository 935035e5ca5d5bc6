// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spline edges as near to their surfaces as Booleans of readers need.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Adds knots to spline edges until they are within 5e-8 mm of both surfaces at four places between
/// adjacent knots. Recognition needs 1e-5 mm, but readers take 1e-7 mm for exact: edges that are
/// farther off are faults of their Boolean operations. Edges of facets, pieces whose ends are off
/// the surfaces, and edges that would cross others stay as they are.
void refine_splines(Part& part);

}  // namespace ncsim::brep
