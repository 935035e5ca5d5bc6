// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a plane cuts a surface in a curve that has no name.
#pragma once

#include "ncsim/brep/surface.h"

#include "geometry/plane_cut.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::brep {

struct CutWalk {
    std::vector<Vec3> between;  ///< The ends left out.
    std::size_t end = 0;        ///< Which end was reached.
};

/// From `begin`, a point of both, with the material on the left of who sees the plane from before,
/// to one of `ends`, with chords within `chords_mm` of the curve. Nothing if none is found.
std::optional<CutWalk> walk_along_cut(const Surface& surface, const CutPlane& plane, Vec3 begin,
                                      std::span<const Vec3> ends, double chords_mm);

}  // namespace ncsim::brep
