// SPDX-License-Identifier: GPL-3.0-or-later
//
// Explanation of a block: the modes of the control, the blocks that set them, moves, volume.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/gcode/state.h"
#include "ncsim/report/modal_state.h"
#include "ncsim/verify/distances.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::report {

/// A block at its first execution.
struct Explanation {
    std::string program;           ///< Name of the main program.
    std::string file;              ///< File of the block.
    std::uint32_t line = 0;        ///< Line of the block.
    std::string text;              ///< Text of the block.
    std::uint64_t executions = 0;  ///< 0: the block is not reached, and the rest is empty.
    gcode::MachineState before, after;
    /// X, Y and Z of `after` in the machine, in active units; empty if they are not known.
    std::optional<std::array<double, 3>> machine_position;
    /// The last block that changed a mode: file and line; line 0: as at the start of the program.
    struct Setter {
        std::string file;
        std::uint32_t line = 0;
    };
    std::array<Setter, kModeGroups> set_by;      ///< By ModeGroup, as of `after`.
    std::array<bool, kModeGroups> is_changed{};  ///< The block changed the mode.
    bool has_codes = true;                       ///< A program in G-code.
    static constexpr std::size_t kMostMotions = 20;
    std::vector<gcode::Motion> motions;  ///< Motions of all executions, at most kMostMotions.
    std::uint64_t motion_count = 0;      ///< Number of motions of all executions.
    verify::Distances distances;         ///< Distances of all executions.
    std::optional<double> removed_mm3;   ///< Removed by all executions; empty if unknown.
    std::string not_simulated;           ///< Why not; empty: known.
    std::string tool;  ///< Tool in the spindle after the block; empty: none, or not described.
    std::string tool_source;               ///< Source of its description.
    std::vector<std::string> assumptions;  ///< Assumptions about modes before the block.
    gcode::Diagnostics diagnostics;        ///< Of the block.
};

/// Returns rows of text, with lengths in the unit that is active after the block.
std::string text_of(const Explanation& explanation);

/// Returns the same as JSON. Positions have the unit of the program, other lengths mm.
std::string json_of(const Explanation& explanation);

}  // namespace ncsim::report
