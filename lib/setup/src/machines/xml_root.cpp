// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses machine files in XML.
#include "machines/xml_root.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace ncsim::setup {

const tinyxml2::XMLElement* xml_root(tinyxml2::XMLDocument& document, const std::string& text,
                                     const std::string& name, const std::string& tag,
                                     const std::string& what) {
    if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
        throw std::runtime_error(fmt::format("{}:{}: this is no XML that can be read ({})", name,
                                             std::max(1, document.ErrorLineNum()),
                                             document.ErrorName()));
    }
    const tinyxml2::XMLElement* root = document.RootElement();
    if (!root || root->Name() != tag)
        throw std::runtime_error(
            fmt::format("{}:{}: expected <{}>{}", name, root ? root->GetLineNum() : 1, tag, what));
    return root;
}

}  // namespace ncsim::setup
