// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first look at a program, before anything is cut: how long it is, which tools it calls, where
// it goes. It decides what has to be assumed, and whether the program can be simulated at all.
#pragma once

#include "ncsim/gcode/source.h"
#include "ncsim/report/facts.h"
#include "ncsim/simulation/plan.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace ncsim::simulation {

/// Pieces into which the feed moves of one tool are cut, by cost. Counted, not measured.
struct FeedPieces {
    std::uint64_t straight = 0;  ///< Straight moves that do not turn the tool.
    std::uint64_t chords = 0;    ///< Chords of arcs and splines, within 0.01 mm.
    std::uint64_t indexed = 0;   ///< Straight moves of a tool that leans and does not turn.
    std::uint64_t turning = 0;   ///< Chords of moves that turn the tool, within 0.5 mm.
};

struct Survey : report::ProgramFacts {
    bool cuts_from_nowhere = false;  ///< A move whose start is not told is a feed move.
    /// It has only rapid moves, and nobody says what stands there: then it is not ready.
    bool only_rapid = false;
    /// It runs on and on; it was stopped at the limit of gcode::Limits, and is not ready.
    bool never_ends = false;
    /// It never tells Z: a plotter's, a laser's or an engraver's, of which only the path is known.
    bool is_flat() const { return untold[2]; }
    bool uses_tip_control = false;
    /// U, V, W stand elsewhere than at 0: without it, and with it.
    std::array<bool, 3> uvw{}, uvw_of_tip{};
    bool turns_under_axes = false;  ///< Rotary axes stand elsewhere than at 0 without it.
    gcode::SourceSpan first_move;
    std::set<int> cutting_tools;
    std::map<int, FeedPieces> pieces;  ///< By tool number; of moves with a known start.

    /// Can it be simulated? Else `diagnostics` says why not.
    bool is_ready() const { return ready; }
    bool ready = false;
};

/// Reads the program once, or twice where it never tells an axis: then `plan` is told that it
/// starts at 0 there.
Survey survey(Plan& plan);

/// Why one that is not ready cannot be simulated: the first error that it met.
std::string reason_against(const Survey& survey);

/// Makes one that is `only_rapid` ready, with a stock that is empty: for those who ask what else
/// the tools meet.
void cut_nothing(Survey& survey);

}  // namespace ncsim::simulation
