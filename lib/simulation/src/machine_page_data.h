// SPDX-License-Identifier: GPL-3.0-or-later
//
// The machine on the page of a program.
#pragma once

#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/checked.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/finding.h"

#include <optional>
#include <span>

namespace ncsim::simulation {

/// Returns links with meshes, the tools, and joint positions after each line and at each finding in
/// which bodies meet. Empty if no link has a mesh, or if the kinematics or the start positions are
/// unknown.
std::optional<MachinePageData> machine_page_data(const Plan& plan, const Survey& survey,
                                                 const setup::MachineFile& machine,
                                                 std::span<const verify::Finding> findings);

}  // namespace ncsim::simulation
