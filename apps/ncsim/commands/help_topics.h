// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pages of `ncsim help` that explain a concept, and texts at the end of the help of commands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

/// Returns a text that several pages share: "tool notation" and "stock notation" of --tool and
/// --stock, "files notation" of files and colours, "exit codes". Ends with a line break.
std::string_view help_section(std::string_view name);

/// Returns the names of the pages, in the order of the list.
std::vector<std::string> topic_names();
/// Returns the page `name`; empty if there is none.
std::string topic_text(std::string_view name);
/// Returns a line for each page: name and summary.
std::string topic_list();

}  // namespace ncsim::app
