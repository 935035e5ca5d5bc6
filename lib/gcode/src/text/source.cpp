// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of a program.
#include "ncsim/gcode/source.h"

#include "text/line_end.h"

namespace ncsim::gcode {

std::string_view line_text(const SourceFile& file, std::uint32_t line) {
    std::string_view rest = after_byte_order_mark(file.text);
    for (std::uint32_t n = 1; !rest.empty(); ++n) {
        const LineEnd end = find_line_end(rest);
        if (n == line) return rest.substr(0, end.length);
        rest.remove_prefix(end.next);
    }
    return {};
}

std::vector<std::string_view> lines_of(const SourceFile& file) {
    std::vector<std::string_view> lines;
    std::string_view rest = after_byte_order_mark(file.text);
    while (!rest.empty()) {
        const LineEnd end = find_line_end(rest);
        lines.push_back(rest.substr(0, end.length));
        rest.remove_prefix(end.next);
    }
    return lines;
}

}  // namespace ncsim::gcode
