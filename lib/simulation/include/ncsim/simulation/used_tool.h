// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tool of a program and the source of the description.
#pragma once

#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/tool_spec.h"
#include "ncsim/toolpath/tool_table.h"

#include <string>

namespace ncsim::simulation {

/// A tool as used in the simulation, and the source of the description.
struct UsedTool {
    toolpath::Tool tool;
    toolpath::ValueSource specified_by = toolpath::ValueSource::Comment;
    gcode::SourceSpan span;   ///< Place of the comment.
    std::string text;         ///< Text of the description.
    std::string file;         ///< Tool table; empty: the program.
    toolpath::ToolSpec spec;  ///< Specification with all assumed values.
    std::string
        assumed_values_text;        ///< Text: values that were not specified and had to be assumed.
    bool is_guess = false;          ///< True if not even the shape was specified.
    bool length_specified = false;  ///< True if the flute length was specified.
    gcode::SourceSpan first;        ///< Block that first moves the tool.
};

}  // namespace ncsim::simulation
