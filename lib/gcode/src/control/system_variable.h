// SPDX-License-Identifier: GPL-3.0-or-later
//
// Variables by which a program changes settings of the control, such as #3000, #5221 and #2001.
#pragma once

#include "control/control_rules.h"

#include <cstddef>
#include <cstdint>

namespace ncsim::gcode {

/// Effect of setting a system variable.
struct SystemVariable {
    enum class Effect : std::uint8_t {
        Stored,      ///< A number that the control stores without acting on the value.
        NotApplied,  ///< The control acts on the value in a way that is not simulated.
        Alarm,       ///< #3000 of Fanuc and Haas: the control stops with an alarm.
        Stop,        ///< #3006: a stop like M0.
        WorkOffset,  ///< `item` of the origin of system `index`.
        External,    ///< `item` of the external offset.
        Home,        ///< `item` of the target of G28 (`index` 0) or G30 (1).
        Stored92,    ///< `item` of the offset that G92.3 restores.
        Probed,      ///< `item` of the contact position of the last probing.
        Length,      ///< Length of the tool offset `index`.
        LengthWear,
        Diameter,
        DiameterWear,
    };
    Effect effect = Effect::Stored;
    int number = 0;
    int index = 0;
    std::size_t item = 0;  ///< An axis, or 9: the rotation of a system.
};

/// Returns the effect that setting #`number` has on the control of `rules`.
SystemVariable system_variable(int number, const Rules& rules);

}  // namespace ncsim::gcode
