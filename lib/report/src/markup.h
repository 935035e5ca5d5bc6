// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text for HTML and XML.
#pragma once

#include <string>
#include <string_view>

namespace ncsim::report {

/// Returns printable(text) for use between tags and in quoted attributes. Bytes beyond ASCII stay
/// unchanged.
std::string escaped(std::string_view text);

/// Returns `text` with bytes that are not UTF-8 replaced by U+FFFD.
std::string valid_utf8(const std::string& text);

}  // namespace ncsim::report
