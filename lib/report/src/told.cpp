// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sources of values, as text.
#include "ncsim/report/told.h"

#include "ncsim/report/plain_text.h"

#include <fmt/format.h>

namespace ncsim::report {

const char* name_of(toolpath::ToldBy by) {
    switch (by) {
        case toolpath::ToldBy::Comment: return "comment";
        case toolpath::ToldBy::Option: return "option";
        case toolpath::ToldBy::Table: return "table";
        case toolpath::ToldBy::Assumption: break;
    }
    return "assumption";
}

std::string told(toolpath::ToldBy by, gcode::SourceSpan span, const std::string& text,
                 const std::string& file, const char* option) {
    switch (by) {
        case toolpath::ToldBy::Comment:
            return fmt::format("line {}: ({})", span.line, one_line(text));
        case toolpath::ToldBy::Option: return fmt::format("from {}", option);
        case toolpath::ToldBy::Table: {
            std::string where = "from " + one_line(file);
            if (span.line > 0) where += fmt::format(", line {}", span.line);
            return text.empty() ? where : fmt::format("{}: {}", where, one_line(text));
        }
        case toolpath::ToldBy::Assumption: break;
    }
    return fmt::format("assumed: {}", one_line(text));
}

}  // namespace ncsim::report
