// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps turn so little that the curve is near the chords.
#include "geometry/cut_walk.h"

#include "geometry/newton.h"
#include "geometry/tolerances.h"

#include <algorithm>
#include <array>

namespace ncsim::brep {

std::optional<CutWalk> walk_along_cut(const Surface& surface, const CutPlane& plane, Vec3 begin,
                                      std::span<const Vec3> ends, double chords_mm) {
    const Form level = Plane{plane.offset * plane.normal, plane.normal};
    const std::array<const Form*, 2> both{&surface.form, &level};
    const auto ahead = [&](Vec3 p) { return normalized(cross(plane.normal, outward(surface, p))); };
    CutWalk walk;
    Vec3 p = begin, direction = ahead(begin);
    // Steps of at most 1 mm. No result if a curve needs steps shorter than ten times the error of
    // points, or more than 20,000 steps.
    double step = 0.1;
    for (int i = 0; i < 20'000 && step > 10.0 * kPointError; ++i) {
        const auto end = std::ranges::find_if(ends, [&](Vec3 at) {
            const double far = norm(at - p);
            return far <= step && dot(at - p, direction) >= 0.8 * far;
        });
        if (end != ends.end()) {
            walk.end = static_cast<std::size_t>(end - ends.begin());
            return walk;
        }
        Vec3 next = p + step * direction;
        const bool is_on = solve(both, next) < kPointError;
        const Vec3 on = ahead(next);
        // The height of an arc over its chord is chord times turn / 8; the limit 4 leaves a margin
        // of two.
        if (!is_on || norm(next - p) * norm(on - direction) > 4.0 * chords_mm ||
            dot(on, direction) <= 0.0) {
            step *= 0.5;
            continue;
        }
        p = next;
        direction = on;
        walk.between.push_back(p);
        step = std::min(1.5 * step, 1.0);
    }
    return std::nullopt;
}

}  // namespace ncsim::brep
