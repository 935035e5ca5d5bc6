// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments of shafts and holders in TOML files.
#include "files/tool_keys.h"

#include <fmt/format.h>

namespace ncsim::setup {

std::vector<toolpath::ToolSegment> read_segments(const TomlReader& r, const TomlTable& t,
                                                 std::string_view key) {
    std::vector<toolpath::ToolSegment> segments;
    if (!t[key]) return segments;
    for (const toml::node& element : TomlReader::list(*t[key])) {
        const toml::array& values = TomlReader::list(element);
        if (values.size() != 2 && values.size() != 3) {
            r.fail(element,
                   fmt::format("'{}': expected [diameter, height] or [lower, upper, height]",
                               t.name_of(key)));
        }
        const double lower = TomlReader::number(values[0]);
        const double upper = values.size() == 3 ? TomlReader::number(values[1]) : lower;
        segments.push_back({lower, upper, TomlReader::number(values[values.size() - 1])});
    }
    return segments;
}

}  // namespace ncsim::setup
