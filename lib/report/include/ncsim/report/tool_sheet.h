// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tools of a program: each called or described tool with shape, source of the description, and
// use.
#pragma once

#include "ncsim/report/facts.h"
#include "ncsim/toolpath/tool_table.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::report {

/// Evidence from the linear moves of a program for the meaning of X, Y and Z: moves at constant
/// tilted angles that run along the tool axis of some machine, or along Z.
struct Plunges {
    /// Evidence that X, Y and Z are positions of the tip.
    struct Tip {
        /// Machines whose rotary axes rotate the tool alike, for the axes that the program uses.
        std::vector<std::string> machines;
        std::uint64_t moves = 0;  ///< Moves along the tool if X, Y and Z are the tip position.
    };
    bool is_tilted = false;   ///< True if some move is at tilted angles.
    std::uint64_t moves = 0;  ///< Moves along the tool axis of some machine, or along Z.
    /// Moves along Z at tilted angles: X, Y and Z are axis positions, or the tip position in a
    /// frame that does not rotate.
    std::uint64_t along_z = 0;
    std::vector<Tip> tip;  ///< Descending by moves, without entries of 0 moves.
};

/// Returns the sheet as text. `described` are all described tools, used or not.
std::string tool_sheet(const ProgramFacts& program,
                       const std::vector<toolpath::ToolEntry>& described,
                       const Plunges& plunges = {}, LengthUnit unit = LengthUnit::Millimetre);

/// Returns the sheet as JSON, with the diagnostics. `name` is the name of the program, `set_up`
/// that of its set-up; empty outside a job.
std::string tool_sheet_json(const std::string& name, const std::string& set_up,
                            const ProgramFacts& program,
                            const std::vector<toolpath::ToolEntry>& described,
                            const Plunges& plunges = {});

}  // namespace ncsim::report
