// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coordinate systems G54 … G59.3 and G54.1 Pn, numbered as in gcode::MachineState::system, and
// their origins.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/interpreter.h"

#include <optional>
#include <string>

namespace ncsim::setup {

/// Returns the number of "G54", "G59.1" or "G54.1 P7"; empty for other names.
std::optional<int> system_named(const std::string& name);
/// Returns the name of coordinate system `system`.
std::string name_of_system(int system);

/// Sets the origin of a coordinate system, in machine coordinates, mm.
void tell_offset(gcode::InterpreterOptions& options, int system, Vec3 origin);
/// Returns the specified origin in machine coordinates, mm; empty if unspecified.
std::optional<Vec3> origin_of(const gcode::InterpreterOptions& options, int system);

}  // namespace ncsim::setup
