// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sources of values, as text.
#include "ncsim/report/value_source.h"

#include "ncsim/base/plain_text.h"

#include <fmt/format.h>

namespace ncsim::report {

const char* name_of(toolpath::ValueSource by) {
    switch (by) {
        case toolpath::ValueSource::Comment: return "comment";
        case toolpath::ValueSource::Option: return "option";
        case toolpath::ValueSource::Table: return "table";
        case toolpath::ValueSource::Assumption: break;
    }
    return "assumption";
}

std::string specified(toolpath::ValueSource by, gcode::SourceSpan span, const std::string& text,
                      const std::string& file, const char* option) {
    switch (by) {
        case toolpath::ValueSource::Comment:
            return fmt::format("line {}: ({})", span.line, one_line(text));
        case toolpath::ValueSource::Option: return fmt::format("from {}", option);
        case toolpath::ValueSource::Table: {
            std::string where = "from " + one_line(file);
            if (span.line > 0) where += fmt::format(", line {}", span.line);
            return text.empty() ? where : fmt::format("{}: {}", where, one_line(text));
        }
        case toolpath::ValueSource::Assumption: break;
    }
    return fmt::format("assumed: {}", one_line(text));
}

}  // namespace ncsim::report
