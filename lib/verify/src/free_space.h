// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies that are far from each other stay so for many motions: what is free between them is proven
// once, and then only added up how far they can have gone.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/machine/relative.h"

#include "rigid_body.h"

#include <array>
#include <optional>
#include <tuple>

namespace ncsim::verify {

/// By the letter of the joint.
using OfJoints = std::array<double, std::tuple_size_v<machine::Values>>;

/// What is free between two bodies with the joints at `at`: `apart_mm` at least, which is proven, 0
/// where they may touch. As long as no point of the one has gone farther than that, as the other
/// sees it, a joint that goes by 1 (mm, degree) takes it no farther than `of_body` says, or, of the
/// observer as the body sees it, `of_observer`.
struct FreeSpace {
    machine::Values at{};
    double apart_mm = 0.0;
    OfJoints of_body{}, of_observer{};
};
/// `way` is PairOnLeg::way; more than `most_mm` is not asked.
FreeSpace free_space(const machine::Chain& way, const machine::Values& at,
                     const RigidBody& observer, const RigidBody& body, const cda::Lattice& lattice,
                     double most_mm);

/// How far each joint goes at most from where it was to where a leg begins, and in the leg: mm and
/// degrees; those of X, Y and Z in the leg apart from the others, and how far the three go
/// together.
struct JointWays {
    OfJoints ways{};
    std::array<double, 3> straight{};
    double all_straight = 0.0;
};
/// `from`: where the leg begins. Nothing if nobody knows.
std::optional<JointWays> ways_of(const machine::Values& begin,
                                 const std::optional<machine::Values>& from,
                                 const std::optional<machine::Going>& leg);
/// Is there still more than `needed_mm` between them, all along such ways?
bool keeps_apart(const FreeSpace& space, const JointWays& ways, double needed_mm);

}  // namespace ncsim::verify
