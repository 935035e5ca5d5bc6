// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/gcode/source.h"

#include "line_end.h"

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

}  // namespace ncsim::gcode
