// SPDX-License-Identifier: GPL-3.0-or-later
//
// How near a moving tool comes to a point: a lower and an upper bound, both certain.
#pragma once

#include "nightly/course.h"

#include <functional>

namespace ncsim::nightly {

/// A convex function of a point in frame T whose slope is at most 1, such as the signed distance of
/// a convex tool.
using Gauge = std::function<double(const Vec& p_T)>;

struct Bounds {
    double lower = 0.0, upper = 0.0;
};

/// Bounds of the least value of `gauge` that the point sees during the move. Refined until they
/// tell whether it is above `cut` (lower > cut, or upper <= cut), or `most_steps` intervals were
/// looked at.
///
/// In an interval of length w the way of the point past the tool lies within b w²/8 of its chord,
/// where b bounds the second derivative. Along a chord a convex function has convex values, whose
/// least is bounded from below by secants. Rounding of the doubles is allowed for on both sides.
Bounds closest_approach(const Gauge& gauge, const Course& course, const Vec& p_W, double cut,
                        int most_steps = 20000);

}  // namespace ncsim::nightly
