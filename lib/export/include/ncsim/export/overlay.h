// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a picture shows besides the part: where the tool went, and where it stands.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/vec.h"
#include "ncsim/export/image.h"

#include <vector>

namespace ncsim::exporter {

/// A line through `points` (mm, W), drawn where nothing stands before it.
struct PathLine {
    std::vector<cda::Vec3> points;
    bool is_rapid = false;  ///< Dashed, and in a colour of its own.
};

/// The edges of a block of which nobody knows that it was there; hidden by what stands before them
/// or in the same plane.
struct Ghost {
    cda::Box box;  ///< mm, W.
};

/// A body beside the part, closed, in mm, W. Where its colour is not opaque (all of a picture by
/// the same share), what is behind it is seen: of several such bodies, the nearest one counts.
struct Body {
    cda::Boundary surface;
    Rgba8 colour;
};

struct Overlay {
    std::vector<PathLine> paths;
    std::vector<Body> bodies;
    std::vector<Ghost> ghosts{};
};

}  // namespace ncsim::exporter
