// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clips polygons at the six planes of a box.
#include "clip_to_box.h"

#include <cstddef>
#include <utility>

namespace ncsim::simulation {

std::vector<Vec3> clip_to_box(std::vector<Vec3> polygon, const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const double most = sign > 0.0 ? box.max[axis] : -box.min[axis];
            std::vector<Vec3> left;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vec3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
                const double a = sign * p[axis] - most, b = sign * q[axis] - most;
                if (a <= 0.0) left.push_back(p);
                if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0))
                    left.push_back(p + (a / (a - b)) * (q - p));
            }
            polygon = std::move(left);
        }
    }
    return polygon;
}

double area_of_polygon(std::span<const Vec3> polygon) {
    Vec3 twice;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        twice = twice + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * norm(twice);
}

}  // namespace ncsim::simulation
