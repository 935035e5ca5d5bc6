// SPDX-License-Identifier: GPL-3.0-or-later
//
// The result of simplify().
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/mesh.h"

#include <vector>

namespace ncsim::exporter {

struct Simplified {
    /// `origin` of a face is the smallest of those it is made of, or, where lines are kept apart,
    /// that of its largest one. Some vertices may be unused.
    cda::Boundary boundary;
    /// For each face the origins of the faces it is made of, ascending, each once.
    std::vector<std::vector<cda::Origin>> origins;
    /// In mm, measured: the farthest that a corner or the middle of a triangle of one surface lies
    /// from the other, shells that vanished aside. Never more than the tolerance.
    double deviation_mm = 0.0;
    /// `boundary`, as cda::triangulate() cuts it.
    cda::TriangleMesh mesh;
};

}  // namespace ncsim::exporter
