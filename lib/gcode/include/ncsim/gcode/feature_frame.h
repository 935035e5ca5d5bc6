// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tilted working plane: the frame F (feature) in which a program gives X, Y and Z, fixed to a
// parent frame W.
#pragma once

#include <array>

namespace ncsim::gcode {

using Triple = std::array<double, 3>;  ///< X, Y, Z of a position or a direction.

/// Pose of F in W: p_W = origin + rows · p_F. The columns of `rows` are the axes of F in W.
struct FeatureFrame {
    Triple origin{};
    std::array<Triple, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    bool operator==(const FeatureFrame&) const = default;

    /// Transforms a position from F to W.
    Triple to_parent(const Triple& p_F) const;
    /// Transforms a position from W to F.
    Triple from_parent(const Triple& p_W) const;
    /// Transforms a direction from F to W.
    Triple direction_to_parent(const Triple& d_F) const;
    /// Returns the Z axis of F in W: the direction of the tool axis.
    Triple normal() const { return {rows[0][2], rows[1][2], rows[2][2]}; }
    /// True if the axes of F are not parallel to the axes of W.
    bool is_turned() const { return rows != FeatureFrame{}.rows; }
};

/// Composes two poses: X_WG = X_WF · X_FG.
FeatureFrame operator*(const FeatureFrame& X_WF, const FeatureFrame& X_FG);

/// Returns the rotation by `degrees` about the axis `axis` (0: X, 1: Y, 2: Z). Exact for multiples
/// of 90 degrees.
FeatureFrame turn_about(int axis, double degrees);

}  // namespace ncsim::gcode
