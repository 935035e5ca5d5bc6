// SPDX-License-Identifier: GPL-3.0-or-later
//
// What there is to tell about a program: what was seen before anything was cut, how it was cut, and
// what came out.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/vec.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/interpreter.h"
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

/// Of a program, before it is cut.
struct ProgramFacts {
    gcode::Interpretation interpretation;
    std::uint64_t moves = 0;
    std::uint64_t feed_moves = 0;
    /// Moves whose start the program does not tell; they leave no trace.
    std::uint64_t moves_from_nowhere = 0;
    std::array<bool, 3> turns{};  ///< About X, Y, Z: A, B, C.
    std::string rotation;         ///< How that turns the tool, in words.
    /// Axes X, Y, Z that the program never tells, though it cuts: taken as 0.
    std::array<bool, 3> untold{};
    /// Rapid moves of several of X, Y and Z: their boxes, mm in W, and places. A machine may move
    /// them straight or axis by axis.
    struct SlantingRapid {
        cda::Box box;
        std::uint32_t file = 0;
        gcode::SourceSpan span;
    };
    std::vector<SlantingRapid> slanting_rapids;
    bool calls_tools = false;    ///< The program changes tools.
    bool units_assumed = false;  ///< Neither the program nor the user specifies the unit.
    bool uses_machine_coordinates = false;
    cda::Box tip_positions;                      ///< Of all moves with a known start, mm, in W.
    std::map<int, verify::Distances> distances;  ///< By tool number.
    std::map<int, UsedTool> tools;               ///< Those that move.
    /// Tools that cut and are not described: the block that first moves them.
    std::map<int, gcode::SourceSpan> unknown_tools;
    std::optional<toolpath::StockEntry> stock;
    gcode::Diagnostics diagnostics;  ///< Of the interpreter, of comments, and of the survey.

    bool turns_tools() const { return turns[0] || turns[1] || turns[2]; }
};

/// How it is cut.
struct CuttingFacts {
    std::string model;
    double resolution = 0.0;              ///< Of a model that has one, mm; else 0.
    bool has_rays_along_z_alone = false;  ///< And not along X and Y, too.
    bool is_model_chosen = false;         ///< Since the program is a long one.
    double tolerance = 0.0;               ///< Of chords and of turning tools, mm.
    double tool_tolerance = 0.0;          ///< Of round tools, mm.
    /// Moves in a row within this of a line are one, mm; 0: none are joined.
    double join_tolerance = 0.0;
    bool is_draft_exact = false;           ///< A draft of a short program, cut exactly.
    std::optional<std::uint32_t> at_line;  ///< Where it was stopped.
};

/// A round tool as it was moved.
struct CutterFacts {
    int sides = 0;
    double error_mm = 0.0;
};

/// File (index into Interpretation::files, 0: the program) and line.
using BlockPlace = std::pair<std::uint32_t, std::uint32_t>;

/// Where the part is thinner than the model's resolution, and lines of the program that made it so
/// where that is thinnest; 0: the stock.
struct AliasingFacts : cda::Aliasing {
    std::uint32_t material_line = 0, gap_line = 0;
};

/// What came out.
struct PartFacts {
    cda::Lattice lattice;
    double stock_volume = 0.0;  ///< mm³
    double part_volume = 0.0;
    double part_volume_error = 0.0;         ///< Of models that are not exact.
    std::optional<AliasingFacts> aliasing;  ///< Of models that have a resolution.
    std::uint64_t hulls = 0;                ///< Cells that were subtracted.
    std::map<int, double> removed_by_tool;  ///< mm³; not where a program is verified.
    /// mm³. Only where it was asked for.
    std::map<BlockPlace, double> removed_by_block;
    std::map<int, CutterFacts> cutters;
    toolpath::SampleBounds bounds;  ///< The worst of all motions that met the stock.
    verify::Distances distances;    ///< Of the motions that were made.
};

}  // namespace ncsim::report
