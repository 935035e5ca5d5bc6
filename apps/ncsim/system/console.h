// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text outputs of all commands: messages to stderr, results to stdout.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"

#include "system/colour.h"

#include <string_view>

namespace ncsim::app {

/// Sets when texts for the user have colours; Auto before the first call.
void set_colour_mode(ColourMode mode);

/// Writes text for the user to stderr, with unprintable characters replaced.
void print_error(std::string_view text);
/// Writes results unchanged to stdout: JSON, commands for a CI service.
/// Throws: std::runtime_error if stdout cannot be written.
void write_stdout(std::string_view text);
/// Writes results for the user, with unprintable characters replaced: to stdout, or to stderr if
/// `aside`, because a file uses stdout.
void put_text(std::string_view text, bool aside = false);

/// Writes each diagnostic with its line and a caret to stderr.
void print_findings(const gcode::SourceFile& program, const gcode::Diagnostics& diagnostics);

}  // namespace ncsim::app
