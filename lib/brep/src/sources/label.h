// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of the surfaces that a motion can leave a flat face approximates.
#pragma once

#include "ncsim/brep/surface.h"
#include "ncsim/brep/swept.h"
#include "ncsim/cda/boundary.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::brep {

/// Where planes of a simplified boundary meet, mm.
inline constexpr double kFlat = 1e-4;

/// A flat face: its corners are `points` at the places that `loops` hold.
struct FlatFace {
    Vec3 normal, centroid;  ///< Unit; by area.
    const std::vector<std::vector<std::uint32_t>>& loops;
    std::span<const Vec3> points;
};

/// Of a face with the normal `normal`; its area and, of one that has any, its centroid.
double area_of(const std::vector<std::vector<std::uint32_t>>& loops, std::span<const Vec3> points,
               Vec3 normal, Vec3& centroid);

/// Does the face lie on the surface, within `most` (mm) and a turn (a chord)? `score`: how badly.
bool fits(const FlatFace& face, const Surface& surface, double most, double most_turn,
          double* score = nullptr);

/// The candidate that the face turns away from least, if one that fits within one and a half times
/// `error` (mm; of coils twice) and `most_turn` (a chord) is better than `best`, which is then what
/// it is worth; else null. `with_envelopes`: of all of them, else but for envelopes.
const Candidate* best_of(const FlatFace& face, std::span<const Candidate> candidates, double error,
                         double most_turn, double& best, bool with_envelopes = true);

}  // namespace ncsim::brep
