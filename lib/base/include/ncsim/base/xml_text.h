// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text in XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace ncsim {

/// Returns `text` for use between tags and in quoted attributes.
std::string xml_escaped(std::string_view text);

}  // namespace ncsim
