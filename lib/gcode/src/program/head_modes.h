// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modes that the head of a program sets. Any other mode keeps the value that the previous program
// left in the control.
#pragma once

#include "control/command.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::gcode {

/// The modes that the head of a program sets.
class HeadModes {
public:
    /// Records the modes that `command` sets. The head ends with the first command that moves to a
    /// programmed position. Moves to positions of the machine (G28, G30, G53) belong to the head.
    void note(const Command& command);

    /// Returns the modes that a control of `dialect` has and the head does not set, with the codes
    /// that set the modes: "units (G20, G21)".
    std::vector<std::string> unset(Dialect dialect) const;

private:
    std::uint32_t groups_ = 0;  ///< A bit for each Group.
    bool sets_shift_ = false;   ///< G92, G52 or a similar code was executed.
    bool has_ended_ = false;
};

}  // namespace ncsim::gcode
