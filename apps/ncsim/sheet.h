// SPDX-License-Identifier: GPL-3.0-or-later
//
// The assumption sheet: what the program said, what was concluded, what had to be assumed. Nobody
// should have to guess what a result stands on.
#pragma once

#include "job.h"
#include "survey.h"

#include <string>

namespace ncsim::app {

/// Text for people, a line for each thing; ends in a newline.
std::string assumption_sheet(const Job& job, const Survey& survey);

/// Who said it: "line 2: (…)", "from tool.tbl, line 3: …", "from --tool".
std::string told(toolpath::ToldBy by, gcode::SourceSpan span, const std::string& text,
                 const std::string& file, const char* option);

/// "50 x 40 x 10 mm, X 0 to 50, Y 0 to 40, Z -10 to 0"
std::string describe(const cda::Box& box);
std::string describe(const toolpath::Stock& stock);

}  // namespace ncsim::app
