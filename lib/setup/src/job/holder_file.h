// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds the tools, as TOML: holders, and which tool is in which of them.
//
//     [[holder]]
//     name = "ER16"
//     segments = [[28, 15], [28, 40, 10], [40, 25]]  # from below: diameter, height; or lower,
//     upper,
//                                                    # height; mm
//     [[tool]]
//     number = 3
//     holder = "ER16"
//     stick_out = 38            # from the tip to the holder, mm
//     flutes = 22               # length
//     shank = 12                # diameter
//     neck = [11.5, 10]         # diameter, length above the flutes
#pragma once

#include "ncsim/setup/input.h"
#include "ncsim/toolpath/tool_spec.h"

#include <string>
#include <vector>

namespace ncsim::setup {

/// For each tool number what such a file tells. Throws std::runtime_error with file, line and
/// column for what is not TOML, unknown keys and holders, and values that make no sense.
std::vector<toolpath::ToolSpec> read_holder_file(const std::string& path, InputSet& inputs);

/// Takes from `more` what `spec` does not tell of flutes, neck, shank and holder.
void complete_assembly(toolpath::ToolSpec& spec, const toolpath::ToolSpec& more);

}  // namespace ncsim::setup
