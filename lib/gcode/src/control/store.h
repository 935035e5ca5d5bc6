// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a control keeps in its tables: a value like MachineState, but one that few blocks change.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/state.h"

#include "control/frames/plane_words.h"

#include <array>
#include <map>
#include <set>
#include <vector>

namespace ncsim::gcode {

/// Of the registers of Fanuc's kin; it is in what `tools` says already.
struct Wear {
    double length_mm = 0.0;
    double radius_mm = 0.0;
    bool operator==(const Wear&) const = default;
};

struct Store {
    std::array<WorkOffset, 9> work_offsets;
    std::map<int, WorkOffset> extended;  ///< G54.1 P1 …, by number.
    /// External offset of Fanuc and Haas (EXT, G10 L2 P0); all origins include it. mm, degrees.
    Axes external{};
    bool has_external = false;  ///< The program has set it.
    /// Frames of the systems that were active, for X, Y and Z. Distances between these frames are
    /// specified, or were assumed when the second of two systems became active.
    std::array<std::set<int>, 3> used_frames;
    std::vector<ToolTableEntry> tools;
    std::map<int, Wear> wear;     ///< By the number of the register.
    std::array<Axes, 2> homes{};  ///< Of G28 and G30, machine, mm.
    Axes via{};                   ///< Over which the last G28 went, program coordinates.
    bool has_via = false;
    Axes stored_92{};  ///< What G92.3 brings back, mm.
    Axes probed{};     ///< Where the last probe met something, program coordinates.
    bool has_probed = false;
    PlaneParts plane_parts;  ///< Of a G68.2 in several blocks.
    /// LinuxCNC: told by G68.2, and taken by the G53.1 to come; active units.
    std::optional<FeatureFrame> told_plane;
    bool operator==(const Store&) const = default;
};

}  // namespace ncsim::gcode
