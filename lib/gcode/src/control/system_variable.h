// SPDX-License-Identifier: GPL-3.0-or-later
//
// Variables by which a program sets the control itself: what #3000, #5221 and #2001 mean.
#pragma once

#include "control/rules.h"

#include <cstddef>
#include <cstdint>

namespace ncsim::gcode {

struct SystemVariable {
    enum class Effect : std::uint8_t {
        Kept,        ///< A number that the control keeps and does not act on.
        NotApplied,  ///< The control acts on it in a way that is not simulated.
        Alarm,       ///< #3000 of Fanuc and Haas: the control stops for good.
        Stop,        ///< #3006: the same as M0.
        WorkOffset,  ///< `item` of the origin of system `index`.
        External,    ///< `item` of the external offset.
        Home,        ///< `item` of the place of G28 (`index` 0) or G30 (1).
        Stored92,    ///< `item` of the offset that G92.3 restores.
        Probed,      ///< `item` of the place where the last probe made contact.
        Length,      ///< Length of the tool offset `index`.
        LengthWear,
        Diameter,
        DiameterWear,
    };
    Effect effect = Effect::Kept;
    int number = 0;
    int index = 0;
    std::size_t item = 0;  ///< An axis, or 9: the rotation of a system.
};

/// Returns the action of the control of `rules` if #`number` is set.
SystemVariable system_variable(int number, const Rules& rules);

}  // namespace ncsim::gcode
