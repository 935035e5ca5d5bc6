// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts as a machinist would describe them.
#pragma once

#include "ncsim/brep/part.h"

#include "brep/made_part.h"

#include <array>
#include <numbers>
#include <string>

namespace ncsim::brep::test {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kBlock = 80.0 * 60.0 * 20.0;  // mm3

// Planes, cylinders, cones, spheres, tori, extrusions, domes, coils, spirals, envelopes.
using Kinds = std::array<int, 10>;

struct Golden {
    std::string name;
    std::string moves;  // after the tool and the stock were told
    Kinds kinds;
    double volume;
    bool is_bar = false;  // else a block of 80 x 60 x 20
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

}  // namespace ncsim::brep::test
