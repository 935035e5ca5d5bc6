// SPDX-License-Identifier: GPL-3.0-or-later
//
// Job files (TOML 1.0): the set-up of a program, so that a run can be repeated. `--save-job` writes
// a job file, and `--job` reads it. Assumed values are marked by a list `assumed` and remain
// assumptions until the mark is removed.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/dialect.h"
#include "ncsim/gcode/source.h"
#include "ncsim/setup/input.h"
#include "ncsim/setup/project_file.h"
#include "ncsim/toolpath/tool_table.h"
#include "ncsim/verify/machine_description.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

/// Value of a job file that is marked as assumed.
struct AssumedValue {
    std::string name;   ///< Name in the list `assumed`, such as "start".
    std::string where;  ///< Place in the file: "job.toml:5:12".
};

/// Value of a file, for messages.
struct PlacedValue {
    std::string where;  ///< Place in the file: "job.toml:12:1".
    std::string text;   ///< The value in TOML; empty for a table.
};

/// A set-up of a job: one clamping of the part. Lengths in mm.
struct JobSetUp {
    std::string name;
    std::vector<std::string> programs;  ///< Paths as written, in the order of machining.
    /// Position of the part: the part that the previous set-up left, turned about the zero of that
    /// set-up, then moved.
    std::string turn;
    Vec3 move{};
    /// Work zero in the frame of part and fixtures.
    Vec3 zero{};
    std::optional<Vec3> start;
    std::map<int, Vec3> offsets;
    std::map<std::string, double> variables;
    std::vector<verify::Fixture> fixtures;
    bool fixtures_specified = false;
    /// Free space below the stock, as in a machine file.
    std::optional<double> below_stock;
    std::map<std::string, std::string> outputs;  ///< By format, as in JobFile::outputs.
    std::vector<AssumedValue> assumed;
    std::string where;  ///< Place in the file: "job.toml:12:1".
};

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
    std::optional<Vec3> start;    ///< Initial tool position, in G54.
    std::map<int, Vec3> offsets;  ///< Origins in machine coordinates, by MachineState::system.
    std::string holders;          ///< Name of a file, as written.
    std::optional<toolpath::Stock> stock;
    std::vector<toolpath::ToolEntry> tools;  ///< Including ToolSpec::assumed.
    /// Set-ups in the order of machining; empty if `program` is the only one.
    std::vector<JobSetUp> set_ups;
    std::vector<verify::Fixture> fixtures;  ///< Fixtures of the only set-up.
    bool fixtures_specified = false;
    std::optional<double> below_stock;
    /// Options of commands: machine, tool tables, accuracy, rules. File names are as written.
    std::vector<OptionSetting> settings;
    /// Output files of ncsim run by format ("png", "step"), as written; of the last set-up.
    std::map<std::string, std::string> outputs;
    std::vector<AssumedValue> assumed;  ///< In addition to units, dialect, stock and tools.
    /// Values by key, for messages: "stock", "tool 3", "variables #500", "offsets G54".
    std::map<std::string, PlacedValue> values;
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

/// Options of commands that a job file may contain, by long name. A key has '_' instead of '-'.
inline constexpr std::string_view kJobOptions[] = {
    "machine",     "tool-table", "subprograms", "tolerance", "tool-tolerance", "model",
    "rapid",       "design",     "design-tol",  "select",    "ignore",         "severity",
    "baseline",    "cut-free",   "air-cuts",    "max-time",  "max-memory",     "warnings-as-errors",
    "report-units"};

/// A program of a job.
struct JobStep {
    std::size_t set_up = 1;  ///< Number of the set-up, from 1.
    std::string name;        ///< Name of the set-up; may be empty.
    std::string program;     ///< Path, seen from the working directory.
    bool begins_set_up = true;
    /// "set-up 2, back"; with the program's name if the set-up has several programs.
    std::string label;
};

/// Returns the programs of a job in the order of machining; `folder` is the folder of the file.
/// Empty if the file names no program.
std::vector<JobStep> steps_of(const JobFile& file, const std::string& folder);

/// Reads a job file. Throws: std::runtime_error with line and column if `file` is not TOML, or
/// contains an unknown key or an invalid value. Unknown keys are refused because an ignored key
/// would change the set-up unnoticed.
JobFile parse_job_file(const gcode::SourceFile& file);
/// Does the same for the file `path`, with the meshes of its fixtures.
JobFile read_job_file(const std::string& path, InputSet& inputs);
/// True if `path` has the ending of a job file, .toml.
bool is_job_file(const std::string& path);
/// True if the TOML text of `file` is a job and not a machine: it has a key that only jobs have.
/// Throws: std::runtime_error with line and column if `file` is not TOML.
bool is_job_text(const gcode::SourceFile& file);
/// Returns the path of an output that a job file in `folder` names.
/// Throws: std::runtime_error, beginning with `where`, if the output is not below `folder`.
std::string output_below(const std::string& folder, const std::string& name,
                         const std::string& where);

}  // namespace ncsim::setup
