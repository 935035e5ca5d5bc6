// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line: argv → Options. A pure function: it reads no files and prints nothing.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/export/camera.h"
#include "ncsim/export/render.h"
#include "ncsim/gcode/dialect.h"
#include "ncsim/toolpath/tool_spec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ncsim::app {

/// Exit codes of the program; in --help, too.
enum ExitCode : int {
    kClean = 0,
    kFindings = 1,     ///< The NC program has faults.
    kEnvironment = 2,  ///< Wrong usage, unreadable input, a failing world.
    kBug = 3,
};

/// Everything the user asked for. Lengths in mm. Empty paths: not asked for.
struct Options {
    std::string program;
    std::string png, gltf, vrml, stl, step, report, stats, xml;

    /// "cda" or "cda-flat".
    std::string model;
    std::optional<cda::Box> stock;
    std::vector<toolpath::ToolSpec> tools;
    /// For tools that nobody describes; its number is 0.
    std::optional<toolpath::ToolSpec> assumed_tool;
    bool inches = false;  ///< For programs that say neither G20 nor G21.
    bool block_delete = false;
    gcode::Dialect dialect = gcode::Dialect::Auto;
    bool strict = false;             ///< RS274/NGC as LinuxCNC runs it.
    std::vector<std::string> allow;  ///< Words declared harmless: "G187".

    double tolerance = 0.005;      ///< Of chords and of turning tools.
    double tool_tolerance = 0.05;  ///< Of round tools.
    unsigned threads = 0;          ///< 0: as many as the machine has.

    exporter::View view = exporter::View::Iso;
    exporter::Colouring colouring = exporter::Colouring::Tool;
    std::uint32_t width = 1280, height = 960;
    bool quiet = false;
    /// In the report: what each block removed. With the model "cda" ten times the work.
    bool block_volumes = true;
};

/// Nothing to run: something to say, and the exit code.
struct Farewell {
    int exit_code = kClean;
    std::string text;  ///< To stdout if the exit code is kClean, else to stderr.
};

/// The paths of all files that were asked for.
std::vector<std::string> outputs_of(const Options& options);

/// Total: any arguments give one of both.
std::variant<Options, Farewell> parse_options(const std::vector<std::string>& arguments);

}  // namespace ncsim::app
