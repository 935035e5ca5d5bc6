// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine with a table that turns about X, given by formulas.
#pragma once

#include "ncsim/base/angles.h"
#include "ncsim/gcode/feature_frame.h"
#include "ncsim/gcode/joints.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ncsim::gcode::language_test {

// Machine with a table A that turns the part about the X axis, with signs of ISO 841.
class Cradle : public JointSolver {
public:
    bool turns() const override { return true; }
    TipPose tip_pose(const Axes& joints, double /*length_mm*/) const override {
        const FeatureFrame turn = turn_about(0, joints[kA]);
        return {turn.direction_to_parent({joints[kX], joints[kY], joints[kZ]}),
                turn.direction_to_parent({0, 0, 1})};
    }
    std::optional<Axes> joints_for(const Triple& tip, const Axes& joints,
                                   double /*length_mm*/) const override {
        const Triple at = turn_about(0, -joints[kA]).direction_to_parent(tip);
        Axes out = joints;
        std::ranges::copy(at, out.begin());
        return out;
    }
    Triple rotate_with_table(const Triple& v, const Axes& from, const Axes& to) const override {
        return turn_about(0, from[kA] - to[kA]).direction_to_parent(v);
    }
    Solution joints_for_direction(const Triple& axis, const Axes& joints,
                                  Way /*way*/) const override {
        if (std::abs(axis[0]) > 1e-9) return {std::nullopt, false, "it turns about X alone"};
        Axes out = joints;
        out[kA] = angle_of(axis[2], -axis[1]);
        return {out, false, {}};
    }
};

}  // namespace ncsim::gcode::language_test
