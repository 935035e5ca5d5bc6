// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/toml_text.h"

#include "ncsim/report/json_string.h"

namespace ncsim::setup {

// As JSON has it, but for one character.
std::string quoted(const std::string& text) {
    std::string result = report::json_string(text);
    for (std::size_t at = 0; (at = result.find('\x7f', at)) != std::string::npos;)
        result.replace(at, 1, "\\u007F");
    return result;
}

}  // namespace ncsim::setup
