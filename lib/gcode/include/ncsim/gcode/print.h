// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks and motions as text: what tests compare and `ncsim parse` shows. One line each,
// the same bytes for the same values everywhere.
#pragma once

#include "ncsim/gcode/block.h"
#include "ncsim/gcode/motion.h"

#include <string>

namespace ncsim::gcode {

/// Appends the block in one fixed spelling, without a line end:
///
///     "n10 g01x1 y.5(go)"   ->   N10 G1 X1 Y0.5 (go)
void print(std::string& out, const Block& block);

/// Appends the motion with millimetres, degrees and all its particulars, without a line end:
///
///     L12 feed X10 Y0 Z-1 F300 T1
///
/// Only what differs from the ordinary is told: rotary axes that are not 0, a start that is not
/// known, feed modes other than per minute. Lengths are rounded to 1e-9 mm.
void print(std::string& out, const Motion& motion);

/// The shortest text that reads back as `value`; never "-0", never an exponent for ordinary sizes.
void print_number(std::string& out, double value);

}  // namespace ncsim::gcode
