// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text that stands in HTML or XML.
#pragma once

#include <string>
#include <string_view>

namespace ncsim::report {

/// `text`, printable, for places between tags and in quoted attributes. Bytes beyond ASCII stay as
/// they are.
std::string escaped(std::string_view text);

}  // namespace ncsim::report
