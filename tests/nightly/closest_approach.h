// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lower and upper bound of the distance between a moving tool and a point; both are certain.
#pragma once

#include "nightly/course.h"

#include <functional>

namespace ncsim::nightly {

/// Convex function of a point in frame T with slopes of at most 1, such as the signed distance from
/// a convex tool.
using Gauge = std::function<double(const Vec& p_T)>;

struct Bounds {
    double lower = 0.0, upper = 0.0;
};

/// Returns bounds of the minimum of `gauge` at the point `p_W` during the motion, refined until
/// lower > cut or upper <= cut, or until `most_steps` intervals have been examined.
///
/// In an interval of length w, the path of the point relative to the tool deviates from its chord
/// by at most b w²/8, where b bounds the second derivative. On a chord the values of a convex
/// function are convex, and secants bound the minimum from below. Both bounds include the rounding
/// of doubles.
Bounds closest_approach(const Gauge& gauge, const Course& course, const Vec& p_W, double cut,
                        int most_steps = 20000);

}  // namespace ncsim::nightly
