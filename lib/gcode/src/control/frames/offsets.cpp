// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coordinate systems: G54 … G59.3, G92 and G52, G10, G43, radius of G41, G68, G51, G16.
#include "ncsim/base/angles.h"

#include "control/machine.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ncsim::gcode {
namespace {

constexpr std::string_view kAxisNames = "XYZABCUVW";

/// Converts mm to active units of size `unit`; rotary axes stay.
Axes from_mm(const Axes& mm, double unit) {
    Axes out = mm;
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (!is_rotary(i)) out[i] /= unit;
    }
    return out;
}
double mm_of(double value, std::size_t axis, double unit) {
    return is_rotary(axis) ? value : value * unit;
}

}  // namespace

/// Updates the program coordinates after a change of offsets; the machine position `machine` stays.
void Machine::recompute_position(const Axes& machine) {
    state_.position = from_machine(machine);
}

/// Returns the offset of `system`: 1 … 9 are G54 … G59.3, kExtended + n is G54.1 Pn.
WorkOffset& Machine::offset_of(int system) {
    Store& store = control_.store.change();
    if (system <= kExtended) return store.work_offsets[static_cast<std::size_t>(system - 1)];
    const auto [entry, is_new] = store.extended.try_emplace(system - kExtended);
    if (is_new) {
        entry->second = store.work_offsets.front();
        entry->second.frame.fill(system);
    }
    return entry->second;
}

void Machine::select_system(int system) {
    Axes machine = machine_position();
    state_.system = system;
    if (state_.is_at_start && place_at_start()) return;
    assume_same_zero(machine);
    use_system(machine);
}

/// Applies the stored origin of the active system, with the axes at `machine`.
void Machine::use_system(const Axes& machine) {
    const WorkOffset& offset = offset_of(state_.system);
    state_.frames.work_offset = from_mm(offset.origin, state_.unit_mm());
    state_.frames.rotation = offset.rotation;
    state_.frame = offset.frame;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!is_known(i)) state_.place_frame[i] = state_.frame[i];
        // Reference 0 is the machine, so a machine position is known in a system with reference 0.
        state_.of_machine[i] = state_.of_machine[i] && state_.frame[i] != 0;
    }
    recompute_position(machine);
}

/// Adds `distance_mm` to the origins with the reference `frame` along `axis`.
void Machine::shift_frame(std::size_t axis, int frame, double distance_mm) {
    Store& store = control_.store.change();
    for (WorkOffset& offset : store.work_offsets) {
        if (offset.frame[axis] == frame) offset.origin[axis] += distance_mm;
    }
    for (auto& [number, offset] : store.extended) {
        if (offset.frame[axis] == frame) offset.origin[axis] += distance_mm;
    }
}

/// Relates the stored origin of the active system, which is not in effect yet, to the origin in
/// effect. Along an axis with an unspecified distance, both zeros are assumed to coincide, so the
/// position keeps its value, and the unspecified reference is shifted. `machine`: position of the
/// axes; moves with the shift.
void Machine::assume_same_zero(Axes& machine) {
    const double unit = state_.unit_mm();
    for (std::size_t i = 0; i < 3; ++i) {
        std::set<int>& used = control_.store.change().used_frames[i];
        used.insert(state_.frame[i]);
        const int frame = offset_of(state_.system).frame[i];
        if (!used.insert(frame).second) continue;
        const double distance =
            state_.frames.work_offset[i] * unit - offset_of(state_.system).origin[i];
        if (frame != 0) {
            shift_frame(i, frame, distance);
            continue;
        }
        for (const int other : used) {
            if (other != 0) shift_frame(i, other, -distance);
        }
        path_.shift_unspecified(i, -distance);
        state_.frame_shift[i] -= distance;
        if (is_known(i) && state_.place_frame[i] != kMachinePlace) machine[i] -= distance / unit;
    }
}

/// Before the first move: places the axes at the specified start in the present G54, and relates
/// the active system to G54.
/// Returns: false, without effect, if X, Y and Z are not axis positions.
bool Machine::place_at_start() {
    if (state_.frames.tilt || state_.frames.dynamic_offset ||
        state_.coordinates != Coordinates::Axes)
        return false;
    const double unit = state_.unit_mm();
    Axes machine = machine_position();
    Axes start{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (options_.start[i]) start[i] = options_.start[i]->mm() / unit;
    }
    Store& store = control_.store.change();
    const WorkOffset& g54 = store.work_offsets.front();
    rotate(start[kX], start[kY], g54.rotation);
    for (std::size_t i = 0; i < 3; ++i) {
        // An axis without a start counts as at home.
        machine[i] = options_.start[i] ? start[i] + g54.origin[i] / unit : 0.0;
        store.used_frames[i] = {g54.frame[i]};
    }
    state_.frames.work_offset = from_mm(g54.origin, unit);
    state_.frame = state_.place_frame = g54.frame;
    assume_same_zero(machine);
    use_system(machine);
    // If the origin of G54 is unspecified, the start refers to the system of the first move.
    for (std::size_t i = 0; i < 3; ++i) {
        if (state_.place_frame[i] != 0) state_.place_frame[i] = state_.frame[i];
    }
    ++state_.length_changes;
    return true;
}

/// Returns the P of G54.1 Pn and similar codes; nullopt if P is invalid.
std::optional<int> Machine::extended_number(const Command& command) {
    constexpr double kMost = 300.0;
    const double p = command.get('P', 0.0);
    if (!(p >= 1.0 && p <= kMost) || p != std::floor(p)) return std::nullopt;
    return static_cast<int>(p);
}

/// Returns the number of the system that `code` selects without P; 1 for other codes.
int Machine::system_of(Code code) {
    constexpr std::array kNamed = {Code::G54, Code::G55,   Code::G56,   Code::G57,  Code::G58,
                                   Code::G59, Code::G59_1, Code::G59_2, Code::G59_3};
    const auto* const named = std::ranges::find(kNamed, code);
    if (named != kNamed.end()) return static_cast<int>(named - kNamed.begin()) + 1;
    // Haas: G110 is G154 P1.
    if (code >= Code::G110 && code <= Code::G129) {
        return kExtended + (tenths_of(code) - tenths_of(Code::G110)) / 10 + 1;
    }
    return 1;
}

/// True if a code of `command` other than the coordinate system uses the word `letter`.
bool Machine::has_other_use(const Command& command, char letter) const {
    Code motion = command.group(Group::Motion);
    if (motion == Code::None && command.axis_words) motion = state_.motion;
    const auto uses = [letter](Code code) {
        return code != Code::None && entry_of(code).group != Group::WorkOffset &&
               (entry_of(code).letters >> letter_index(letter) & 1U) != 0;
    };
    return command.group(Group::PathMode) != Code::None || uses(motion) ||
           std::ranges::any_of(command.g, uses);
}

bool Machine::set_work_offset(const Command& command) {
    const Code code = command.group(Group::WorkOffset);
    if (code == Code::None) return true;
    int system = system_of(code);
    if (code == Code::G54_1 || code == Code::G154 ||
        (code == Code::G54 && command.has('P') && !rules_.strict && !has_other_use(command, 'P'))) {
        const std::optional<int> number = extended_number(command);
        if (!number)
            return fail(Message::ExtendedNumber, span_of_g(command, code), {name_of(code)});
        system = kExtended + *number;
    }
    if (state_.cutter_side != CutterSide::Off && system != state_.system && rules_.strict) {
        return fail(Message::ForbiddenWithCompensation, span_of_g(command, code), {"G54 … G59.3"});
    }
    // LinuxCNC ignores the selection of the active system; values written as variables take effect
    // with the selection of another system.
    const bool stays = rules_.dialect == Dialect::Rs274 && system == state_.system;
    if (!stays) select_system(system);
    return true;
}

bool Machine::offset_92(const Command& command, Code code) {
    const double unit = state_.unit_mm();
    const bool sets = code == Code::G92 || code == Code::G52;
    if (state_.cutter_side != CutterSide::Off && rules_.strict && sets) {
        return fail(Message::ForbiddenWithCompensation, span_of_g(command, code), {"G92"});
    }
    const Axes machine = machine_position();
    Axes offset = state_.frames.offset_92;
    switch (code) {
        case Code::G92:
        // Smoothieware, Carvera: sets the position of the machine axis, as in "A0 is here".
        case Code::G92_4:
        case Code::G28_3:  // TinyG, g2core: same as G92.4.
        case Code::G52:
            if (!command.axis_words) {
                // Fanuc: "G92 S2000" limits the spindle speed.
                if (rules_.strict) return fail(Message::AxesMissing, command.span, {"G92"});
                return true;
            }
            for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
                if (!command.has(kAxisNames[i])) continue;
                const bool is_diameter = i == kX && state_.lathe_diameter;
                const double value = command[kAxisNames[i]] / (is_diameter ? 2.0 : 1.0);
                offset[i] = code == Code::G52
                                ? value
                                : state_.position[i] + state_.frames.offset_92[i] - value;
                // If the position of the axis was unknown, G92 defines the position and the program
                // zero.
                if (code == Code::G52 || i > kZ || is_known(i) || state_.frames.tilt) continue;
                state_.frames.zero_92[i] = offset[i];
                state_.frames.is_zero_by_hand[i] = true;
                path_.record_offset(state_.system);
                mark_known(i);
            }
            if (code != Code::G52) state_.is_at_start = false;
            for (std::size_t i = 0; i < offset.size(); ++i)
                control_.store.change().stored_92[i] = mm_of(offset[i], i, unit);
            state_.offset_92_active = true;
            break;
        case Code::G92_1: control_.store.change().stored_92 = {}; [[fallthrough]];
        case Code::G92_2:
            offset = {};
            state_.frames.zero_92 = {};
            state_.frames.is_zero_by_hand = {};
            state_.offset_92_active = false;
            break;
        case Code::G92_3:
            offset = from_mm(control_.store->stored_92, unit);
            state_.offset_92_active = true;
            break;
        default: return true;
    }
    state_.frames.offset_92 = offset;
    recompute_position(machine);
    return true;
}

// --- G10 ---

bool Machine::set_data(const Command& command) {
    const SourceSpan span = span_of_g(command, Code::G10);
    if (!command.has('L')) return fail(Message::G10Form, span);
    const int l = static_cast<int>(std::lround(std::clamp(command['L'], -1e6, 1e6)));
    const int p = static_cast<int>(std::lround(std::clamp(command.get('P', -1.0), -1e6, 1e6)));
    switch (l) {
        case 2:
        case 20:
            if (l == 20 && rules_.macro_b) {
                // Fanuc and Haas: the origin of G54.1 Pn, not the present position.
                const std::optional<int> number = extended_number(command);
                if (!number) return fail(Message::ExtendedNumber, span, {"G10 L20"});
                return set_work_data(command, kExtended + *number, false);
            }
            if (p < 0 || p > 9) {
                if (rules_.strict || p < 0) return fail(Message::G10System, span_of(command, 'P'));
                return tolerate(Message::G10System, span_of(command, 'P'));
            }
            if (p == 0 && rules_.macro_b) return set_external(command);
            return set_work_data(command, p == 0 ? state_.system : p, l == 20);
        case 1:
        case 10:
        case 11:
            if (p < 0) return fail(Message::G10Form, span);
            if (is_register(command, l)) return set_register(command, p, l);
            return set_tool_data(command, p);
        case 12:
        case 13:
            if (p < 0 || !is_register(command, l)) return fail(Message::G10Form, span);
            return set_register(command, p, l);
        default: return fail(Message::G10Form, span);
    }
}

bool Machine::set_work_data(const Command& command, int index, bool from_position) {
    WorkOffset& offset = offset_of(index);
    const double unit = state_.unit_mm();
    Axes machine = machine_position();
    path_.record_offset(index);
    if (command.has('R') && from_position && rules_.strict)
        return fail(Message::WordUnused, span_of(command, 'R'), {"R"});
    if (command.has('R') && !from_position) {
        const bool has_g92 =
            state_.frames.offset_92[kX] != 0.0 || state_.frames.offset_92[kY] != 0.0;
        if (rules_.is_linuxcnc() && index == state_.system && has_g92 &&
            offset.rotation != command['R'])
            warn(Message::RotationUnderG92, span_of(command, 'R'));
        offset.rotation = command['R'];
    }
    // L20: the present position gets the coordinates of the block.
    double x = machine[kX] - state_.frames.tool_offset[kX] - offset.origin[kX] / unit;
    double y = machine[kY] - state_.frames.tool_offset[kY] - offset.origin[kY] / unit;
    rotate(x, y, -offset.rotation);
    double wanted_x = x;
    double wanted_y = y;
    for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
        if (!command.has(kAxisNames[i])) continue;
        const double value = command[kAxisNames[i]];
        if (!from_position) {
            const double before = state_.incremental && !rules_.is_linuxcnc()
                                      ? offset.origin[i]
                                      : control_.store->external[i];
            offset.origin[i] = before + mm_of(value, i, unit);
            if (i <= kZ && (!state_.incremental || rules_.is_linuxcnc())) offset.frame[i] = 0;
        } else if (i == kX) {
            wanted_x = value + state_.frames.offset_92[kX];
        } else if (i == kY) {
            wanted_y = value + state_.frames.offset_92[kY];
        } else {
            offset.origin[i] = mm_of(
                machine[i] - state_.frames.tool_offset[i] - state_.frames.offset_92[i] - value, i,
                unit);
        }
    }
    if (from_position && command.has_any(letters('X', 'Y'))) {
        rotate(wanted_x, wanted_y, offset.rotation);
        offset.origin[kX] = unit * (machine[kX] - state_.frames.tool_offset[kX] - wanted_x);
        offset.origin[kY] = unit * (machine[kY] - state_.frames.tool_offset[kY] - wanted_y);
    }
    for (std::size_t i = kX; from_position && i <= kZ; ++i) {
        if (!command.has(kAxisNames[i])) continue;
        if (is_known(i)) {
            const int frame = state_.place_frame[i];
            offset.frame[i] = frame == kMachinePlace ? 0 : frame;
        } else {
            offset.frame[i] = index;  // An unknown position.
            // The computed origin is arbitrary; the position gets the number of the block.
            control_.store.change().used_frames[i].insert(index);
        }
    }
    if (from_position) state_.is_at_start = false;
    if (state_.is_at_start && place_at_start()) return true;
    if (index != state_.system) return true;
    assume_same_zero(machine);
    use_system(machine);
    for (std::size_t i = kX; from_position && i <= kZ; ++i) {
        if (command.has(kAxisNames[i]) && !is_known(i)) mark_known(i);
    }
    return true;
}

/// G10 L2 P0 of Fanuc and Haas: sets the external offset, which is part of all origins.
bool Machine::set_external(const Command& command) {
    Axes external = control_.store->external;
    for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
        if (!command.has(kAxisNames[i])) continue;
        const double value = mm_of(command[kAxisNames[i]], i, state_.unit_mm());
        external[i] = state_.incremental ? external[i] + value : value;
    }
    move_external(external);
    return true;
}

void Machine::move_external(const Axes& external) {
    const Axes machine = machine_position();
    Store& store = control_.store.change();
    const auto shift = [&](WorkOffset& offset) {
        for (std::size_t i = 0; i < external.size(); ++i)
            offset.origin[i] += external[i] - store.external[i];
    };
    std::ranges::for_each(store.work_offsets, shift);
    for (auto& [number, offset] : store.extended)
        shift(offset);
    store.external = external;
    store.has_external = true;
    if (!state_.is_at_start || !place_at_start()) use_system(machine);
}

ToolTableEntry* Machine::register_of(int index) {
    std::vector<ToolTableEntry>& tools = control_.store.change().tools;
    auto entry = std::ranges::find(tools, index, &ToolTableEntry::number);
    if (entry == tools.end()) {
        if (tools.size() > 10'000) return nullptr;
        tools.push_back({.number = index, .offset = {}, .length_specified = false, .diameter = {}});
        entry = tools.end() - 1;
    }
    return &*entry;
}

/// True for G10 of Fanuc and Haas that sets a register without naming an axis: "G10 L10 P1 R120.".
bool Machine::is_register(const Command& command, int l) const {
    if (rules_.strict || !command.has('R') || command.has_any(letters('X', 'Y', 'Z'))) return false;
    // L1 is wear on Haas, a tool table on other controls.
    return l != 1 || rules_.dialect == Dialect::Haas;
}

/// Sets a register. L10: length; L11, and L1 of Haas: wear of the length; L12: radius; L13: wear of
/// the radius. The control adds wear to length and radius. Under G91 the value is added to the old
/// value.
bool Machine::set_register(const Command& command, int index, int l) {
    ToolTableEntry* entry = register_of(index);
    if (!entry) return fail(Message::G10Form, command.span);
    const bool of_length = l <= 11;
    const bool is_wear = l == 1 || l == 11 || l == 13;
    const std::array<char, 4> name{'L', static_cast<char>('0' + l / 10),
                                   static_cast<char>('0' + l % 10), '\0'};
    double value = command['R'] * state_.unit_mm();
    if (!of_length && rules_.dialect == Dialect::Haas && is_diameter(*entry, value, is_wear)) {
        log_.add(Message::G10Diameter, span_of(command, 'R'), {std::string_view(name.data(), 3)});
        value /= 2.0;
    }
    set_register_value(*entry, of_length, is_wear, value, state_.incremental);
    return true;
}

/// Sets the length or radius of `entry`, or the wear, to `mm`; `adds`: adds `mm` to the old value.
void Machine::set_register_value(ToolTableEntry& entry, bool of_length, bool is_wear, double mm,
                                 bool adds) {
    Wear& wear = control_.store.change().wear[entry.number];
    double& worn = of_length ? wear.length_mm : wear.radius_mm;
    const double sum =
        of_length ? entry.offset[2].mm() : entry.diameter.value_or(Length()).mm() / 2.0;
    double whole = sum - worn;  // Value without the wear.
    double& specified = is_wear ? worn : whole;
    specified = adds ? specified + mm : mm;
    if (of_length) {
        entry.offset[2] = Length::from_mm(whole + worn);
        entry.length_specified = true;
        if (entry.number == state_.tool) state_.tool_length = gauge_length();
    } else {
        entry.diameter = Length::from_mm(2.0 * (whole + worn));
    }
}

/// True if `mm` is a diameter. Haas controls use diameters by default, radii by setting 40. If the
/// tool's diameter is specified, the nearer of diameter and radius decides. Wear counts as a
/// diameter.
bool Machine::is_diameter(const ToolTableEntry& entry, double mm, bool is_wear) const {
    const auto& specified = options_.tools;
    const auto tool = std::ranges::find(specified, entry.number, &ToolTableEntry::number);
    if (is_wear || tool == specified.end() || !tool->diameter) return true;
    const double diameter = tool->diameter->mm();
    return std::abs(mm - diameter) <= std::abs(mm - diameter / 2.0);
}

bool Machine::set_tool_data(const Command& command, int index) {
    ToolTableEntry* entry = register_of(index);
    if (!entry) return fail(Message::G10Form, command.span);
    const long l = std::lround(command['L']);
    const double unit = state_.unit_mm();
    const Axes machine = machine_position();
    Axes zero = state_.frames.work_offset;
    if (l == 11 && control_.store->work_offsets[8].origin != Axes{})
        zero = from_mm(control_.store->work_offsets[8].origin, unit);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!command.has(kAxisNames[i])) continue;
        const double value = command[kAxisNames[i]];
        // L10 and L11: with the new offset the present position has the coordinates of the block.
        const double offset =
            l == 1 ? value
                   : machine[i] - zero[i] - value - (l == 10 ? state_.frames.offset_92[i] : 0.0);
        entry->offset[i] = Length::from_mm(unit * offset);
    }
    entry->length_specified |= command.has('Z');
    if (command.has('R')) entry->diameter = Length::from_mm(2.0 * unit * command['R']);
    if (index == state_.tool) state_.tool_length = gauge_length();
    return true;
}

// --- Tools ---

/// Returns the specified length of `tool`, mm; nullopt if unspecified.
std::optional<double> Machine::specified_length(int tool) const {
    const auto entry = std::ranges::find(control_.store->tools, tool, &ToolTableEntry::number);
    if (entry == control_.store->tools.end() || !entry->length_specified) return std::nullopt;
    return entry->offset[2].mm();
}

/// Returns the length of the tool in the spindle, mm: the value specified before the program
/// starts, even if the program changes the register; otherwise the value of the register.
std::optional<double> Machine::gauge_length() const {
    const auto& specified = options_.tools;
    const auto entry = std::ranges::find(specified, state_.tool, &ToolTableEntry::number);
    if (entry != specified.end() && entry->length_specified) return entry->offset[2].mm();
    return specified_length(state_.tool);
}

/// Returns the register of G43. H0 is no offset, except on LinuxCNC, where H0 is the tool in the
/// spindle.
int Machine::length_number(const Command& command) const {
    const int h = static_cast<int>(std::clamp(command.get('H', state_.tool), 0.0, 1e9));
    return h == 0 && rules_.is_linuxcnc() ? state_.tool : h;
}

bool Machine::set_tool_length(const Command& command) {
    const Code code = command.group(Group::ToolLength);
    if (code == Code::None) return true;
    state_.by_vector = false;
    if (rules_.strict && command.has('H') && !check_tool(command, 'H')) return false;
    if (code == Code::G43_5 && !options_.joints) {
        return stop_with(Message::RotaryUnspecified, span_of_g(command, code), {name_of(code)});
    }
    if (code == Code::G43_4 || code == Code::G43_5 || code == Code::G234) {
        // Haas fixes the frame to the table at rotary positions 0.
        if (is_turned() && code != Code::G234 && !options_.tip_control.frame_at_zero) {
            stopped_ = true;
            return fail(Message::TipFrameUnspecified, span_of_g(command, code));
        }
        state_.tip_by_length = true;
        state_.by_vector = code == Code::G43_5;
        choose(Coordinates::Tip);
    } else if (state_.tip_by_length) {
        state_.tip_by_length = false;
        choose(Coordinates::Axes);
    }
    const double unit = state_.unit_mm();
    state_.length_register = code == Code::G49 ? kNoLength : kStatedLength;
    state_.length_specified = code == Code::G43_1;
    Axes offset{};
    if (code == Code::G43_1) {
        offset = state_.frames.tool_offset;  // Axes without a word keep the offset.
        for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
            if (command.has(kAxisNames[i])) offset[i] = command[kAxisNames[i]];
        }
    } else if (code != Code::G49) {
        const int h = length_number(command);
        if (code == Code::G43_2) {
            offset = state_.frames.tool_offset;
        } else {
            state_.length_register = code == Code::G44 && h != 0 ? kNegatedLength : h;
            state_.length_specified = specified_length(h).has_value();
        }
        const auto entry = std::ranges::find(control_.store->tools, h, &ToolTableEntry::number);
        if (entry != control_.store->tools.end()) {
            const double sign = code == Code::G44 ? -1.0 : 1.0;
            for (std::size_t i = 0; i < 3; ++i)
                offset[i] += sign * entry->offset[i].mm() / unit;
        }
    }
    uses_length_offsets_ |= state_.length_register != kNoLength;
    if (offset == state_.frames.tool_offset) return true;
    const Axes machine = machine_position();
    state_.frames.tool_offset = offset;
    recompute_position(machine);
    ++state_.length_changes;
    return true;
}

/// Returns the radius of register D, or of the tool in the spindle, in active units. If the radius
/// is unspecified, reports a warning and returns 0.
double Machine::radius_of_register(const Command& command, SourceSpan span) {
    int d = static_cast<int>(std::clamp(command.get('D', state_.tool), 0.0, 1e9));
    if (d == 0 && rules_.is_linuxcnc()) d = state_.tool;
    unread_registers_.erase(d);
    const auto entry = std::ranges::find(control_.store->tools, d, &ToolTableEntry::number);
    if (entry != control_.store->tools.end() && entry->diameter) {
        return entry->diameter->mm() / 2.0 / state_.unit_mm();
    }
    if (!rules_.strict && d != 0) {
        warn(Message::CompensationRadiusUnknown, span,
             {std::string("D").append(std::to_string(d))});
    }
    return 0.0;
}

/// Refuses words as LinuxCNC does: a tool missing in the table, G41.1 without D, an orientation (L)
/// outside G18.
bool Machine::check_compensation_words(const Command& command, bool stated) {
    if (stated) {
        if (!command.has('D'))
            return fail(Message::CycleWordMissing, command.span, {"G41.1 or G42.1", "D"});
        return !command.has('L') || state_.plane == Plane::ZX ||
               fail(Message::WordUnused, span_of(command, 'L'), {"L outside G18"});
    }
    return !command.has('D') || check_tool(command, 'D');
}

/// Checks a tool number under strict rules: 0 is the tool in the spindle; every other number must
/// be in the table.
bool Machine::check_tool(const Command& command, char letter) {
    const double value = command[letter];
    if (value < 0.0) return fail(Message::NegativeValue, span_of(command, letter), {{&letter, 1}});
    const int number = static_cast<int>(std::min(value, 1e9));
    const auto& tools = control_.store->tools;
    if (number == 0 || tools.empty()) return true;
    if (std::ranges::find(tools, number, &ToolTableEntry::number) != tools.end()) return true;
    return fail(Message::ToolNotInTable, span_of(command, letter), {std::to_string(number)});
}

bool Machine::set_cutter_side(const Command& command) {
    const Code code = command.group(Group::CutterSide);
    if (code == Code::None) return true;
    if (code == Code::G40) {
        if (compensation_.is_on()) {
            // On LinuxCNC the next move begins at the programmed point: axes of the plane that the
            // next move does not name also move there.
            const std::optional<Axes> programmed = compensation_.programmed_end();
            compensation_.end(state_);
            if (programmed && rules_.is_linuxcnc()) {
                state_.position = *programmed;
            } else if (programmed && rules_.compensation_start == CompensationStart::SquareToNext) {
                const PlaneAxes axes = axes_of(state_.plane);
                for (const std::size_t axis : {axes.first, axes.second})
                    state_.uncancelled[axis] = (*programmed)[axis] - state_.position[axis];
            }
            path_.set_origin(span_, file_);
            state_.just_left_compensation |= !rules_.strict || programmed.has_value();
        }
        state_.cutter_side = CutterSide::Off;
        return true;
    }
    const SourceSpan span = span_of_g(command, code);
    if (state_.cutter_side != CutterSide::Off && !tolerate(Message::CompensationTwice, span)) {
        return false;
    }
    if (state_.plane != Plane::XY && state_.plane != Plane::ZX) {
        return fail(Message::CompensationPlane, span);
    }
    const bool stated =
        code == Code::G41_1 || code == Code::G42_1;  // G41.1 D3.5: D is the diameter itself.
    if (rules_.strict && !check_compensation_words(command, stated)) return false;
    double radius = 0.0;
    if (stated) {
        radius = command.get('D', 0.0) / 2.0;
    } else {
        radius = radius_of_register(command, span);
    }
    const bool is_41 = code == Code::G41 || code == Code::G41_1;
    const bool left = is_41 == (radius >= 0.0);  // A negative radius means the opposite side.
    const CutterSide side = left ? CutterSide::Left : CutterSide::Right;
    if (compensation_.is_on() && side == state_.cutter_side &&
        std::abs(radius) == state_.cutter_radius)
        return true;
    if (compensation_.is_on()) compensation_.end(state_);
    state_.cutter_side = side;
    state_.cutter_radius = std::abs(radius);
    if (radius != 0.0)
        compensation_.begin(state_.cutter_side, std::abs(radius), rules_.compensation_start);
    return true;
}

void Machine::begin_compensation_at(CutterSide side, double radius, const Axes& contour) {
    if (compensation_.is_on()) compensation_.end(state_);
    state_.cutter_side = side;
    state_.cutter_radius = radius;
    const Axes at = state_.position;
    const PlaneAxes axes = axes_of(state_.plane);
    const Axes from = from_programmed(contour);
    if (radius > 0.0) compensation_.begin_at_offset(side, radius, at);
    state_.position[axes.first] = from[axes.first];
    state_.position[axes.second] = from[axes.second];
}

// --- G68, G51, G16 ---

bool Machine::set_programmed(const Command& command) {
    ProgrammedTransform& t = state_.frames.programmed;
    if (const Code code = command.group(Group::Polar); code != Code::None)
        t.polar = code == Code::G16;
    const Code rotation = command.group(Group::Rotation);
    if (rotation == Code::G69) t.rotated = false;
    if (rotation == Code::G68) {
        if (!command.has('R'))
            return fail(Message::RotationWithoutAngle, span_of_g(command, Code::G68));
        const Axes at = to_programmed(state_.position);
        t.plane = state_.plane;
        const PlaneAxes axes = axes_of(t.plane);
        t.centre_1 = command.get(kAxisNames[axes.first], at[axes.first]);
        t.centre_2 = command.get(kAxisNames[axes.second], at[axes.second]);
        t.angle = state_.incremental && t.rotated ? t.angle + command['R'] : command['R'];
        t.rotated = true;
    }
    const Code scaling = command.group(Group::Scaling);
    if (scaling == Code::G50) t.scaled = false;
    if (scaling == Code::G51) {
        const Axes at = to_programmed(state_.position);
        double all = command.get('P', 1.0);
        if (all >= 100.0 && all == std::floor(all)) all /= 1000.0;  // P2000 is 2.0 on Fanuc.
        const char factors[] = {'I', 'J', 'K'};
        for (std::size_t i = 0; i < 3; ++i) {
            double factor = command.get(factors[i], all);
            if (std::abs(factor) >= 100.0) factor /= 1000.0;
            if (factor == 0.0) return fail(Message::ScaleZero, span_of_g(command, Code::G51));
            t.scale[i] = factor;
            t.scale_centre[i] = command.get(kAxisNames[i], at[i]);
        }
        t.scaled = true;
    }
    if (const Code mirror = command.group(Group::Mirror); mirror != Code::None) {
        const bool on = mirror == Code::G51_1;
        if (!t.scaled) t.scale = {1.0, 1.0, 1.0};
        for (std::size_t i = 0; i < 3; ++i) {
            if (!on && (command.has(kAxisNames[i]) || !command.axis_words))
                t.scale[i] = std::abs(t.scale[i]);
            if (!on || !command.has(kAxisNames[i])) continue;
            t.scale[i] = -std::abs(t.scale[i]);
            t.scale_centre[i] = command[kAxisNames[i]];
        }
        t.scaled = t.scale != std::array<double, 3>{1.0, 1.0, 1.0};
    }
    return true;
}

}  // namespace ncsim::gcode
