// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tools of a program: each that is called or described, its shape, who said so, what it does.
#pragma once

#include "ncsim/report/facts.h"
#include "ncsim/toolpath/tool_table.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::report {

/// Which ways of turning a tool a program's own moves agree with: those at tilted angles that go
/// along the tool of some machine, or along Z.
struct Plunges {
    struct Tip {
        std::vector<std::string> machines;  ///< That hold the tool alike.
        std::uint64_t moves = 0;            ///< Along it, if X, Y, Z are the tip's.
    };
    bool is_tilted = false;     ///< Some move stands at such angles.
    std::uint64_t moves = 0;    ///< Along any of these, or along Z.
    std::uint64_t along_z = 0;  ///< Of axes, or of the tip in a frame that stays.
    std::vector<Tip> tip;       ///< Those with most first; none with none.
};

/// Text for people. `described`: all tools that somebody describes, used or not.
std::string tool_sheet(const ProgramFacts& program,
                       const std::vector<toolpath::ToolEntry>& described,
                       const Plunges& plunges = {});

/// The same as JSON, with what was found. `name` is the program's.
std::string tool_sheet_json(const std::string& name, const ProgramFacts& program,
                            const std::vector<toolpath::ToolEntry>& described,
                            const Plunges& plunges = {});

}  // namespace ncsim::report
