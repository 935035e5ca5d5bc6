// SPDX-License-Identifier: GPL-3.0-or-later
#include "deviation.h"

#include "ncsim/cda/triangle_tree.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ncsim::exporter {

namespace {

using cda::Vec3;

// Is there a triangle within `limit` of a point? Sometimes no where there is one, by rounding.
bool is_within(const cda::TriangleTree& tree, Vec3 p, double limit) {
    bool found = false;
    tree.visit(
        [&](const cda::Box& box) {
            for (int axis = 0; axis < 3; ++axis) {
                if (p[axis] < box.min[axis] - limit || p[axis] > box.max[axis] + limit)
                    return false;
            }
            return !found;
        },
        [&](std::uint32_t t) {
            found = found || cda::distance(p, cda::corners_of(tree.mesh(), t)) <= limit;
        });
    return found;
}

// Only what is farther than all before it is measured: of most points it is soon clear that they
// are not.
double farthest(const cda::TriangleMesh& from, const cda::TriangleTree& to) {
    double result = 0.0;
    const auto measure = [&](Vec3 p) {
        if (!is_within(to, p, result)) result = std::max(result, to.nearest(p).distance_mm);
    };
    std::vector<bool> is_done(from.vertices.size(), false);
    for (const auto& triangle : from.triangles) {
        Vec3 sum;
        for (const std::uint32_t v : triangle) {
            sum = sum + from.vertices[v];
            if (is_done[v]) continue;
            is_done[v] = true;
            measure(from.vertices[v]);
        }
        measure((1.0 / 3.0) * sum);
    }
    return result;
}

}  // namespace

double deviation(const cda::TriangleMesh& a, const cda::TriangleMesh& b) {
    return std::max(farthest(a, cda::TriangleTree(b)), farthest(b, cda::TriangleTree(a)));
}

}  // namespace ncsim::exporter
