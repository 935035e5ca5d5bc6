// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a reference interpreter made of a program, and what we made of it, in one form.
//
// A reference line is "<n> L<source line> CALL(arguments)": the canonical machining functions of
// RS274/NGC version 3, numbers in program coordinates and the units of the moment.
#pragma once

#include "ncsim/gcode/interpreter.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::corpus {

enum class Call : std::uint8_t { Traverse, Feed, Arc, Probe, Spline, Dwell, ToolChange };

/// One thing the machine does; machine coordinates, millimetres and degrees.
struct Event {
    Call call = Call::Feed;
    std::uint32_t line = 0;
    gcode::Axes end{};
    double centre_1 = 0.0, centre_2 = 0.0;
    int turns = 0;
    gcode::Plane plane = gcode::Plane::XY;
    double feed = 0.0;  ///< mm/min or mm/rev; of feeds and arcs.
    bool compare_feed = true;
    double value = 0.0;  ///< Seconds, tool number, number of control points.
    double knots = 0.0;  ///< Of a spline of ours: how many.
    bool inches = false;
    // The frame: mm, degrees.
    gcode::Axes work_offset{};
    gcode::Axes offset_92{};
    double rotation = 0.0;
};

std::optional<std::string> read_gzip(const std::string& path);
std::vector<Event> read_reference(const std::string& text);
/// Of ours, in W; put_into_machine() takes all of them where those of a reference are.
Event to_event(const gcode::Motion& motion, const gcode::ProgramFrame& frame);
void put_into_machine(std::vector<Event>& events, const gcode::WorkOffset& workpiece);

struct Difference {
    std::size_t index = 0;
    std::string text;
};
/// The first difference; `geometry_only` leaves out feeds, dwells, tools, frames and moves that
/// go nowhere.
std::optional<Difference> compare(const std::vector<Event>& ours,
                                  const std::vector<Event>& reference, bool geometry_only);

}  // namespace ncsim::corpus
