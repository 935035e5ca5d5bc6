// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of commands in TOML files.
#pragma once

#include "ncsim/setup/option_setting.h"

#include "files/toml_reader.h"

#include <string>

namespace ncsim::setup {

/// Reads the value of `option` under `key`: a text, a number, true, false, or a list.
/// Throws: std::runtime_error with file, line and column.
OptionSetting read_option(const TomlReader& reader, const std::string& option,
                          const std::string& key, const toml::node& node);

}  // namespace ncsim::setup
