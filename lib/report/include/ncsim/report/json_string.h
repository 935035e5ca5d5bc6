// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text as JSON and TOML have it.
#pragma once

#include <string>
#include <string_view>

namespace ncsim::report {

/// `text` in quotes, with escapes, without what CI services look for; bytes that are no UTF-8
/// become U+FFFD.
std::string json_string(std::string_view text);

}  // namespace ncsim::report
