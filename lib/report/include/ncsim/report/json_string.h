// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quoted strings for JSON and TOML.
#pragma once

#include <string>
#include <string_view>

namespace ncsim::report {

/// Returns `text` in quotes, with escapes and without markers that CI services interpret. Bytes
/// that are not UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

}  // namespace ncsim::report
