// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets that a program sets by variables: #5223 = -370.
#include "control/frames/frame_steps.h"

#include <cmath>
#include <string>

namespace ncsim::gcode {
namespace {

void set_work_variable(ControlState& control, const SystemVariable& variable, double value,
                       bool is_relative, SourceSpan span, Context& context) {
    MachineState& state = control.machine;
    constexpr std::size_t kRotation = 9;
    Axes machine = state.machine_position();
    context.path.record_offset(variable.index);
    WorkOffset& offset = offset_of(control, variable.index);
    const std::size_t item = variable.item;
    if (item == kRotation) {
        offset.rotation = value;
    } else {
        // Fanuc uses the units of the program, LinuxCNC the units of the machine: here mm.
        const double unit = context.rules.macro_b && !is_rotary(item) ? state.unit_mm() : 1.0;
        offset.origin[item] = value * unit + control.store->external[item];
        if (item <= kZ && !is_relative) offset.frame[item] = 0;
    }
    if (state.is_at_start && context.rules.macro_b && place_at_start(control, context)) return;
    if (variable.index != state.system) return;
    // LinuxCNC applies the new numbers of the active system only after another system was selected.
    if (!context.rules.macro_b) {
        const std::string name = std::string("#").append(std::to_string(variable.number));
        if (!context.rules.linuxcnc_planes && !context.rules.strict)
            warn(context, Message::VariableTiming, span, {name});
        return;
    }
    assume_same_zero(control, machine, context);
    use_system(control, machine);
}

}  // namespace

bool set_variable_offset(ControlState& control, const SystemVariable& variable, double value,
                         bool is_relative, SourceSpan span, Context& context) {
    const double unit = control.machine.unit_mm();
    using Effect = SystemVariable::Effect;
    const std::size_t item = variable.item;
    switch (variable.effect) {
        case Effect::WorkOffset:
            set_work_variable(control, variable, value, is_relative, span, context);
            return true;
        case Effect::External: {
            Axes external = control.store->external;
            external[item] = is_rotary(item) ? value : value * unit;
            move_external(control, external, context);
            return true;
        }
        case Effect::Home:
            control.store.change().homes[static_cast<std::size_t>(variable.index)][item] = value;
            return true;
        case Effect::Stored92: control.store.change().stored_92[item] = value; return true;
        case Effect::Probed:
            control.store.change().probed[item] = value;
            control.store.change().has_probed = true;
            return true;
        default: break;
    }
    ToolTableEntry* entry = register_of(control, variable.index);
    if (!entry) return false;
    const bool of_length =
        variable.effect == Effect::Length || variable.effect == Effect::LengthWear;
    const bool is_wear =
        variable.effect == Effect::LengthWear || variable.effect == Effect::DiameterWear;
    const double mm = value * unit;
    // Variables hold diameters, registers hold radii.
    set_register_value(control, *entry, of_length, is_wear, of_length ? mm : mm / 2.0, false,
                       context);
    return false;
}

}  // namespace ncsim::gcode
