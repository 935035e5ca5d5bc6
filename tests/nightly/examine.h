// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks a program against all properties that the result of ncsim must have.
#pragma once

#include "nightly/program_generator.h"
#include "nightly/simulated.h"

#include <cstdint>

namespace ncsim::nightly {

/// Numbers of examined objects.
struct Tally {
    std::uint64_t hulls = 0;
    std::uint64_t flat = 0;  ///< Programs compared with cda-flat.
    std::uint64_t points = 0;
    std::uint64_t certain = 0;        ///< Points with a certain verdict.
    std::uint64_t material = 0;       ///< Certain points in material.
    std::uint64_t asked_of_mesh = 0;  ///< Certain points compared with the mesh.
    std::uint64_t lines = 0;          ///< Points of the surface whose line was checked.

    Tally& operator+=(const Tally& other);
};

/// Runs `program` and checks the part.
/// Throws: std::runtime_error with the violated property:
/// - a point that must be inside or outside is on the wrong side of the part or of its mesh;
/// - the surface is not closed, or its volume differs from the volume of the part, or the volume
///   contradicts the certain points;
/// - a face names a line that did not cut there;
/// - 1, 2 and 8 threads, or both models of the workpiece, differ in a bit;
/// - the stated accuracy exceeds the permitted accuracy.
Tally examine(const Program& program, const ProgramFile& file);

}  // namespace ncsim::nightly
