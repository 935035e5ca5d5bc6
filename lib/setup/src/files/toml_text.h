// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace ncsim::setup {

/// A text as TOML has it: in quotes, on one line.
std::string quoted(const std::string& text);

}  // namespace ncsim::setup
