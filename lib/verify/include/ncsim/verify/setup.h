// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program is verified against: everything that was told, and words for what was not.
#pragma once

#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/tool_polytope.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/machine.h"
#include "ncsim/verify/rule.h"
#include "ncsim/verify/suppression.h"

#include <map>
#include <optional>
#include <string>

namespace ncsim::verify {

/// A tool, and what it may be asked to do. Limits that nobody told are empty.
struct ToolFacts {
    toolpath::Tool tool;
    std::string assumption;          ///< What of its shape was not told, in words; empty: nothing.
    bool is_guess = false;           ///< Nobody described it: all of it is assumed.
    std::optional<double> max_feed;  ///< mm/min
    std::optional<double> max_rpm;
    std::optional<double> max_depth;         ///< Along the axis, mm.
    std::optional<double> max_engagement;    ///< Removed volume per path, mm³/mm (= mm²).
    std::optional<double> max_removal_rate;  ///< mm³/min
    /// Diameter (mm) about the axis that does not cut; 0: cuts to its centre.
    std::optional<double> blind_diameter;
    std::string blind_assumption;  ///< Where that was concluded, in words.
    bool left_hand = false;        ///< Cuts with M4.
};

struct Setup {
    std::map<int, ToolFacts> tools;
    MachineDescription machine;
    Selection selection;
    Suppressions suppressions;  ///< Of the program itself.
    toolpath::RapidPath rapid;
    toolpath::ToolAccuracy accuracy;
    /// Can the program be simulated? Else why not: geometric rules are skipped then.
    std::optional<std::string> not_simulated;
    /// What was assumed, in words; empty where it was told.
    std::string stock_assumption;
    std::string units_assumption;
    std::string home_assumption;  ///< Of moves in machine coordinates.
    bool pieces_counted = false;  ///< Somebody looks for pieces that are cut free.
    bool design = false;          ///< Somebody compares the part with a design.
    bool ledger = false;          ///< Keep a row a block, with exact volumes.
};

}  // namespace ncsim::verify
