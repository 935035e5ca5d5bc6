// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volume, area and bounds of a boundary.
#include "ncsim/cda/boundary.h"

namespace ncsim::cda {

namespace {

// Returns twice the area vector of a loop. Differences to the first corner keep the precision of
// loops far from the origin.
Vec3 double_area(const Boundary& boundary, const std::vector<std::uint32_t>& loop) {
    Vec3 sum;
    const Vec3 a = boundary.vertices[loop[0]];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        sum = sum + cross(boundary.vertices[loop[i]] - a, boundary.vertices[loop[i + 1]] - a);
    }
    return sum;
}

}  // namespace

double volume(const Boundary& boundary) {
    if (boundary.vertices.empty()) return 0.0;
    const Vec3 reference = bounds(boundary).centre();
    double sixfold = 0.0;
    for (const BoundaryFace& face : boundary.faces) {
        for (const auto& loop : face.loops) {
            sixfold += dot(boundary.vertices[loop[0]] - reference, double_area(boundary, loop));
        }
    }
    return sixfold / 6.0;
}

double area(const Boundary& boundary) {
    double twofold = 0.0;
    for (const BoundaryFace& face : boundary.faces) {
        for (const auto& loop : face.loops)
            twofold += dot(face.normal, double_area(boundary, loop));
    }
    return twofold / 2.0;
}

Box bounds(const Boundary& boundary) {
    Box box;
    for (const Vec3& vertex : boundary.vertices)
        box.add(vertex);
    return box;
}

}  // namespace ncsim::cda
