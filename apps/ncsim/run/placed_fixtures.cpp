// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places fixtures.
#include "run/placed_fixtures.h"

#include "ncsim/simulation/fixtures.h"

#include "system/console.h"

#include <string>
#include <utility>

namespace ncsim::app {

std::vector<verify::Fixture> placed_fixtures(const simulation::Plan& plan,
                                             const simulation::Survey& survey,
                                             const std::optional<setup::MachineFile>& machine) {
    setup::MachineFile specified;
    if (machine) {
        specified.machine = machine->machine;
    } else {
        simulation::add_fixtures(specified, plan.job);
    }
    for (const std::string& lost : simulation::place_fixtures(specified.machine, plan, survey))
        print_error("not shown: " + lost + "\n");
    return std::move(specified.machine.fixtures);
}

}  // namespace ncsim::app
