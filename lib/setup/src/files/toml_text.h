// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing of TOML.
#pragma once

#include <string>
#include <string_view>

namespace ncsim::setup {

/// Returns `text` in quotes as in JSON, without markers that CI services interpret. Bytes that are
/// not UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

/// Returns a text in TOML form: in quotes, on a single line.
std::string quoted(const std::string& text);

}  // namespace ncsim::setup
