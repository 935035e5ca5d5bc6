// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters of the numbered cycles of Klartext.
#pragma once

#include <cstdint>

namespace ncsim::gcode::klartext {

/// True if parameter Q`q` with `value` changes the motions of `cycle` on the control, and ncsim
/// does not apply the parameter.
bool leaves_out(int cycle, std::uint32_t q, double value);

}  // namespace ncsim::gcode::klartext
