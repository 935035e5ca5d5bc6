// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing of TOML.
#pragma once

#include <string>

namespace ncsim::setup {

/// Returns a text in TOML form: in quotes, on a single line.
std::string quoted(const std::string& text);

}  // namespace ncsim::setup
