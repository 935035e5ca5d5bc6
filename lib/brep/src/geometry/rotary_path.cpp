// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths of tools that turn, as polynomials through Chebyshev points. Few values determine functions
// as smooth as rotations at constant speed to the last bits. At this low degree, powers are as
// exact as Chebyshev polynomials and are evaluated in a single loop.
// Source: Trefethen, Approximation Theory and Approximation Practice, 2013, chapters 3 and 8.
#include "ncsim/base/angles.h"
#include "ncsim/brep/profile_sweep.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace ncsim::brep {

namespace {

// A rotation by half a turn needs 17 terms for 1e-12 of the length.
constexpr std::size_t kTerms = 22;
constexpr double kWidth = 1.0 + 2.0 * kPathExtension;
constexpr std::size_t kCoordinates = 6;
using Coordinates = std::array<double, kCoordinates>;

// Maps t to [-1, 1], and back.
double place_of(double t) {
    return (2.0 * (t + kPathExtension)) / kWidth - 1.0;
}
double time_of(double place) {
    return 0.5 * (place + 1.0) * kWidth - kPathExtension;
}

// Returns cos(`times` φ), where cos φ is the k-th zero of the Chebyshev polynomial of degree
// kTerms.
double cosine_at(std::size_t k, std::size_t times) {
    const double degrees =
        kHalfTurnDegrees * (static_cast<double>(k) + 0.5) / static_cast<double>(kTerms);
    return sin_cos(static_cast<double>(times) * degrees).cos;
}

// Returns the coefficients of the Chebyshev polynomials, without those that are rounding errors.
std::vector<Coordinates> terms_through(const std::array<Coordinates, kTerms>& values) {
    std::vector<Coordinates> terms(kTerms, Coordinates{});
    for (std::size_t j = 0; j < kTerms; ++j) {
        for (std::size_t k = 0; k < kTerms; ++k) {
            const double share =
                (j == 0 ? 1.0 : 2.0) / static_cast<double>(kTerms) * cosine_at(k, j);
            for (std::size_t c = 0; c < kCoordinates; ++c)
                terms[j][c] += share * values[k][c];
        }
    }
    // Tip and axis have different scales.
    const auto size = [](const Coordinates& v, std::size_t from) {
        return std::abs(v[from]) + std::abs(v[from + 1]) + std::abs(v[from + 2]);
    };
    const auto counts = [&](const Coordinates& term, std::size_t from) {
        double largest = 0.0;
        for (const Coordinates& other : terms)
            largest = std::max(largest, size(other, from));
        return size(term, from) > 4e-15 * largest;
    };
    // Short rotations have few terms. Terms of the size of rounding errors would grow with each
    // derivative.
    for (const std::size_t from : {std::size_t{0}, kCoordinates / 2}) {
        std::size_t count = kTerms;
        while (count > 1 && !counts(terms[count - 1], from))
            --count;
        for (std::size_t j = count; j < kTerms; ++j)
            std::fill_n(terms[j].begin() + static_cast<std::ptrdiff_t>(from), kCoordinates / 2,
                        0.0);
    }
    while (terms.size() > 1 && terms.back() == Coordinates{})
        terms.pop_back();
    return terms;
}

// Converts Chebyshev coefficients into coefficients of powers: T(k + 1) = 2 s T(k) - T(k - 1).
std::vector<Coordinates> powers_of(const std::vector<Coordinates>& terms) {
    const std::size_t count = terms.size();
    std::vector<Coordinates> powers(count, Coordinates{});
    std::vector<double> before(count, 0.0), here(count, 0.0), next(count, 0.0);
    here[0] = 1.0;
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t i = 0; i <= k; ++i) {
            for (std::size_t c = 0; c < kCoordinates; ++c)
                powers[i][c] += here[i] * terms[k][c];
        }
        if (k + 1 == count) break;
        for (std::size_t i = 0; i <= k + 1; ++i)
            next[i] = (k == 0 ? 1.0 : 2.0) * (i > 0 ? here[i - 1] : 0.0) - before[i];
        before = std::exchange(here, next);
    }
    return powers;
}

}  // namespace

std::optional<RotaryPath> fit_rotary_path(const std::function<TipAndAxis(double)>& pose) {
    std::array<Coordinates, kTerms> values;
    for (std::size_t k = 0; k < kTerms; ++k) {
        const auto [tip, axis] = pose(time_of(cosine_at(k, 1)));
        values[k] = {tip.x, tip.y, tip.z, axis.x, axis.y, axis.z};
    }
    RotaryPath path{powers_of(terms_through(values))};
    for (std::size_t k = 0; k < 2 * kTerms; ++k) {
        const double t = time_of(2.0 * (static_cast<double>(k) + 0.3) / (2.0 * kTerms) - 1.0);
        const TipAndAxis there = pose(t);
        const ToolFrame here = tool_frame(path, t);
        if (norm(here.tip - there.tip) > kRounding ||
            kPartMm * norm(here.axis - there.axis) > kRounding)
            return std::nullopt;
    }
    return path;
}

ToolFrame tool_frame(const RotaryPath& path, double t) {
    // Horner's rule for the polynomials, their first derivatives and half of their second
    // derivatives; two coordinates at a time.
    using Pair = double __attribute__((vector_size(2 * sizeof(double))));
    const double s = place_of(t);
    const Pair times{s, s};
    using Pairs = Pair[kCoordinates / 2];
    Pairs value{}, slope{}, bend{};
    for (std::size_t i = path.powers.size(); i-- > 0;) {
        const double* power = path.powers[i].data();
        for (std::size_t c = 0; c < std::size(value); ++c) {
            bend[c] = bend[c] * times + slope[c];
            slope[c] = slope[c] * times + value[c];
            value[c] = value[c] * times + Pair{power[2 * c], power[2 * c + 1]};
        }
    }
    const auto tip = [](const Pairs& of, double by) {
        return by * Vec3{of[0][0], of[0][1], of[1][0]};
    };
    const auto axis = [](const Pairs& of, double by) {
        return by * Vec3{of[1][1], of[2][0], of[2][1]};
    };
    const double rate = 2.0 / kWidth;
    return {tip(value, 1.0),  tip(slope, rate),  tip(bend, 2.0 * rate * rate),
            axis(value, 1.0), axis(slope, rate), axis(bend, 2.0 * rate * rate)};
}

}  // namespace ncsim::brep
