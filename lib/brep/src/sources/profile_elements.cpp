// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides profiles, whose corners may be rounded, into elements.
#include "sources/profile_elements.h"

#include "ncsim/base/vec2.h"

#include "geometry/tolerances.h"

#include <cmath>
#include <cstddef>

namespace ncsim::brep {

namespace {

// Points of the profile: x is the radius, y the height.
Vec2 direction(Vec2 from, Vec2 to) {
    const Vec2 d = to - from;
    const double length = norm(d);
    return length > kRounding ? Vec2{d.x / length, d.y / length} : Vec2{};
}

}  // namespace

std::vector<ProfileElement> elements_of(const toolpath::ToolPiece& piece) {
    const auto& profile = piece.profile;
    if (profile.empty()) return {};
    std::vector<Vec2> corners{{0.0, profile.front().height}};
    corners.reserve(profile.size() + 2);
    for (const toolpath::ProfilePoint& p : profile)
        corners.push_back({p.radius, p.height});
    corners.push_back({0.0, profile.back().height});
    std::vector<ProfileElement> elements;
    Vec2 at = corners.front();  // End of the last element.
    const auto straight_to = [&](Vec2 end) {
        if (std::abs(end.x - at.x) > kRounding || std::abs(end.y - at.y) > kRounding)
            elements.push_back({at.x, at.y, end.x, end.y});
        at = end;
    };
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Vec2 corner = corners[i + 1];
        const double rho = profile[i].fillet;
        if (rho <= 0.0) {
            straight_to(corner);
            continue;
        }
        const Vec2 in = direction(corners[i], corner), out = direction(corner, corners[i + 2]);
        const double tangent = rho * cross(in, out) / (1.0 + in.x * out.x + in.y * out.y);
        const Vec2 begin = corner - tangent * in, centre = begin + rho * left_normal(in);
        straight_to(begin);
        elements.push_back({centre.x, centre.y, 0.0, 0.0, rho});
        at = corner + tangent * out;
    }
    straight_to(corners.back());
    return elements;
}

}  // namespace ncsim::brep
