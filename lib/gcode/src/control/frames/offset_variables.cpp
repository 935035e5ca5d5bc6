// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets that a program sets by variables: #5223 = -370.
#include "control/machine.h"

#include <cmath>

namespace ncsim::gcode {

void Machine::set_work_variable(const SystemVariable& variable, double value, bool is_relative,
                                SourceSpan span) {
    constexpr std::size_t kRotation = 9;
    Axes machine = machine_position();
    path_.record_offset(variable.index);
    WorkOffset& offset = offset_of(variable.index);
    const std::size_t item = variable.item;
    if (item == kRotation) {
        offset.rotation = value;
    } else {
        // Fanuc uses the units of the program, LinuxCNC the units of the machine: here mm.
        const double unit = rules_.macro_b && !is_rotary(item) ? state_.unit_mm() : 1.0;
        offset.origin[item] = value * unit + control_.store->external[item];
        if (item <= kZ && !is_relative) offset.frame[item] = 0;
    }
    if (state_.is_at_start && rules_.macro_b && place_at_start()) return;
    if (variable.index != state_.system) return;
    // LinuxCNC applies the new numbers of the active system only after another system was selected.
    if (!rules_.macro_b) {
        const std::string name = std::string("#").append(std::to_string(variable.number));
        if (!rules_.linuxcnc_planes && !rules_.strict) warn(Message::VariableTiming, span, {name});
        return;
    }
    assume_same_zero(machine);
    use_system(machine);
}

bool Machine::set_variable(const SystemVariable& variable, double value, bool is_relative,
                           SourceSpan span) {
    using Effect = SystemVariable::Effect;
    const std::size_t item = variable.item;
    const bool is_active =
        variable.effect == Effect::External ||
        (variable.effect == Effect::WorkOffset && variable.index == state_.system);
    if (is_active && rules_.macro_b) flush();
    switch (variable.effect) {
        case Effect::WorkOffset: set_work_variable(variable, value, is_relative, span); return true;
        case Effect::External: {
            Axes external = control_.store->external;
            external[item] = is_rotary(item) ? value : value * state_.unit_mm();
            move_external(external);
            return true;
        }
        case Effect::Home:
            control_.store.change().homes[static_cast<std::size_t>(variable.index)][item] = value;
            return true;
        case Effect::Stored92: control_.store.change().stored_92[item] = value; return true;
        case Effect::Probed:
            control_.store.change().probed[item] = value;
            control_.store.change().has_probed = true;
            return true;
        default: break;
    }
    ToolTableEntry* entry = register_of(variable.index);
    if (!entry) return false;
    const bool of_length =
        variable.effect == Effect::Length || variable.effect == Effect::LengthWear;
    const bool is_wear =
        variable.effect == Effect::LengthWear || variable.effect == Effect::DiameterWear;
    const double mm = value * state_.unit_mm();
    // Variables hold diameters, registers hold radii.
    set_register_value(*entry, of_length, is_wear, of_length ? mm : mm / 2.0, false);
    return false;
}

}  // namespace ncsim::gcode
