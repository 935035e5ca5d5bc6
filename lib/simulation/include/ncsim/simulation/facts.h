// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facts about a program before the cut, and about the part.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/simulation/used_tool.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/tool_table.h"
#include "ncsim/verify/distances.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace ncsim::simulation {

/// Facts about a program before the cut.
struct ProgramFacts {
    gcode::Interpretation interpretation;
    std::uint64_t moves = 0;
    std::uint64_t feed_moves = 0;
    /// Moves with an unspecified start, which are not cut.
    std::uint64_t moves_without_start = 0;
    std::array<bool, 3> turns{};  ///< True for A, B, C if the program rotates about X, Y, Z.
    std::string rotation;         ///< Text: how the rotation moves the tool.
    /// Axes X, Y, Z that the program never specifies although it cuts; the positions count as 0.
    std::array<bool, 3> unspecified{};
    /// Rapid moves of several of X, Y and Z: the boxes of the moves, mm in W, and the blocks. A
    /// machine may move straight or as a dog-leg.
    struct SlantingRapid {
        Box box;
        std::uint32_t file = 0;
        gcode::SourceSpan span;
    };
    std::vector<SlantingRapid> slanting_rapids;
    bool calls_tools = false;    ///< True if the program changes tools.
    bool units_assumed = false;  ///< True if neither the program nor the user specifies the unit.
    bool uses_machine_coordinates = false;
    Box tip_positions;  ///< Tip positions of all moves with a known start, mm, in W.
    std::map<int, verify::Distances> distances;  ///< By tool number.
    std::map<int, UsedTool> tools;               ///< Tools that move.
    /// Operation: blocks of a tool between names in comments.
    struct Operation {
        std::string name;        ///< Empty if the comments name none.
        std::uint32_t line = 0;  ///< Line of the name; 0 without one.
        int tool = 0;
        std::uint64_t first_motion = 0;  ///< Number in the program, counted from 1.
        verify::Distances distances;
    };
    std::vector<Operation> operations;  ///< In the order of execution.
    /// Tools that cut without a description: the block that first moves each tool.
    std::map<int, gcode::SourceSpan> unknown_tools;
    std::optional<toolpath::StockEntry> stock;
    /// Diagnostics of the interpreter, of comments, and of the survey.
    gcode::Diagnostics diagnostics;

    bool turns_tools() const { return turns[0] || turns[1] || turns[2]; }
};

/// Polytope that replaced a round tool.
struct CutterFacts {
    int sides = 0;
    double error_mm = 0.0;
};

/// File (index into Interpretation::files, 0: the program) and line.
using BlockPlace = std::pair<std::uint32_t, std::uint32_t>;

/// Places where the part is thinner than the resolution of the model, and the lines that cut the
/// thinnest material and the thinnest gap; 0: the stock.
struct AliasingFacts : cda::Aliasing {
    std::uint32_t material_line = 0, gap_line = 0;
};

/// Facts about the part.
struct PartFacts {
    cda::Lattice lattice;
    double stock_volume = 0.0;  ///< mm³
    double part_volume = 0.0;
    double part_volume_error = 0.0;         ///< Bound of the error for models that are not exact.
    std::optional<AliasingFacts> aliasing;  ///< Only for models with a resolution.
    std::uint64_t hulls = 0;                ///< Number of hulls subtracted.
    std::map<int, double> removed_by_tool;  ///< mm³; not computed in a verification.
    /// mm³, by index in ProgramFacts::operations; not computed in a verification.
    std::vector<double> removed_by_operation;
    /// mm³; only on request.
    std::map<BlockPlace, double> removed_by_block;
    std::map<int, CutterFacts> cutters;
    toolpath::SampleBounds bounds;  ///< Largest values over all motions that met the stock.
    verify::Distances distances;    ///< Distances of the simulated motions.
};

}  // namespace ncsim::simulation
