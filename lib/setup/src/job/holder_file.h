// SPDX-License-Identifier: GPL-3.0-or-later
//
// Holder files (TOML): holders, and the assignment of tools to holders.
//
//     [[holder]]
//     name = "ER16"
//     segments = [[28, 15], [28, 40, 10], [40, 25]]  # from below: [diameter, height], or
//                                                    # [lower, upper, height]; mm
//     [[tool]]
//     number = 3
//     holder = "ER16"
//     stick_out = 38            # from the tip to the holder, mm
//     flutes = 22               # flute length, mm
//     shank = 12                # diameter, mm
//     neck = [11.5, 10]         # diameter, length above the flutes, mm
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/toolpath/tool_spec.h"

#include <string>
#include <vector>

namespace ncsim::setup {

/// Returns the values of a holder file by tool. Throws: std::runtime_error with file, line and
/// column for a file that is not TOML, unknown keys and holders, and invalid values.
std::vector<toolpath::ToolSpec> read_holder_file(const std::string& path, InputSet& inputs);

/// Completes unspecified values of flutes, neck, shank and holder in `spec` from `more`.
void complete_assembly(toolpath::ToolSpec& spec, const toolpath::ToolSpec& more);

}  // namespace ncsim::setup
