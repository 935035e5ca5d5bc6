// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of G and M codes: names, and the group of each code. Two codes of a group exclude each
// other in a block.
#pragma once

#include "ncsim/gcode/dialect.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ncsim::gcode {

/// Modal group of a G code.
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
    DynamicOffset,       ///< G254, G255, G54.2, G54.4.
    PolarInterpolation,  ///< G12.1, G13.1 and G112, G113 of Haas.
    Cylinder,            ///< G7.1, G107.
    TiltedPlane,         ///< G68.2 and similar codes: frame of a tilted working plane.
    Orient,              ///< G53.1 and similar codes: turn the tool normal to the plane.
    Macro,
    Pocket,        ///< G12, G13 and G150 of Haas.
    HolePattern,   ///< G70, G71, G72 of Haas: positions of holes for the active cycle.
    Unsupported,   ///< Known but not simulated; all later positions would be wrong.
    NotSimulated,  ///< Known but not simulated; the cut of the block is missing.
    Ignored,       ///< Known and without effect on the path of the tool.
};
constexpr std::size_t kGroups = 29;

/// Returns ten times the number in the name of a code: 382 for "G38_2".
constexpr int parse_tenths(std::string_view name) {
    int number = 0;
    int tenths = 0;
    bool point = false;
    for (const char c : name.substr(1)) {
        if (c == '_') {
            point = true;
        } else if (point) {
            tenths = c - '0';
        } else {
            number = number * 10 + (c - '0');
        }
    }
    return number * 10 + tenths;
}

/// The G codes of codes.def: G38_2 is G38.2. Value: ten times the number.
enum class Code : std::int16_t {
    None = -1,
#define NCSIM_G(name, group, takes_axes, letters, availability) name = parse_tenths(#name),
#include "control/codes.def"
#undef NCSIM_G
};

/// Controls that have a code.
enum class Availability : std::uint8_t {
    All,     ///< RS274/NGC as in LinuxCNC, and other controls.
    Others,  ///< Controls other than RS274/NGC.
    Haas,    ///< Haas only.
};

/// A row of codes.def.
struct GCode {
    Code code;
    std::string_view name;  ///< Spelling in programs: "G38.2".
    Group group;
    bool takes_axes;         ///< Axis words of the block belong to the code.
    std::uint32_t letters;   ///< A bit, counted from A, for each letter that the code uses.
    bool has_other_letters;  ///< Controls other than LinuxCNC may use further letters.
    Availability availability;
};

/// Returns the code with ten times the number `tenths`, or None.
Code find_g(int tenths);

/// Returns the row of `code`.
/// Requires: `code` is not None.
const GCode& entry_of(Code code);
inline std::string_view name_of(Code code) {
    return entry_of(code).name;
}
/// Returns ten times the number of `code`; -1 for None.
constexpr int tenths_of(Code code) {
    return static_cast<int>(code);
}

/// True for G73, G74, G76, G81 … G89: canned cycles that drill, tap or bore.
bool is_cycle(Code code);

/// Group of an M code.
enum class MGroup : std::uint8_t {
    Stop,
    ToolChange,
    Spindle,
    Coolant,
    Override,
    Io,
    Call,
    Other,
    Clamp,       ///< Clamps or releases a rotary axis; defined by the machine.
    Kinematics,  ///< Chooses the kinematics of a LinuxCNC machine; defined by the configuration.
    Unknown
};
constexpr std::size_t kMGroups = 10;

/// Returns the group of the M code `number`.
MGroup m_group(int number);
/// True for M codes of a control that move no axis and do not change the order of blocks: coolant,
/// chips, air, doors, brakes, outputs.
bool is_harmless_m(int number, Dialect dialect);

}  // namespace ncsim::gcode
