// SPDX-License-Identifier: GPL-3.0-or-later
//
// Escapes the special characters of XML.
#include "ncsim/base/xml_text.h"

namespace ncsim {

std::string xml_escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            default: result += c;
        }
    }
    return result;
}

}  // namespace ncsim
