// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meaning of a program's X, Y and Z, estimated from its moves. A hole is drilled, and a cut begun,
// along the tool. So moves along an inclined tool show whether X, Y and Z are positions of the tip,
// and on which machine; moves along Z alone show that they are positions of axes.
#pragma once

#include "ncsim/simulation/plan.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// Evidence from the linear moves of a program for the meaning of X, Y and Z: moves at constant
/// tilted angles that run along the tool axis of some machine, or along Z.
struct Plunges {
    /// Evidence that X, Y and Z are positions of the tip.
    struct Tip {
        /// Machines whose rotary axes rotate the tool alike, for the axes that the program uses.
        std::vector<std::string> machines;
        std::uint64_t moves = 0;  ///< Moves along the tool if X, Y and Z are the tip position.
    };
    bool is_tilted = false;   ///< True if some move is at tilted angles.
    std::uint64_t moves = 0;  ///< Moves along the tool axis of some machine, or along Z.
    /// Moves along Z at tilted angles: X, Y and Z are axis positions, or the tip position in a
    /// frame that does not rotate.
    std::uint64_t along_z = 0;
    std::vector<Tip> tip;  ///< Descending by moves, without entries of 0 moves.
};

/// Least length of a straight move, mm, and largest angle to a direction, degrees.
inline constexpr double kLeastPlunge = 3.0, kPlungeDegrees = 0.4;

/// Counts plunges for all presets, for each preset with inverted rotary axes, and for the machine
/// of `plan`. Without a machine, M428 to M430 and G43.4 do not change coordinates. Cost: one
/// interpretation of the program.
Plunges plunges_of(const Plan& plan);

}  // namespace ncsim::simulation
