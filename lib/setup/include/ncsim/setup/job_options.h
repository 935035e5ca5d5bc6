// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of a job: values that the program does not contain.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/dialect.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/tool_spec.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::setup {

/// The program, and values that it does not contain. Lengths in mm.
struct JobOptions {
    std::string program;
    /// Number of the program in its file, from 0; empty for the first, with a warning about further
    /// programs.
    std::optional<std::size_t> number_in_file;
    std::optional<toolpath::Stock> stock;
    /// Placement of a stock from a file.
    std::optional<std::string> stock_turn;
    std::optional<Vec3> stock_move;
    std::vector<toolpath::ToolSpec> tools;
    /// Specification used for undescribed tools; its number is 0.
    std::optional<toolpath::ToolSpec> assumed_tool;
    std::string job;  ///< Job file; empty if none.
    /// Program of a job with set-ups, numbered from 0 in the order of machining (steps_of()); empty
    /// if `program` identifies the step, or if there is only one. With both, `program` replaces the
    /// program of the step.
    std::optional<std::size_t> job_step;
    /// Stock that the previous step of the job left, placed for this step.
    std::optional<toolpath::Stock> left_stock;
    std::vector<std::string> tool_tables;  ///< Files of tool tables.
    std::string holders;                   ///< File of holders; empty if none.
    std::optional<Vec3> start;             ///< Initial tool position, in G54.
    /// Origins of coordinate systems in machine coordinates, by gcode::MachineState::system.
    std::map<int, Vec3> offsets;
    bool inches_assumed = false;  ///< True if a job file marks `inches` as assumed.
    std::optional<bool> inches;   ///< Unit of programs without G20 and G21; default: mm.
    /// True if numbers without a point count least increments; unspecified means false.
    std::optional<bool> increments;
    /// Folders of subprograms, in addition to the folder of the program.
    std::vector<std::string> subprograms;
    /// True to skip blocks that start with '/'; unspecified means false.
    std::optional<bool> block_delete;
    /// Initial values of variables: "#500", "#<_depth>".
    std::map<std::string, double> variables;
    /// Initial radii in the registers D of cutter compensation, by number, mm.
    std::map<int, double> compensation;
    gcode::Dialect dialect = gcode::Dialect::Auto;
    bool strict = false;             ///< RS274/NGC as LinuxCNC runs it.
    std::vector<std::string> allow;  ///< Words declared harmless: "G187".
    /// For a verdict: accepted reasons for doubt, and values that must be specified.
    std::vector<std::string> accept, require;
};

}  // namespace ncsim::setup
