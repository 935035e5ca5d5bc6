// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces that go round an axis more than once.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// True if a face of a cylinder or a coil winds about its axis by more than a turn.
bool has_long_windings(const Part& part);

/// Divides faces of cylinders and coils that wind about their axis by more than a turn, such as
/// walls of helical grooves, into faces of at most half a turn. CAD readers trim by parameters that
/// repeat after a turn, so Boolean operations with an undivided face lose the part. Faces of coils
/// with more than one loop, and faces whose pieces would have faults, stay.
void split_long_windings(Part& part);

}  // namespace ncsim::brep
