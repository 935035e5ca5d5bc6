// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random numbers and directions, the same in each run.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstdint>
#include <random>

namespace ncsim::brep::test {

class Draw {
public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}

    double from(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    Vec3 direction() { return normalized({from(-1, 1), from(-1, 1), from(-1, 1)}); }
    Vec3 point() { return {from(-9, 9), from(-9, 9), from(-9, 9)}; }

private:
    std::mt19937_64 random_;
};

}  // namespace ncsim::brep::test
