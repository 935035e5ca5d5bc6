// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sources of values, as text.
#pragma once

#include "ncsim/gcode/source.h"
#include "ncsim/toolpath/tool_table.h"

#include <string>

namespace ncsim::report {

/// Returns "comment", "option" …
const char* name_of(toolpath::ValueSource by);

/// Returns the source of a value: "line 2: (…)", "from tool.tbl, line 3: …", "from --tool".
std::string specified(toolpath::ValueSource by, gcode::SourceSpan span, const std::string& text,
                      const std::string& file, const char* option);

}  // namespace ncsim::report
