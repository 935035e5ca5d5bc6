// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splits a program text into lines.
#include "source_lines.h"

#include <cstddef>

namespace ncsim::report {

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find_first_of("\r\n");
        lines.push_back(text.substr(0, end));
        if (end == std::string_view::npos) break;
        const bool pair = text.substr(end, 2) == "\r\n";
        text.remove_prefix(end + (pair ? 2 : 1));
    }
    return lines;
}

}  // namespace ncsim::report
