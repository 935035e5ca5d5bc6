// SPDX-License-Identifier: GPL-3.0-or-later
//
// Job files (TOML 1.0): the set-up of a program, so that a run can be repeated. `--save-job` writes
// a job file, and `--job` reads it. Assumed values are marked by a list `assumed` and remain
// assumptions until the mark is removed.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/dialect.h"
#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/tool_table.h"

#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

/// Content of a job file; unspecified values are empty. Lengths in mm, angles in degrees.
struct JobFile {
    std::string program;  ///< Path as written: absolute, or relative to the folder of the job file.
    std::optional<bool> inches;
    std::optional<gcode::Dialect> dialect;
    bool strict = false;
    std::optional<bool> block_delete;
    std::optional<bool> increments;
    std::map<std::string, double> variables;  ///< Initial values: "#500", "#<_depth>".
    std::map<int, double> compensation;       ///< Radii in the registers D, by number, mm.
    std::vector<std::string> allow, accept, require;
    std::optional<cda::Vec3> start;    ///< Initial tool position, in G54.
    std::map<int, cda::Vec3> offsets;  ///< Origins in machine coordinates, by MachineState::system.
    std::string holders;               ///< Name of a file, as written.
    std::optional<toolpath::Stock> stock;
    std::vector<toolpath::ToolEntry> tools;  ///< Including ToolSpec::assumed.
    bool units_assumed = false, dialect_assumed = false;
    bool stock_assumed = false, stock_place_assumed = false;
    /// True for version 1, of ncsim 0.1, which does not record assumptions.
    bool has_unknown_origin = false;
};

/// Returns the interpreter's name of a variable ("#500", "#<_depth>"); empty if `text` is not a
/// variable.
std::optional<std::string> variable_name(std::string_view text);
/// Returns the number of a register of cutter compensation, 1 to 9999, as in "D1"; empty for other
/// texts.
std::optional<int> compensation_register(std::string_view text);

/// Reads a job file. Throws: std::runtime_error with line and column if `file` is not TOML, or
/// contains an unknown key or an invalid value. Unknown keys are refused because an ignored key
/// would change the set-up unnoticed.
JobFile parse_job_file(const gcode::SourceFile& file);

/// Remarks of one line each that explain the values of a job file.
struct JobRemarks {
    std::string stock;
    std::vector<std::vector<std::string>> tools;  ///< Remarks for each tool of JobFile::tools.
    /// Undescribed tools, to be filled in, and the line of their first move.
    std::map<int, std::uint32_t> unknown_tools;
};

/// Writes a file for parse_job_file(). Paths are written as in `file`.
void write_job_file(std::ostream& out, const JobFile& file, const JobRemarks& remarks);

}  // namespace ncsim::setup
