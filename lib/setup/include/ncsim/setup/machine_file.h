// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machine files (TOML): description of a machine. Unknown values are left out.
//
//     name = "three-axis mill"
//     [travel]                       # machine coordinates, mm
//     x = [-500, 0]
//     y = [-400, 0]
//     z = [-450, 0]
//     a = [-110, 30]                 # degrees, for a machine with rotary axes
//     [rapid]                        # mm/min
//     x = 15000
//     y = 15000
//     z = 10000
//     [acceleration]                 # mm/s2
//     x = 3000
//     y = 3000
//     z = 2000
//     [spindle]
//     min = 100
//     max = 12000
//     [feed]
//     max = 8000
//     [position]                     # machine coordinates, mm
//     home = [0, 0, 0]               # target of G28
//     tool_change = [0, 0, 0]        # target of G30
//     start = [0, 0, 0]              # tool position at the start of a program
//     [offsets]                      # origins of coordinate systems, machine coordinates, mm
//     G54 = [-250, -200, -300]       # or work_zero = … under [position]
//     G55 = [-100, -200, -300]
//     "G54.1 P1" = [-50, -200, -300]
//     [time]
//     tool_change = 6.0              # s
//     junction_deviation = 0.01      # mm
//     below_stock = 5                # free space below the stock, mm; before the first [table]
//     path_deviation = 0.05          # largest deviation of the tip in a rotary feed move, mm
//     [[fixture]]                    # in the system of the first cut, mm; fixture = []: none
//     name = "vice"
//     offset = "G55"                 # coordinate system, if a different one
//     box = [[-60, -40, -20], [60, -30, 5]]
//     clearance = 2                  # or mesh = "vice.stl" (also: stl = …), as for a link; or
//                                    # vise = { … }, clamp = { … }: see docs/jobs.md
//     [[tool]]                       # limits of a tool
//     number = 3
//     max_feed = 600                 # mm/min
//     max_speed = 8000               # rpm
//     max_depth = 4                  # mm along the axis
//     max_engagement = 20            # mm3 per mm of path
//     max_removal_rate = 12000       # mm3/min
//     max_ramp = 3                   # degrees, for a tool that does not cut at its centre
//     blind_diameter = 6             # diameter about the axis that does not cut, mm
//     left_handed = false
//
// Kinematics: given by the name of a preset (before the first [table]), or by links from the bed to
// the part and to the tool. Without kinematics, A, B and C rotate about the program zero:
//
//     preset = "xyzac-trt"           # see ncsim/machine/presets.h
//     pivot = { A = [0, 20, 10], C = [0, 0, 0] }   # a point of each rotary axis: machine
//                                    # coordinates of the spindle nose at that point, mm
//     control = { m_codes = { M428 = "tip", M429 = "axes" }, tip_frame = "table" }
//                                    # tip_frame: G43.4 is known, too. orient = "positive": if
//                                    # two solutions give a direction, the solution whose first
//                                    # joint is at 0 or above; "negative"; "shortest" (default).
//                                    # kinematics = ["tip", "axes"]: of LinuxCNC's G12.1 P0, P1
//                                    # at_start = "tip": mode before any of these words
//                                    # fixture_offsets, fixture_offset_moves, setting_errors,
//                                    # setting_error_moves, setting_error_turns_axes: of Fanuc's
//                                    # G54.2 and G54.4, see docs/dialect.md
//     way = { C = "shortest" }       # effect of C10 if C is at 350: "linear" (-340), the
//                                    # default; "shortest" (+20, roll-over), "positive", "sign"
//                                    # (the sign is the direction, the size the position)
//     along_tool = "W"               # W (or U, V) moves the tip along the tool, by means of X, Y
//                                    # and Z, as in LinuxCNC's 5axiskins. No joint of its own
//     assumed = "…"                  # assumptions, in words; a doubt until removed
//     clamps = { B = ["M10", "M11"] }   # M10 clamps B, M11 releases B
//     part = { link = "platter" }
//     ignore = [["table", "way cover"]]   # pairs without collision check: links, fixtures,
//                                    # "tool", "part". Adjacent links are checked only if named in
//     ask = [["cradle", "platter"]]  # pairs with collision check
//     [spindle]
//     link = "head"
//     [[link]]
//     name = "cradle"
//     parent = "table"               # default: the bed
//     axis = "A"
//     turns_about = [1, 0, 0]        # or moves_along
//     through = [0, 20, 10]
//     travel = [-110, 30]
//     mesh = "cradle.stl"            # relative to this file: STL, OBJ, VRML97, GLB, STEP; closed,
//                                    # placed as with all axes at 0
//     scale = 1000                   # mm per unit of length in STL, OBJ and VRML; default: 1
//     hull = true                    # collision checks use the convex hull: for a mesh that
//                                    # crosses itself. Also for fixtures
//     colour = "#c08040"
//     clearance = 2                  # least distance from everything else, mm
//     positive = "part"              # rotates the part right-handed; default "tool" (ISO 841)
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
    std::map<int, cda::Vec3> offsets;  ///< By MachineState::system, machine coordinates, mm.
    std::optional<cda::Vec3> start;    ///< Initial tool position, machine coordinates.
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

/// Reads and checks the file `path`. Throws: std::runtime_error with file, line and column, for a
/// file that is not TOML, unknown keys, wrong types and invalid values.
MachineFile read_machine_file(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
