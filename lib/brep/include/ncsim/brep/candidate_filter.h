// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of candidate surfaces with the faces of a boundary.
#pragma once

#include "ncsim/brep/swept_surfaces.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/origin.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::brep {

/// Faces of a boundary, sorted by origin.
class FacesByOrigin {
public:
    /// `boundary` must outlive the object.
    explicit FacesByOrigin(const cda::Boundary& boundary);
    /// Returns the faces of `origin`, ascending.
    std::span<const std::uint32_t> of(cda::Origin origin) const;

private:
    const cda::Boundary& boundary_;
    std::vector<std::uint32_t> faces_;
};

/// Finds the candidates on which faces lie.
class CandidateFilter {
public:
    /// `boundary` must outlive the filter.
    explicit CandidateFilter(const cda::Boundary& boundary);

    /// Returns for each candidate of `source` whether a face of `origin` lies on the candidate,
    /// within `times` the distance that recognition allows.
    /// Cost: O(n m) for n corners and m candidates.
    std::vector<bool> fitting(cda::Origin origin, const SweptSurfaces& source, double times) const;

private:
    const cda::Boundary& boundary_;
    FacesByOrigin by_origin_;
};

}  // namespace ncsim::brep
