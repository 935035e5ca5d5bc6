// SPDX-License-Identifier: GPL-3.0-or-later
//
// Root element of machine files in XML.
#pragma once

#include <tinyxml2.h>

#include <string>

namespace ncsim::setup {

/// Parses `text` into `document` and returns the root, an element `tag`. `name` is the name of the
/// file, and `what` further describes the expected root in messages. Throws: std::runtime_error
/// with file and line.
const tinyxml2::XMLElement* xml_root(tinyxml2::XMLDocument& document, const std::string& text,
                                     const std::string& name, const std::string& tag,
                                     const std::string& what = {});

}  // namespace ncsim::setup
