// SPDX-License-Identifier: GPL-3.0-or-later
#include "deviation.h"

#include "ncsim/cda/triangle_tree.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ncsim::exporter {

namespace {

using cda::Vec3;

double farthest(const cda::TriangleMesh& from, const cda::TriangleTree& to) {
    double result = 0.0;
    std::vector<bool> is_done(from.vertices.size(), false);
    for (const auto& triangle : from.triangles) {
        Vec3 sum;
        for (const std::uint32_t v : triangle) {
            sum = sum + from.vertices[v];
            if (is_done[v]) continue;
            is_done[v] = true;
            result = std::max(result, to.nearest(from.vertices[v]).distance_mm);
        }
        result = std::max(result, to.nearest((1.0 / 3.0) * sum).distance_mm);
    }
    return result;
}

}  // namespace

double deviation(const cda::TriangleMesh& a, const cda::TriangleMesh& b) {
    return std::max(farthest(a, cda::TriangleTree(b)), farthest(b, cda::TriangleTree(a)));
}

}  // namespace ncsim::exporter
