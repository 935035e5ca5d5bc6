// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pages of `ncsim help` that explain a concept, and texts at the end of the help of commands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

/// Notation of a tool in --tool; begins and ends with a line break.
extern const std::string_view kToolNotation;
/// Notation of stock in --stock; ends with a line break.
extern const std::string_view kStockNotation;
/// Standard input and output as files, and colours; ends with a line break.
extern const std::string_view kFileNotes;
/// Exit codes of all commands; ends with a blank line.
extern const std::string_view kExitCodes;

/// Returns the names of the pages, in the order of the list.
std::vector<std::string> topic_names();
/// Returns the page `name`; empty if there is none.
std::string topic_text(std::string_view name);
/// Returns a line for each page: name and summary.
std::string topic_list();

}  // namespace ncsim::app
