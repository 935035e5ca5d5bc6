// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops that are one whole circle: the rims of bores. mm, frame W.
#pragma once

#include "ncsim/brep/part.h"

#include <optional>

namespace ncsim::brep {

/// A loop of one edge: a circle from `start` counter-clockwise about `axis` (unit), as the face
/// uses the edge.
struct WholeCircle {
    Vec3 centre, axis, start;
    double radius = 0.0;

    /// True if the circle is about the line through `origin` along the unit vector `along`.
    bool is_about(Vec3 origin, Vec3 along) const;
};

/// Returns the circle that a loop is; nothing if the loop is anything else.
std::optional<WholeCircle> whole_circle(const Part& part, const Loop& loop);

}  // namespace ncsim::brep
