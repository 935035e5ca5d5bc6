// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text below a picture.
#pragma once

#include "run/outcome.h"

#include <string>
#include <vector>

namespace ncsim::app {

/// Returns the lines that the options and the contents of the picture require; may be empty.
std::vector<std::string> caption_of(const Outcome& outcome);

}  // namespace ncsim::app
