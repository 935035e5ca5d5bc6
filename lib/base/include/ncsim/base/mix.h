// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hash mixing with the same numbers on every machine.
#pragma once

#include <cstdint>

namespace ncsim {

/// Mixes `v` into the hash `h`; the result is the same on every machine and in every run. Source:
/// the finalizer of splitmix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number
/// Generators", OOPSLA 2014).
constexpr std::uint64_t mix(std::uint64_t h, std::uint64_t v) {
    h = (h ^ v) + 0x9e3779b97f4a7c15U;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
    return h ^ (h >> 31);
}

}  // namespace ncsim
