// SPDX-License-Identifier: GPL-3.0-or-later
//
// Survey of a program before the simulation: its length, its tools and its positions. The survey
// decides what has to be assumed, and whether the program can be simulated at all.
#pragma once

#include "ncsim/gcode/source.h"
#include "ncsim/simulation/facts.h"
#include "ncsim/simulation/plan.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace ncsim::simulation {

/// Number of pieces of a tool's feed moves, by cost. Counted, not measured.
struct FeedPieces {
    std::uint64_t straight = 0;  ///< Straight moves without rotation of the tool.
    std::uint64_t chords = 0;    ///< Chords of arcs and splines, within 0.01 mm.
    std::uint64_t indexed = 0;   ///< Straight moves of an inclined tool without rotation.
    std::uint64_t turning = 0;   ///< Chords of moves that rotate the tool, within 0.5 mm.
};

/// Result of the survey.
struct Survey : ProgramFacts {
    bool has_cut_without_start = false;  ///< True if a feed move has an unknown start.
    /// True if there are only rapid moves and the stock is unspecified; then the program is not
    /// ready.
    bool only_rapid = false;
    /// True if the program does not end: it was stopped at the limit of gcode::Limits, and is not
    /// ready.
    bool never_ends = false;
    /// True if Z is never specified, as for a plotter, laser or engraver: only the path is known.
    bool is_flat() const { return unspecified[2]; }
    bool uses_tip_control = false;
    /// U, V, W are not always 0: without tip control, and with tip control.
    std::array<bool, 3> uvw{}, uvw_of_tip{};
    bool turns_under_axes = false;  ///< True if rotary axes are not always 0 without tip control.
    gcode::SourceSpan first_move;
    std::set<int> cutting_tools;
    std::map<int, FeedPieces> pieces;  ///< By tool number, for moves with a known start.

    /// True if the program can be simulated; otherwise `diagnostics` has the reason.
    bool is_ready() const { return ready; }
    bool ready = false;
};

/// Reads the program once, or twice if an axis is never specified: then the start of `plan` is set
/// to 0 in that axis.
Survey survey(Plan& plan);

/// Returns why the program cannot be simulated: the first error.
std::string reason_not_simulated(const Survey& survey);

/// Makes a survey with `only_rapid` ready, with an empty stock, to check the tools against further
/// bodies.
void set_empty_stock(Survey& survey);

}  // namespace ncsim::simulation
