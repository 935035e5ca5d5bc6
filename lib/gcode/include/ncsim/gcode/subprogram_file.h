// SPDX-License-Identifier: GPL-3.0-or-later
//
// Under which names controls keep the subprograms that a program calls.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Names of files in which the program called `name` may stand, the likeliest first: for "probe"
/// (O<probe> call) "probe.ngc" …, for "O12" (M98 P12, G65 P12) "O12", "O0012.nc", "0012.nc",
/// "12.nc" … Empty for a name that would lead into another folder.
std::vector<std::string> subprogram_files(std::string_view name);

/// Does the name of a file end as those of programs do?
bool is_program_file(std::string_view name);

}  // namespace ncsim::gcode
