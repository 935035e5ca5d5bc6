// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection curves are followed in steps. Each step is a cubic with the correct ends and
// directions; a step is halved if the cubic is too far off. CAD readers search for a curve on the
// surfaces at equal steps of the parameter, so the speed must be low where steps are short.
#include "geometry/intersection_spline.h"

#include "ncsim/base/angles.h"

#include "geometry/newton.h"
#include "geometry/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace ncsim::brep {

namespace {

struct Knot {
    Vec3 at, along;  // unit
};

class Walk {
public:
    // The tolerance includes the distance by which the ends miss the forms.
    Walk(const Form& a, const Form& b, Vec3 begin, Vec3 end) : forms_{&a, &b} {
        for (const Form* form : forms_) {
            for (const Vec3& p : {begin, end})
                accuracy_ =
                    std::max(accuracy_, 5.0 * kPointError + 1.5 * std::abs(distance(*form, p)));
        }
    }

    Vec3 direction(Vec3 p, Vec3 ahead) {
        const Vec3 t = cross(evaluate(*forms_[0], p, seeds_[0]).gradient,
                             evaluate(*forms_[1], p, seeds_[1]).gradient);
        if (norm(t) < kLeastSine) return {};
        return dot(t, ahead) < 0.0 ? -normalized(t) : normalized(t);
    }

    // Returns the direction of the curve at its end `end`, towards `next`. If the forms are tangent
    // there, the direction is that of a parabola through a nearby point.
    Vec3 end_direction(Vec3 end, Vec3 next) {
        seeds_ = {};
        const Vec3 ahead = normalized(next - end);
        const Vec3 plain = direction(end, ahead);
        if (plain != Vec3{}) return plain;
        // The nearest point is best unless rounding in the program bends the curve there. Takes the
        // first direction with which the direction from the next farther point agrees.
        Vec3 along = ahead;
        bool is_first = true;
        for (const double nearby : {0.02, 0.1, 0.4, 1.6}) {  // mm
            Vec3 p = end + std::min(nearby, 0.5 * norm(next - end)) * ahead;
            solve(forms_, p, std::span(seeds_).first(2));
            const Vec3 there = direction(p, ahead);
            if (there == Vec3{}) continue;
            const Vec3 farther = normalized(2.0 * normalized(p - end) - there);
            if (!is_first && norm(farther - along) < 10.0 * kLeastSine) break;
            along = farther;
            is_first = false;
        }
        return along;
    }

    // Sets `to` to the point of the curve in the plane across the direction, `step` ahead.
    bool advance(const Knot& from, double step, Knot& to) {
        to.at = from.at + step * from.along;
        const Form across = Plane{to.at, from.along};
        const std::array<const Form*, 3> three{forms_[0], forms_[1], &across};
        if (solve(three, to.at, seeds_) > 0.1 * kRounding) return false;
        to.along = direction(to.at, to.at - from.at);
        return to.along != Vec3{} && follows(from, to);
    }

    // True if the cubic between both knots is accurate. The derivatives at the knots have the
    // length of the chord, or the lengths `first` and `last`.
    bool follows(const Knot& from, const Knot& to) {
        const double length = norm(to.at - from.at);
        return follows(from, to, length, length);
    }
    bool follows(const Knot& from, const Knot& to, double first, double last) {
        const Vec3 chord = to.at - from.at;
        const double length = norm(chord);
        if (dot(from.along, chord) < 0.7 * length || dot(to.along, chord) < 0.7 * length)
            return false;
        for (const double s : {0.2, 0.4, 0.6, 0.8}) {
            const double r = 1.0 - s;
            const Vec3 p = (r * r * (1.0 + 2.0 * s)) * from.at + (s * r * r * first) * from.along +
                           (s * s * (3.0 - 2.0 * s)) * to.at - (s * s * r * last) * to.along;
            for (std::size_t k = 0; k < forms_.size(); ++k) {
                if (std::abs(distance(*forms_[k], p, seeds_[k])) > accuracy_) return false;
            }
        }
        return true;
    }

private:
    std::array<const Form*, 2> forms_;
    std::array<ProjectionSeed, 3> seeds_;  // For both forms and the plane across.
    double accuracy_ = 5.0 * kPointError;
};

// Speed at each knot, and parameter width of each piece.
struct Pace {
    std::vector<double> speeds, widths;
};

std::vector<double> chords_of(const std::vector<Knot>& knots) {
    std::vector<double> chords;
    for (std::size_t i = 1; i < knots.size(); ++i)
        chords.push_back(norm(knots[i].at - knots[i - 1].at));
    return chords;
}

// Returns the speed 1 at all knots.
Pace even_pace(const std::vector<Knot>& knots) {
    return {std::vector<double>(knots.size(), 1.0), chords_of(knots)};
}

// Returns the geometric mean of the adjacent chords as the speed at each knot. The speed changes
// linearly on a piece, so all pieces have similar widths.
Pace pace_by_chords(const std::vector<Knot>& knots) {
    const std::vector<double> chords = chords_of(knots);
    Pace pace;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const double before = chords[i == 0 ? 0 : i - 1];
        const double after = chords[std::min(i, chords.size() - 1)];
        pace.speeds.push_back(std::sqrt(before * after));
    }
    for (std::size_t i = 0; i < chords.size(); ++i)
        pace.widths.push_back(2.0 * chords[i] / (pace.speeds[i] + pace.speeds[i + 1]));
    return pace;
}

Spline through(const std::vector<Knot>& knots, const Pace& pace) {
    Spline spline;
    double at = 0.0;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const Knot& k = knots[i];
        const Vec3 on = (pace.speeds[i] / 3.0) * k.along;
        const bool is_last = i + 1 == knots.size();
        if (i > 0) at += pace.widths[i - 1];
        spline.points.push_back(i == 0 ? k.at : k.at - pace.widths[i - 1] * on);
        spline.points.push_back(is_last ? k.at : k.at + pace.widths[i] * on);
        spline.knots.push_back(at);
    }
    return spline;
}

// Returns a spline through the knots, with more knots where the spline would be too far off.
Spline through(Walk& walk, const std::vector<Knot>& knots) {
    const std::vector<double> chords = chords_of(knots);
    const auto [shortest, longest] = std::ranges::minmax(chords);
    const Pace even = even_pace(knots);
    if (longest < 10.0 * shortest) return through(knots, even);
    std::vector<Knot> finer = knots;
    for (int pass = 0; pass < 20; ++pass) {
        const Pace pace = pace_by_chords(finer);
        std::vector<Knot> next{finer.front()};
        for (std::size_t i = 1; i < finer.size(); ++i) {
            const Knot &from = finer[i - 1], &to = finer[i];
            const double width = pace.widths[i - 1];
            if (!walk.follows(from, to, width * pace.speeds[i - 1], width * pace.speeds[i])) {
                Knot between;
                if (!walk.advance(from, 0.5 * norm(to.at - from.at), between))
                    return through(knots, even);
                next.push_back(between);
            }
            next.push_back(to);
        }
        if (next.size() == finer.size()) return through(finer, pace);
        finer = std::move(next);
    }
    return through(knots, even);
}

// Follows the curve from the first to the last point. Points determine the direction at an end if
// they are farther from the end than the fraction `share` of the path.
std::optional<Spline> follow(const Form& a, const Form& b, const std::vector<Vec3>& points,
                             double share) {
    Walk walk(a, b, points.front(), points.back());
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += norm(points[i] - points[i - 1]);
    const Vec3 begin = points.front(), end = points.back();
    // Corners of the polygon that are very near determine no direction.
    const auto far_from = [&](Vec3 p, auto first, auto last) {
        for (; first != last; ++first) {
            if (norm(*first - p) > share * length) return *first;
        }
        return *(last - 1);
    };
    Knot at{begin, walk.end_direction(begin, far_from(begin, points.begin(), points.end()))};
    const Knot goal{end, -walk.end_direction(end, far_from(end, points.rbegin(), points.rend()))};
    std::vector<Knot> knots{at};
    // A path as short as the least step is tried as a whole.
    const double least = 0.1 * kLeastSizeMm;
    double step = std::max(0.25 * length, 2.0 * least), passed = 0.0;
    for (int i = 0; i < 1000 && step > least && passed < 2.0 * length + 1.0; ++i) {
        const double rest = norm(goal.at - at.at);
        const bool is_near = i > 0 || norm(end - begin) > 0.5 * length;
        if (rest <= 1.5 * step && is_near && rest > 0.0 && walk.follows(at, goal)) {
            knots.push_back(goal);
            return through(walk, knots);
        }
        // A closed curve begins at its end; the end is ahead after half of the path.
        const bool is_ahead = norm(end - begin) > least || passed > 0.5 * length;
        const double most = is_ahead ? std::max(0.6 * rest, 4.0 * least) : step;
        Knot next;
        if (!walk.advance(at, std::min(step, most), next)) {
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

}  // namespace

std::optional<Spline> intersection_spline(const Form& a, const Form& b,
                                          const std::vector<Vec3>& points) {
    // Near a sharp corner of the path, distant points lie behind.
    auto spline = follow(a, b, points, 0.2);
    return spline ? spline : follow(a, b, points, 0.05);
}

Spline arc_spline(const Circle& circle, Vec3 from, Vec3 to) {
    const Vec3 x = normalized(radial_vector(circle.centre, circle.axis, from));
    const Vec3 y = cross(circle.axis, x);
    const Curve curve = circle;
    const double sweep = Track(curve, from, to).sweep_degrees();
    int pieces = 3;
    SinCos handle = sin_cos(0.25 * sweep / pieces);
    // By so much misses a cubic the arc: 4/27 r sin(w / 4)^6 / cos(w / 4)^2.
    const auto miss = [&] {
        const double square = handle.sin * handle.sin;
        return 4.0 / 27.0 * circle.radius * square * square * square / (handle.cos * handle.cos);
    };
    // Shorter pieces leave the direction of the circle.
    const Form ball = Sphere{circle.centre, circle.radius};
    const double shortest =
        100.0 * std::max(std::abs(distance(ball, from)), std::abs(distance(ball, to)));
    const double length = circle.radius * sweep * kRadiansPerDegree;
    while ((sweep > 15.0 * pieces || miss() > kRounding) && length > shortest * pieces)
        handle = sin_cos(0.25 * sweep / ++pieces);
    const double step = sweep / pieces;
    const double width = circle.radius * step * kRadiansPerDegree;
    const double speed = 4.0 * circle.radius * handle.sin / handle.cos / width;
    std::vector<Knot> knots;
    for (int i = 0; i <= pieces; ++i) {
        const auto turn = sin_cos(i * step);
        knots.push_back({circle.centre + circle.radius * (turn.cos * x + turn.sin * y),
                         turn.cos * y - turn.sin * x});
    }
    knots.front().at = from;
    knots.back().at = to;
    return through(knots, {std::vector(knots.size(), speed),
                           std::vector(static_cast<std::size_t>(pieces), width)});
}

}  // namespace ncsim::brep
