// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in texts.
#include "plain_number.h"

#include "ncsim/gcode/print.h"

#include <cmath>

namespace ncsim::report {

std::string plain_number(double value) {
    std::string text;
    gcode::print_number(text, std::round(value * 1e6) / 1e6 + 0.0);
    return text;
}

}  // namespace ncsim::report
