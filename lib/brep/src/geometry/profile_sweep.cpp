// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions, samples and frames of tools along their paths.
#include "ncsim/brep/profile_sweep.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ncsim::brep {

namespace {

ToolFrame tool_frame(const StraightPath& path, double t) {
    return {path.from + t * path.along, path.along, {}, path.axis, {}, {}};
}

ToolFrame tool_frame(const HelixPath& path, double t) {
    const double w = t * path.swept;
    const auto angle = sin_cos(w / kRadiansPerDegree);
    const Vec3 side = cross(path.about, path.ahead);
    const Vec3 up = angle.cos * path.ahead + angle.sin * side;
    const Vec3 on = angle.cos * side - angle.sin * path.ahead;
    const double reach = path.reach + path.growth * w;
    ToolFrame p;
    p.tip = path.centre + reach * up + (path.lead * w) * path.about;
    p.speed = path.swept * (path.growth * up + reach * on + path.lead * path.about);
    p.change = (path.swept * path.swept) * (2.0 * path.growth * on - reach * up);
    p.axis = path.axis;
    return p;
}

std::size_t samples_for(const StraightPath&) {
    return 2;
}
std::size_t samples_for(const HelixPath& path) {
    // A sample every 5 degrees.
    return 9 + static_cast<std::size_t>(std::abs(path.swept) / kRadiansPerDegree / 5.0);
}

// A path with few powers is nearly straight and needs few samples.
std::size_t samples_for(const RotaryPath& path) {
    return std::min<std::size_t>(33, 2 * path.powers.size() + 1);
}

}  // namespace

Sweep::Sweep(const Meridian& meridian, const ToolPath& path) : meridian_(meridian), path_(path) {
    const std::size_t count =
        std::visit([](const auto& which) { return samples_for(which); }, path_);
    for (std::size_t i = 0; i < count; ++i)
        samples_.push_back(at(static_cast<double>(i) / static_cast<double>(count - 1)));
    const auto length = [&](double height) {
        double sum = 0.0;
        for (std::size_t i = 1; i < count; ++i) {
            const ToolFrame &from = samples_[i - 1], &to = samples_[i];
            sum += norm(to.tip + height * to.axis - from.tip - height * from.axis);
        }
        return sum;
    };
    length_ = length(0.0);
    if (const Flank* side = flank())
        length_ =
            std::max(length(lowest_centre(*this)), length(height_of_centre(*side, side->length)));
}

ToolFrame Sweep::at(double t) const {
    return std::visit([t](const auto& path) { return tool_frame(path, t); }, path_);
}

Vec3 gradient_of_time(const ClosestPoint& closest) {
    return closest.bend != 0.0 ? (-1.0 / closest.bend) * closest.drift : Vec3{};
}

double height_of_centre(const Flank& flank, double along) {
    return flank.height + (along - flank.radius * flank.sine) / flank.cosine;
}

double lowest_centre(const Sweep& sweep) {
    const Fillet* fillet = sweep.fillet();
    return fillet ? fillet->height : height_of_centre(*sweep.flank(), 0.0);
}

Vec3 velocity_at(const ToolFrame& tool, double height) {
    return tool.speed + height * tool.turn;
}

PathFrame path_frame(const Sweep& sweep, const ToolFrame& tool) {
    PathFrame at;
    at.centre = tool.tip + lowest_centre(sweep) * tool.axis;
    at.ahead = normalized(velocity_at(tool, lowest_centre(sweep)));
    at.up = normalized(tool.axis - dot(tool.axis, at.ahead) * at.ahead);
    at.side = cross(at.ahead, at.up);
    return at;
}

}  // namespace ncsim::brep
