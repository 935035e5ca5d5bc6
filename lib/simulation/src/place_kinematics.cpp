// SPDX-License-Identifier: GPL-3.0-or-later
//
// Position of the program zero on a machine, and assumptions about the kinematics.
#include "place_kinematics.h"

#include "joint_solver.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace ncsim::simulation {

std::optional<Vec3> work_zero(const gcode::WorkOffset& workpiece) {
    if (workpiece.rotation != 0.0 || workpiece.frame != gcode::OriginFrame{}) return std::nullopt;
    return Vec3{workpiece.origin[gcode::kX], workpiece.origin[gcode::kY],
                workpiece.origin[gcode::kZ]};
}

void place_kinematics(Plan& plan) {
    if (!plan.kinematics) return;
    // A first interpretation finds the program zero, which does not depend on the kinematics.
    plan.job.interpreter.joints = make_joint_solver(
        {plan.kinematics->chain, {}}, {}, plan.kinematics->travels, plan.kinematics->prefer);
    const gcode::Interpretation seen = gcode::interpret(plan.job.program, plan.job.interpreter, {});
    toolpath::Kinematics placed{plan.kinematics->chain, work_zero(seen.workpiece).value_or(Vec3{})};
    for (machine::Joint& joint : placed.chain.joints) {
        if (plan.kinematics->unspecified_pivots.find(joint.letter) != std::string::npos)
            joint.through = placed.zero;
    }
    plan.placed = std::make_shared<const toolpath::Kinematics>(std::move(placed));
    plan.job.interpreter.joints = make_joint_solver(
        *plan.placed, seen.workpiece, plan.kinematics->travels, plan.kinematics->prefer);
}

namespace {

// Returns the assumption about U, V and W. On a table they move along X, Y and Z. On a rotary head
// only the machine file specifies their motion, and only under tip control.
std::string second_axes_guess(const setup::SpecifiedKinematics& specified, const AxesInUse& axes) {
    if (!specified.chain.has_head()) return {};
    bool as_specified = false, as_axes = false;
    for (std::size_t i = 0; i < axes.uvw.size(); ++i) {
        const bool is_along_tool = specified.chain.find("UVW"[i]) != nullptr;
        as_axes |= !is_along_tool && (axes.uvw[i] || axes.uvw_of_tip[i]);
        as_specified |= is_along_tool && axes.uvw[i];
    }
    if (as_axes) return "U, V and W go along X, Y and Z, whichever way the head is turned";
    return as_specified ? "what goes along the tool does so without tip control, too"
                        : std::string();
}

}  // namespace

std::string kinematics_guess(const Plan& plan, const gcode::WorkOffset& workpiece,
                             const AxesInUse& axes, bool of_tip) {
    if (!plan.kinematics) return "A, B and C turn about the program origin";
    const setup::SpecifiedKinematics& specified = *plan.kinematics;
    const auto& turns = axes.turns;
    std::vector<std::string> guesses;
    if (!specified.guess.empty() && std::ranges::find(turns, true) != turns.end())
        guesses.push_back(specified.guess);
    std::string at_zero;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const char letter = "ABC"[i];
        if (!turns[i]) continue;
        if (!specified.chain.find(letter)) {
            guesses.push_back(std::string("the machine has no axis ") + letter +
                              "; its words turn nothing");
        } else if (specified.unspecified_pivots.find(letter) != std::string::npos) {
            at_zero += at_zero.empty() ? "" : ", ";
            at_zero += letter;
        }
    }
    if (workpiece.rotation != 0.0 || workpiece.origin[gcode::kA] != 0.0 ||
        workpiece.origin[gcode::kB] != 0.0 || workpiece.origin[gcode::kC] != 0.0) {
        guesses.emplace_back("the coordinate system is turned; taken as if it were not");
    }
    if (!of_tip && !at_zero.empty())
        guesses.push_back("the axes " + at_zero + " pass through the program zero");
    if (!of_tip && !work_zero(workpiece) && at_zero.empty())
        guesses.emplace_back("the program zero is the machine zero, to which axes refer");
    if (std::string second = second_axes_guess(specified, axes); !second.empty())
        guesses.push_back(std::move(second));
    for (std::size_t i = 0; i < axes.uvw.size(); ++i) {
        const char letter = "UVW"[i];
        if ((axes.uvw[i] || axes.uvw_of_tip[i]) && specified.chain.find(letter) &&
            workpiece.origin[gcode::kU + i] != 0.0)
            guesses.push_back(std::string("the tool has gone along itself by nothing where ") +
                              letter + " is 0 in the program");
    }
    std::string all;
    for (const std::string& guess : guesses)
        all += (all.empty() ? "" : "; ") + guess;
    return all;
}

}  // namespace ncsim::simulation
