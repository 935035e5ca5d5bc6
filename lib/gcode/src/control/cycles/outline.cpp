// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and polygons of outlines.
#include "control/cycles/outline.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ncsim::gcode {
namespace {

constexpr double kMostPieces = 2000.0;  // Segments of an arc; an arc with more is a wrong word.

/// An arc whose ends subtend at most this angle at the centre is a full circle, degrees.
constexpr double kNoTurn = 1e-9 * 180.0 / std::numbers::pi;

/// Returns the angle that the arc `move` turns by, in degrees, positive counter-clockwise.
double sweep_of(const OutlineMove& move) {
    const double from = angle_of(move.from.x - move.centre.x, move.from.y - move.centre.y);
    const double to = angle_of(move.to.x - move.centre.x, move.to.y - move.centre.y);
    double sweep = move.turns > 0 ? to - from : from - to;
    while (sweep <= kNoTurn)
        sweep += 360.0;
    return move.turns > 0 ? sweep : -sweep;
}

}  // namespace

Vec2 point_at(const OutlineMove& move, double share) {
    if (move.turns == 0) {
        return {move.from.x + share * (move.to.x - move.from.x),
                move.from.y + share * (move.to.y - move.from.y)};
    }
    const SinCos turn = sin_cos(share * sweep_of(move));
    const double x = move.from.x - move.centre.x;
    const double y = move.from.y - move.centre.y;
    return {move.centre.x + x * turn.cos - y * turn.sin,
            move.centre.y + x * turn.sin + y * turn.cos};
}

Vec2 direction_in_middle(const OutlineMove& move) {
    if (move.turns == 0) return {move.to.x - move.from.x, move.to.y - move.from.y};
    const double turn = move.turns > 0 ? 1.0 : -1.0;
    const Vec2 middle = point_at(move, 0.5);
    return {-turn * (middle.y - move.centre.y), turn * (middle.x - move.centre.x)};
}

std::vector<Vec2> polygon_of(const std::vector<OutlineMove>& outline, double chord) {
    std::vector<Vec2> points;
    for (const OutlineMove& move : outline) {
        int pieces = 1;
        if (move.turns != 0) {
            const double r = hypotenuse(move.from.x - move.centre.x, move.from.y - move.centre.y);
            const double rise = std::min(chord / r, 0.5);
            const double step = 2.0 * angle_of(1.0 - rise, std::sqrt(rise * (2.0 - rise)));
            const double wanted = step > 0.0 ? std::abs(sweep_of(move)) / step : kMostPieces;
            pieces = static_cast<int>(std::ceil(std::clamp(wanted, 4.0, kMostPieces)));
        }
        for (int i = 0; i < pieces; ++i)
            points.push_back(point_at(move, static_cast<double>(i) / pieces));
    }
    return points;
}

}  // namespace ncsim::gcode
