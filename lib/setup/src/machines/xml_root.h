// SPDX-License-Identifier: GPL-3.0-or-later
//
// How machine files in XML begin.
#pragma once

#include <tinyxml2.h>

#include <string>

namespace ncsim::setup {

/// Reads `text` into `document`; its root, an element called `tag`. Throws std::runtime_error with
/// `name` (of the file) and line, and `what` was expected beside the tag, if anything is to be
/// said.
const tinyxml2::XMLElement* xml_root(tinyxml2::XMLDocument& document, const std::string& text,
                                     const std::string& name, const std::string& tag,
                                     const std::string& what = {});

}  // namespace ncsim::setup
