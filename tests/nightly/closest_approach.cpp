// SPDX-License-Identifier: GPL-3.0-or-later
//
// Branch and bound over the intervals of a motion.
#include "nightly/closest_approach.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace ncsim::nightly {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Values of a convex function on [0, 1], with the greatest lower bound that the values imply.
class ConvexValues {
public:
    // Requires: slopes are at most `steepest`; values are exact within `rounding`.
    ConvexValues(double steepest, double rounding) : steepest_(steepest), rounding_(rounding) {}

    void add(double t, double value) {
        const auto at = std::upper_bound(values_.begin(), values_.end(), t,
                                         [](double x, const Value& v) { return x < v.t; });
        values_.insert(at, {t, value});
    }

    double least() const { return values_[best()].value; }
    double where() const { return values_[best()].t; }

    struct Kink {
        double t = 0.0, bound = 0.0;
        bool can_be_added = true;
    };
    // Returns the parameter with the smallest lower bound of the function. Without rounding, the
    // parameter would be in an interval next to the least value.
    Kink lowest() const {
        const std::size_t i = best();
        Kink kink{values_[i].t, values_[i].value - rounding_, false};
        for (std::size_t k = 0; k + 1 < values_.size(); ++k)
            lower(kink, k);
        return kink;
    }

private:
    struct Value {
        double t, value;
    };

    std::size_t best() const {
        std::size_t best = 0;
        for (std::size_t i = 1; i < values_.size(); ++i) {
            if (values_[i].value < values_[best].value) best = i;
        }
        return best;
    }

    // Slope of the secant through two successive values; slope_error() bounds the error by
    // rounding.
    double slope(std::size_t i) const {
        const Value a = values_[i];
        const Value b = values_[i + 1];
        return (b.value - a.value) / (b.t - a.t);
    }
    double slope_error(std::size_t i) const {
        return 2 * rounding_ / (values_[i + 1].t - values_[i].t);
    }

    // Between values i and i + 1 the function is above the extended secants of both neighbouring
    // intervals.
    void lower(Kink& kink, std::size_t i) const {
        const Value a = values_[i];
        const Value b = values_[i + 1];
        double down = -steepest_;
        if (i > 0) down = std::max(down, slope(i - 1) - slope_error(i - 1));
        double up = steepest_;
        if (i + 2 < values_.size()) up = std::min(up, slope(i + 1) + slope_error(i + 1));
        double t = a.t;
        double bound = std::min(a.value, b.value);
        if (down < 0.0 && up > 0.0) {
            t = (b.value - a.value + down * a.t - up * b.t) / (down - up);
            t = std::clamp(t, a.t, b.t);
            // Value at the intersection of both secants; the smaller value, because t is rounded.
            bound = std::min({bound, a.value + down * (t - a.t), b.value + up * (t - b.t)});
        }
        bound -= rounding_;
        if (bound >= kink.bound) return;
        // At some distance from known values: secants of close values are steep by rounding.
        const double margin = 0.02 * (b.t - a.t);
        kink = {std::clamp(t, a.t + margin, b.t - margin), bound, b.t - a.t > 1e-7};
    }

    double steepest_, rounding_;
    std::vector<Value> values_;
};

struct ChordBound {
    double lower = 0.0;
    double at = 0.0;  // of the least value found, in [0, 1]
};

// Returns a lower bound of a convex gauge on the chord from a to b. Stops as soon as the bound is
// above `enough` or cannot exceed `enough`.
ChordBound along_chord(const Gauge& gauge, const Vec& a, const Vec& b, double enough,
                       double rounding) {
    ConvexValues values(norm(b - a), rounding);
    const auto look = [&](double t) { values.add(t, gauge(a + t * (b - a))); };
    look(0.5);
    // A bound from a single value in the middle.
    const double quick = values.least() - rounding - 0.5 * norm(b - a);
    if (quick > enough) return {quick, 0.5};
    look(0.0);
    look(1.0);
    constexpr int kMost = 60;
    for (int i = 0; i < kMost; ++i) {
        const auto kink = values.lowest();
        if (kink.bound > enough || values.least() <= enough || !kink.can_be_added) break;
        look(kink.t);
    }
    return {values.lowest().bound, values.where()};
}

}  // namespace

Bounds closest_approach(const Gauge& gauge, const Course& course, const Vec& p_W, double cut,
                        int most_steps) {
    // A few roundings of doubles in each of several dozen operations.
    const double rounding = 4e-15 * course.magnitude(p_W);
    const double bend = course.bend(p_W);
    Bounds bounds{kInfinity, kInfinity};
    const auto value_at = [&](double t) {
        bounds.upper = std::min(bounds.upper, gauge(course.to_tool(t, p_W)) + rounding);
    };
    struct Interval {
        double from, to;
        Vec a, b;
    };
    std::vector<Interval> pending{{0.0, 1.0, course.to_tool(0.0, p_W), course.to_tool(1.0, p_W)}};
    for (int steps = 0; !pending.empty(); ++steps) {
        const Interval now = pending.back();
        pending.pop_back();
        const double w = now.to - now.from;
        const double bulge = bend * w * w / 8;
        const ChordBound chord = along_chord(gauge, now.a, now.b, cut + bulge, rounding);
        const double lower = chord.lower - bulge;
        value_at(now.from + chord.at * w);
        if (bounds.upper <= cut || steps == most_steps) {
            bounds.lower = -kInfinity;  // decided by the upper bound, or given up
            return bounds;
        }
        if (lower > cut || bulge <= rounding) {
            bounds.lower = std::min(bounds.lower, lower);
            continue;
        }
        const double middle = 0.5 * (now.from + now.to);
        const Vec m = course.to_tool(middle, p_W);
        const Interval first{now.from, middle, now.a, m};
        const Interval second{middle, now.to, m, now.b};
        // The half with the nearest point of the chord first, because this half may decide the
        // result.
        pending.push_back(chord.at < 0.5 ? second : first);
        pending.push_back(chord.at < 0.5 ? first : second);
    }
    return bounds;
}

}  // namespace ncsim::nightly
