// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells to be subtracted from a cube of 6 mm about the origin: random hulls, or passes of tools
// that meet floors and walls of earlier passes.
#pragma once

#include "ncsim/cda/hull.h"

#include "support/oracle.h"
#include "support/random_shapes.h"

#include <cstdint>
#include <vector>

namespace ncsim::test {

inline std::vector<cda::Cell> random_cuts(std::uint64_t seed, int count, std::int64_t reach) {
    Random random(seed);
    std::vector<cda::Cell> cuts;
    for (int i = 0; i < count; ++i) {
        cuts.push_back(ranked(random_hull(random, random_point(random, 300000), reach, 14,
                                          cda::Origin{static_cast<std::uint32_t>(i + 1)})));
    }
    return cuts;
}

// Returns passes of a cone that repeats a few straight paths with offsets of one or two lattice
// units. A pass removes almost no volume, and rounding can make a sum of volumes negative.
inline std::vector<cda::Cell> jittered_passes(std::uint64_t seed, int count) {
    Random random(seed);
    std::vector<cda::LatticePoint> cone{{0, 0, 0}};
    for (int i = 0; i < 12; ++i) {
        constexpr std::int64_t kCircle[] = {100000, 86603, 50000, 0};
        const auto at = [&](int k) {
            const int j = (k % 12 + 12) % 12;
            return j <= 3   ? kCircle[j]
                   : j <= 6 ? -kCircle[6 - j]
                   : j <= 9 ? -kCircle[j - 6]
                            : kCircle[12 - j];
        };
        cone.push_back({at(i), at(i - 3), 37000});
    }
    const auto sweep = cda::TranslationSweep::of(cone, kLattice).value();
    std::vector<cda::Cell> passes;
    for (int i = 0; i < count; ++i) {
        const auto jitter = [&] { return random.between(-2, 2); };
        const auto lane = random.between(-2, 2) * 61003;
        const cda::LatticePoint from{-290000 + jitter(), lane + jitter(), 260000 + jitter()};
        const cda::LatticePoint to{290000 + jitter(), lane + 1000 * random.between(-3, 3),
                                   260000 + jitter()};
        passes.push_back(sweep(from, to, cda::Origin{static_cast<std::uint32_t>(i + 1)}));
    }
    return passes;
}

// Returns passes of two boxes and a cone, mostly along floors and walls of earlier passes.
inline std::vector<cda::Cell> passes_of_several_tools(std::uint64_t seed, int count) {
    std::vector<cda::TranslationSweep> tools;
    for (const std::int64_t size : {30000, 50000}) {
        std::vector<cda::LatticePoint> corners;
        for (const std::int64_t x : {-size, size}) {
            for (const std::int64_t y : {-size, size}) {
                corners.push_back({x, y, 0});
                corners.push_back({x, y, 400000});
            }
        }
        tools.push_back(cda::TranslationSweep::of(corners, kLattice).value());
    }
    const std::vector<cda::LatticePoint> cone{{0, 0, 0},
                                              {40000, 0, 37000},
                                              {-20000, 34641, 37000},
                                              {-20000, -34641, 37000},
                                              {40000, 0, 400000},
                                              {-20000, 34641, 400000},
                                              {-20000, -34641, 400000}};
    tools.push_back(cda::TranslationSweep::of(cone, kLattice).value());
    Random random(seed);
    const auto place = [&] {
        return cda::LatticePoint{50000 * random.between(-5, 5), 50000 * random.between(-5, 5),
                                 100000 + 40000 * random.between(0, 4)};
    };
    std::vector<cda::Cell> passes;
    cda::LatticePoint at = place();
    for (int i = 0; i < count; ++i) {
        const cda::LatticePoint to = place();
        passes.push_back(tools[random.next() % tools.size()](
            at, random.one_in(3) ? cda::LatticePoint{to.x, at.y, at.z} : to,
            cda::Origin{static_cast<std::uint32_t>(i + 1)}));
        at = to;
    }
    return passes;
}

}  // namespace ncsim::test
