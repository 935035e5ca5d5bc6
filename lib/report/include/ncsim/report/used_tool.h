// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tool of a program, and who says what it is.
#pragma once

#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/tool_spec.h"
#include "ncsim/toolpath/tool_table.h"

#include <string>

namespace ncsim::report {

/// A tool as it will be used, and why it is taken to be so.
struct UsedTool {
    toolpath::Tool tool;
    toolpath::ToldBy told_by = toolpath::ToldBy::Comment;
    gcode::SourceSpan span;    ///< Of the comment.
    std::string text;          ///< As told.
    std::string file;          ///< Of a table; empty: the program.
    toolpath::ToolSpec spec;   ///< With all that was filled in.
    std::string filled_in;     ///< What was not told and had to be assumed.
    bool is_guess = false;     ///< Not even its shape was told.
    bool length_told = false;  ///< Of its flutes.
    gcode::SourceSpan first;   ///< The block that first moves it.
};

}  // namespace ncsim::report
