// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plane at which a picture shows bodies cut open.
#pragma once

#include "ncsim/cda/vec.h"

namespace ncsim::exporter {

/// Plane that cuts bodies open. Points with normal · x > offset are removed; mm, W.
struct CutPlane {
    cda::Vec3 normal;  ///< Unit vector towards the removed half.
    double offset = 0.0;
};

}  // namespace ncsim::exporter
