// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of G and M codes: which group a code belongs to. Two codes of one group exclude
// each other in a block.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ncsim::gcode {

enum class Group : std::uint8_t {
    OneShot,
    Motion,
    Plane,
    Distance,
    Centre,
    Feed,
    Units,
    CutterSide,
    ToolLength,
    WorkOffset,
    PathMode,
    Retract,
    SpindleSpeed,
    Diameter,
    Rotation,
    Scaling,
    Mirror,
    Polar,
    Macro,
    Pocket,        ///< G12, G13 of Haas.
    HolePattern,   ///< G70, G71, G72 of Haas: where the cycle drills.
    Unsupported,   ///< Known, and not simulated: after it every place would be wrong.
    NotSimulated,  ///< Known, and not simulated: a cut would be missing.
    Ignored,       ///< Known, and without effect on where the tool goes.
};
constexpr std::size_t kGroups = 24;

struct GCode {
    std::int16_t number;  ///< Times ten.
    Group group;
    bool uses_axes;
    bool in_rs274;
};

/// The entry of ten times the G number, or nullptr.
const GCode* find_g(int number);

enum class MGroup : std::uint8_t {
    Stop,
    ToolChange,
    Spindle,
    Coolant,
    Override,
    Io,
    Call,
    Other,
    Kinematics,  ///< How a LinuxCNC machine turns, as its configuration has it.
    Unknown
};
constexpr std::size_t kMGroups = 9;

/// The group of an M code.
MGroup m_group(int number);

}  // namespace ncsim::gcode
