// SPDX-License-Identifier: GPL-3.0-or-later
//
// Job files (TOML 1.0): everything a program does not say about its set-up, so that it can be run
// again. What `--save-job` writes, `--job` reads. Values that a run assumed are marked by a list
// `assumed`, and stay assumptions until the mark is removed.
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

/// What a job file says; what it does not say is empty. Lengths in mm, angles in degrees.
struct JobFile {
    std::string program;  ///< As written: absolute, or seen from the folder of the job file.
    std::optional<bool> inches;
    std::optional<gcode::Dialect> dialect;
    bool strict = false;
    std::optional<bool> block_delete;
    std::optional<bool> increments;
    std::map<std::string, double> variables;  ///< At the start: "#500", "#<_depth>".
    std::map<int, double> compensation;       ///< Radii in the registers D, by number.
    std::vector<std::string> allow, accept, require;
    std::optional<cda::Vec3> start;    ///< Where the tool stands at the beginning, in G54.
    std::map<int, cda::Vec3> offsets;  ///< Origins in the machine, by MachineState::system.
    std::string holders;               ///< A file, as written.
    std::optional<toolpath::Stock> stock;
    std::vector<toolpath::ToolEntry> tools;  ///< With ToolSpec::assumed.
    bool units_assumed = false, dialect_assumed = false;
    bool stock_assumed = false, stock_place_assumed = false;
    /// Version 1, of ncsim 0.1, does not record what was assumed.
    bool has_unknown_origin = false;
};

/// Name of a variable as the interpreter has it ("#500", "#<_depth>"); empty if it is none.
std::optional<std::string> variable_name(std::string_view text);
/// Number of a register of cutter compensation, 1 to 9999, as in "D1"; empty if it is none.
std::optional<int> compensation_register(std::string_view text);

/// Throws std::runtime_error with line and column if `file` is no TOML, or says something that is
/// not known or makes no sense: a key that is passed over is a set-up that is not what it seems.
JobFile parse_job_file(const gcode::SourceFile& file);

/// What a job file tells people beside its values: remarks of one line each.
struct JobRemarks {
    std::string stock;
    std::vector<std::vector<std::string>> tools;  ///< For each of JobFile::tools.
    /// Tools to fill in, since nobody describes them, and the line from which they move.
    std::map<int, std::uint32_t> unknown_tools;
};

/// What parse_job_file() reads back. Paths stand there as they are in `file`.
void write_job_file(std::ostream& out, const JobFile& file, const JobRemarks& remarks);

}  // namespace ncsim::setup
