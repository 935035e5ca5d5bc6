// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeded numbers for tests: the same in every run, on every machine.
#pragma once

#include <cstdint>

namespace ncsim::test {

/// splitmix64, of its own: what judges the program uses nothing of it.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    /// From low to high, both possible.
    std::int64_t between(std::int64_t low, std::int64_t high) {
        return low + static_cast<std::int64_t>(next() % static_cast<std::uint64_t>(high - low + 1));
    }
    /// In [0, 1).
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    /// In [low, high).
    double within(double low, double high) { return low + (high - low) * unit(); }
    /// One time in `n`.
    bool one_in(std::int64_t n) { return between(1, n) == 1; }

private:
    std::uint64_t state_;
};

}  // namespace ncsim::test
