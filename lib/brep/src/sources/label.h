// SPDX-License-Identifier: GPL-3.0-or-later
//
// Assignment of planar facets to the surfaces that a motion can leave.
#pragma once

#include "ncsim/brep/surface_forms.h"
#include "ncsim/brep/swept_surfaces.h"
#include "ncsim/cda/boundary.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::brep {

/// Planar face whose corners are the `points` with the indices in `loops`.
struct FlatFace {
    Vec3 normal, centroid;  ///< Unit; centroid of the area.
    const std::vector<std::vector<std::uint32_t>>& loops;
    std::span<const Vec3> points;
};

/// Returns the area of a face with the normal `normal`. Sets `centroid`, to the first corner if the
/// area is not positive.
double area_of(const std::vector<std::vector<std::uint32_t>>& loops, std::span<const Vec3> points,
               Vec3 normal, Vec3& centroid);

/// True if the face lies on the surface within `most` (mm) and a deviation of the normal of
/// `most_turn` (as a chord). Sets `score`; lower is better.
bool fits(const FlatFace& face, const Surface& surface, double most, double most_turn,
          double* score = nullptr);

/// Returns the candidate from which the face deviates least in direction; null if no candidate has
/// a better score than `best`. Candidates must fit within 1.5 times `error` (mm; 2 times for coils,
/// 3 times for flanks and peaks) and `most_turn` (as a chord). Sets `best` to the score of the
/// result. Without `with_envelopes`, envelopes are left out.
const CandidateSurface* best_of(const FlatFace& face, std::span<const CandidateSurface> candidates,
                                double error, double most_turn, double& best,
                                bool with_envelopes = true);

}  // namespace ncsim::brep
