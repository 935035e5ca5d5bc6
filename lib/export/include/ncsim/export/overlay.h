// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of a picture in addition to the workpiece: tool paths, tools and outlines of stock.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/export/image.h"

#include <vector>

namespace ncsim::exporter {

/// A line through `points` (mm, W), drawn where no body hides it.
struct PathLine {
    std::vector<Vec3> points;
    bool is_rapid = false;  ///< Rapid: dashed, and in a different colour.
};

/// Box of an assumed stock. Its edges are drawn; bodies in front of an edge, or in its plane, hide
/// the edge.
struct Ghost {
    Box box;  ///< mm, W.
};

/// A closed body in addition to the part, in mm, W. A colour that is not opaque shows the objects
/// behind; if several bodies of a picture are not opaque, the opacity of the first applies to all,
/// and only the nearest on a line of sight counts.
struct Body {
    cda::Boundary surface;
    Rgba8 colour;
    bool is_cut = false;  ///< True: cut open with the part (RenderOptions::cut).
};

/// All additional objects of a picture.
struct Overlay {
    std::vector<PathLine> paths;
    std::vector<Body> bodies;
    std::vector<Ghost> ghosts{};
};

}  // namespace ncsim::exporter
