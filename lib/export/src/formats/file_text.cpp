// SPDX-License-Identifier: GPL-3.0-or-later
//
// UTF-8, XML text and numbers for all formats.
#include "formats/file_text.h"

#include "ncsim/base/number_text.h"
#include "ncsim/base/utf8.h"
#include "ncsim/base/xml_text.h"

namespace ncsim::exporter {

std::string printable_utf8(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const Character c = first_character(text);
        result += c.is_valid() && !c.is_control() ? text.substr(0, c.bytes) : "\xEF\xBF\xBD";
        text.remove_prefix(c.bytes);
    }
    return result;
}

std::string xml_text(std::string_view text) {
    return xml_escaped(printable_utf8(text));
}

void append_number(std::string& text, double number) {
    append_shortest(text, number + 0.0);  // -0 + 0 is 0
}

}  // namespace ncsim::exporter
