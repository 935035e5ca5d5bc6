// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text for HTML and XML.
#include "markup.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/base/xml_text.h"

#include "json.h"

namespace ncsim::report {

std::string escaped(std::string_view text) {
    return xml_escaped(printable(text));
}

std::string valid_utf8(const std::string& text) {
    const std::string quoted = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
    return Json::parse(quoted).get<std::string>();
}

}  // namespace ncsim::report
