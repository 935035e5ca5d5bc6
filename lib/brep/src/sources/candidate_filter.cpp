// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of candidate surfaces with the faces of a boundary.
#include "ncsim/brep/candidate_filter.h"

#include "geometry/tolerances.h"
#include "sources/label.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace ncsim::brep {

FacesByOrigin::FacesByOrigin(const cda::Boundary& boundary)
    : boundary_(boundary), faces_(boundary.faces.size()) {
    std::iota(faces_.begin(), faces_.end(), 0U);
    std::ranges::stable_sort(faces_, {}, [&](std::uint32_t f) { return boundary.faces[f].origin; });
}

std::span<const std::uint32_t> FacesByOrigin::of(cda::Origin origin) const {
    const auto origin_of = [&](std::uint32_t f) { return boundary_.faces[f].origin; };
    const auto first = std::ranges::lower_bound(faces_, origin, {}, origin_of);
    const auto last = std::ranges::upper_bound(faces_, origin, {}, origin_of);
    return {first, last};
}

CandidateFilter::CandidateFilter(const cda::Boundary& boundary)
    : boundary_(boundary), by_origin_(boundary) {}

std::vector<bool> CandidateFilter::fitting(cda::Origin origin, const SweptSurfaces& source,
                                           double times) const {
    // The largest slack of best_of(), and twice that for the shading of coarse hulls. A normal that
    // is off by a chord of 1, 60°, does not fit.
    const double most = times * (6.0 * source.error_mm + kFlat);
    std::vector<bool> result(source.candidates.size(), false);
    const std::span<const Vec3> points(boundary_.vertices);
    for (const std::uint32_t f : by_origin_.of(origin)) {
        const cda::BoundaryFace& face = boundary_.faces[f];
        FlatFace flat{face.normal, {}, face.loops, points};
        area_of(face.loops, points, face.normal, flat.centroid);
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = result[i] || fits(flat, source.candidates[i].surface, most, times);
    }
    return result;
}

}  // namespace ncsim::brep
