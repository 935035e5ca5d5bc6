// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run works on: the program as text, and what is told about its tools and its stock.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/tool_table.h"

#include "budget.h"
#include "input.h"
#include "run_options.h"

#include <optional>
#include <string>
#include <vector>

namespace ncsim::app {

struct Job {
    Options options;
    gcode::SourceFile program;
    gcode::InterpreterOptions interpreter;
    /// From options first, then from a job file, tables, comments: the first of a number counts.
    std::vector<toolpath::ToolEntry> tools;
    std::optional<toolpath::StockEntry> stock;
    /// Where the tool stands when the program starts, in G54, mm.
    std::optional<cda::Vec3> start;
    gcode::Diagnostics diagnostics;  ///< Comments that contradict each other.
    Budget budget;
};

/// Tells where a coordinate system lies in the machine (mm), by MachineState::system.
void tell_offset(gcode::InterpreterOptions& options, int system, cda::Vec3 origin);

/// Reads what `options` names. Throws std::runtime_error if a file cannot be read, the program is
/// not text, or a job file or tool table is none. `inputs`, from which subprograms are read later,
/// must outlive the job.
Job read_job(Options options, InputSet& inputs);

}  // namespace ncsim::app
