// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spline edges as near to their surfaces as Boolean operations of CAD readers need.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Adds knots to spline edges until each edge is within 5e-8 mm of both surfaces, measured at four
/// places between adjacent knots. Recognition needs 1e-5 mm, but CAD readers take 1e-7 mm for
/// exact, and edges farther off make Boolean operations of CAD readers fail. Edges of facets,
/// pieces whose ends are off the surfaces, and edges that would cross other edges stay unchanged.
void refine_splines(Part& part);

}  // namespace ncsim::brep
