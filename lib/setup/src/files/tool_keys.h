// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of tools that the project's TOML files share.
#pragma once

#include "ncsim/toolpath/tool_spec.h"

#include "files/toml_reader.h"

#include <string_view>
#include <vector>

namespace ncsim::setup {

/// Reads [[28, 15], [28, 40, 10]]: diameter and height, or lower and upper diameter and height; mm.
/// Empty if the table does not have the key.
std::vector<toolpath::ToolSegment> read_segments(const TomlReader& reader, const TomlTable& table,
                                                 std::string_view key);

}  // namespace ncsim::setup
