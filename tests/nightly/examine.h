// SPDX-License-Identifier: GPL-3.0-or-later
//
// One program, and everything that must be true of what ncsim makes of it.
#pragma once

#include "nightly/program_generator.h"
#include "nightly/simulated.h"

#include <cstdint>

namespace ncsim::nightly {

/// How much was looked at.
struct Tally {
    std::uint64_t hulls = 0;
    std::uint64_t flat = 0;  ///< Programs compared with cda-flat.
    std::uint64_t points = 0;
    std::uint64_t certain = 0;        ///< Of the points.
    std::uint64_t material = 0;       ///< Of the certain ones.
    std::uint64_t asked_of_mesh = 0;  ///< Of the certain ones.
    std::uint64_t lines = 0;          ///< Places of the surface whose line was checked.

    Tally& operator+=(const Tally& other);
};

/// Throws std::runtime_error that says what is wrong:
///
/// - a point that must be in the part, or must not be, is said to be on the other side, by the part
///   or by its mesh;
/// - the surface is not closed, or its volume is not that of the part, or not between what certain
///   points allow;
/// - a face names a line that did not cut there;
/// - 1, 2 and 8 threads, or both models of the workpiece, do not agree to the last bit;
/// - what the program states of its own accuracy is more than it promises.
Tally examine(const Program& program, const ProgramFile& file);

}  // namespace ncsim::nightly
