// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text for HTML and XML.
#include "markup.h"

#include "ncsim/report/plain_text.h"

#include "json.h"

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

std::string valid_utf8(const std::string& text) {
    const std::string quoted = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
    return Json::parse(quoted).get<std::string>();
}

}  // namespace ncsim::report
