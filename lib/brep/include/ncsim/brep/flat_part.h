// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facets alone: what is written where true surfaces are not asked for, or cannot be had.
#pragma once

#include "ncsim/brep/facets.h"
#include "ncsim/brep/part.h"

#include <functional>

namespace ncsim::brep {

/// Is a part of planes with straight edges alone one that readers find nothing wrong with? It is
/// closed: loops go from corner to corner, along each edge twice, in opposite directions. None of
/// its planes is narrower than its corners are off those around them, or has loops that cross,
/// touch within 2e-7 mm or go round the wrong way. Its volume is `volume_mm3`, within 1e-4 mm times
/// its area. O(n log n) for n edges that are spread evenly.
bool is_sound_polyhedron(const Part& part, double volume_mm3);

struct FlatPart {
    Part part;
    double coarser = 1.0;  ///< Facets were joined within so many times the tolerance.
    bool is_sound = true;  ///< False: not even the coarsest are, so these are the finest.
};

/// Facets as a part, kept apart (apart.h). `facets` are those that are joined within so many times
/// a tolerance of theirs: once; where that is not sound, 4, 16 and 64 times.
FlatPart flat_part(const std::function<Facets(double times)>& facets);

}  // namespace ncsim::brep
