// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in texts.
#pragma once

#include <string>

namespace ncsim::report {

/// Returns the shortest text of `value`, rounded to a millionth, which hides the rounding errors of
/// units and offsets.
std::string plain_number(double value);

}  // namespace ncsim::report
