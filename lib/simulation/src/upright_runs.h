// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of sloping moves in a vertical plane. CAM systems write the arcs by which a tool enters and
// leaves as short lines with rounded ends, so that each line deviates from the preceding line by a
// degree. Without correction, the walls would be strips that meet at these angles, with strips of
// cylinders between them, all narrower than a side of a round tool's polytope.
#pragma once

#include "ncsim/gcode/interpreter.h"

#include <functional>
#include <vector>

namespace ncsim::simulation {

/// Moves the ends of sloping moves into a vertical plane.
class UprightRuns {
public:
    /// Receives a motion, and the largest displacement of its ends, mm.
    using Sink = std::function<void(const gcode::Motion&, double moved_mm)>;

    /// Passes all motions on to `sink`, in order. Successive straight feed moves of an upright tool
    /// that slope are moved into the vertical plane through the first and the last point, if all
    /// intermediate points lie within kRoundedMm of the plane.
    explicit UprightRuns(Sink sink);

    /// Adds a motion. Cost: the length of the current run, at most kMostMoves.
    void take(const gcode::Motion& motion);
    /// Passes on the current run. Requires: the last motion was added.
    void flush();

    /// Rounding of programs: three decimals of millimetres, or four of inches.
    static constexpr double kRoundedMm = 2e-3;
    static constexpr std::size_t kMostMoves = 256;

private:
    bool goes_on(const gcode::Motion& next) const;

    Sink sink_;
    std::vector<gcode::Motion> run_;
};

}  // namespace ncsim::simulation
