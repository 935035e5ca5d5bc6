// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions as JSON.
#pragma once

#include "ncsim/gcode/motion.h"

#include "json.h"

namespace ncsim::report {

/// Returns a motion in W, mm and degrees, with lengths rounded to 1e-9 mm.
Json to_json(const gcode::Motion& motion);

}  // namespace ncsim::report
