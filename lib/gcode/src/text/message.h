// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of the messages in diagnostics.def.
#pragma once

#include "ncsim/gcode/diagnostic.h"

namespace ncsim::gcode {

/// The messages of lib/gcode, by name.
struct Message {
#define NCSIM_DIAGNOSTIC(name, severity, code, text) \
    static constexpr MessageText name{Severity::severity, code, text};
#include "text/diagnostics.def"
#undef NCSIM_DIAGNOSTIC
};

}  // namespace ncsim::gcode
