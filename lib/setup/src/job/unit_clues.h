// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unit of a program without G20 and G21, derived from tools and numbers of the program.
#pragma once

#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/tool_table.h"

#include <span>

namespace ncsim::setup {

/// True if the program has neither G20 nor G21, all sizes in tool comments are in inches, and feeds
/// and coordinates are as small as in programs in inches.
/// Cost: the text of the tools; if the tools are in inches, a pass over the program.
bool suggests_inches(const gcode::SourceFile& program,
                     std::span<const toolpath::ToolEntry> tools_of_comments);

}  // namespace ncsim::setup
