// SPDX-License-Identifier: GPL-3.0-or-later
//
// Search for contact between two bodies during a motion. Stretches of the motion are halved until
// each is decided. Clear: the hulls of a piece at both ends, grown by the deviation of the path
// between the ends, are separate. Certain: two pieces meet at a time in the stretch.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/toolpath/joint_path.h"

#include "rigid_body.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace ncsim::verify {

/// Length (mm): a stretch in which no point travels farther is not halved. Bodies that are neither
/// proven separate nor found in contact there are nearer than this length, up to rounding.
inline constexpr double kUndecidedMm = 0.001;

enum class Closeness : std::uint8_t { Clear, Open, Certain };

/// Largest number of stretches of a pair in one leg; then the pair is open. Pieces of 200 mm that
/// pass each other at 0.01 mm need some hundreds. The small number is for pairs that were often
/// open or certain, because bodies that touch by design touch in every motion.
inline constexpr std::size_t kMostStretches = 4000, kFewStretches = 100;

/// Result of a search. All further values are valid unless `closeness` is Clear.
struct Encounter {
    Closeness closeness = Closeness::Clear;
    double time = 0.0;         ///< Time in the leg, 0 to 1.
    machine::Values values{};  ///< Joint positions at that time, machine coordinates.
    Vec3 point;  ///< Common or near point, in the frame of the observer with all joints at 0.
    double amount_mm = 0.0;  ///< Penetration; or distance, if distance is searched.
    bool assumed = false;    ///< The shape of a piece is not fully specified.
};

/// Motion of a body relative to an observer in one leg of a motion.
struct PairOnLeg {
    const toolpath::JointPath& path;
    const std::optional<machine::Values>& from;  ///< path.at(0)
    const std::optional<machine::Values>& to;    ///< path.at(1)
    double missed_mm = 0.0;                      ///< Deviation of the leg itself.
    machine::Chain way;  ///< Chain from the observer to the body: machine::seen_from().
    /// The observer is fixed to the part, and the body to the tool, whose tip is at `tip` with all
    /// joints at 0. The path of the tip then also bounds the path of the body.
    bool of_part_and_tool = false;
    Vec3 tip;
    std::size_t most_stretches = kMostStretches;
    /// Contact in the preceding motion; contact at an end is then likely.
    bool had_contact = false;
};

/// Searches for contact. A certain contact penetrates by more than rounding. `measured`: also finds
/// the largest penetration among sampled times. `lattice`: units in which a piece has 24 bits.
Encounter find_contact(const PairOnLeg& pair, const RigidBody& observer, const RigidBody& body,
                       const cda::Lattice& lattice, bool measured);
/// Searches for distances below `clearance_mm`.
Encounter search_near(const PairOnLeg& pair, const RigidBody& observer, const RigidBody& body,
                      const cda::Lattice& lattice, double clearance_mm);
/// Searches for contact of the body with the rest of the stock (`stock`: box in W, mm), or for
/// distances below `clearance_mm`. `zero`: origin of W in the frame of the observer with all joints
/// at 0. The penetration is the distance by which the body would have to shrink on all sides.
Encounter search_part(const PairOnLeg& pair, const cda::VerifyingModel& part, const Box& stock,
                      Vec3 zero, const RigidBody& body, double clearance_mm, bool measured);

}  // namespace ncsim::verify
