// SPDX-License-Identifier: GPL-3.0-or-later
//
// Transformations between a frame and the parent frame.
#include "ncsim/gcode/feature_frame.h"

#include "ncsim/base/angles.h"

namespace ncsim::gcode {

Triple FeatureFrame::to_parent(const Triple& p_F) const {
    Triple p = direction_to_parent(p_F);
    for (std::size_t i = 0; i < 3; ++i)
        p[i] += origin[i];
    return p;
}

Triple FeatureFrame::from_parent(const Triple& p_W) const {
    Triple p{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            p[i] += rows[k][i] * (p_W[k] - origin[k]);
    }
    return p;
}

Triple FeatureFrame::direction_to_parent(const Triple& d_F) const {
    Triple d{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            d[i] += rows[i][k] * d_F[k];
    }
    return d;
}

FeatureFrame operator*(const FeatureFrame& X_WF, const FeatureFrame& X_FG) {
    FeatureFrame X_WG;
    X_WG.origin = X_WF.to_parent(X_FG.origin);
    for (std::size_t column = 0; column < 3; ++column) {
        const Triple d = X_WF.direction_to_parent(
            {X_FG.rows[0][column], X_FG.rows[1][column], X_FG.rows[2][column]});
        for (std::size_t i = 0; i < 3; ++i)
            X_WG.rows[i][column] = d[i];
    }
    return X_WG;
}

FeatureFrame turn_about(int axis, double degrees) {
    const SinCos q = sin_cos(degrees);
    const auto i = static_cast<std::size_t>((axis + 1) % 3);
    const auto k = static_cast<std::size_t>((axis + 2) % 3);
    FeatureFrame turn;
    turn.rows[i][i] = turn.rows[k][k] = q.cos;
    turn.rows[i][k] = -q.sin;
    turn.rows[k][i] = q.sin;
    return turn;
}

}  // namespace ncsim::gcode
