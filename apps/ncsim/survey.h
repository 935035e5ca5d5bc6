// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first look at a program, before anything is cut: how long it is, which tools it calls, where
// it goes. It decides what has to be assumed, and whether the program can be simulated at all.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/tool_table.h"

#include "job.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace ncsim::app {

/// A tool as it will be used, and why it is taken to be so.
struct UsedTool {
    toolpath::Tool tool;
    toolpath::ToldBy told_by = toolpath::ToldBy::Comment;
    gcode::SourceSpan span;    ///< Of the comment.
    std::string text;          ///< As told.
    std::string file;          ///< Of a table; empty: the program.
    toolpath::ToolSpec spec;   ///< With all that was filled in.
    std::string filled_in;     ///< What was not told and had to be assumed.
    bool is_guess = false;     ///< Not even its shape was told.
    bool length_told = false;  ///< Of its flutes.
    gcode::SourceSpan first;   ///< The block that first moves it.
};

struct Distances {
    double rapid_mm = 0.0;
    double feed_mm = 0.0;
    /// Of the moves at feed, as if every one kept its feed from end to end. Empty if a feed is
    /// not told, or no spindle speed where it counts.
    std::optional<double> feed_seconds = 0.0;
    double dwell_seconds = 0.0;
    std::uint64_t tool_changes = 0;  ///< To this tool.
};

struct Survey {
    gcode::Interpretation interpretation;
    std::uint64_t moves = 0;
    std::uint64_t feed_moves = 0;
    /// Moves whose start the program does not tell; they leave no trace.
    std::uint64_t moves_from_nowhere = 0;
    bool cuts_from_nowhere = false;  ///< One of them is a feed move.
    /// It has only rapid moves, and nobody says what stands there: then it is not ready.
    bool only_rapid = false;
    std::array<bool, 3> turns{};  ///< About X, Y, Z: A, B, C.
    /// Axes X, Y, Z that the program never tells, though it cuts: taken as 0.
    std::array<bool, 3> untold{};
    /// It never tells Z: a plotter's, a laser's or an engraver's, of which only the path is known.
    bool is_flat() const { return untold[2]; }
    bool uses_machine_coordinates = false;
    gcode::SourceSpan first_move;
    cda::Box tip_positions;              ///< Of all moves with a known start, mm, in W.
    std::map<int, Distances> distances;  ///< By tool number.
    std::map<int, UsedTool> tools;       ///< Those that move.
    /// Tools that cut and are not described: the block that first moves them.
    std::map<int, gcode::SourceSpan> unknown_tools;
    std::set<int> cutting_tools;
    std::optional<toolpath::StockEntry> stock;
    gcode::Diagnostics diagnostics;  ///< Of the interpreter, of comments, and of this.

    /// Can it be simulated? Else `diagnostics` says why not.
    bool is_ready() const { return ready; }
    bool ready = false;

    bool turns_tools() const { return turns[0] || turns[1] || turns[2]; }
};

/// Adds those of a motion with a known start, of a dwell or of a tool change.
void add(Distances& distances, const gcode::Motion& motion);

/// Sum over all tools.
Distances total_distances(const Survey& survey);

/// Reads the program once, or twice where it never tells an axis: then `job` is told that it starts
/// at 0 there.
Survey survey(Job& job);

/// Makes one that is `only_rapid` ready, with a stock that is empty: for those who ask what else
/// the tools meet.
void cut_nothing(Survey& survey);

}  // namespace ncsim::app
