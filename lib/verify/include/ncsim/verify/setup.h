// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program is verified against: everything that was told, and words for what was not.
#pragma once

#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/tool_polytope.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/machine.h"
#include "ncsim/verify/machine_bodies.h"
#include "ncsim/verify/selection.h"
#include "ncsim/verify/suppression.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify {

/// A tool, and what it may be asked to do. Limits that nobody told are empty.
struct ToolFacts {
    toolpath::Tool tool;     ///< With shank and holder, as far as they are told.
    std::string assumption;  ///< What of its shape was not told, in words; empty: nothing.
    bool is_guess = false;   ///< Nobody described its shape: it is assumed.
    /// Up to where its flutes certainly reach, mm above the tip; empty: as high as it is modelled.
    std::optional<double> certain_flutes;
    bool holder_told = false;
    bool gauge_length_specified = false;  ///< From the spindle nose to the tip.
    std::optional<double> max_feed;       ///< mm/min
    std::optional<double> max_rpm;
    std::optional<double> max_depth;         ///< Along the axis, mm.
    std::optional<double> max_engagement;    ///< Removed volume per path, mm³/mm (= mm²).
    std::optional<double> max_removal_rate;  ///< mm³/min
    /// Diameter (mm) about the axis that does not cut; 0: cuts to its centre.
    std::optional<double> blind_diameter;
    std::string blind_assumption;    ///< Where that was concluded, in words.
    std::optional<double> max_ramp;  ///< Degrees, of one with such a diameter.
    bool left_hand = false;          ///< Cuts with M4.
    std::optional<double> pitch;     ///< Of a tap or a thread mill, mm.
    /// Specified height of the flutes of a drill, mm.
    std::optional<double> flute_length;
    /// Specified diameter of the flat tip of a chamfer mill, where that is too wide to cut, mm.
    std::optional<double> flat_tip;
};

/// The accuracy of the tools leaves open whether something touches: somewhere in `boxes` (mm, W).
struct OpenContact {
    std::uint64_t motion = 0;  ///< From 1, in the order of execution.
    std::string_view rule;
    int tool = 0;
    std::optional<std::size_t> piece;  ///< Of the tool; none: what cuts.
    std::vector<cda::Box> boxes;
};

/// Decides it with finer tools: certain, still open (Within), or nothing: they do not touch.
using SecondLook = std::function<std::optional<Certainty>(const OpenContact&)>;

struct Setup {
    std::map<int, ToolFacts> tools;
    MachineDescription machine;
    Selection selection;
    Suppressions suppressions;  ///< Of the program itself.
    toolpath::RapidPath rapid;
    /// How the machine turns; null: nobody tells it.
    std::shared_ptr<const toolpath::Kinematics> kinematics;
    /// Its links, as far as they are told; null: nobody tells any.
    std::shared_ptr<const MachineBodies> bodies;
    /// What of that is assumed nevertheless, in words: where the program tells places of the tip,
    /// and where it tells those of axes.
    std::string tip_guess, axes_guess = "A, B and C turn about the program origin";
    /// By how many degrees the part is set up askew, which G54.4 corrects; 0: it is straight.
    double setting_askew = 0.0;
    toolpath::ToolAccuracy accuracy;
    std::optional<cda::Box> stock;   ///< mm, W.
    double path_tolerance_mm = 0.0;  ///< How far a path may be missed; 0: nobody asks.
    /// How far the control may miss corners of the path (G64 P), where that is more than the
    /// tolerance of the path; mm, 0: not at all.
    double blend_mm = 0.0;
    /// Can the program be simulated? Else why not: geometric rules are skipped then.
    std::optional<std::string> not_simulated;
    /// What was assumed, in words; empty where it was told.
    std::string stock_assumption;
    std::string units_assumption;
    std::string home_assumption;  ///< Of moves in machine coordinates.
    /// Height of the reference point, where G28 leads, in W, mm: told, or assumed to be above all
    /// that stands on the table.
    double home_z = 0.0;
    bool pieces_counted = false;  ///< Somebody looks for pieces that are cut free.
    bool design = false;          ///< Somebody compares the part with a design.
    bool air_cuts = false;        ///< Somebody asks for feed moves that remove nothing.
    bool ledger = false;          ///< Keep a row a block, with exact volumes.
    /// The program uses G43: then every tool has to.
    bool uses_length_offsets = false;
    std::set<int> cutting_tools;  ///< All that cut somewhere in the program.
    /// Modes that the program does not set before its first move: "units (G20, G21)".
    std::vector<std::string> inherited_modes;
    SecondLook second_look;  ///< Empty: what is open stays open.
    /// Reasons for doubt that do not count, by id: somebody decided so.
    std::set<std::string, std::less<>> accepted;
    /// What must be told: those of kRequirements.
    std::set<std::string, std::less<>> required;
};

/// The words that `required` knows.
inline constexpr std::string_view kRequirements[] = {"holder", "fixtures", "travels", "offsets",
                                                     "links",  "lengths",  "modes"};

/// Does any selected rule look at the part?
bool needs_part(const Setup& setup);

}  // namespace ncsim::verify
