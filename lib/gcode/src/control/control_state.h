// SPDX-License-Identifier: GPL-3.0-or-later
//
// Complete state of the control that a block can change, as a value. Refusing a block restores the
// previous value.
//
// The state excludes outputs: motions made and messages. Parameters are excluded, too: assignments
// take effect even if the words of the block are refused, because a loop whose counter stays
// constant never ends.
#pragma once

#include "ncsim/gcode/state.h"

#include "control/command.h"
#include "control/copy_on_write.h"
#include "control/growing_list.h"
#include "control/paths/compensation.h"
#include "control/paths/path.h"
#include "control/rare.h"
#include "control/store.h"

#include <cstdint>
#include <optional>

namespace ncsim::gcode {

/// A line with ,R or ,C or ,A. The end of the line depends on the next line.
struct HeldCorner {
    MachineState state;  ///< State at the start of the line.
    Axes end{};          ///< The programmed corner.
    AxisMask mask = 0;
    char letter = 'R';
    bool is_modal = false;          ///< See Command.
    std::optional<ProgramArc> arc;  ///< The element, if it is an arc.
    std::optional<double> feed;     ///< Feed of the corner.
    double size = 0.0;
    /// Direction of a line that ends where the line meets the next line.
    std::optional<double> angle;
    SourceSpan span, word;
    std::uint32_t file = 0;
    bool operator==(const HeldCorner&) const = default;
};

/// A curve of G5.2 or G6.2 whose points come block by block. Program coordinates.
struct Curve {
    bool by_points = false;  ///< Between G5.2 and G5.3.
    bool by_knots = false;   ///< G6.2 is active, before the last knot.
    int order = 4;
    GrowingList<Spline::ControlPoint> points;
    GrowingList<double> knots;
    bool operator==(const Curve&) const = default;
};

/// State of the control. See the head of the file.
struct ControlState {
    MachineState machine;
    CopyOnWrite<Store> store;
    CompensationState compensation;
    Rare<HeldCorner> corner;
    Curve curve;
    double feed_word = 0.0;  ///< Number of the last F; a change of units does not convert it.
    bool operator==(const ControlState&) const = default;
};

/// Returns the motion mode in which `command` moves: its own, or the active mode.
inline Code motion_of(const MachineState& state, const Command& command) {
    const Code named = command.group(Group::Motion);
    return named == Code::None ? state.motion : named;
}

}  // namespace ncsim::gcode
