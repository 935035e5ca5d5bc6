// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules gouge and excess. compare() checks the finished part once.
#include "finding_log.h"
#include "rule_table.h"

namespace ncsim::verify {

std::optional<std::string> needs_design(const Setup& setup) {
    if (!setup.design) return "no design is given (--design)";
    return needs_simulation(setup);
}

}  // namespace ncsim::verify
