// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text for HTML and XML.
#include "markup.h"

#include "ncsim/report/plain_text.h"

namespace ncsim::report {

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : printable(text)) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            default: out += c;
        }
    }
    return out;
}

}  // namespace ncsim::report
