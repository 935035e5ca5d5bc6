// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which surfaces a motion can leave behind: those that the pieces of its tool's profile sweep, and
// those of the tool at rest where it starts and ends.
#pragma once

#include "ncsim/brep/surface.h"
#include "ncsim/cda/vec.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/machine.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/tool.h"

#include <array>
#include <optional>
#include <vector>

namespace ncsim::brep {

struct Candidate {
    Surface surface;
    bool is_at_rest = false;  ///< Of the tool in its first or last pose.
    /// Where it is, nearly, of surfaces that go on and come back: what is elsewhere is none of it.
    std::optional<cda::Box> place{};
    /// Of one piece of a way: where it begins and where it ends, both planes across the way,
    /// looking along it. Facets belong to the piece in which their middles are.
    std::optional<std::array<Plane, 2>> ends{};
};

/// Whose facets approximate one of the candidates, and how well: no corner is farther from it than
/// `error_mm`.
struct Source {
    std::vector<Candidate> candidates;
    double error_mm = 0.0;
    /// By how many times what chords of the way are off its facets may be, on top of the rest: of
    /// straight moves 0.
    double chords = 1.0;
    /// How far the candidates are beside what the motion leaves, mm: those of splines, which are
    /// taken as arcs.
    double beside_mm = 0.0;
    /// It may have left others, too: what fits none of them is what it is, however small.
    bool leaves_unknown = false;
};

/// Of a tool that keeps its direction, by pieces of its profile:
///
/// | piece | line | line along the axis | arc about an axis along the tool's |
/// | --- | --- | --- | --- |
/// | disc | plane, if it is level | plane | plane, if it is level |
/// | upright | 2 planes | cylinder | 2 cylinders, also of helices |
/// | sloping | 2 planes | cone | 2 cones, if it is level |
/// | rounded | 2 cylinders, if it is level | ring | 2 rings, if it is level |
/// | ball | cylinder | sphere | ring, in any plane |
/// | corner | extrusion, if it is not level | | coil, if it is a helix; dome, in upright planes |
///
/// Of what is rounded, and of balls, envelopes on other lines and arcs: helices, spirals, in other
/// planes; rings have to go down all the way, or up. Of several turns each half is one.
///
/// Arcs whose radius changes by more than 4 µm leave planes below flat ends and spirals beside
/// upright sides. Lines that rise by less than 1 µm for 1 mm, arcs whose radius changes by more
/// than a fifth of it for each radian, and rings that are thicker than wide but of arcs about the
/// tool's axis, or nearly as thick as wide, have no surface here.
/// Of tools that turn envelopes on lines, of sides and balls, and of corner radii and rims where
/// the flat end goes level nowhere; and those at rest. `told`: the machine that
/// moves it, null for the default one; it may hold the tool or the part at any angle. What has no
/// surface here is unknown. The error is for whoever knows it.
Source surfaces_of(const gcode::Motion& motion, const toolpath::Tool& tool,
                   const toolpath::Kinematics* told);

/// Six planes, or a cylinder and two of them; nothing of stock from a file, whose facets are what
/// they are.
std::vector<Candidate> surfaces_of(const toolpath::Stock& stock);

}  // namespace ncsim::brep
