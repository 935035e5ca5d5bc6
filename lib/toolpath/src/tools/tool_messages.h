// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of the rows of tool_messages.def.
#pragma once

#include "ncsim/gcode/diagnostic.h"

namespace ncsim::toolpath {

struct Message {
#define NCSIM_DIAGNOSTIC(name, severity, code, text) \
    static constexpr gcode::MessageText name{gcode::Severity::severity, code, text};
#include "tools/tool_messages.def"
#undef NCSIM_DIAGNOSTIC
};

}  // namespace ncsim::toolpath
