// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeded random numbers for tests: identical in each run and on each machine.
#pragma once

#include <cstdint>

namespace ncsim::test {

/// Random number generator splitmix64. Code that judges ncsim shares no code with ncsim.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    /// Returns an integer in [low, high].
    std::int64_t between(std::int64_t low, std::int64_t high) {
        return low + static_cast<std::int64_t>(next() % static_cast<std::uint64_t>(high - low + 1));
    }
    /// Returns a number in [0, 1).
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    /// Returns a number in [low, high).
    double within(double low, double high) { return low + (high - low) * unit(); }
    /// True with probability 1 / `n`.
    bool one_in(std::int64_t n) { return between(1, n) == 1; }

private:
    std::uint64_t state_;
};

}  // namespace ncsim::test
