// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kinematics for the interpreter, by a chain of joints.
#include "joint_solver.h"

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::simulation {

namespace {

using gcode::Axes;
using gcode::Triple;

class ChainSolver : public gcode::JointSolver {
public:
    ChainSolver(const toolpath::Kinematics& placed, const gcode::WorkOffset& workpiece,
                const machine::Travels& travels, machine::SolutionPreference prefer)
        : placed_(placed), origin_(workpiece.origin), travels_(travels), prefer_(prefer) {}

    bool turns() const override {
        return std::ranges::any_of(placed_.chain.joints, &machine::Joint::turns);
    }

    TipPose tip_pose(const Axes& joints, double length_mm) const override {
        const machine::Pose X_WT = chain(length_mm).pose(in_W(joints));
        const Vec3 axis = axis_of(X_WT);
        const Vec3& tip = X_WT.translation;
        return {{tip.x + origin_[0], tip.y + origin_[1], tip.z + origin_[2]},
                {axis.x, axis.y, axis.z}};
    }

    std::optional<Axes> joints_for(const Triple& tip, const Axes& joints,
                                   double length_mm) const override {
        const Vec3 tip_W{tip[0] - origin_[0], tip[1] - origin_[1], tip[2] - origin_[2]};
        const auto found = machine::values_for(chain(length_mm), tip_W, in_W(joints));
        if (!found) return std::nullopt;
        Axes at = joints;
        for (std::size_t i = 0; i < 3; ++i)
            at[i] = (*found)[i] + origin_[i];
        return at;
    }

    // The rotary joints of the table are before X, Y and Z in the chain.
    Triple rotate_with_table(const Triple& v, const Axes& from, const Axes& to) const override {
        std::vector<machine::Joint> table;
        for (const machine::Joint& joint : placed_.chain.joints) {
            if (!joint.turns) break;
            table.push_back(joint);
        }
        const machine::Values start = in_W(from), end = in_W(to);
        const auto of = [](const machine::Values& values, const machine::Joint& joint) {
            return values[*machine::index_of(joint.letter)];
        };
        Vec3 d{v[0], v[1], v[2]};
        for (auto next = table.rbegin(); next != table.rend(); ++next)
            d = machine::rotate_by_joint(*next, of(start, *next), d);
        for (const machine::Joint& joint : table)
            d = machine::rotate_by_joint(joint, -of(end, joint), d);
        return {d.x, d.y, d.z};
    }

    Solution joints_for_direction(const Triple& axis, const Axes& joints, Way way) const override {
        const machine::SolutionPreference prefer =
            way == Way::Up     ? machine::SolutionPreference::PositiveMotion
            : way == Way::Down ? machine::SolutionPreference::NegativeMotion
                               : prefer_;
        const Vec3 to{axis[0], axis[1], axis[2]};
        const machine::Values now = in_W(joints);
        machine::Travels travels = travels_;  // machine travels, converted to W
        for (auto& [letter, travel] : travels) {
            const double zero = origin_[*machine::index_of(letter)];
            travel.min -= zero;
            travel.max -= zero;
        }
        const auto found = machine::orient(chain(0.0), to, now, travels, prefer);
        if (!found) return {std::nullopt, false, why_not(to, now, travels)};
        Axes at = joints;
        for (std::size_t i = gcode::kA; i <= gcode::kC; ++i)
            at[i] = found->values[i] + origin_[i];
        return {at, found->singular, {}};
    }

private:
    machine::Chain chain(double length_mm) const {
        return placed_.chain.placed(placed_.zero, length_mm);
    }

    // U, V and W are 0, because X, Y and Z of the tip do not include their motion.
    machine::Values in_W(const Axes& joints) const {
        machine::Values values{};
        for (std::size_t i = 0; i <= gcode::kC; ++i)
            values[i] = joints[i] - origin_[i];
        return values;
    }

    std::string why_not(Vec3 to, const machine::Values& now,
                        const machine::Travels& travels) const {
        const auto turning = std::ranges::count_if(placed_.chain.joints, &machine::Joint::turns);
        if (turning > 2)
            return "it has more than two rotary axes, so the angles must be programmed";
        if (machine::orient(chain(0.0), to, now, travels)) return "not by a way of this sign";
        return machine::orient(chain(0.0), to, now) ? "it is beyond the travel of a rotary axis"
                                                    : "no turn of its rotary axes leads there";
    }

    toolpath::Kinematics placed_;
    Axes origin_;
    machine::Travels travels_;
    machine::SolutionPreference prefer_;
};

}  // namespace

std::shared_ptr<const gcode::JointSolver> make_joint_solver(const toolpath::Kinematics& placed,
                                                            const gcode::WorkOffset& workpiece,
                                                            const machine::Travels& travels,
                                                            machine::SolutionPreference prefer) {
    return std::make_shared<const ChainSolver>(placed, workpiece, travels, prefer);
}

}  // namespace ncsim::simulation
