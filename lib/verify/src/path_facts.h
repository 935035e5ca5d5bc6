// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program alone says about the path of a motion, whatever the tool meets on it.
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
    /// `setup` must outlive it; `stock` in mm, W.
    PathFacts(const Setup& setup, const cda::Box& stock);

    /// What is active when the next motion begins.
    void set_frame(const gcode::ProgramFrame& frame);
    /// Notes in `move`, whose motion goes between these, where it goes and how far.
    void take(Move& move, const gcode::Position& from, const gcode::Position& to, FindingLog& log);
    /// As the control counts it, and as the tool is.
    ToolLength tool_length(const gcode::Motion& motion) const;

private:
    void measure(Move& move, const toolpath::Poses& poses, const gcode::Position& from,
                 const gcode::Position& to) const;
    void place_in_machine(Move& move, FindingLog& log) const;
    /// Of one that goes from the one height of the tip to the other.
    void look_at_length(Move& move, double from_mm, double to_mm) const;
    /// Notes whether Z is a position of the spindle nose, given in machine coordinates.
    void look_at_nose(Move& move, const gcode::Position& from, const gcode::Position& to);
    bool passes_above(const gcode::Motion& motion, const gcode::Position& from,
                      const gcode::Position& to) const;

    const Setup& setup_;
    gcode::ProgramFrame frame_;
    cda::Vec3 tool_offset_;  // mm
    bool at_nose_ = false;   // Z is a position of the spindle nose, not of the tip
    double highest_ = -std::numeric_limits<double>::infinity();  // of all that stands there, W
    cda::Box way_;                                               // of all motions so far
};

}  // namespace ncsim::verify
