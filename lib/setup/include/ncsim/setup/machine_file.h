// SPDX-License-Identifier: GPL-3.0-or-later
//
// The description of a machine as TOML: what is known of it, the rest left out.
//
//     name = "three-axis mill"
//     [travel]                       # machine coordinates, mm
//     x = [-500, 0]
//     y = [-400, 0]
//     z = [-450, 0]
//     a = [-110, 30]                 # degrees, of a machine that turns
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
//     home = [0, 0, 0]               # where G28 leads
//     tool_change = [0, 0, 0]        # where G30 leads
//     start = [0, 0, 0]              # where the tool stands when a program starts
//     [offsets]                      # origins of coordinate systems, machine coordinates, mm
//     G54 = [-250, -200, -300]       # or work_zero = … under [position]
//     G55 = [-100, -200, -300]
//     "G54.1 P1" = [-50, -200, -300]
//     [time]
//     tool_change = 6.0              # s
//     junction_deviation = 0.01      # mm
//     below_stock = 5                # mm free below the stock; stands before the first [table]
//     path_deviation = 0.05          # mm that the tip may leave the line of a feed move that turns
//     [[fixture]]                    # where the stock is, mm; fixture = []: there is none
//     name = "vice"
//     offset = "G55"                 # in this system, if it is not that of the first cut
//     box = [[-60, -40, -20], [60, -30, 5]]
//     clearance = 2                  # or mesh = "vice.stl" (also: stl = …), as that of a link
//     [[tool]]                       # limits of a tool
//     number = 3
//     max_feed = 600                 # mm/min
//     max_speed = 8000               # rpm
//     max_depth = 4                  # mm along the axis
//     max_engagement = 20            # mm3 per mm of path
//     max_removal_rate = 12000       # mm3/min
//     max_ramp = 3                   # degrees, of one that does not cut at its centre
//     blind_diameter = 6             # mm that do not cut about the axis
//     left_handed = false
//
// How it turns, by the name of a machine (before the first [table]), or by its links from the bed
// to the part and to the tool; without either A, B and C turn about the program's zero:
//
//     preset = "xyzac-trt"           # see ncsim/machine/presets.h
//     pivot = { A = [0, 20, 10], C = [0, 0, 0] }   # a point of each rotary axis: the machine
//                                    # coordinates of the spindle nose when it is there, mm
//     control = { m_codes = { M428 = "tip", M429 = "axes" }, tip_frame = "table" }
//                                    # tip_frame: G43.4 is known, too. orient = "positive": of
//                                    # two ways to a direction the one with the joint that counts
//                                    # first at 0 or above; "negative", "shortest" (default).
//                                    # kinematics = ["tip", "axes"]: of LinuxCNC's G12.1 P0, P1
//                                    # at_start = "tip": before any of these words
//                                    // fixture_offsets, fixture_offset_moves, setting_errors,
//                                    // setting_error_moves, setting_error_turns_axes: of Fanuc's
//                                    // G54.2 and G54.4, see docs/dialect.md
//     way = { C = "shortest" }       # what C10 says where C stands at 350: "linear" (-340), the
//                                    # default; "shortest" (+20, roll-over), "positive", "sign"
//                                    # (the size is the place, the sign the way)
//     along_tool = "W"               # W (or U, V) moves the tip along the tool, by X, Y and Z: as
//                                    # LinuxCNC's 5axiskins does. No joint of its own
//     assumed = "…"                  # what nobody told, in words: a doubt until it is taken out
//     clamps = { B = ["M10", "M11"] }   # M10 holds B, M11 lets it go
//     part = { link = "platter" }
//     ignore = [["table", "way cover"]]   # not asked whether they meet: links, fixtures, "tool",
//                                    # "part". Links next to each other are not asked, but for
//     ask = [["cradle", "platter"]]  # these
//     [spindle]
//     link = "head"
//     [[link]]
//     name = "cradle"
//     parent = "table"               # without: the bed
//     axis = "A"
//     turns_about = [1, 0, 0]        # or moves_along
//     through = [0, 20, 10]
//     travel = [-110, 30]
//     mesh = "cradle.stl"            # beside this file: STL, OBJ, VRML97, GLB, STEP; closed, as it
//                                    # stands with all axes at 0
//     scale = 1000                   # mm that a length of 1 is in STL, OBJ and VRML; default: 1
//     hull = true                    # what it meets is asked of its convex hull: for a mesh that
//                                    # crosses itself, which is refused else. A fixture's, too
//     colour = "#c08040"
//     clearance = 2                  # mm that all else is to stay away
//     positive = "part"              # the part turns by the right hand; else "tool" (ISO 841)
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/machine_body.h"
#include "ncsim/setup/told_kinematics.h"
#include "ncsim/verify/machine.h"
#include "ncsim/verify/setup.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::setup {

struct MachineFile {
    /// Where the workpiece is in the machine follows from the program, too.
    verify::MachineDescription machine;
    std::map<int, cda::Vec3> offsets;  ///< By MachineState::system, machine coordinates, mm.
    std::optional<cda::Vec3> start;    ///< Machine coordinates.
    std::optional<ToldKinematics> kinematics;
    std::vector<MachineBody> bodies;       ///< Of links that have a mesh.
    std::vector<MachineBody> other_links;  ///< Those that have none.
    std::string part_link, tool_link;      ///< Which of them carry the part and the tool, if told.
    /// What moves the part and the tool, as MachineBody::moved_by.
    machine::Chain part_moved_by, tool_moved_by;
    /// Who is not asked whether they meet, and who is though they are neighbours.
    std::vector<verify::NamePair> ignored, asked;
    gcode::TipControl tip_control;
    gcode::TableOffsets fixture_offsets, setting_errors;
    std::array<gcode::RotaryWay, 3> rotary_ways{};  ///< Of A, B and C.
    std::vector<gcode::RotaryClamp> clamps;
    /// Limits by tool number; the shape is not told here.
    std::map<int, verify::ToolFacts> tools;
};

/// Reads and judges `path`. Throws std::runtime_error, naming file, line and column, for what is
/// not TOML, unknown keys, wrong types and values that make no sense.
MachineFile read_machine_file(const std::string& path, InputSet& inputs);

}  // namespace ncsim::setup
