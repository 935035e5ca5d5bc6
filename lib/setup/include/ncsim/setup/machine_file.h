// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machine files (TOML): description of a machine. Unknown values are left out. The keys with their
// units, ranges and meanings are in docs/schemas/machine.schema.json, which the reader uses, and in
// docs/reference/files/machine.md.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/machine_body.h"
#include "ncsim/setup/specified_kinematics.h"
#include "ncsim/verify/machine_description.h"
#include "ncsim/verify/setup.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::setup {

/// Content of a machine file.
struct MachineFile {
    /// Limits and positions of the machine. The position of the workpiece in the machine also
    /// depends on the program.
    verify::MachineDescription machine;
    std::map<int, Vec3> offsets;  ///< By MachineState::system, machine coordinates, mm.
    std::optional<Vec3> start;    ///< Initial tool position, machine coordinates.
    std::optional<SpecifiedKinematics> kinematics;
    std::vector<MachineBody> bodies;       ///< Links with a mesh.
    std::vector<MachineBody> other_links;  ///< Links without a mesh.
    std::string part_link, tool_link;  ///< Links that carry the part and the tool, if specified.
    /// Joints that move the part and the tool, as in MachineBody::moved_by.
    machine::Chain part_moved_by, tool_moved_by;
    /// Pairs without collision check, and adjacent pairs with collision check.
    std::vector<verify::NamePair> ignored, checked_neighbours;
    gcode::TipControl tip_control;
    gcode::TableOffsets fixture_offsets, setting_errors;
    std::array<gcode::RotaryWay, 3> rotary_ways{};  ///< For A, B and C.
    std::vector<gcode::RotaryClamp> clamps;
    /// Limits by tool number, without shapes.
    std::map<int, verify::ToolFacts> tools;
};

}  // namespace ncsim::setup
