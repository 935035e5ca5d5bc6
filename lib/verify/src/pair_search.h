// SPDX-License-Identifier: GPL-3.0-or-later
//
// Do two bodies that a machine moves meet in a motion? Stretches of it are halved until each is
// decided: clear where the hulls of a piece at both ends, grown by how far the way between them may
// be off, keep apart; certain where two pieces meet at one of its times.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/toolpath/joint_path.h"

#include "rigid_body.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace ncsim::verify {

/// A stretch in which no point goes farther than this (mm) is not halved any more: bodies that
/// neither keep apart there nor meet are that near, and rounding.
inline constexpr double kUndecidedMm = 0.001;

enum class Closeness : std::uint8_t { Clear, Open, Certain };

/// Stretches of a pair in one leg, after which it is open: pieces of 200 mm that pass each other at
/// a hundredth of a millimetre take some hundred. And where that has been open or certain often:
/// what touches by design does so in every motion.
inline constexpr std::size_t kMostStretches = 4000, kFewStretches = 100;

/// What came of it. Where it is not clear:
struct Encounter {
    Closeness closeness = Closeness::Clear;
    double time = 0.0;         ///< Of the leg, 0 to 1.
    machine::Values values{};  ///< Of the joints then, machine coordinates.
    cda::Vec3 point;  ///< In both, as the observer has it with all joints at 0; or near both.
    double amount_mm = 0.0;  ///< Deep in each other; or apart, where that is asked.
    bool assumed = false;    ///< Nobody told all of what meets there.
};

/// What moves, as what does not move sees it: one leg of a motion, and two bodies.
struct PairOnLeg {
    const toolpath::JointPath& path;
    const std::optional<machine::Values>& from;  ///< At its ends: path.at(0),
    const std::optional<machine::Values>& to;    ///< and path.at(1).
    double missed_mm = 0.0;                      ///< Of the leg itself.
    machine::Chain way;  ///< Of the body as the observer sees it: machine::seen_from().
    /// The observer is fixed to the part, the body to the tool, whose tip is here with all joints
    /// at 0: the way of the tip bounds theirs, too.
    bool of_part_and_tool = false;
    cda::Vec3 tip;
    std::size_t most_stretches = kMostStretches;
    bool met_before = false;  ///< In the motion before: then they are likely to be in each other.
};

/// Do they meet? Certain ones are deep in each other by more than rounding. `measured`: how deep,
/// at the worst of the times that are looked at; `lattice`: units that hold a piece in 24 bits.
Encounter meet(const PairOnLeg& pair, const RigidBody& observer, const RigidBody& body,
               const cda::Lattice& lattice, bool measured);
/// Do they come nearer to each other than `clearance_mm`?
Encounter come_near(const PairOnLeg& pair, const RigidBody& observer, const RigidBody& body,
                    const cda::Lattice& lattice, double clearance_mm);
/// Does the body meet what is left of the stock (a box in W, mm), or come nearer to it than that?
/// `zero`: of W, as the observer has it with all joints at 0. How deep is by how much all of the
/// body would have to be smaller.
Encounter meet_part(const PairOnLeg& pair, const cda::WorkpieceModel& part, const cda::Box& stock,
                    cda::Vec3 zero, const RigidBody& body, double clearance_mm, bool measured);

}  // namespace ncsim::verify
