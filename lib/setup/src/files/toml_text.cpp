// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quoted texts of TOML.
#include "files/toml_text.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/base/utf8.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

namespace ncsim::setup {

std::string json_string(std::string_view text) {
    using Json = nlohmann::json;
    return printable_json(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
}

// Returns `text` as a TOML string. JSON escapes ASCII control characters; further control
// characters are escaped here, because editors obey control characters instead of showing them.
std::string quoted(const std::string& text) {
    const std::string json = json_string(text);
    std::string result;
    for (std::string_view rest = json; !rest.empty();) {
        const Character c = first_character(rest);
        result += c.is_control() ? fmt::format("\\u{:04X}", c.code) : rest.substr(0, c.bytes);
        rest.remove_prefix(c.bytes);
    }
    return result;
}

}  // namespace ncsim::setup
