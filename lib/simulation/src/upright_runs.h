// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves that go down or up in one upright plane. CAM systems write the arcs by which a tool enters
// and leaves as short lines, whose ends are rounded: each goes a degree aside of the one before.
// The walls beside them would be strips that meet at such angles, with more strips of cylinders
// between, all of them narrower than any side of a round tool.
#pragma once

#include "ncsim/gcode/interpreter.h"

#include <functional>
#include <vector>

namespace ncsim::simulation {

class UprightRuns {
public:
    /// A motion, and how far its ends were moved, mm.
    using Sink = std::function<void(const gcode::Motion&, double moved_mm)>;

    /// Hands all motions on to `sink`, in order. Straight moves at feed of an upright tool that go
    /// down or up, in a row, are put into the upright plane through the first and the last point,
    /// if all others lie within kRoundedMm of it.
    explicit UprightRuns(Sink sink);

    /// Cost: what a run has so far, kMostMoves at most.
    void take(const gcode::Motion& motion);
    /// After the last motion.
    void flush();

    /// What programs round: three places of millimetres, or four of inches.
    static constexpr double kRoundedMm = 2e-3;
    static constexpr std::size_t kMostMoves = 256;

private:
    bool goes_on(const gcode::Motion& next) const;

    Sink sink_;
    std::vector<gcode::Motion> run_;
};

}  // namespace ncsim::simulation
