// SPDX-License-Identifier: GPL-3.0-or-later
//
// Result of reading a comment about a tool.
#pragma once

#include "ncsim/toolpath/tool_spec.h"

#include "tools/comment_text.h"

namespace ncsim::toolpath {

/// Values of a comment about a tool. Lengths are as written, in `unit`, or in the program's units
/// if the comment has no unit.
struct ToolRemark {
    ToolSpec spec;  ///< The number is 0 if the comment has no tool number.
    text::Unit unit = text::Unit::None;
    bool certain = false;  ///< True for a form used only for tools; false for free text.
};

}  // namespace ncsim::toolpath
