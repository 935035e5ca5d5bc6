// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spline patches for faces on surfaces that file formats can store only as splines.
#pragma once

#include "ncsim/brep/part.h"
#include "ncsim/brep/spline_surface.h"

namespace ncsim::brep {

/// True if files store the form as a spline: domes, coils, spirals and envelopes.
inline bool is_spline_in_files(const Form& form) {
    return std::holds_alternative<Dome>(form) || std::holds_alternative<Coil>(form) ||
           std::holds_alternative<Spiral>(form) || std::holds_alternative<Envelope>(form);
}

/// Returns the part of a spline surface on which a face lies.
/// Requires: is_spline_in_files(face.surface.form).
/// Returns:
/// - For domes and coils, a patch of degree 5 within 6e-10 of the radii. The parameters are the
///   angles around the circle and along the path. On a coil the patch has only the half of the
///   circle ahead or behind, whichever has the face, and the half turns with the path. The patch
///   ends with the face where an edge runs along that end (coils: a level circle), and extends 4
///   degrees beyond the face elsewhere.
/// - For spirals, the wall to 4 degrees beyond the face and 5 % higher and lower, within 2e-9 of
///   the radius.
/// - For envelopes, the surface around and along the path, a little beyond the face, within 3e-8 mm
///   or as near as 400 knots in each direction allow.
Patch patch_of(const Part& part, const Face& face);

}  // namespace ncsim::brep
