// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of the rows of simulation_messages.def.
#pragma once

#include "ncsim/gcode/diagnostic.h"

namespace ncsim::simulation {

struct Message {
#define NCSIM_DIAGNOSTIC(name, severity, code, text) \
    static constexpr gcode::MessageText name{gcode::Severity::severity, code, text};
#include "simulation_messages.def"
#undef NCSIM_DIAGNOSTIC
};

}  // namespace ncsim::simulation
