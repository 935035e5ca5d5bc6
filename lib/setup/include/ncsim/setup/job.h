// SPDX-License-Identifier: GPL-3.0-or-later
//
// Job: the text of a program, with its tools, stock and options.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/source.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/job_options.h"
#include "ncsim/toolpath/tool_table.h"
#include "ncsim/verify/machine_description.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

/// A reason for doubt about the files and options of a job: `file-origin`, `contradiction`.
struct JobDoubt {
    std::string_view reason;  ///< A reason of verify::reasons(); static.
    std::string message;
    gcode::SourceSpan span{};  ///< Position in the program; line 0 if there is none.
};

/// A program with its set-up.
struct Job {
    JobOptions options;  ///< Completed from the job file.
    /// In a file with several programs, empty lines replace all but this program.
    gcode::SourceFile program;
    /// "O0101" if the file has several programs, "set-up 2, back" if the job has several set-ups;
    /// otherwise empty.
    std::string label;
    std::size_t programs_in_file = 1;
    gcode::InterpreterOptions interpreter;
    /// Tools from options, then from a job file, tables and comments. The first tool of a number
    /// counts.
    std::vector<toolpath::ToolEntry> tools;
    std::optional<toolpath::StockEntry> stock;
    std::vector<toolpath::OperationName> operations;  ///< Names in the order of lines.
    /// Fixtures of the job file, in addition to the fixtures of the machine.
    std::vector<verify::Fixture> fixtures;
    bool fixtures_specified = false;    ///< Also true if the specified list is empty.
    std::optional<double> below_stock;  ///< Free space below the stock, mm.
    /// Place of the tool when the program starts, in G54 as it is at the first move, mm.
    std::optional<Vec3> start;
    gcode::Diagnostics diagnostics;  ///< Warnings about contradictory comments and tables.
    /// True if the unit of programs without G20 and G21 is unspecified.
    bool units_assumed = true;
    std::vector<JobDoubt> doubts;
};

/// Reads the program and the files named in `options`. Throws: std::runtime_error if a file cannot
/// be read, the program is not text, or a job file or tool table is invalid. Requires: `inputs`
/// outlives the job, because subprograms are read later.
Job read_job(JobOptions options, InputSet& inputs);

/// Returns the step of the job file that `options` select: the specified step, the only step with
/// options.program, or the only step. Empty if there is no job file with set-ups.
/// Throws: std::runtime_error if the job file is invalid, or if no step or several steps match.
std::optional<std::size_t> selected_step(const JobOptions& options, InputSet& inputs);

/// Makes the job of a program whose text is given. Subprograms in further files are not searched.
Job job_of(gcode::SourceFile program, JobOptions options = {});

}  // namespace ncsim::setup
