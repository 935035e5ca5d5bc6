// SPDX-License-Identifier: GPL-3.0-or-later
//
// Data of the cycles that mill areas, faces and threads. Heights along the tool axis; lengths in
// active units.
#pragma once

#include "control/cycles/area.h"
#include "language/milled_area.h"

#include <cstdint>
#include <optional>

namespace ncsim::gcode::language {

/// Way of the tool down to the next level.
enum class Plunge : std::uint8_t { Vertical, Rapid, Helix, Ramp };

/// A pocket, slot or stud that is milled level by level.
struct Milling {
    MilledArea area;
    bool is_stud = false;
    double blank = 0.0;         ///< Stud: distance from the outline up to which there is material.
    double blank_length = 0.0;  ///< Stud: length of the blank.
    double tool_radius = 0.0;
    double surface = 0.0, bottom = 0.0;
    double clear = 0.0;   ///< Height of the clearance above the surface.
    double infeed = 0.0;  ///< Largest infeed of roughing; 0: in one.
    bool has_equal_infeeds = false;
    double side_allowance = 0.0, floor_allowance = 0.0;
    double step = 0.0;  ///< Largest distance between passes.
    double feed = 0.0, plunge_feed = 0.0;
    double finishing_feed = 0.0;
    double finishing_infeed = 0.0;          ///< Largest infeed of finishing; 0: in one.
    std::optional<double> finishing_speed;  ///< Spindle speed of finishing.
    bool roughs = true;
    bool finishes_side = false, finishes_floor = false;
    bool is_clockwise = false;
    Plunge plunge = Plunge::Vertical;
    double helix_radius = 0.0;  ///< 0: the radius of the tool.
    double helix_pitch = 0.0;   ///< 0: a slope of 1 to 20.
};

/// A face that is milled in parallel strokes.
struct FaceMilling {
    PlanePoint corner;  ///< Corner with the lowest coordinates.
    double length = 0.0, width = 0.0;
    bool is_along_second = false;  ///< The strokes are along the second axis.
    bool is_alternating = false;   ///< Every second stroke runs back.
    double tool_radius = 0.0;
    double surface = 0.0, bottom = 0.0, clear = 0.0;
    double infeed = 0.0;  ///< Largest infeed; 0: in one.
    double step = 0.0;    ///< Largest distance between strokes.
    double margin = 0.0;  ///< Distance between tool and face at the ends of the strokes.
    double feed = 0.0;
};

/// A thread that is milled along helices.
struct ThreadMilling {
    PlanePoint centre;
    double radius = 0.0;  ///< Radius of the path of the tool centre.
    bool is_internal = true;
    double entry = 0.0;  ///< External thread: radius at which the tool goes down.
    double top = 0.0, bottom = 0.0, clear = 0.0;
    double pitch = 0.0;           ///< > 0
    double turns_per_step = 1.0;  ///< 0: one turn at the bottom; 1: one helix; more: turns between.
    bool is_clockwise = false;
    bool goes_up = false;
    double feed = 0.0;
    std::optional<double> approach_feed;  ///< Without a value rapid.
};

}  // namespace ncsim::gcode::language
