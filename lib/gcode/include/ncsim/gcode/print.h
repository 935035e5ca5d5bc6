// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints blocks and motions as text, one line each, for tests and `ncsim parse`. Equal values give
// equal bytes on every platform.
#pragma once

#include "ncsim/gcode/block.h"
#include "ncsim/gcode/motion.h"

#include <string>

namespace ncsim::gcode {

/// Appends `block` in a canonical spelling, without a line end:
///
///     "n10 g01x1 y.5(go)"   ->   N10 G1 X1 Y0.5 (go)
void print(std::string& out, const Block& block);

/// Appends `motion` in millimetres and degrees, without a line end:
///
///     L12 feed X10 Y0 Z-1 F300 T1
///
/// Default values are omitted: rotary axes at 0, a known start, feed per minute. Lengths are
/// rounded to 1e-9 mm.
void print(std::string& out, const Motion& motion);

/// Appends the shortest text that reads back as `value`; never "-0". Uses an exponent only if
/// |value| ≥ 1e15 or 0 < |value| ≤ 1e-9.
void print_number(std::string& out, double value);

}  // namespace ncsim::gcode
