// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a plan to a verdict: what `ncsim check` does with one program.
#pragma once

#include "ncsim/report/baseline.h"
#include "ncsim/report/checked.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/design.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/questions.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/evidence.h"
#include "ncsim/verify/machine_bodies.h"
#include "ncsim/verify/selection.h"

#include <memory>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// A tile of a part that was asked what it meets. Nothing in it: the program is not simulated.
struct SeenTile {
    std::vector<MetStock> met;
    std::string tile;  ///< As WorkpieceModel::write_tile() writes it.
    verify::Evidence evidence;
};

/// The links of a machine, ready to be asked; null if it has none.
std::shared_ptr<const verify::MachineBodies> bodies_of(const setup::MachineFile& machine);

/// The result depends on `plan` and `questions` only. Throws std::invalid_argument if plan.model
/// does not verify, std::runtime_error if plan.budget is used up, or a picture cannot be drawn.
report::Checked check(Plan plan, const Questions& questions = {});
/// The same into `checked`, which keeps what was known by then if it throws.
void check(Plan plan, const Questions& questions, report::Checked& checked);
/// Returns, a text each, the doubts that a verdict on the plan would have about tools, stock and
/// motions, and the errors of its blocks, for files that the plan's run writes.
/// Requires: `survey` is that of the plan; take_machine() has applied `machine`.
/// Cost: one interpretation of the program; nothing is cut.
std::vector<std::string> assumptions_of(const Plan& plan, const Survey& survey,
                                        const setup::MachineFile& machine);
/// Asks plan.tile of the part, and judges nothing. Throws as check() does.
SeenTile check_tile(Plan plan, const Questions& questions);

}  // namespace ncsim::simulation
