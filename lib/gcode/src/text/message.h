// SPDX-License-Identifier: GPL-3.0-or-later
//
// The names of the rows of diagnostics.def: all that lib/gcode can say.
#pragma once

#include "ncsim/gcode/diagnostic.h"

namespace ncsim::gcode {

struct Message {
#define NCSIM_DIAGNOSTIC(name, severity, code, text) \
    static constexpr MessageText name{Severity::severity, code, text};
#include "text/diagnostics.def"
#undef NCSIM_DIAGNOSTIC
};

}  // namespace ncsim::gcode
