// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables of a control, as a value like MachineState. Few blocks change the tables.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/state.h"

#include "control/frames/plane_words.h"

#include <array>
#include <map>
#include <set>
#include <vector>

namespace ncsim::gcode {

/// Wear in the tool registers of Fanuc and similar controls. The offsets in `tools` include the
/// wear.
struct Wear {
    double length_mm = 0.0;
    double radius_mm = 0.0;
    bool operator==(const Wear&) const = default;
};

constexpr int kExtended = 9;  ///< System of G54.1 P0: G54.1 Pn is system kExtended + n.

/// Tables of a control: origins, tools, homes, probed positions.
struct Store {
    std::array<WorkOffset, 9> work_offsets;
    std::map<int, WorkOffset> extended;  ///< G54.1 P1 …, by number.
    /// External offset of Fanuc and Haas (EXT, G10 L2 P0); all origins include it. mm, degrees.
    Axes external{};
    bool has_external = false;  ///< Set by the program.
    /// References (OriginFrame) of the systems that were active, for X, Y and Z. The distances
    /// between these references are specified, or were assumed when the second of two systems
    /// became active.
    std::array<std::set<int>, 3> used_frames;
    std::vector<ToolTableEntry> tools;
    std::map<int, Wear> wear;     ///< By register number.
    std::array<Axes, 2> homes{};  ///< Targets of G28 and G30, machine coordinates, mm.
    Axes via{};                   ///< Intermediate point of the last G28, program coordinates.
    bool has_via = false;
    Axes stored_92{};  ///< Offset that G92.3 restores, mm.
    Axes probed{};     ///< Contact position of the last probing, program coordinates.
    bool has_probed = false;
    PlaneParts plane_parts;  ///< Parts of a G68.2 definition in several blocks.
    /// LinuxCNC: frame set by G68.2, activated by the next G53.1; active units.
    std::optional<FeatureFrame> specified_plane;
    bool operator==(const Store&) const = default;
};

}  // namespace ncsim::gcode
