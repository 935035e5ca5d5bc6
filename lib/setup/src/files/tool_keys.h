// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of tools that the project's TOML files share.
#pragma once

#include "ncsim/toolpath/tool_spec.h"

#include "files/toml_reader.h"

#include <string>
#include <vector>

namespace ncsim::setup {

/// Reads [[28, 15], [28, 40, 10]]: diameter and height, or lower and upper diameter and height; mm.
std::vector<toolpath::ToolSegment> read_segments(const TomlReader& reader, const toml::node& node,
                                                 const std::string& key);

}  // namespace ncsim::setup
