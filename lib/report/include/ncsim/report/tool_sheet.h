// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tools of a program: each that is called or described, its shape, who said so, what it does.
#pragma once

#include "ncsim/report/facts.h"
#include "ncsim/toolpath/tool_table.h"

#include <string>
#include <vector>

namespace ncsim::report {

/// Text for people. `described`: all tools that somebody describes, used or not.
std::string tool_sheet(const ProgramFacts& program,
                       const std::vector<toolpath::ToolEntry>& described);

/// The same as JSON, with what was found. `name` is the program's.
std::string tool_sheet_json(const std::string& name, const ProgramFacts& program,
                            const std::vector<toolpath::ToolEntry>& described);

}  // namespace ncsim::report
