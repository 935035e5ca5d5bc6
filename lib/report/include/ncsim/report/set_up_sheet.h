// SPDX-License-Identifier: GPL-3.0-or-later
//
// The set-up sheet of a job as HTML: a page on paper for each set-up, with the values that the
// operator needs at the machine.
#pragma once

#include "ncsim/report/length_unit.h"
#include "ncsim/simulation/facts.h"
#include "ncsim/toolpath/tool_table.h"

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::report {

/// A set-up on the sheet. All texts may contain any characters.
struct SheetSetUp {
    std::string title;    ///< "set-up 2, back"; may be empty.
    std::string program;  ///< File of the program.
    /// Name and value of part, zero, start, machine and so on.
    std::vector<std::pair<std::string, std::string>> values;
    std::vector<std::string> fixtures;  ///< One line each.
    std::vector<std::string> assumed;   ///< Values to measure at the machine, one line each.
    const simulation::ProgramFacts* facts = nullptr;
    std::vector<toolpath::ToolEntry> described;  ///< Tools of the job, for their length offsets.
};

/// Writes the sheet. `job` is the name in the heading. The same values give the same bytes.
void write_set_up_sheet(std::ostream& out, const std::string& job,
                        const std::vector<SheetSetUp>& set_ups,
                        LengthUnit unit = LengthUnit::Millimetre);

}  // namespace ncsim::report
