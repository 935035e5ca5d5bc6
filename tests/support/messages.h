// SPDX-License-Identifier: GPL-3.0-or-later
//
// Matches message texts against the rows of message tables (*_messages.def).
#pragma once

#include "ncsim/gcode/diagnostic.h"

#include <string>
#include <string_view>

namespace ncsim::test {

/// Returns "code: text", the form in which test cases state expected messages.
inline std::string said(const gcode::Diagnostic& d) {
    return d.code + ": " + d.message;
}

/// True if `said` is the text of `row` with any text in place of each "{}".
inline bool says(std::string_view said, const gcode::MessageText& row) {
    const std::string begin = std::string(row.code) + ": ";
    if (!said.starts_with(begin)) return false;
    said.remove_prefix(begin.size());
    std::string_view text = row.text;
    std::size_t hole = text.find("{}");
    if (hole == std::string_view::npos) return said == text;
    if (!said.starts_with(text.substr(0, hole))) return false;
    said.remove_prefix(hole);
    for (;;) {
        text.remove_prefix(hole + 2);
        hole = text.find("{}");
        if (hole == std::string_view::npos)
            return said.size() > text.size() && said.ends_with(text);
        const std::size_t found = said.find(text.substr(0, hole), 1);
        if (found == std::string_view::npos) return false;
        said.remove_prefix(found + hole);
    }
}

}  // namespace ncsim::test
