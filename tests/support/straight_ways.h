// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies that move in several collinear steps: the cells of the steps, and the single cell of the
// whole motion.
#pragma once

#include "ncsim/cda/hull.h"

#include "support/random_shapes.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace ncsim::test {

/// Cells of a straight motion: one per step, and the cell of the whole motion.
struct StraightWay {
    std::vector<cda::Cell> steps;
    cda::Cell all;
};
/// Returns successive motions about the origin: there, back, and across. Origins count from 1.
inline std::vector<StraightWay> straight_ways(std::uint64_t seed, int count) {
    Random random(seed);
    std::vector<cda::TranslationSweep> bodies;
    for (int i = 0; i < 3; ++i) {
        // Corners whose planes stay on the lattice, as do the walls along the motions.
        std::vector<cda::LatticePoint> corners;
        for (int k = 0; k < 12; ++k) {
            const cda::LatticePoint p = random_point(random, 90);
            corners.push_back({1000 * p.x, 1000 * p.y, 1000 * p.z});
        }
        bodies.push_back(cda::TranslationSweep::of(corners, kLattice).value());
    }
    std::vector<StraightWay> ways;
    std::uint32_t origin = 0;
    cda::LatticePoint at = random_point(random, 250000);
    for (int i = 0; i < count; ++i) {
        if (random.one_in(3)) at = random_point(random, 250000);
        const cda::TranslationSweep& body = bodies[static_cast<std::size_t>(random.between(0, 2))];
        const cda::LatticePoint unit = random_point(random, 3);
        const auto steps = random.between(2, 9);
        std::vector<cda::LatticePoint> ends{at};
        for (int k = 0; k < steps; ++k) {
            const auto times = random.between(1, 6000);
            ends.push_back(ends.back() +
                           cda::LatticePoint{times * unit.x, times * unit.y, times * unit.z});
        }
        if (ends.back() == at) continue;
        at = ends.back();
        StraightWay way;
        cda::StraightSteps specified{ends.back() - ends.front(), {}};
        const auto length = [&](const cda::LatticePoint& end) {
            return norm(kLattice.to_mm(end - ends[0]));
        };
        for (std::size_t k = 1; k < ends.size(); ++k) {
            way.steps.push_back(body(ends[k - 1], ends[k], cda::Origin{++origin}));
            way.steps.back().rank = 0;
            specified.steps.push_back({cda::Origin{origin}, length(ends[k]) / length(ends.back()),
                                       way.steps.back().bounds});
        }
        specified.steps.back().end = 1.0;
        way.all = body(ends.front(), ends.back(), cda::Origin{origin});
        way.all.rank = -1;
        way.all.steps = std::make_shared<const cda::StraightSteps>(std::move(specified));
        ways.push_back(std::move(way));
    }
    return ways;
}

}  // namespace ncsim::test
