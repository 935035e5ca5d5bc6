// SPDX-License-Identifier: GPL-3.0-or-later
//
// Option of a command in a project file or a job file.
#pragma once

#include <string>
#include <vector>

namespace ncsim::setup {

/// An option of a command in a file.
struct OptionSetting {
    std::string option;               ///< Long name without dashes: "tool-table".
    std::vector<std::string> values;  ///< The values of the command line.
    bool is_flag = false;             ///< True for an option without value, true or false.
    bool is_on = true;                ///< Value of a flag.
    std::string where;                ///< Place in the file, for messages: "ncsim.toml:3:1".
};

}  // namespace ncsim::setup
