// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tilted plane: the frame F (feature) in which a program counts X, Y and Z, fixed to another one.
#pragma once

#include <array>

namespace ncsim::gcode {

using Triple = std::array<double, 3>;  ///< X, Y, Z of a place or of a direction.

/// p_W = origin + rows · p_F; the columns of `rows` are the axes of F in W.
struct FeatureFrame {
    Triple origin{};
    std::array<Triple, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    bool operator==(const FeatureFrame&) const = default;

    /// A place of F in W, and back.
    Triple outward(const Triple& p_F) const;
    Triple inward(const Triple& p_W) const;
    /// A direction of F in W.
    Triple turned(const Triple& d_F) const;
    /// Z of F, the direction that the tool is to have.
    Triple normal() const { return {rows[0][2], rows[1][2], rows[2][2]}; }
    bool is_turned() const { return rows != FeatureFrame{}.rows; }
};

/// X_WG = X_WF · X_FG.
FeatureFrame operator*(const FeatureFrame& X_WF, const FeatureFrame& X_FG);

/// Turned by `degrees` about the axis 0, 1 or 2; exact for multiples of 90 degrees.
FeatureFrame turn_about(int axis, double degrees);

}  // namespace ncsim::gcode
