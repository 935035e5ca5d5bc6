// SPDX-License-Identifier: GPL-3.0-or-later
//
// Characters that begin a value in NC programs.
#pragma once

#include "ncsim/base/ascii.h"

namespace ncsim::gcode {

constexpr bool starts_value(char c) {
    return is_digit(c) || c == '.' || c == '-' || c == '+' || c == '[' || c == '#';
}

}  // namespace ncsim::gcode
