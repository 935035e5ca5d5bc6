// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of modes that the head of a program should set.
#include "program/head_modes.h"

namespace ncsim::gcode {
namespace {

constexpr std::uint32_t bit(Group group) {
    return 1U << static_cast<unsigned>(group);
}

struct Mode {
    Group group;
    std::string_view name;
    bool has_grbl_code;  ///< False: grbl 1.1 has no code that changes the mode.
    bool has_linuxcnc_code;
};

constexpr Mode kModes[] = {
    {Group::Units, "units (G20, G21)", true, true},
    {Group::Distance, "distances (G90, G91)", true, true},
    {Group::Plane, "plane (G17)", true, true},
    {Group::Feed, "feed mode (G94)", true, true},
    {Group::WorkOffset, "coordinate system (G54)", true, true},
    {Group::CutterSide, "cutter compensation (G40)", false, true},
    {Group::ToolLength, "tool length (G43, G49)", true, true},
    {Group::Motion, "motion mode (G0, G80)", true, true},
    {Group::Rotation, "rotation (G69)", false, false},
    {Group::Scaling, "scaling (G50)", false, false},
    {Group::Polar, "polar coordinates (G15)", false, false},
};

}  // namespace

void HeadModes::note(const Command& command) {
    if (has_ended_) return;
    for (std::size_t i = 0; i < kGroups; ++i) {
        if (command.g[i] != Code::None) groups_ |= 1U << i;
    }
    const Code one_shot = command.group(Group::OneShot);
    sets_shift_ |= one_shot >= Code::G92 && one_shot <= Code::G92_4;
    sets_shift_ |= one_shot == Code::G52;
    has_ended_ = command.axis_words && one_shot != Code::G53 && !command.axes_are_taken();
}

std::vector<std::string> HeadModes::unset(Dialect dialect) const {
    const bool is_linuxcnc = dialect == Dialect::Rs274;
    std::vector<std::string> names;
    for (const Mode& mode : kModes) {
        const bool is_known = dialect == Dialect::Grbl ? mode.has_grbl_code
                              : is_linuxcnc            ? mode.has_linuxcnc_code
                                                       : true;
        if (is_known && (groups_ & bit(mode.group)) == 0) names.emplace_back(mode.name);
    }
    if (!sets_shift_) names.emplace_back(is_linuxcnc ? "shift (G92.1)" : "shift (G52, G92)");
    return names;
}

}  // namespace ncsim::gcode
