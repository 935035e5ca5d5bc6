// SPDX-License-Identifier: GPL-3.0-or-later
//
// How every command tells what it found, and where its results go.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/tool_table.h"
#include "ncsim/verify/region.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

/// "error", "warning", "note".
const char* name_of(gcode::Severity severity);
/// "comment", "option" …
const char* name_of(toolpath::ToldBy by);

/// Text for people, to stderr, printable.
void say(std::string_view text);
/// Results as they are, to stdout: JSON, commands for a CI service. Throws std::runtime_error if
/// they cannot be written.
void put_out(std::string_view text);
/// Results for people, printable: to stdout, or `aside`, to stderr, where stdout is a file's.
void put_text(std::string_view text, bool aside = false);

/// Each with its line and a caret, to stderr.
void print_findings(const gcode::SourceFile& program, const gcode::Diagnostics& diagnostics);
/// An array of {severity, code, message, file, line, column, count}.
nlohmann::ordered_json findings_json(const gcode::Diagnostics& diagnostics);

/// "3-7, 12": the first few of them.
std::string lines_text(const std::vector<verify::LineRange>& lines);

/// One line of JSON; bytes that are no UTF-8 become U+FFFD.
std::string to_line(const nlohmann::ordered_json& json);
/// JSON for files and for the standard output, a line for each thing; the same of bytes.
std::string to_text(const nlohmann::ordered_json& json);

}  // namespace ncsim::app
