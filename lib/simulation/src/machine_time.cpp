// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times of a program by a verifier without rules.
#include "ncsim/simulation/machine_time.h"

#include "ncsim/verify/rule.h"
#include "ncsim/verify/verifier.h"

#include "motions.h"

#include <utility>

namespace ncsim::simulation {

verify::Ledger machining_times(const Plan& plan, const Survey& survey,
                               const verify::MachineDescription& machine) {
    verify::Setup setup;
    setup.machine = machine;
    for (const verify::RuleInfo& rule : verify::rules())
        setup.selection.ignored.emplace(rule.id, "");
    for (const auto& [number, used] : survey.tools)
        setup.tools[number].tool = used.tool;
    verify::Verifier verifier(std::move(setup), {}, {});
    for_each_motion(plan, [&](const gcode::Motion& motion) {
        verifier.begin(motion);
        verifier.end();
    });
    return verifier.finish(survey.interpretation, nullptr, 0.0).ledger;
}

}  // namespace ncsim::simulation
