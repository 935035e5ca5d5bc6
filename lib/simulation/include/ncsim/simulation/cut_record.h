// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records of the motions that met the stock: what the pass that cuts decides about a motion. Later
// stages read the records, and take the motions themselves from the program's motions by number.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/verify/finding.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace ncsim::simulation {

/// Straight path of a cut that differs from the path of its motion, or that belongs to a longer
/// line. X, Y and Z of positions, mm.
struct CutPath {
    Vec3 from, to;          ///< Ends of all joined motions, displaced in a sloping run.
    double moved_mm = 0.0;  ///< Largest displacement of an end in the sloping run.
    /// Start of the tool (mm, W) on the line whose cells as a whole may have the cut's origin.
    std::optional<Vec3> line_start;
};

/// A motion that met the stock.
struct CutRecord {
    verify::Place place;
    /// Number in the order of execution, from 1; of the first motion if several were joined.
    std::uint64_t motion = 0;
    int tool = 0;
    std::unique_ptr<CutPath> path;  ///< Null: the path of the motion.
};

}  // namespace ncsim::simulation
