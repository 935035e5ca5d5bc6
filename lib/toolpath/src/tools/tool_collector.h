// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of all readers of tool files: the list of tools, and the kind of a tool from its remark.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/toolpath/tool_table.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::toolpath {

/// Collects the tools of a file, a single tool for each number.
class Collector {
public:
    /// Requires: the arguments outlive the object. `file`: name of the file.
    Collector(std::vector<ToolEntry>& tools, gcode::Diagnostics& diagnostics,
              const std::string& file)
        : tools_(tools), diagnostics_(diagnostics), file_(file) {}

    void add_remark(const gcode::MessageText& message, gcode::SourceSpan span,
                    std::initializer_list<std::string_view> arguments = {});

    /// Adds a tool. Adds a warning instead if a tool has the same number, or if `spec` is
    /// incomplete.
    void keep(ToolSpec spec, Vec3 offset, gcode::SourceSpan span, std::string text);

private:
    std::vector<ToolEntry>& tools_;
    gcode::Diagnostics& diagnostics_;
    const std::string& file_;
};

/// Adds kind and shape from a remark to `spec`. The diameter of `spec` counts; for a V-cutter it
/// may be the tip diameter.
void take_kind(std::string_view remark, ToolSpec& spec);

}  // namespace ncsim::toolpath
