// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments of shafts and holders in TOML files.
#include "files/tool_keys.h"

#include <fmt/format.h>

namespace ncsim::setup {

std::vector<toolpath::ToolSegment> read_segments(const TomlReader& r, const toml::node& node,
                                                 const std::string& key) {
    std::vector<toolpath::ToolSegment> segments;
    for (const toml::node& element : r.list(node, key)) {
        const toml::array& values = r.list(element, key);
        if (values.size() != 2 && values.size() != 3) {
            r.fail(element,
                   fmt::format("'{}': expected [diameter, height] or [lower, upper, height]", key));
        }
        const double lower = r.positive(values[0], key);
        const double upper = values.size() == 3 ? r.positive(values[1], key) : lower;
        segments.push_back({lower, upper, r.positive(values[values.size() - 1], key)});
    }
    return segments;
}

}  // namespace ncsim::setup
