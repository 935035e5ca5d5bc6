// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verification of a program, from a plan to a verdict, as in `ncsim check`.
#pragma once

#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/checked.h"
#include "ncsim/simulation/design_check.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/simulation/verification_options.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/evidence.h"
#include "ncsim/verify/machine_bodies.h"
#include "ncsim/verify/selection.h"

#include <memory>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// Contacts and content of a tile of the part. Empty if the program is not simulated.
struct TileResult {
    std::vector<StockContact> stock_contacts;
    std::string tile;  ///< In the form of TreeCda::write_tile().
    verify::Evidence evidence;
};

/// Prepares the links of a machine for collision checks. Null if the machine has no links.
std::shared_ptr<const verify::MachineBodies> bodies_of(const setup::MachineFile& machine);
/// Adds the fixtures of `job` to the machine of `verification_options`.
void add_fixtures(VerificationOptions& verification_options, const setup::Job& job);

/// Returns the path of rapid moves, at the machine's rates if all are specified.
toolpath::RapidPath rapid_path(const VerificationOptions& verification_options);

/// Verifies a program. The result depends on `plan` and `verification_options` only. Throws:
/// std::invalid_argument if plan.model does not verify; std::runtime_error if plan.budget is
/// exceeded, or a picture cannot be drawn.
Checked check(Plan plan, const VerificationOptions& verification_options = {});
/// Does the same with the result in `checked`, which keeps the partial result after an exception.
void check(Plan plan, const VerificationOptions& verification_options, Checked& checked);
/// Returns, a text each, the doubts that a verdict on the plan would have about tools, stock and
/// motions, and the errors of its blocks, for files that the plan's run writes.
/// Requires: `survey` belongs to `plan`; apply_machine() has applied `machine`.
/// Cost: one pass over the motions of the program; nothing is cut.
std::vector<std::string> assumptions_of(const Plan& plan, const Survey& survey,
                                        const setup::MachineFile& machine);
/// Returns the reasons before the colons of `assumptions`, each once: "stock-guess, tool-guess".
std::string reasons_of(const std::vector<std::string>& assumptions);
/// Collects the contacts of tile plan.tile, without a verdict. Throws as check() does.
TileResult check_tile(Plan plan, const VerificationOptions& verification_options);

}  // namespace ncsim::simulation
