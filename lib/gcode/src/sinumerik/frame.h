// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chain of programmable frames in the form p_parent = F · S · p, with a rigid motion F and factors
// S along the axes.
#pragma once

#include "ncsim/gcode/feature_frame.h"
#include "ncsim/gcode/state.h"

#include <array>
#include <cstddef>
#include <optional>

namespace ncsim::gcode::sinumerik {

/// A chain of translations, rotations, factors and mirror images.
struct Frame {
    FeatureFrame rigid;
    std::array<double, 3> scale{1.0, 1.0, 1.0};
    Axes shift{};  ///< Translations of the axes A … W.
    /// All rotations are about the axis `axis`, in total by `angle` degrees; otherwise empty.
    struct Turn {
        std::size_t axis = 2;
        double angle = 0.0;
        bool operator==(const Turn&) const = default;
    };
    std::optional<Turn> turn = Turn{};
    bool operator==(const Frame&) const = default;

    bool is_identity() const { return *this == Frame{}; }

    void translate(const Triple& distance) {
        const Triple scaled{scale[0] * distance[0], scale[1] * distance[1], scale[2] * distance[2]};
        rigid.origin = rigid.to_parent(scaled);
    }
    /// Rotates about `about` (0: X …).
    /// Returns: false, without effect, if the factors of two axes differ.
    bool rotate(int about, double degrees) {
        if (degrees == 0.0) return true;
        const auto size = [this](std::size_t i) { return scale[i] < 0.0 ? -scale[i] : scale[i]; };
        if (size(0) != size(1) || size(1) != size(2)) return false;
        // S · R = R' · S: a mirror image in the plane of rotation inverts the sense.
        const auto first = static_cast<std::size_t>((about + 1) % 3);
        const auto second = static_cast<std::size_t>((about + 2) % 3);
        const double angle = (scale[first] < 0.0) != (scale[second] < 0.0) ? -degrees : degrees;
        rigid = rigid * turn_about(about, angle);
        const auto axis = static_cast<std::size_t>(about);
        if (turn && turn->angle == 0.0) {
            turn = Turn{axis, angle};
        } else if (turn && turn->axis == axis) {
            turn->angle += angle;
        } else {
            turn.reset();
        }
        return true;
    }
    /// Returns the chain of this frame and then `inner`.
    /// Requires: this frame has no factors.
    Frame then(const Frame& inner) const {
        Frame both = inner;
        both.rigid = rigid * inner.rigid;
        const bool is_turned = rigid.is_turned();
        const bool inner_is_turned = inner.rigid.is_turned();
        if (is_turned && !inner_is_turned) {
            both.turn = turn;
        } else if (is_turned) {
            both.turn.reset();
        }
        return both;
    }
};

}  // namespace ncsim::gcode::sinumerik
