// SPDX-License-Identifier: GPL-3.0-or-later
//
// Form of a face, with the name and the dimensions that CAD systems use.
#pragma once

#include "ncsim/brep/surface_forms.h"
#include "ncsim/simulation/checked.h"

namespace ncsim::simulation {

/// Returns the form of `surface`, mm.
FaceForm form_of(const brep::Surface& surface);

}  // namespace ncsim::simulation
