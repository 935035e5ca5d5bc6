// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading of I, J, K before G90.1 and G91.1: absolute or incremental, for the whole program.
#pragma once

#include <cstdint>
#include <functional>

namespace ncsim::gcode {

/// Evidence for the reading, and the decision.
struct ArcCentres {
    /// True: arcs are only counted, and both readings are accepted.
    bool counts_only = false;
    bool is_settled = false;
    /// Numbers of arcs that fit only one of the readings.
    std::uint64_t incremental = 0, absolute = 0;
    /// Interprets the whole program with `counts_only`; may be empty.
    /// Returns: true if more arcs fit absolute than incremental centres.
    std::function<bool()> are_absolute;
};

}  // namespace ncsim::gcode
