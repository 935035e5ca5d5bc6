// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two things that a machine moves, each by joints of its own: where the one is as the other sees
// it, and how far it can be from there while the joints go on.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/machine/chain.h"

#include <array>

namespace ncsim::machine {

/// The joints between two things, as a chain of which the last one is next to what is looked at.
/// Each of both is told by what moves it from the bed on, every joint as it moves the thing itself.
/// Joints that carry both are left out: they move neither against the other. None are left: the
/// two are one body.
Chain seen_from(const Chain& observer, const Chain& body);

/// Where the joints bring what stands at home with all of them at 0: X, all of its rotation.
Pose pose_of(const Chain& moved_by, const Values& values);
/// p_B = inverse(X_AB) * p_A, to rounding.
Pose inverse(const Pose& X_AB);

/// How the joints go in a stretch of a motion, whose parameter runs from 0 to 1. A, B and C go
/// evenly from one end to the other.
struct Going {
    Values from{}, to{};
    std::array<double, 3> speed{};  ///< Of X, Y and Z at most, mm.
    double all_speed = 0.0;         ///< Of the three together,
    double bend = 0.0;              ///< and of its change: second derivatives, mm.
};

/// A body somewhere in a ball, whose points move already: at most so fast, and with such second
/// derivatives. mm.
struct Ball {
    cda::Vec3 centre;
    double radius = 0.0;
    double speed = 0.0, bend = 0.0;
};

/// The same, once `chain` has moved it in such a stretch. For a turn by θ about an axis at distance
/// d at most, of what moves with v and a,
///
///     |x'| <= θ d + v        |x''| <= θ² d + 2 θ v + a
///
/// joint by joint from the body on; X, Y and Z are at right angles. So no point is farther than
/// `speed` from where it began, nor farther than bend / 8 from the straight way between its two
/// ends.
Ball moved(const Chain& chain, const Going& going, Ball body);

}  // namespace ncsim::machine
