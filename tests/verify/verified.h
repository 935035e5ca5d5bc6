// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program, tools and a block: verified as the program does it, without files.
#pragma once

#include "ncsim/cda/tree.h"
#include "ncsim/verify/verdict.h"
#include "ncsim/verify/verifier.h"

#include <set>
#include <string>
#include <vector>

namespace ncsim::verify_test {

/// A block of 40 x 30 x 10 mm, its top at Z0, centred on X0 Y0.
inline constexpr cda::Box kBlock{{-20, -15, -10}, {20, 15, 0}};

/// T1: a flat end mill of 10 mm that cuts 20 mm high. No machine.
verify::Setup plain_setup();
/// T1 with a shank of 10 mm from 5 to 30 mm and a holder of 40 mm above it.
verify::Setup setup_with_holder();

/// Verifies `program` on kBlock, or only its motions if the setup says it is not simulated.
verify::Verdict verdict_of(const std::string& program, verify::Setup setup = plain_setup());

/// One motion: what is there is looked at, taken away, and looked at again. `part` is null where
/// nothing is simulated.
void take(const gcode::Motion& motion, cda::Origin origin, verify::Verifier& verifier,
          toolpath::Walk& walk, cda::TreeCda* part);

/// The findings of a rule, in order.
std::vector<verify::Finding> findings_of(const verify::Verdict& verdict, const std::string& rule);
/// The reason why a rule was skipped; empty if it was not.
std::string skipped_because(const verify::Verdict& verdict, const std::string& rule);
/// The ids of the reasons why it is not proven, each once.
std::set<std::string> doubts_of(const verify::Verdict& verdict);

}  // namespace ncsim::verify_test
