// SPDX-License-Identifier: GPL-3.0-or-later
//
// Events of a reference interpreter and of ncsim in a common form.
//
// A reference line is "<n> L<source line> CALL(arguments)": the canonical machining functions of
// RS274/NGC version 3, with numbers in program coordinates and the active units.
#pragma once

#include "ncsim/gcode/interpreter.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::corpus {

enum class Call : std::uint8_t { Traverse, Feed, Arc, Probe, Spline, Dwell, ToolChange };

/// An action of the machine, in machine coordinates, millimetres and degrees.
struct Event {
    Call call = Call::Feed;
    std::uint32_t line = 0;
    gcode::Axes end{};
    double centre_1 = 0.0, centre_2 = 0.0;
    int turns = 0;
    gcode::Plane plane = gcode::Plane::XY;
    double feed = 0.0;  ///< mm/min or mm/rev, for feed moves and arcs.
    bool compare_feed = true;
    double value = 0.0;  ///< Seconds, tool number, number of control points.
    double knots = 0.0;  ///< Number of knots of an ncsim spline.
    bool inches = false;
    // Frame, in mm and degrees.
    gcode::Axes work_offset{};
    gcode::Axes offset_92{};
    double rotation = 0.0;
};

std::optional<std::string> read_gzip(const std::string& path);
std::vector<Event> read_reference(const std::string& text);
/// Returns the event of an ncsim motion in workpiece coordinates. `put_into_machine` transforms all
/// events to the machine coordinates of a reference.
Event to_event(const gcode::Motion& motion, const gcode::ProgramFrame& frame);
void put_into_machine(std::vector<Event>& events, const gcode::WorkOffset& workpiece);

struct Difference {
    std::size_t index = 0;
    std::string text;
};
/// Returns the first difference. `geometry_only` ignores feeds, dwells, tools, frames and moves
/// without a displacement.
std::optional<Difference> compare(const std::vector<Event>& ours,
                                  const std::vector<Event>& reference, bool geometry_only);

}  // namespace ncsim::corpus
