// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading of I, J, K before G90.1 and G91.1: absolute or incremental, one for the whole program.
#pragma once

#include <cstdint>
#include <functional>

namespace ncsim::gcode {

struct ArcCentres {
    /// True: arcs are counted, and both readings are accepted.
    bool counts_only = false;
    bool is_settled = false;
    /// Arcs of the program that fit one reading only.
    std::uint64_t incremental = 0, absolute = 0;
    /// Interprets the whole program with `counts_only`; may be empty. Returns: more arcs fit
    /// absolute centres.
    std::function<bool()> are_absolute;
};

}  // namespace ncsim::gcode
