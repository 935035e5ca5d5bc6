// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies a program with tools and a block without files, as ncsim check does.
#pragma once

#include "ncsim/cda/tree.h"
#include "ncsim/verify/verdict.h"
#include "ncsim/verify/verifier.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace ncsim::verify_test {

/// Block of 40 x 30 x 10 mm with its top at Z0, centred on X0 Y0.
inline constexpr Box kBlock{{-20, -15, -10}, {20, 15, 0}};

/// Returns a set-up without machine. T1 is a flat end mill of 10 mm diameter with a flute length of
/// 20 mm.
verify::Setup plain_setup();
/// Returns plain_setup() with a shank of 10 mm diameter from 5 to 30 mm and a holder of 40 mm
/// diameter above the shank.
verify::Setup setup_with_holder();

/// Decides an open contact.
using Decide = std::function<verify::ContactDecision(const verify::OpenContact&)>;

/// Verifies `program` on kBlock, or only the motions if `setup` disables the simulation.
verify::Verdict verdict_of(const std::string& program, verify::Setup setup = plain_setup(),
                           const Decide& decide = {});

/// Verifies and subtracts a motion: the verifier examines the part before and after the cut. `part`
/// is null if the part is not simulated.
void take(const gcode::Motion& motion, cda::Origin origin, verify::Verifier& verifier,
          toolpath::Walk& walk, cda::TreeCda* part, const Decide& decide = {});

/// Returns the findings of a rule, in order.
std::vector<verify::Finding> findings_of(const verify::Verdict& verdict, const std::string& rule);
/// Returns the reason why a rule was skipped; empty if the rule was checked.
std::string skipped_because(const verify::Verdict& verdict, const std::string& rule);
/// Returns the ids of the reasons why the program is not proven, each once.
std::set<std::string> doubts_of(const verify::Verdict& verdict);

}  // namespace ncsim::verify_test
