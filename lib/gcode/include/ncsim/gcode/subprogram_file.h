// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of the files in which controls store subprograms.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Returns the possible names of the file that contains the program `name`, most likely first: for
/// "probe" (O<probe> call) "probe.ngc" …, for "O12" (M98 P12, G65 P12) "O12", "O0012.nc",
/// "0012.nc", "12.nc" … Empty if `name` would lead into another folder.
std::vector<std::string> subprogram_files(std::string_view name);

/// True if the file name `name` has an extension of NC programs.
bool is_program_file(std::string_view name);

}  // namespace ncsim::gcode
