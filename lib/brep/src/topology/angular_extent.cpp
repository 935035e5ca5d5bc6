// SPDX-License-Identifier: GPL-3.0-or-later
//
// Angles that faces cover around an axis.
#include "topology/angular_extent.h"

#include "ncsim/base/angles.h"

#include "geometry/tolerances.h"
#include "topology/face_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ncsim::brep {

std::vector<std::vector<Vec3>> points_along(const Part& part, const Face& face) {
    std::vector<std::vector<Vec3>> loops;
    for (const Loop& loop : face.loops) {
        std::vector<Vec3>& points = loops.emplace_back();
        for (const EdgeUse& use : loop) {
            const Edge& edge = part.edges[use.edge];
            const Track track = track_of(part, edge);
            const std::size_t steps = 4 * track.pieces();
            for (std::size_t i = 0; i < steps; ++i) {
                const double t = static_cast<double>(i) / static_cast<double>(steps);
                points.push_back(track.at(use.is_forward ? t : 1.0 - t));
            }
        }
    }
    return loops;
}

AngularExtent angular_extent(const std::vector<std::vector<Vec3>>& loops, Vec3 origin, Vec3 axis,
                             Vec3 x) {
    const Vec3 y = cross(axis, x);
    AngularExtent extent;
    std::vector<std::pair<double, double>> covered;  // begin in [0, 360), length
    for (const auto& points : loops) {
        double sum = 0.0;
        std::optional<double> first, last;
        const auto take = [&](double angle) {
            if (last) {
                double step = angle - *last;
                step -= 360.0 * std::floor(step / 360.0 + 0.5);
                sum += step;
                double begin = step < 0.0 ? angle : *last;
                if (begin < 0.0) begin += 360.0;
                covered.emplace_back(begin, std::abs(step));
            } else {
                first = angle;
            }
            last = angle;
        };
        for (const Vec3& p : points) {
            const Vec3 v = p - origin;
            const double u = dot(v, x), w = dot(v, y);
            const double radius = std::sqrt(u * u + w * w);
            const double far = norm(v);
            if (far > 0.0) extent.nearest = std::min(extent.nearest, radius / far);
            // A tip has no angle.
            if (radius > kPointError) take(angle_of(u, w));
        }
        if (first) take(*first);
        extent.is_full_turn = extent.is_full_turn || std::abs(sum) > 180.0;
        extent.sum += sum;
    }
    if (covered.empty()) return extent;
    std::sort(covered.begin(), covered.end());
    double end = covered.front().first;
    for (const auto& [begin, length] : covered) {
        if (begin - end > extent.gap) {
            extent.gap = begin - end;
            extent.gap_begin = end;
        }
        end = std::max(end, begin + length);
    }
    if (covered.front().first + 360.0 - end > extent.gap) {
        extent.gap = covered.front().first + 360.0 - end;
        extent.gap_begin = end;
    }
    return extent;
}

double winding_angle(const std::vector<Vec3>& points, Vec3 centre, Vec3 axis) {
    double sum = 0.0;
    const Vec3 x = any_perpendicular(axis), y = cross(axis, x);
    std::optional<double> last;
    for (const Vec3& p : points) {
        const double angle = angle_of(dot(p - centre, x), dot(p - centre, y));
        if (last) {
            const double step = angle - *last;
            sum += step - 360.0 * std::floor(step / 360.0 + 0.5);
        }
        last = angle;
    }
    return sum;
}

}  // namespace ncsim::brep
