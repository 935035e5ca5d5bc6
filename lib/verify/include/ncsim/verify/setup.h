// SPDX-License-Identifier: GPL-3.0-or-later
//
// Input of verification: all specified values, and texts about the assumed values.
#pragma once

#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/tool_polytope.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/machine_bodies.h"
#include "ncsim/verify/machine_description.h"
#include "ncsim/verify/selection.h"
#include "ncsim/verify/suppression.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify {

/// Tool with the limits of its use. Limits that are not specified are empty.
struct ToolFacts {
    toolpath::Tool tool;     ///< Includes the shank and the holder if specified.
    std::string assumption;  ///< Description of the assumed part of the shape; empty: none.
    bool is_guess = false;   ///< The whole shape is assumed.
    /// Height (mm) above the tip up to which the flutes certainly reach; empty: up to the modelled
    /// height.
    std::optional<double> certain_flutes;
    bool holder_specified = false;
    bool gauge_length_specified = false;  ///< Length from the spindle nose to the tip.
    std::optional<double> max_feed;       ///< mm/min
    std::optional<double> max_rpm;
    std::optional<double> max_depth;         ///< Along the axis, mm.
    std::optional<double> max_engagement;    ///< Removed volume per path length, mm³/mm (= mm²).
    std::optional<double> max_removal_rate;  ///< mm³/min
    /// Diameter (mm) of the core about the axis that does not cut; 0: the tool cuts to the centre.
    std::optional<double> blind_diameter;
    std::string blind_assumption;    ///< Description of the conclusion that gave the diameter.
    std::optional<double> max_ramp;  ///< Degrees, for a tool with a core.
    bool left_hand = false;          ///< Cuts with M4.
    std::optional<double> pitch;     ///< Pitch of a tap or a thread mill, mm.
    /// Specified flute length of a drill, mm.
    std::optional<double> flute_length;
    /// Specified diameter of the flat tip of a chamfer mill, where that is too wide to cut, mm.
    std::optional<double> flat_tip;
};

/// Contact that the accuracy of the tools leaves open, somewhere in `boxes` (mm, W).
struct OpenContact {
    std::uint64_t motion = 0;  ///< Number of the motion from 1, in the order of execution.
    std::string_view rule;
    int tool = 0;
    std::optional<std::size_t> piece;  ///< Piece of the tool; empty: the cutter.
    std::vector<Box> boxes;
};

/// Decision about an open contact with finer tools: Certain, Within (still open), or empty (no
/// contact).
using ContactDecision = std::optional<Certainty>;

/// Tools, machine, stock, selection of rules and assumptions of a verification.
struct Setup {
    std::map<int, ToolFacts> tools;
    MachineDescription machine;
    Selection selection;
    Suppressions suppressions;  ///< Suppressions of the program itself.
    toolpath::RapidPath rapid;
    /// Kinematics of the machine; null: unspecified.
    std::shared_ptr<const toolpath::Kinematics> kinematics;
    /// Links of the machine; null: unspecified.
    std::shared_ptr<const MachineBodies> bodies;
    /// Descriptions of the kinematics that is assumed although unspecified: for blocks that give
    /// positions of the tip, and for blocks that give positions of axes.
    std::string tip_guess, axes_guess = "A, B and C turn about the program origin";
    /// Angle (degrees) by which the part is set up askew and which G54.4 corrects; 0: straight.
    double setting_askew = 0.0;
    toolpath::ToolAccuracy accuracy;
    std::optional<Box> stock;        ///< mm, W.
    double path_tolerance_mm = 0.0;  ///< Largest permitted deviation from the path; 0: not checked.
    /// Distance (mm) by which the control may miss corners of the path (G64 P) if it exceeds the
    /// tolerance of the path; 0: none.
    double blend_mm = 0.0;
    /// Reason why the program cannot be simulated; geometric rules are then skipped. Empty: the
    /// program is simulated.
    std::optional<std::string> not_simulated;
    /// Descriptions of assumed values; empty if specified.
    std::string stock_assumption;
    std::string units_assumption;
    std::string home_assumption;  ///< For moves in machine coordinates.
    /// Height of the reference point (G28); mm, W. Specified, or assumed above all bodies on the
    /// table.
    double home_z = 0.0;
    bool pieces_counted = false;  ///< The caller searches for detached pieces.
    bool design = false;          ///< The caller compares the part with a design.
    bool air_cuts = false;        ///< The caller requests feed moves that remove nothing.
    bool ledger = false;          ///< Keep one row a block, with exact volumes.
    /// The program uses G43, so every tool needs a length offset.
    bool uses_length_offsets = false;
    std::set<int> cutting_tools;  ///< All tools that cut in the program.
    /// Modes that the program does not set before the first move: "units (G20, G21)".
    std::vector<std::string> inherited_modes;
    bool decides_contacts = false;  ///< The caller decides open contacts.
    /// Ids of doubts that the user accepted.
    std::set<std::string, std::less<>> accepted;
    /// Values that must be specified; elements of kRequirements.
    std::set<std::string, std::less<>> required;
};

/// Permitted elements of `required`.
inline constexpr std::string_view kRequirements[] = {"holder", "fixtures", "travels", "offsets",
                                                     "links",  "lengths",  "modes"};

/// True if a selected rule needs the part.
bool needs_part(const Setup& setup);

}  // namespace ncsim::verify
