// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions, samples and frames of tools along their paths.
#include "ncsim/brep/sweep.h"

#include "ncsim/trig/angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ncsim::brep {

using cda::cross;
using cda::dot;
using cda::norm;
using cda::normalized;
using trig::kRadiansPerDegree;

namespace {

ToolFrame passage(const StraightWay& way, double t) {
    return {way.from + t * way.along, way.along, {}, way.axis, {}, {}};
}

ToolFrame passage(const RoundWay& way, double t) {
    const double w = t * way.swept;
    const auto angle = trig::sin_cos(w / kRadiansPerDegree);
    const Vec3 side = cross(way.about, way.ahead);
    const Vec3 up = angle.cos * way.ahead + angle.sin * side;
    const Vec3 on = angle.cos * side - angle.sin * way.ahead;
    const double reach = way.reach + way.growth * w;
    ToolFrame p;
    p.tip = way.centre + reach * up + (way.lead * w) * way.about;
    p.speed = way.swept * (way.growth * up + reach * on + way.lead * way.about);
    p.change = (way.swept * way.swept) * (2.0 * way.growth * on - reach * up);
    p.axis = way.axis;
    return p;
}

std::size_t samples_for(const StraightWay&) {
    return 2;
}
std::size_t samples_for(const RoundWay& way) {
    constexpr double kStep = 5.0;  // degrees
    return 9 + static_cast<std::size_t>(std::abs(way.swept) / kRadiansPerDegree / kStep);
}

// A path with few powers is nearly straight and needs few samples.
std::size_t samples_for(const RotaryPath& way) {
    constexpr std::size_t kMost = 33;
    return std::min(kMost, 2 * way.powers.size() + 1);
}

}  // namespace

Sweep::Sweep(const Meridian& meridian, const ToolWay& way) : meridian_(meridian), way_(way) {
    const std::size_t count =
        std::visit([](const auto& which) { return samples_for(which); }, way_);
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
    return std::visit([t](const auto& way) { return passage(way, t); }, way_);
}

Vec3 gradient_of_time(const ClosestPoint& aspect) {
    return aspect.bend != 0.0 ? (-1.0 / aspect.bend) * aspect.drift : Vec3{};
}

double height_of_centre(const Flank& flank, double along) {
    return flank.height + (along - flank.radius * flank.sine) / flank.cosine;
}

double lowest_centre(const Sweep& sweep) {
    const Fillet* fillet = sweep.fillet();
    return fillet ? fillet->height : height_of_centre(*sweep.flank(), 0.0);
}

Vec3 velocity_at(const ToolFrame& passage, double height) {
    return passage.speed + height * passage.turn;
}

Around around(const Sweep& sweep, const ToolFrame& passage) {
    Around at;
    at.centre = passage.tip + lowest_centre(sweep) * passage.axis;
    at.ahead = normalized(velocity_at(passage, lowest_centre(sweep)));
    at.up = normalized(passage.axis - dot(passage.axis, at.ahead) * at.ahead);
    at.side = cross(at.ahead, at.up);
    return at;
}

}  // namespace ncsim::brep
