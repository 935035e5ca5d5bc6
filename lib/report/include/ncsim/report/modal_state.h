// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modes of a control between two blocks, as rows of a table, with the blocks that set the modes.
#pragma once

#include "ncsim/gcode/state.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace ncsim::report {

/// Group of modes: a row.
enum class ModeGroup : std::uint8_t {
    Motion,
    Plane,
    Units,
    Distance,
    Feed,
    Spindle,
    Coolant,
    Tool,
    Length,
    Compensation,
    System,
    Shift,
    Transform,
    TiltedPlane,
    Controlled,
    Cycle,
};
constexpr std::size_t kModeGroups = 16;

/// Returns the name of a row: "motion", "plane" …
std::string_view name_of(ModeGroup group);

/// Returns the value of a row with lengths in the active units: "feed (G1)", "G54, zero at X10 Y0
/// Z5 in the machine". `with_codes`: G codes are named, as in G-code programs.
std::string text_of(ModeGroup group, const gcode::MachineState& state, bool with_codes);

/// Numbers of a row that differ if the row differs.
constexpr std::size_t kModeNumbers = 16;
using ModeNumbers = std::array<std::array<double, kModeNumbers>, kModeGroups>;
/// Cost: 0.3 µs.
ModeNumbers numbers_of(const gcode::MachineState& state);

}  // namespace ncsim::report
