// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quoted texts of TOML.
#include "files/toml_text.h"

#include "ncsim/report/json_string.h"

#include <fmt/format.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace ncsim::setup {

namespace {

/// Returns characters that an editor obeys instead of showing, as UTF-8 and as escapes of TOML:
/// U+007F, the control characters of Latin-1, and characters that change the direction of writing.
std::vector<std::pair<std::string, std::string>> escapes() {
    std::vector<std::pair<std::string, std::string>> all{{"\x7f", "\\u007F"},
                                                         {"\xd8\x9c", "\\u061C"}};
    for (unsigned c = 0x80; c < 0xa0; ++c)
        all.emplace_back(std::string("\xc2") + static_cast<char>(c), fmt::format("\\u{:04X}", c));
    for (const auto& [first, last] :
         {std::pair{0x200eU, 0x200fU}, {0x2028U, 0x202eU}, {0x2066U, 0x2069U}}) {
        for (unsigned c = first; c <= last; ++c) {
            std::string character = "\xe2";
            character += static_cast<char>(0x80U | (c >> 6 & 0x3fU));
            character += static_cast<char>(0x80U | (c & 0x3fU));
            all.emplace_back(std::move(character), fmt::format("\\u{:04X}", c));
        }
    }
    return all;
}

}  // namespace

// Returns `text` as a string of JSON, with more characters escaped.
std::string quoted(const std::string& text) {
    static const auto replacements = escapes();
    std::string result = report::json_string(text);
    for (const auto& [character, escape] : replacements) {
        for (std::size_t at = 0; (at = result.find(character, at)) != std::string::npos;)
            result.replace(at, character.size(), escape);
    }
    return result;
}

}  // namespace ncsim::setup
