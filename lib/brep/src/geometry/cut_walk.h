// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walk along the curve in which a plane cuts a surface, for curves without a name.
#pragma once

#include "ncsim/brep/surface_forms.h"

#include "geometry/plane_cut.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::brep {

/// Points of a walk, and its end.
struct CutWalk {
    std::vector<Vec3> between;  ///< Points without the ends.
    std::size_t end = 0;        ///< Index of the end that was reached.
};

/// Walks along the cut from `begin`, a point on the surface and the plane, to one of `ends`. The
/// material is on the left, seen from the side to which the plane's normal points. The chords are
/// within `chords_mm` of the curve. No value if no end is found.
std::optional<CutWalk> walk_along_cut(const Surface& surface, const CutPlane& plane, Vec3 begin,
                                      std::span<const Vec3> ends, double chords_mm);

}  // namespace ncsim::brep
