// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace ncsim::cda {

/// Of hashes: stirs `v` into `h`; the same on every machine and in every run. The finalizer of
/// splitmix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA
/// 2014).
constexpr std::uint64_t mix(std::uint64_t h, std::uint64_t v) {
    h = (h ^ v) + 0x9e3779b97f4a7c15U;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
    return h ^ (h >> 31);
}

/// splitmix64: small, seeded, the same everywhere (std::shuffle is not).
class SplitMix {
public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        const std::uint64_t result = mix(0, state_);
        state_ += 0x9e3779b97f4a7c15U;
        return result;
    }

private:
    std::uint64_t state_;
};

}  // namespace ncsim::cda
