// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is worked on: the program as text, and what is told about its tools and its stock.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/source.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/job_options.h"
#include "ncsim/toolpath/tool_table.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

/// A reason for doubt about the files and options of a job: `file-origin`, `contradiction`.
struct JobDoubt {
    std::string_view reason;  ///< Of verify::reasons(); static.
    std::string message;
    gcode::SourceSpan span{};  ///< In the program; line 0: nowhere.
};

struct Job {
    JobOptions options;  ///< As they were completed from a job file.
    /// In a file with several programs, empty lines replace all but this program.
    gcode::SourceFile program;
    std::string label;  ///< "O0101" if the file has several programs; otherwise empty.
    std::size_t programs_in_file = 1;
    gcode::InterpreterOptions interpreter;
    /// From options first, then from a job file, tables, comments: the first of a number counts.
    std::vector<toolpath::ToolEntry> tools;
    std::optional<toolpath::StockEntry> stock;
    /// Place of the tool when the program starts, in G54 as it is at the first move, mm.
    std::optional<cda::Vec3> start;
    gcode::Diagnostics diagnostics;  ///< Comments that contradict each other.
    bool units_assumed = true;       ///< The unit of programs without G20 and G21 is not specified.
    std::vector<JobDoubt> doubts;
};

/// Reads what `options` names. Throws std::runtime_error if a file cannot be read, the program is
/// not text, or a job file or tool table is none. `inputs`, from which subprograms are read later,
/// must outlive the job.
Job read_job(JobOptions options, InputSet& inputs);

/// The same of a program whose text is at hand. Subprograms in other files are not looked for.
Job job_of(gcode::SourceFile program, JobOptions options = {});

}  // namespace ncsim::setup
