// SPDX-License-Identifier: GPL-3.0-or-later
//
// One motion as the rules see it: what the program says, and what was measured while it was
// simulated.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/machine/chain.h"
#include "ncsim/verify/finding.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::verify {

/// A piece of the tool that does not cut, and the material it meets.
struct BodyContact {
    std::size_t piece = 0;  ///< Index into Tool::pieces.
    Certainty certainty = Certainty::Within;
    /// The least by which the piece would have to sit higher on the tool not to meet material in
    /// any motion so far, rounded up to 0.01 mm.
    double raise_mm = 0.0;
    std::optional<cda::Vec3> point;  ///< In both.
    cda::Box box;                    ///< Encloses the contact.
};

struct FixtureContact {
    std::size_t fixture = 0;  ///< Index into MachineDescription::fixtures.
    std::size_t piece = 0;    ///< Of the tool.
    bool touches = false;     ///< The fixture itself, not only the clearance around it.
    Certainty certainty = Certainty::Within;
    cda::Box box;
};

/// Two things that a machine moves, and one of them a link.
struct MachineContact {
    std::string first, second;  ///< "the link 'cradle'"
    bool touches = false;       ///< Else they only come nearer than `clearance_mm`.
    Certainty certainty = Certainty::Within;
    double amount_mm = 0.0;  ///< Deep in each other; or apart. 0 where it was not measured.
    double clearance_mm = 0.0;
    machine::Values values{};        ///< Of the joints then, machine coordinates.
    std::optional<cda::Vec3> point;  ///< In W; where it is certain.
    bool assumed = false;            ///< Nobody told all of what meets there.
    std::vector<std::string> hulls;  ///< Meshes that count as their hulls, and why.
};

struct Move {
    const gcode::Motion* motion = nullptr;
    std::uint64_t number = 0;  ///< From 1, in the order of execution.
    bool is_move = false;      ///< Else a dwell or a tool change.
    bool is_traced = false;    ///< Its tool and its start are known, so it was simulated.
    /// It meets nothing, whatever is not known of its start.
    bool passes_above = false;
    /// Its start is not known; what it met where it ends was asked.
    bool arrives = false;
    bool after_probe = false;  ///< A probe moved before: where it met something is assumed.
    double length_mm = 0.0;    ///< Path of the controlled point.
    cda::Vec3 enters, leaves;  ///< Unit vectors of the path's two ends; 0 without a length.
    double radius_mm = 0.0;    ///< Of an arc, the smaller one of a spiral; else 0.
    cda::Box path;             ///< Of the controlled point, in W.
    /// Of the controlled point, in machine coordinates with the tool length, if the machine tells
    /// where the work zero lies.
    std::optional<cda::Box> machine_path;
    /// Tip control with rotary axes that are not at 0, or a tool that W moves along itself: X, Y
    /// and Z are not where the axes go.
    bool is_tilted_tip = false;
    /// Z of the start, of the end, is a position of the spindle nose, not of the tip.
    bool starts_at_nose = false, ends_at_nose = false;
    /// Box of all paths up to here, and before this motion.
    cda::Box way, way_before;

    // The length of the tool as the control has it.
    int length_register = 0;            ///< Number, or a gcode::LengthRegister.
    bool length_told = false;           ///< Of that register.
    double length_offset = 0.0;         ///< Active along Z, mm.
    std::optional<double> tool_length;  ///< Of the tool itself, mm, where it is told.
    /// Goes down, feeds or probes: where a tool of another length breaks something.
    bool needs_length = false;

    // What the cutting pieces met; only where `asked`.
    bool asked = false;
    bool meets_material = false;
    bool volume_known = false;
    double removed_mm3 = 0.0;
    Certainty certainty = Certainty::Within;
    cda::Box contact;                        ///< Encloses where the stock was met.
    std::optional<cda::Vec3> contact_point;  ///< In the tool and in the material.

    /// How far it went down on material under the centre, where it does not cut, without having
    /// been aside; beyond what the tool may.
    double plunged_mm = 0.0;
    double too_deep_mm = 0.0;  ///< Engaged height above the limit of the tool.
    /// Straight along its axis in a hole: the tip below the first contact with material there, mm.
    double hole_depth_mm = 0.0;
    /// Z of the highest material above the tip where it goes straight down at feed, W, mm.
    std::optional<double> mouth_z;
    bool tip_cuts = false;    ///< A flat tip goes sideways through material.
    bool is_at_wall = false;  ///< A thread mill starts in the wall of its thread.
    /// The tool has cut a helix since it was changed.
    bool has_threaded = false;
    /// The tool has cut in the place where this motion goes straight up.
    bool has_cut_below = false;
    /// The motion before cut straight down, with this spindle; this one goes straight up.
    std::optional<gcode::SpindleTurning> leaves_cut;
    /// Farther off the programmed path than the tolerance allows, mm.
    double path_error_mm = 0.0;
    std::vector<BodyContact> bodies;
    std::vector<FixtureContact> fixtures;
    std::vector<MachineContact> machine;
};

}  // namespace ncsim::verify
