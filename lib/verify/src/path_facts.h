// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facts about the path of a motion that follow from the program alone.
#pragma once

#include "ncsim/gcode/state.h"
#include "ncsim/verify/setup.h"

#include "finding_log.h"
#include "machine_scene.h"
#include "move.h"

#include <limits>

namespace ncsim::verify {

class PathFacts {
public:
    /// Starts at the beginning of a program; `stock` in mm, W.
    /// Requires: `setup` outlives the object.
    PathFacts(const Setup& setup, const Box& stock);

    /// Sets the frame of the next motion, which includes the tool length offset.
    void set_frame(const gcode::ProgramFrame& frame);
    /// Enters positions and lengths of the motion, from `from` to `to`, into `move`.
    void take(Move& move, const gcode::Position& from, const gcode::Position& to, FindingLog& log);
    /// Returns the length of the tool in the control, and of the tool itself.
    ToolLength tool_length(const gcode::Motion& motion) const;

private:
    void measure(Move& move, const toolpath::Poses& poses, const gcode::Position& from,
                 const gcode::Position& to) const;
    void place_in_machine(Move& move, FindingLog& log) const;
    /// Enters the tool length of a motion between two heights of the tip.
    void enter_tool_length(Move& move, double from_mm, double to_mm) const;
    /// Notes whether Z is a position of the spindle nose, given in machine coordinates.
    void note_nose_position(Move& move, const gcode::Position& from, const gcode::Position& to);
    bool passes_above(const gcode::Motion& motion, const gcode::Position& from,
                      const gcode::Position& to) const;

    const Setup& setup_;
    gcode::ProgramFrame frame_;
    Vec3 tool_offset_;      // mm
    bool at_nose_ = false;  // Z is a position of the spindle nose, not of the tip
    // highest point of stock and fixtures, W
    double highest_ = -std::numeric_limits<double>::infinity();
    Box way_;  // box of all motions so far
};

}  // namespace ncsim::verify
