// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ways of tools that turn, as series of Chebyshev polynomials: what is as smooth as turns by
// constant speeds is known to the last bits from few values (Trefethen, Approximation Theory and
// Approximation Practice, 2013, chapters 3 and 8).
#include "ncsim/brep/envelope.h"
#include "ncsim/trig/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ncsim::brep {

namespace {

// For turns of half a turn it would take 17 for 1e-12 of the length.
constexpr std::size_t kTerms = 22;
constexpr double kWidth = 1.0 + 2.0 * kBeyondEnds;

// From t to -1 ... 1, and back.
double place_of(double t) {
    return (2.0 * (t + kBeyondEnds)) / kWidth - 1.0;
}
double time_of(double place) {
    return 0.5 * (place + 1.0) * kWidth - kBeyondEnds;
}

// The k-th of the places where the polynomial after the last one is zero; times `times` as an
// angle.
double cosine_at(std::size_t k, std::size_t times) {
    constexpr double kHalf = 180.0;
    const double degrees = kHalf * (static_cast<double>(k) + 0.5) / static_cast<double>(kTerms);
    return trig::sin_cos(static_cast<double>(times) * degrees).cos;
}

// Clenshaw's sum.
Vec3 sum_at(const std::vector<Vec3>& terms, double place) {
    Vec3 one, two;
    for (std::size_t i = terms.size(); i-- > 1;) {
        const Vec3 next = terms[i] + (2.0 * place) * one - two;
        two = one;
        one = next;
    }
    return terms.front() + place * one - two;
}

// By t.
std::vector<Vec3> derivative_of(const std::vector<Vec3>& terms) {
    std::vector<Vec3> slope(terms.size());
    for (std::size_t i = terms.size() - 1; i-- > 0;) {
        slope[i] = (2.0 * static_cast<double>(i + 1)) * terms[i + 1];
        if (i + 2 < terms.size()) slope[i] = slope[i] + slope[i + 2];
    }
    slope[0] = 0.5 * slope[0];
    for (Vec3& term : slope)
        term = (2.0 / kWidth) * term;
    return slope;
}

Course course_through(const std::array<Vec3, kTerms>& values) {
    Course course;
    for (std::size_t j = 0; j < kTerms; ++j) {
        Vec3 sum;
        for (std::size_t k = 0; k < kTerms; ++k)
            sum = sum + cosine_at(k, j) * values[k];
        course.value.push_back(((j == 0 ? 1.0 : 2.0) / static_cast<double>(kTerms)) * sum);
    }
    // What is rounding alone costs time, and its derivatives are large. Lengths of 1 at least.
    constexpr double kMereRounding = 2e-15;
    double length = 1.0;
    for (const Vec3& value : values)
        length = std::max(length, cda::norm(value));
    constexpr std::size_t kFewest = 3;
    while (course.value.size() > kFewest && cda::norm(course.value.back()) < kMereRounding * length)
        course.value.pop_back();
    course.slope = derivative_of(course.value);
    course.bend = derivative_of(course.slope);
    return course;
}

}  // namespace

std::optional<TurningWay> turning_way(const std::function<TipAndAxis(double)>& pose) {
    std::array<Vec3, kTerms> tips, axes;
    for (std::size_t k = 0; k < kTerms; ++k) {
        const TipAndAxis there = pose(time_of(cosine_at(k, 1)));
        tips[k] = there.tip;
        axes[k] = there.axis;
    }
    TurningWay way{course_through(tips), course_through(axes)};
    constexpr double kMiss = 1e-9, kReach = 100.0;  // mm
    for (std::size_t k = 0; k < 2 * kTerms; ++k) {
        const double t = time_of(2.0 * (static_cast<double>(k) + 0.3) / (2.0 * kTerms) - 1.0);
        const TipAndAxis there = pose(t);
        const Passage here = passage(way, t);
        if (cda::norm(here.tip - there.tip) > kMiss ||
            kReach * cda::norm(here.axis - there.axis) > kMiss)
            return std::nullopt;
    }
    return way;
}

Passage passage(const TurningWay& way, double t) {
    const double place = place_of(t);
    return {sum_at(way.tip.value, place),  sum_at(way.tip.slope, place),
            sum_at(way.tip.bend, place),   sum_at(way.axis.value, place),
            sum_at(way.axis.slope, place), sum_at(way.axis.bend, place)};
}

}  // namespace ncsim::brep
