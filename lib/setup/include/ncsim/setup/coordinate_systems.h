// SPDX-License-Identifier: GPL-3.0-or-later
//
// G54 … G59.3 and G54.1 Pn: numbered as in gcode::MachineState::system, and where they lie.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/interpreter.h"

#include <optional>
#include <string>

namespace ncsim::setup {

/// "G54", "G59.1", "G54.1 P7" → its number; nothing if it is none.
std::optional<int> system_named(const std::string& name);
std::string name_of_system(int system);

/// Tells where a coordinate system lies in the machine (mm).
void tell_offset(gcode::InterpreterOptions& options, int system, cda::Vec3 origin);
/// Where it was told to lie; nothing if it was not.
std::optional<cda::Vec3> origin_of(const gcode::InterpreterOptions& options, int system);

}  // namespace ncsim::setup
