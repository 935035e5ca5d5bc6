// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tools of a program: each called or described tool with shape, source of the description, and
// use.
#pragma once

#include "ncsim/report/length_unit.h"
#include "ncsim/simulation/facts.h"
#include "ncsim/simulation/plunges.h"
#include "ncsim/toolpath/tool_table.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::report {

using simulation::Plunges;

/// Returns the sheet as text. `described` are all described tools, used or not.
std::string tool_sheet(const simulation::ProgramFacts& program,
                       const std::vector<toolpath::ToolEntry>& described,
                       const Plunges& plunges = {}, LengthUnit unit = LengthUnit::Millimetre);

/// Returns the sheet as JSON, with the diagnostics. `name` is the name of the program, `set_up`
/// that of its set-up; empty outside a job.
std::string tool_sheet_json(const std::string& name, const std::string& set_up,
                            const simulation::ProgramFacts& program,
                            const std::vector<toolpath::ToolEntry>& described,
                            const Plunges& plunges = {});

}  // namespace ncsim::report
