// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facts about a program: before the cut, about the cut, and about the part.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/report/length_unit.h"
#include "ncsim/report/used_tool.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/tool_table.h"
#include "ncsim/verify/distances.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace ncsim::report {

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

/// Model and tolerances of the cut.
struct CuttingFacts {
    std::string model;
    double resolution = 0.0;              ///< Resolution of the model, mm; 0 if the model has none.
    bool has_rays_along_z_alone = false;  ///< True if there are no rays along X and Y.
    bool is_model_chosen = false;  ///< True if the model was chosen because the program is long.
    double tolerance = 0.0;        ///< Tolerance of chords and of rotary moves, mm.
    double tool_tolerance = 0.0;   ///< Tolerance of round tools, mm.
    /// Consecutive moves within this distance of a line are joined, mm; 0: no moves are joined.
    double join_tolerance = 0.0;
    bool is_draft_exact = false;  ///< True for a draft of a short program, which is cut exactly.
    std::optional<std::uint32_t> at_line;      ///< Line after which the simulation was stopped.
    LengthUnit unit = LengthUnit::Millimetre;  ///< Of texts; all values here are in mm.
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

}  // namespace ncsim::report
