// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tool tables as CSV with a line of names, from spreadsheets and CAM programs.
#pragma once

#include "ncsim/gcode/source.h"

#include "tools/tool_collector.h"

#include <string_view>

namespace ncsim::toolpath {

/// Returns true if the first line with text names columns, among them a tool number and a diameter.
bool is_csv_table(std::string_view text);

/// Reads a table with fields as in RFC 4180, separated by comma, semicolon or tab; lines end with a
/// line feed, a carriage return, or both. Names of columns decide, in any order and case; columns
/// with unknown names are not read. Lengths are in the unit of the value, of the name, or of a
/// column `metric` or `unit`; otherwise in `unit` mm. A first line "sep=;" is not a row. A line
/// that begins with # is a comment, unless the line has a tool number.
/// Requires: is_csv_table(file.text).
/// Source: RFC 4180; columns of Carbide Create as in converters of the Carbide Create community.
void read_csv_table(const gcode::SourceFile& file, double unit, Collector& out);

}  // namespace ncsim::toolpath
