// SPDX-License-Identifier: GPL-3.0-or-later
//
// Golden parts: small programs with known faces and volumes.
#pragma once

#include "ncsim/brep/measure.h"
#include "ncsim/brep/part.h"

#include "brep/made_part.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <string>
#include <vector>

namespace ncsim::brep::test {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kBlock = 80.0 * 60.0 * 20.0;  // mm³

// Numbers of planes, cylinders, cones, spheres, tori, extrusions, domes, coils, spirals and
// envelopes.
using Kinds = std::array<int, 10>;

struct Golden {
    std::string name;
    std::string moves;  // without tool and stock
    Kinds kinds;
    double volume;
    bool is_bar = false;  // otherwise a block of 80 x 60 x 20 mm
};

inline Made make(const Golden& golden, double tool_tolerance, unsigned threads = 0) {
    return make_part(golden.name, golden.moves, tool_tolerance, threads, golden.is_bar);
}

inline Kinds kinds_of(const Part& part) {
    Kinds kinds{};
    for (const Face& face : part.faces)
        ++kinds[face.surface.form.index()];
    return kinds;
}

// Expects the faces of `golden`, no facet, and the volume `left` up to `share`, at each of
// `tolerances`.
inline void expect_at(const std::vector<double>& tolerances, const Golden& golden, double left,
                      double share = 1e-8) {
    for (const double tolerance : tolerances) {
        SCOPED_TRACE(tolerance);
        const Made made = make(golden, tolerance);
        EXPECT_EQ(kinds_of(made.solid.part), golden.kinds);
        EXPECT_EQ(made.solid.facets_kept, 0U);
        EXPECT_LT(made.solid.part.miss_mm, 1e-5);
        EXPECT_NEAR(volume(made.solid.part), left, share * left);
    }
}

}  // namespace ncsim::brep::test
