// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is told about a program and does not stand in it.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/dialect.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/tool_spec.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::setup {

/// The program, and what it does not say itself. Lengths in mm.
struct JobOptions {
    std::string program;
    /// Number of the program in its file, from 0; empty: the first one, with a warning about more.
    std::optional<std::size_t> number_in_file;
    std::optional<toolpath::Stock> stock;
    /// Of stock that comes from a file.
    std::optional<std::string> stock_turn;
    std::optional<cda::Vec3> stock_move;
    std::vector<toolpath::ToolSpec> tools;
    /// For tools that nobody describes; its number is 0.
    std::optional<toolpath::ToolSpec> assumed_tool;
    std::string job;                       ///< A job file, empty: none.
    std::vector<std::string> tool_tables;  ///< Files with tools.
    std::string holders;                   ///< A file with what holds them, empty: none.
    std::optional<cda::Vec3> start;        ///< Where the tool stands at the beginning, in G54.
    /// Origins of coordinate systems in the machine, by gcode::MachineState::system.
    std::map<int, cda::Vec3> offsets;
    bool inches_assumed = false;  ///< `inches` is marked as assumed in a job file.
    std::optional<bool> inches;   ///< For programs that say neither G20 nor G21; mm.
    /// Numbers without a point count least increments; empty: not specified, which is no.
    std::optional<bool> increments;
    std::vector<std::string> subprograms;  ///< Folders, besides that of the program.
    /// Skip blocks that start with '/'; empty: not specified, which is no.
    std::optional<bool> block_delete;
    /// Values of variables at the start: "#500", "#<_depth>".
    std::map<std::string, double> variables;
    /// Radii in the registers D of cutter compensation at the start, by number, mm.
    std::map<int, double> compensation;
    gcode::Dialect dialect = gcode::Dialect::Auto;
    bool strict = false;             ///< RS274/NGC as LinuxCNC runs it.
    std::vector<std::string> allow;  ///< Words declared harmless: "G187".
    /// For a verdict: reasons for doubt that do not count, and what has to be told.
    std::vector<std::string> accept, require;
};

}  // namespace ncsim::setup
