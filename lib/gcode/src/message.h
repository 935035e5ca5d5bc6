// SPDX-License-Identifier: GPL-3.0-or-later
//
// The names of the entries of diagnostics.def.
#pragma once

#include "ncsim/gcode/diagnostic.h"

#include <string_view>

namespace ncsim::gcode {

enum class Message : std::uint16_t {
#define NCSIM_DIAGNOSTIC(name, severity, code, text) name,
#include "diagnostics.def"
#undef NCSIM_DIAGNOSTIC
};

struct MessageText {
    Severity severity;
    std::string_view code;
    std::string_view text;
};

const MessageText& text_of(Message message);

}  // namespace ncsim::gcode
