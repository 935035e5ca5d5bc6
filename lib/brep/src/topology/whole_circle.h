// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of a single whole circle, such as the rims of bores. mm, frame W.
#pragma once

#include "ncsim/brep/part.h"

#include <optional>

namespace ncsim::brep {

/// Circle that is a loop of a face: from `start` counter-clockwise about the unit vector `axis`, in
/// the direction in which the face uses the edge.
struct WholeCircle {
    Vec3 centre, axis, start;
    double radius = 0.0;

    /// True if the circle is about the line through `origin` along the unit vector `along`.
    bool is_about(Vec3 origin, Vec3 along) const;
};

/// Returns the circle of a loop; no value if the loop is not a single whole circle.
std::optional<WholeCircle> whole_circle(const Part& part, const Loop& loop);

}  // namespace ncsim::brep
