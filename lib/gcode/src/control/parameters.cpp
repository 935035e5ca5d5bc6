// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters of RS274/NGC and Fanuc, and their unknown values.
#include "control/parameters.h"

#include "control/codes.h"
#include "text/number.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {
namespace {

constexpr int kMaxNumber = 99'999;
constexpr int kMaxStrict = 5602;
/// Limit on the number of names, above any real program; stops a loop that creates names.
constexpr std::size_t kMaxNames = 20'000;

int to_index(double number, bool strict) {
    const double rounded = std::round(number);
    if (!(std::abs(number - rounded) < 1e-4)) return -1;
    if (rounded < 0 || rounded > (strict ? kMaxStrict : kMaxNumber)) return -1;
    return static_cast<int>(rounded);
}

constexpr bool is_in(int n, int first, int count) {
    return n >= first && n < first + count;
}

}  // namespace

void Parameters::set_rules(const Rules& rules) {
    rules_ = rules;
    locals_.fill(empty());
}

std::string Parameters::take_unknown() const {
    std::string name;
    name.swap(unknown_);
    return name;
}

/// Records `key` as read if the value of `key` is unknown.
void Parameters::note_read(std::string_view key, bool is_set) const {
    if (!unknown_.empty()) return;
    if (!is_set) {
        unknown_ = key;
    } else if (const auto found = computed_from_.find(key); found != computed_from_.end()) {
        unknown_ = found->second;
    }
}

/// Records the unknown variable on which the value of `key` depends; empty: none.
void Parameters::keep_origin(std::string_view key, std::string_view unknown) {
    if (!unknown.empty()) {
        computed_from_.insert_or_assign(std::string(key), std::string(unknown));
    } else if (const auto found = computed_from_.find(key); found != computed_from_.end()) {
        computed_from_.erase(found);
    }
}

/// Returns the values of #5161 … #5410 of RS274/NGC and #5201 … of Fanuc: homes, offsets, origins.
std::optional<Parameters::MachineValue> Parameters::offset_value(int number) const {
    const MachineState& state = *view.state;
    const Store& store = **view.store;
    const auto axis = [&](int first) { return static_cast<std::size_t>(number - first); };
    for (std::size_t i = 0; i < store.homes.size(); ++i) {
        const int first = i == 0 ? 5161 : 5181;
        // No option specifies the homes; a home of zeros is a default.
        if (is_in(number, first, 9))
            return MachineValue{store.homes[i][axis(first)], store.homes[i] != Axes{}};
    }
    if (number == 5210) return MachineValue{state.offset_92_active ? 1.0 : 0.0};
    if (is_in(number, 5211, 9)) return MachineValue{store.stored_92[axis(5211)]};
    if (number == 5220) return MachineValue{static_cast<double>(state.system)};
    if (rules_.macro_b && is_in(number, 5201, 9)) {
        const std::size_t item = axis(5201);
        return MachineValue{store.external[item] / (is_rotary(item) ? 1.0 : state.unit_mm()),
                            store.has_external};
    }
    if (!is_in(number, 5221, 180)) return std::nullopt;
    const WorkOffset& offset = store.work_offsets[axis(5221) / 20];
    const std::size_t item = axis(5221) % 20;
    if (item == 9) return MachineValue{offset.rotation, offset.frame[kZ] == 0};
    if (item > 9) return std::nullopt;
    // Fanuc shows the units of the program, LinuxCNC the units of the machine: here mm.
    const double unit = rules_.macro_b && !is_rotary(item) ? state.unit_mm() : 1.0;
    const bool is_known = offset.frame[item > kZ ? std::size_t{kZ} : item] == 0;
    return MachineValue{(offset.origin[item] - store.external[item]) / unit,
                        is_known && (rules_.macro_b || !state.inches)};
}

/// Returns the values of Fanuc variables that RS274/NGC lacks: #5001 … #5049 and #4001 ….
std::optional<Parameters::MachineValue> Parameters::fanuc_variable(int number) const {
    const MachineState& state = *view.state;
    const auto axis = [&](int first) { return static_cast<std::size_t>(number - first); };
    for (const int first : {5001, 5041}) {
        if (is_in(number, first, 9))
            return MachineValue{state.position[axis(first)], state.is_known(axis(first))};
    }
    if (is_in(number, 5021, 9)) {
        const std::size_t a = axis(5021);
        const FrameStack& f = state.frames;
        const bool is_known = state.is_known(a) && state.frame[a > kZ ? std::size_t{kZ} : a] == 0;
        return MachineValue{
            state.position[a] + f.offset_92[a] + f.work_offset[a] + f.tool_offset[a], is_known};
    }
    switch (number) {
        case 4001: return MachineValue{std::max(tenths_of(state.motion), 0) / 10.0};
        case 4003: return MachineValue{state.incremental ? 91.0 : 90.0};
        case 4006: return MachineValue{state.inches ? 20.0 : 21.0};
        case 4009:
        case 4109: return MachineValue{state.feed};
        case 4014: return MachineValue{53.0 + state.system};
        case 4119: return MachineValue{state.spindle_rpm};
        case 4120: return MachineValue{static_cast<double>(state.tool), state.tool != 0};
        default: return std::nullopt;
    }
}

std::optional<Parameters::MachineValue> Parameters::machine_value(int number) const {
    const MachineState& state = *view.state;
    const auto axis = [&](int first) { return static_cast<std::size_t>(number - first); };
    if (is_in(number, 5420, 9))
        return MachineValue{state.position[axis(5420)], state.is_known(axis(5420))};
    // A probe always makes contact in the simulation.
    const bool has_probed = (*view.store)->has_probed;
    if (is_in(number, 5061, 9)) return MachineValue{(*view.store)->probed[axis(5061)], has_probed};
    if (number == 5070) return MachineValue{1.0, has_probed};
    if (const std::optional<MachineValue> offset = offset_value(number)) return offset;
    if (number == 5400) return MachineValue{static_cast<double>(state.tool), state.tool != 0};
    if (is_in(number, 5401, 9)) {
        return MachineValue{state.frames.tool_offset[axis(5401)] * state.unit_mm(),
                            state.length_register == kNoLength || state.length_specified};
    }
    if (number == 5410) return MachineValue{2.0 * state.cutter_radius * state.unit_mm()};
    if (rules_.strict) return std::nullopt;
    return fanuc_variable(number);
}

std::optional<double> Parameters::numbered(double number) const {
    const int n = to_index(number, rules_.strict);
    if (n < 0 || (n == 0 && rules_.strict) || is_hidden(number)) return std::nullopt;
    if (n == 0) return empty();
    const auto i = static_cast<std::size_t>(n);
    bool is_set = i <= kLocals ? locals_set_[i] : i < is_set_.size() && is_set_[i] != 0;
    double value = i <= kLocals ? locals_[i] : i < numbers_.size() ? numbers_[i] : empty();
    if (n >= 4001 && !is_set) {
        if (const std::optional<MachineValue> shown = machine_value(n)) {
            value = shown->value;
            is_set = shown->is_known;
        }
    }
    if (!is_set || !computed_from_.empty())
        note_read(std::string("#").append(std::to_string(n)), is_set);
    return value;
}

/// True for positions while cutter compensation is on: LinuxCNC refuses to read the position then.
bool Parameters::is_hidden(double number) const {
    return rules_.strict && is_in(to_index(number, true), 5420, 9) &&
           view.state->cutter_side != CutterSide::Off;
}

bool Parameters::is_read_only(double number) {
    const int n = to_index(number, false);
    return n == 0 || is_in(n, 5420, 9) || is_in(n, 5400, 14);
}

bool Parameters::set_numbered(double number, double value, std::string_view unknown) {
    const int n = to_index(number, rules_.strict);
    if (n < 1 || is_read_only(number)) return false;
    if (!unknown.empty() || !computed_from_.empty())
        keep_origin(std::string("#").append(std::to_string(n)), unknown);
    const auto i = static_cast<std::size_t>(n);
    if (i <= kLocals) {
        locals_[i] = value;
        locals_set_[i] = true;
        return true;
    }
    if (i >= numbers_.size()) {
        numbers_.resize(i + 100, empty());
        is_set_.resize(i + 100, 0);
    }
    numbers_[i] = value;
    is_set_[i] = 1;
    return true;
}

bool Parameters::specify(std::string_view name, double value) {
    if (name.starts_with("#<") && name.ends_with('>'))
        return set_named(name.substr(2, name.size() - 3), value);
    if (!name.starts_with('#')) return false;
    const PlainNumber number = read_plain_number(name.data() + 1, name.data() + name.size());
    return number.end == name.data() + name.size() && set_numbered(number.value, value);
}

void Parameters::show_machine(int number) {
    const auto i = static_cast<std::size_t>(number);
    if (i < is_set_.size()) is_set_[i] = 0;
}

/// Returns the value of a predefined name such as #<_x>. Names of LinuxCNC's configuration
/// ("_ini[…]", "_hal[…]") are missing because their values do not follow from the program.
std::optional<Parameters::MachineValue> Parameters::predefined(std::string_view name) const {
    const MachineState& s = *view.state;
    constexpr std::string_view kNames = "xyzabcuvw";
    const auto axis_of = [&](char c) { return kNames.find(c); };
    if (name.size() == 2 && name[0] == '_' && axis_of(name[1]) != std::string_view::npos) {
        return MachineValue{s.position[axis_of(name[1])], s.is_known(axis_of(name[1]))};
    }
    if (name.size() == 6 && name.starts_with("_abs_") &&
        axis_of(name[5]) != std::string_view::npos) {
        const std::size_t a = axis_of(name[5]);
        const FrameStack& f = s.frames;
        if (f.rotation == 0.0 || a > kY) {
            return MachineValue{
                s.position[a] + f.offset_92[a] + f.work_offset[a] + f.tool_offset[a],
                s.is_known(a) && s.frame[a > kZ ? std::size_t{kZ} : a] == 0};
        }
        return std::nullopt;  // Depends on the rotation; not computed.
    }
    struct Entry {
        std::string_view name;
        double value;
    };
    const auto flag = [](bool b) { return b ? 1.0 : 0.0; };
    const Entry entries[] = {
        {"_metric", flag(!s.inches)},
        {"_imperial", flag(s.inches)},
        {"_absolute", flag(!s.incremental)},
        {"_incremental", flag(s.incremental)},
        {"_feed", s.feed},
        {"_rpm", s.spindle_rpm},
        {"_current_tool", static_cast<double>(s.tool)},
        {"_selected_tool", static_cast<double>(std::max(s.selected_tool, 0))},
        {"_selected_pocket", static_cast<double>(std::max(s.selected_tool, 0))},
        {"_current_pocket", static_cast<double>(s.tool)},
        {"_motion_mode", static_cast<double>(tenths_of(s.motion))},
        {"_plane", 170.0 + 10.0 * (static_cast<int>(s.plane) % 3)},
        {"_coord_system", s.system <= 6 ? 530.0 + 10.0 * s.system : 584.0 + s.system},
        {"_ccomp", s.cutter_side == CutterSide::Off    ? 400.0
                   : s.cutter_side == CutterSide::Left ? 410.0
                                                       : 420.0},
        {"_units_per_minute", flag(s.feed_mode == FeedMode::PerMinute)},
        {"_inverse_time", flag(s.feed_mode == FeedMode::InverseTime)},
        {"_units_per_rev", flag(s.feed_mode == FeedMode::PerRevolution)},
        {"_spindle_on", flag(s.spindle != SpindleTurning::Stopped)},
        {"_spindle_cw", flag(s.spindle == SpindleTurning::Clockwise)},
        {"_ijk_absolute_mode", flag(s.absolute_centres)},
        {"_lathe_diameter_mode", flag(s.lathe_diameter)},
        {"_lathe_radius_mode", flag(!s.lathe_diameter)},
        {"_retract_r_plane", flag(s.retract_to_r)},
        {"_retract_old_z", flag(!s.retract_to_r)},
        {"_spindle_rpm_mode", flag(!s.constant_surface_speed)},
        {"_spindle_css_mode", flag(s.constant_surface_speed)},
        {"_task", 0.0},
        {"_call_level", static_cast<double>(view.call_level)},
        {"_remap_level", 0.0},
        {"_vmajor", 2.9},
        {"_vminor", 0.0},
        {"_line", static_cast<double>(view.line)},
        {"_flood", 0.0},
        {"_mist", 0.0},
        {"_speed_override", 1.0},
        {"_feed_override", 1.0},
        {"_adaptive_feed", 0.0},
        {"_feed_hold", 0.0},
        {"_value", view.return_value},
        {"_value_returned", flag(view.has_return_value)},
    };
    const auto* found = std::ranges::find(entries, name, &Entry::name);
    if (found == std::end(entries)) return std::nullopt;
    return MachineValue{found->value};
}

std::optional<double> Parameters::named(std::string_view name) const {
    const bool global = name.starts_with('_');
    const auto& names = global ? global_names_ : local_names_;
    const auto key = [&] { return std::string("#<").append(name).append(">"); };
    if (const auto found = names.find(name); found != names.end()) {
        if (!computed_from_.empty()) note_read(key(), true);
        return found->second;
    }
    if (!global) return std::nullopt;
    const std::optional<MachineValue> shown = predefined(name);
    if (!shown || !shown->is_known) note_read(key(), false);
    if (!shown) return std::nullopt;
    return shown->value;
}

bool Parameters::set_named(std::string_view name, double value, std::string_view unknown) {
    const bool global = name.starts_with('_');
    if (rules_.strict && global && name != "_value" && predefined(name)) return false;
    if (!unknown.empty() || !computed_from_.empty())
        keep_origin(std::string("#<").append(name).append(">"), unknown);
    auto& names = global ? global_names_ : local_names_;
    if (const auto found = names.find(name); found != names.end()) {
        found->second = value;
        return true;
    }
    if (names.size() >= kMaxNames) return false;
    names.emplace(name, value);
    return true;
}

namespace {

/// True for "#1" … `count` and for names that are local to a subroutine.
bool is_local(std::string_view key, std::size_t count) {
    if (key.starts_with("#<")) return !key.starts_with("#<_");
    const PlainNumber number = read_plain_number(key.data() + 1, key.data() + key.size());
    return number.value <= static_cast<double>(count);
}

}  // namespace

Parameters::Locals Parameters::take_locals(std::size_t count) {
    Locals saved;
    saved.names.swap(local_names_);
    saved.numbers = locals_;
    saved.is_set = locals_set_;
    for (auto it = computed_from_.begin(); it != computed_from_.end();) {
        auto here = it++;
        if (is_local(here->first, count)) saved.computed_from.insert(computed_from_.extract(here));
    }
    // A called program starts with the arguments and no other local variables, so all locals are
    // known.
    std::fill_n(locals_.begin() + 1, count, empty());
    std::fill_n(locals_set_.begin() + 1, count, true);
    return saved;
}

void Parameters::restore_locals(Locals locals, std::size_t count) {
    local_names_ = std::move(locals.names);
    std::copy_n(locals.numbers.begin() + 1, count, locals_.begin() + 1);
    std::copy_n(locals.is_set.begin() + 1, count, locals_set_.begin() + 1);
    std::erase_if(computed_from_, [&](const auto& e) { return is_local(e.first, count); });
    computed_from_.merge(locals.computed_from);
}

}  // namespace ncsim::gcode
