// SPDX-License-Identifier: GPL-3.0-or-later
//
// Data of the cycles that mill areas, faces and threads. Heights along the tool axis; lengths in
// active units.
#pragma once

#include "ncsim/gcode/state.h"

#include "control/cycles/area.h"
#include "language/milled_area.h"

#include <cstdint>
#include <optional>
#include <vector>

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
    double repeats = 1.0;       ///< Number of equal areas of the cycle.
};

/// A face that is milled in parallel strokes.
struct FaceMilling {
    Vec2 corner;                       ///< Corner at the beginning of the first stroke.
    double angle = 0.0;                ///< Degrees: direction of the length.
    double length = 0.0, width = 0.0;  ///< Signs: the side of the corner on which the face is.
    bool is_along_second = false;      ///< The strokes are along the second axis.
    bool is_alternating = false;       ///< Every second stroke runs back.
    double tool_radius = 0.0;
    double surface = 0.0, bottom = 0.0, clear = 0.0;
    double infeed = 0.0;   ///< Largest infeed; 0: in one.
    double step = 0.0;     ///< Largest distance between strokes.
    double margin = 0.0;   ///< Distance between tool and face at the ends of the strokes.
    double overrun = 0.0;  ///< Distance of the edge of the tool beyond the last side.
    double feed = 0.0;
};

/// Way of the tool to the beginning of a contour, or from its end.
struct Lead {
    enum class Form : std::uint8_t { None, Line, Quadrant, Semicircle };
    Form form = Form::None;
    double size = 0.0;      ///< Length of the line, radius of the arc; of the tool centre.
    bool in_space = false;  ///< The tool moves between the levels on the way.
};

/// A path along a contour, level by level.
struct ContourPath {
    Pass contour;
    CutterSide side = CutterSide::Off;
    bool is_mirrored = false;  ///< The frame exchanges left and right.
    double offset = 0.0;       ///< Distance between the tool centre and the contour.
    double surface = 0.0, bottom = 0.0;
    double clear = 0.0;   ///< Height of the clearance above the surface.
    double infeed = 0.0;  ///< Largest infeed; 0: in one.
    bool has_equal_infeeds = false;
    bool is_alternating = false;  ///< Every second level is milled backwards, without a lift.
    Lead in, out;
    std::optional<double> lift_to;  ///< Height between levels; without a value `lift_by`.
    double lift_by = 0.0;           ///< Height above the level.
    double feed = 0.0, plunge_feed = 0.0;
    std::optional<double> transfer_feed;  ///< Between levels; without a value rapid.
};

/// A thread that is milled along helices.
struct ThreadMilling {
    Vec2 centre;
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

/// Largest number of passes of a cycle, at all levels.
inline constexpr double kMostPasses = 20'000.0;

/// Returns the levels from `from` down to `to`, at most `infeed` apart (0: in one), at equal
/// distances or with the rest at the end. Returns `to` alone for more than kMostPasses levels.
std::vector<double> levels_of(double from, double to, double infeed, bool is_equal);

}  // namespace ncsim::gcode::language
