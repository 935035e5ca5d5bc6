// SPDX-License-Identifier: GPL-3.0-or-later
//
// How every command tells what it found, and where its results go.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"

#include <string_view>

namespace ncsim::app {

/// Text for people, to stderr, printable.
void say(std::string_view text);
/// Results as they are, to stdout: JSON, commands for a CI service. Throws std::runtime_error if
/// they cannot be written.
void put_out(std::string_view text);
/// Results for people, printable: to stdout, or `aside`, to stderr, where stdout is a file's.
void put_text(std::string_view text, bool aside = false);

/// Each with its line and a caret, to stderr.
void print_findings(const gcode::SourceFile& program, const gcode::Diagnostics& diagnostics);

}  // namespace ncsim::app
