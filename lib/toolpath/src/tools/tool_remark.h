// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/toolpath/tool_spec.h"

#include "tools/text.h"

namespace ncsim::toolpath {

/// What one comment says about a tool. Lengths are as written, in `unit`, or in the program's
/// units where there is none.
struct ToolRemark {
    ToolSpec spec;  ///< number 0: the comment does not say which.
    text::Unit unit = text::Unit::None;
    bool certain = false;  ///< A form that only tools are written in; else free text.
};

}  // namespace ncsim::toolpath
