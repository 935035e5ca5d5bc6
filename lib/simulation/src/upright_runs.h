// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of sloping moves in a vertical plane. CAM systems write the arcs by which a tool enters and
// leaves as short lines with rounded ends, so that each line deviates from the preceding line by a
// degree. Without correction, the walls would be strips that meet at these angles, with strips of
// cylinders between them, all narrower than a side of a round tool's polytope.
#pragma once

#include "ncsim/gcode/motion.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace ncsim::simulation {

/// Moves the ends of sloping moves into a vertical plane.
class UprightRuns {
public:
    /// Receives the number of a cut, its line with moved ends, and the largest displacement of an
    /// end in the run, mm.
    using Sink = std::function<void(std::size_t cut, const gcode::Linear& line, double moved_mm)>;

    /// Passes the cuts of all runs of at least two moves on to `sink`, in order. Successive
    /// straight feed moves of an upright tool that slope are moved into the vertical plane through
    /// the first and the last point, if all intermediate points lie within kRoundedMm of the plane.
    explicit UprightRuns(Sink sink) : sink_(std::move(sink)) {}

    /// Adds a motion. `cut`: number of the cut; empty if the motion did not meet the stock. Cost:
    /// the length of the current run, at most kMostMoves.
    void take(const gcode::Motion& motion, std::optional<std::size_t> cut);
    /// Passes on the current run. Requires: the last motion was added.
    void flush();

    /// Rounding of programs: three decimals of millimetres, or four of inches.
    static constexpr double kRoundedMm = 2e-3;
    static constexpr std::size_t kMostMoves = 256;

private:
    struct Move {
        gcode::Linear line;
        std::optional<std::size_t> cut;
    };
    bool goes_on(const gcode::Linear& next, int tool) const;

    Sink sink_;
    std::vector<Move> run_;
    int tool_ = 0;  // of the run
};

}  // namespace ncsim::simulation
