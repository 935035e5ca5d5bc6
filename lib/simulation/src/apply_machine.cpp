// SPDX-License-Identifier: GPL-3.0-or-later
//
// Applies a machine file to a plan.
#include "ncsim/simulation/apply_machine.h"

#include "ncsim/setup/coordinate_systems.h"

namespace ncsim::simulation {

std::vector<std::string> apply_machine(Plan& plan, const setup::MachineFile& file) {
    setup::Job& job = plan.job;
    plan.kinematics = file.kinematics;
    job.interpreter.tip_control = file.tip_control;
    job.interpreter.rotary_ways = file.rotary_ways;
    job.interpreter.clamps = file.clamps;
    job.interpreter.fixture_offsets = file.fixture_offsets;
    job.interpreter.setting_errors = file.setting_errors;
    std::vector<std::string> lost;
    for (const auto& [system, origin] : file.offsets) {
        if (!setup::origin_of(job.interpreter, system))
            setup::tell_offset(job.interpreter, system, origin);
    }
    const auto lead = [](gcode::Position& to, const std::optional<Vec3>& specified) {
        if (!specified) return;
        to.x = gcode::Length::from_mm(specified->x);
        to.y = gcode::Length::from_mm(specified->y);
        to.z = gcode::Length::from_mm(specified->z);
    };
    lead(job.interpreter.homes[0], file.machine.home);
    lead(job.interpreter.homes[1], file.machine.tool_change);
    if (!file.start || job.start) return lost;
    constexpr int kG54 = 1;
    const auto origin = setup::origin_of(job.interpreter, kG54);
    if (!origin) {
        lost.emplace_back(
            "start of the tool: the machine file specifies it, but not the position of G54");
        return lost;
    }
    job.interpreter.start_is_of_machine = true;
    for (int axis = 0; axis < 3; ++axis)
        job.interpreter.start[static_cast<std::size_t>(axis)] =
            gcode::Length::from_mm((*file.start - *origin)[axis]);
    return lost;
}

}  // namespace ncsim::simulation
