// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of a program text.
#pragma once

#include <string_view>
#include <vector>

namespace ncsim::report {

/// Returns the lines of `text` without line ends, which are LF, CR LF or CR.
std::vector<std::string_view> lines_of(std::string_view text);

}  // namespace ncsim::report
