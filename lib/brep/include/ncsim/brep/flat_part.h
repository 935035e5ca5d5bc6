// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts made of facets alone, written if true surfaces are not requested or cannot be found.
#pragma once

#include "ncsim/brep/facets.h"
#include "ncsim/brep/part.h"

#include <functional>

namespace ncsim::brep {

/// True if CAD readers accept `part`, which has planes and straight edges only.
/// Requires: all faces are planes, all edges lines.
/// Returns: true if the part is closed (each edge is used twice, in opposite directions, and loops
/// are connected); no face is narrower than its corners are off adjacent planes; no loops cross,
/// come within 2e-7 mm of each other or have the wrong orientation; and the volume is `volume_mm3`
/// within 1e-4 mm times the area.
/// Cost: O(n log n) for n evenly distributed edges.
bool is_sound_polyhedron(const Part& part, double volume_mm3);

/// Result of flat_part().
struct FlatPart {
    Part part;
    double tolerance_factor = 1.0;  ///< Factor of the tolerance within which facets were joined.
    /// False if even the coarsest attempt is unsound; `part` is then the finest.
    bool is_sound = true;
};

/// Returns the facets as a part with the vertices kept apart (vertex_distance.h). `facets` returns
/// the facets joined within `times` a tolerance; the factors tried are 1 and, if the result is
/// unsound, 4, 16 and 64.
FlatPart flat_part(const std::function<Facets(double times)>& facets);

}  // namespace ncsim::brep
