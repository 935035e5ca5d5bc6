// SPDX-License-Identifier: GPL-3.0-or-later
//
// Number of motions up to a line.
#include "until_line.h"

#include "motions.h"

namespace ncsim::simulation {

std::uint64_t motions_until(const Plan& plan, std::uint32_t line) {
    std::uint64_t count = 0;
    std::uint64_t until = 0;
    std::uint32_t nearest = 0;
    bool is_running = false;  // whether the nearest line is being run
    for_each_motion(plan, [&](const gcode::Motion& motion) {
        ++count;
        const std::uint32_t at = motion.file == 0 ? motion.span.line : 0;
        if (at > nearest && at <= line) {
            nearest = at;
            is_running = true;
        }
        is_running = is_running && at == nearest;
        if (is_running) until = count;
    });
    return until;
}

}  // namespace ncsim::simulation
