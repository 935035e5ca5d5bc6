// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of G and M codes: what their names are, and which group a code belongs to. Two codes of
// one group exclude each other in a block.
#pragma once

#include "ncsim/gcode/dialect.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

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
    Carried,      ///< G254, G255, G54.2, G54.4.
    Face,         ///< G12.1, G13.1 and Haas's G112, G113.
    Cylinder,     ///< G7.1, G107.
    TiltedPlane,  ///< G68.2 and its kin: a frame.
    Orient,       ///< G53.1 and its kin: the tool is turned upright to it.
    Macro,
    Pocket,        ///< G12, G13 of Haas.
    HolePattern,   ///< G70, G71, G72 of Haas: where the cycle drills.
    Unsupported,   ///< Known, and not simulated: after it every place would be wrong.
    NotSimulated,  ///< Known, and not simulated: a cut would be missing.
    Ignored,       ///< Known, and without effect on where the tool goes.
};
constexpr std::size_t kGroups = 29;

/// Ten times the number in the name of a code: 382 of "G38_2".
constexpr int tenths_in(std::string_view name) {
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

/// The G codes of codes.def: G38_2 is G38.2. The value is ten times the number.
enum class Code : std::int16_t {
    None = -1,
#define NCSIM_G(name, group, takes_axes, letters, known_to) name = tenths_in(#name),
#include "control/codes.def"
#undef NCSIM_G
};

enum class KnownTo : std::uint8_t {
    All,     ///< RS274/NGC as LinuxCNC runs it, and others.
    Others,  ///< But not RS274/NGC.
    Haas,    ///< Haas only.
};

/// A row of codes.def.
struct GCode {
    Code code;
    std::string_view name;  ///< As it is written: "G38.2".
    Group group;
    bool takes_axes;         ///< Axis words of the block are its own.
    std::uint32_t letters;   ///< A bit, from A, for each of the other words that it has a use for.
    bool has_other_letters;  ///< On controls other than LinuxCNC's it may use any.
    KnownTo known_to;
};

/// The code of ten times the G number; None, where there is none.
Code find_g(int tenths);

/// Of a code that is not None.
const GCode& entry_of(Code code);
inline std::string_view name_of(Code code) {
    return entry_of(code).name;
}
/// Ten times its number; -1 of None.
constexpr int tenths_of(Code code) {
    return static_cast<int>(code);
}

/// G73, G74, G76, G81 … G89: a canned cycle that drills, taps or bores.
bool is_cycle(Code code);

enum class MGroup : std::uint8_t {
    Stop,
    ToolChange,
    Spindle,
    Coolant,
    Override,
    Io,
    Call,
    Other,
    Clamp,       ///< Holds a rotary axis or lets it go, as the machine tells.
    Kinematics,  ///< How a LinuxCNC machine turns, as its configuration has it.
    Unknown
};
constexpr std::size_t kMGroups = 10;

/// The group of an M code.
MGroup m_group(int number);
/// True for M codes of a control that move no axis and choose no block: coolant, chips, air, doors,
/// brakes, outputs.
bool is_harmless_m(int number, Dialect dialect);

}  // namespace ncsim::gcode
