// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motion as the rules see it: values from the program, and values measured during the simulation.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/machine/chain.h"
#include "ncsim/verify/finding.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::verify {

/// Contact of a non-cutting piece of the tool with material.
struct BodyContact {
    std::size_t piece = 0;  ///< Index into Tool::pieces.
    Certainty certainty = Certainty::Within;
    /// Smallest distance by which the piece would have to sit higher on the tool to avoid material
    /// in all motions so far, rounded up to 0.01 mm.
    double raise_mm = 0.0;
    std::optional<Vec3> point;  ///< Common point.
    Box box;                    ///< Encloses the contact.
};

struct FixtureContact {
    std::size_t fixture = 0;  ///< Index into MachineDescription::fixtures.
    std::size_t piece = 0;    ///< Index of the piece of the tool.
    bool touches = false;     ///< The fixture itself, not only the clearance.
    Certainty certainty = Certainty::Within;
    Box box;
};

/// Contact of two bodies that a machine moves, at least one of them a link.
struct MachineContact {
    std::string first, second;  ///< "the link 'cradle'"
    bool touches = false;       ///< Otherwise the bodies are only nearer than `clearance_mm`.
    Certainty certainty = Certainty::Within;
    double amount_mm = 0.0;  ///< Penetration, or distance; 0 if not measured.
    double clearance_mm = 0.0;
    /// Positions of the joints at the contact, machine coordinates.
    machine::Values values{};
    std::optional<Vec3> point;       ///< W; empty unless the contact is certain.
    bool assumed = false;            ///< The shape of a body in contact is not fully specified.
    std::vector<std::string> hulls;  ///< Meshes replaced by hulls, with reasons.
};

struct Move {
    const gcode::Motion* motion = nullptr;
    std::uint64_t number = 0;  ///< Number from 1, in the order of execution.
    bool is_move = false;      ///< Otherwise a dwell or a tool change.
    bool is_traced = false;    ///< The tool and the start are known, so the motion was simulated.
    /// The motion meets no body, whatever its unknown start.
    bool passes_above = false;
    /// The start is unknown; only the end position was checked.
    bool arrives = false;
    bool after_probe = false;  ///< A probing move precedes; its contact point is assumed.
    double length_mm = 0.0;    ///< Path of the controlled point.
    Vec3 enters, leaves;       ///< Unit vectors at the two ends of the path; 0 without a length.
    double radius_mm = 0.0;    ///< Radius of an arc, the smaller radius of a spiral; otherwise 0.
    Box path;                  ///< Box of the path of the controlled point, W.
    /// Box of the controlled point in machine coordinates, including the tool length; empty if the
    /// position of the work zero is unspecified.
    std::optional<Box> machine_path;
    /// X, Y and Z of the program differ from the positions of the axes: tip control with rotary
    /// axes away from 0, or W moves the tool along its axis.
    bool is_tilted_tip = false;
    /// Z at the start, and at the end, is a position of the spindle nose, not of the tip.
    bool starts_at_nose = false, ends_at_nose = false;
    /// Box of all paths up to and including this motion, and up to the motion before.
    Box way, previous_path_box;

    // Length of the tool in the control.
    int length_register = 0;            ///< Number, or a gcode::LengthRegister.
    bool length_specified = false;      ///< The value of the register is specified.
    double length_offset = 0.0;         ///< Active along Z, mm.
    std::optional<double> tool_length;  ///< Length of the tool itself, mm; empty: unspecified.
    /// The motion descends, feeds or probes, so a wrong tool length does damage.
    bool needs_length = false;

    // Contacts of the cutting pieces; only if `asked`.
    bool needs_contacts = false;
    bool meets_material = false;
    bool volume_known = false;
    double removed_mm3 = 0.0;
    Certainty certainty = Certainty::Within;
    Box contact;                        ///< Encloses all contacts with the stock.
    std::optional<Vec3> contact_point;  ///< Point in the tool and in the material.

    /// Length (mm) of the descent on material under the core, which does not cut, since the tool
    /// last moved aside; 0 if the length is permitted.
    double plunged_mm = 0.0;
    double too_deep_mm = 0.0;  ///< Engaged height above the depth limit of the tool.
    /// Depth (mm) of the tip below the first contact with material, for a motion along the tool
    /// axis in a hole.
    double hole_depth_mm = 0.0;
    /// Z of the highest material above the tip in a straight descent at feed, W, mm.
    std::optional<double> mouth_z;
    bool tip_cuts = false;    ///< A flat tip moves sideways through material.
    bool is_at_wall = false;  ///< A thread mill starts in the wall of its thread.
    /// The tool has cut a helix since the tool change.
    bool has_threaded = false;
    /// The tool has cut in the place where this motion moves straight up.
    bool has_cut_below = false;
    /// Spindle state of the preceding motion if that motion cut straight down and this motion goes
    /// straight up.
    std::optional<gcode::SpindleTurning> leaves_cut;
    /// Deviation (mm) from the programmed path if it exceeds the tolerance.
    double path_error_mm = 0.0;
    std::vector<BodyContact> bodies;
    std::vector<FixtureContact> fixtures;
    std::vector<MachineContact> machine;
};

}  // namespace ncsim::verify
