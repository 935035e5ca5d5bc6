// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random numbers and directions, the same in each run.
#pragma once

#include "ncsim/cda/vec.h"

#include <cstdint>
#include <random>

namespace ncsim::brep::test {

class Draw {
public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}

    double from(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    cda::Vec3 direction() { return cda::normalized({from(-1, 1), from(-1, 1), from(-1, 1)}); }
    cda::Vec3 point() { return {from(-9, 9), from(-9, 9), from(-9, 9)}; }

private:
    std::mt19937_64 random_;
};

}  // namespace ncsim::brep::test
