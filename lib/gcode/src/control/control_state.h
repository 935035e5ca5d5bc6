// SPDX-License-Identifier: GPL-3.0-or-later
//
// All that a block can change in the control, as one value: to refuse a block is to put the value
// from before it back.
//
// What is not in it was not changed by the control but told to others: motions that were made, what
// was said. Nor are parameters: those a block assigns to are set even if its words are refused,
// because a counter that stood still would never let its loop end.
#pragma once

#include "ncsim/gcode/state.h"

#include "control/copy_on_write.h"
#include "control/growing_list.h"
#include "control/paths/compensation.h"
#include "control/paths/path.h"
#include "control/rare.h"
#include "control/store.h"

#include <cstdint>
#include <optional>

namespace ncsim::gcode {

/// A line with ,R or ,C or ,A: how it ends, only the next one tells.
struct HeldCorner {
    MachineState state;  ///< As it was at the start of the line.
    Axes end{};          ///< As programmed: the corner.
    AxisMask mask = 0;
    char letter = 'R';
    double size = 0.0;
    std::optional<double> angle;  ///< Of a line whose end the next one tells.
    SourceSpan span, word;
    std::uint32_t file = 0;
    bool operator==(const HeldCorner&) const = default;
};

/// A curve of G5.2 or G6.2 whose points come block by block. Program coordinates.
struct Curve {
    bool by_points = false;  ///< Between G5.2 and G5.3.
    bool by_knots = false;   ///< Of G6.2, before its last knot.
    int order = 4;
    GrowingList<Spline::ControlPoint> points;
    GrowingList<double> knots;
    bool operator==(const Curve&) const = default;
};

struct ControlState {
    MachineState machine;
    CopyOnWrite<Store> store;
    CompensationState compensation;
    Rare<HeldCorner> corner;
    Curve curve;
    bool operator==(const ControlState&) const = default;
};

}  // namespace ncsim::gcode
