// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curve is followed in steps, each a cubic that has the right ends and directions, and is half
// as long where it lies too far off.
#include "spline.h"

#include "contact.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::brep {

namespace {

using cda::cross;
using cda::dot;
using cda::norm;
using cda::normalized;

constexpr double kAccuracy = 1e-5;    // mm
constexpr double kLeastAngle = 1e-3;  // sine of the angle between both forms
constexpr double kLeastStep = 1e-4;   // mm
constexpr double kStraight = 0.7;     // cosine between chord and direction, at least
constexpr int kMostSteps = 1000;

struct Knot {
    Vec3 at, along;  // unit
};

class Walk {
public:
    // What the ends miss, the curve may miss, too.
    Walk(const Form& a, const Form& b, Vec3 begin, Vec3 end) : forms_{&a, &b} {
        for (const Form* form : forms_) {
            for (const Vec3& p : {begin, end})
                accuracy_ =
                    std::max(accuracy_, 0.5 * kAccuracy + 1.5 * std::abs(distance(*form, p)));
        }
    }

    Vec3 direction(Vec3 p, Vec3 ahead) const {
        const Vec3 t = cross(gradient(*forms_[0], p), gradient(*forms_[1], p));
        if (norm(t) < kLeastAngle) return {};
        return dot(t, ahead) < 0.0 ? -normalized(t) : normalized(t);
    }

    // Where both forms touch in one point of their curve, at its end: its direction there is that
    // of a parabola through a point nearby. Towards `next`.
    Vec3 end_direction(Vec3 end, Vec3 next) const {
        const Vec3 ahead = normalized(next - end);
        const Vec3 plain = direction(end, ahead);
        if (plain != Vec3{}) return plain;
        constexpr double kNearby = 0.02;  // mm
        Vec3 p = end + kNearby * ahead;
        solve(forms_, p);
        return normalized(2.0 * normalized(p - end) - direction(p, ahead));
    }

    // The point of the curve in the plane across the direction, `step` ahead.
    bool advance(const Knot& from, double step, Knot& to) const {
        to.at = from.at + step * from.along;
        const Form across = Plane{to.at, from.along};
        const std::array<const Form*, 3> three{forms_[0], forms_[1], &across};
        if (solve(three, to.at) > kAccuracy * kAccuracy) return false;
        to.along = direction(to.at, to.at - from.at);
        return to.along != Vec3{} && follows(from, to);
    }

    // Is the cubic between both knots as near as it has to be?
    bool follows(const Knot& from, const Knot& to) const {
        const Vec3 chord = to.at - from.at;
        const double length = norm(chord);
        if (dot(from.along, chord) < kStraight * length ||
            dot(to.along, chord) < kStraight * length)
            return false;
        for (const double s : {0.2, 0.4, 0.6, 0.8}) {
            const double r = 1.0 - s;
            const Vec3 p = (r * r * (1.0 + 2.0 * s)) * from.at + (s * r * r * length) * from.along +
                           (s * s * (3.0 - 2.0 * s)) * to.at - (s * s * r * length) * to.along;
            for (const Form* form : forms_) {
                if (std::abs(distance(*form, p)) > accuracy_) return false;
            }
        }
        return true;
    }

private:
    std::array<const Form*, 2> forms_;
    double accuracy_ = 0.5 * kAccuracy;
};

Spline through(const std::vector<Knot>& knots) {
    Spline spline;
    double at = 0.0;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const Knot& k = knots[i];
        if (i > 0) {
            const double width = norm(k.at - knots[i - 1].at);
            at += width;
            spline.points.push_back(k.at - (width / 3.0) * k.along);
        } else {
            spline.points.push_back(k.at);
        }
        spline.knots.push_back(at);
        if (i + 1 < knots.size()) {
            const double width = norm(knots[i + 1].at - k.at);
            spline.points.push_back(k.at + (width / 3.0) * k.along);
        } else {
            spline.points.push_back(k.at);
        }
    }
    return spline;
}

}  // namespace

std::optional<Spline> spline_between(const Form& a, const Form& b,
                                     const std::vector<Vec3>& points) {
    const Walk walk(a, b, points.front(), points.back());
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += norm(points[i] - points[i - 1]);
    const Vec3 begin = points.front(), end = points.back();
    // Corners of the polygon that are very near tell no direction.
    const auto far_from = [&](Vec3 p, auto first, auto last) {
        for (; first != last; ++first) {
            if (norm(*first - p) > 0.2 * length) return *first;
        }
        return *(last - 1);
    };
    Knot at{begin, walk.end_direction(begin, far_from(begin, points.begin(), points.end()))};
    const Knot goal{end, -walk.end_direction(end, far_from(end, points.rbegin(), points.rend()))};
    std::vector<Knot> knots{at};
    double step = 0.25 * length, passed = 0.0;
    for (int i = 0; i < kMostSteps && step > kLeastStep && passed < 2.0 * length + 1.0; ++i) {
        const double rest = norm(goal.at - at.at);
        const bool is_near = i > 0 || norm(end - begin) > 0.5 * length;
        if (rest <= 1.5 * step && is_near && rest > 0.0 && walk.follows(at, goal)) {
            knots.push_back(goal);
            return through(knots);
        }
        Knot next;
        if (!walk.advance(at, std::min(step, std::max(0.6 * rest, 4.0 * kLeastStep)), next)) {
            step *= 0.5;
            continue;
        }
        passed += norm(next.at - at.at);
        at = next;
        knots.push_back(at);
        step *= 1.5;
    }
    return std::nullopt;
}

}  // namespace ncsim::brep
