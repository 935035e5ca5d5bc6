// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/parameters.h"

#include "control/codes.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {
namespace {

constexpr int kMaxNumber = 99'999;
constexpr int kMaxStrict = 5602;
/// More names than any program uses; a loop that makes names stops here.
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

void Parameters::set_rules(bool vacant, bool strict) {
    vacant_ = vacant;
    strict_ = strict;
    locals_.fill(empty());
}

/// #5061 … #5599 of RS274/NGC; #5001 … #5064 and #4001 … of Fanuc where RS274/NGC has nothing.
std::optional<double> Parameters::of_machine(int number) const {
    const MachineState& state = *view.state;
    const auto axis = [&](int first) { return static_cast<std::size_t>(number - first); };
    if (is_in(number, 5420, 9)) return state.position[axis(5420)];
    if (is_in(number, 5061, 9)) return (*view.store)->probed[axis(5061)];
    if (number == 5070) return 1.0;  // a probe always makes contact here
    if (is_in(number, 5161, 9)) return (*view.store)->homes[0][axis(5161)];
    if (is_in(number, 5181, 9)) return (*view.store)->homes[1][axis(5181)];
    if (number == 5210) return state.offset_92_active ? 1.0 : 0.0;
    if (is_in(number, 5211, 9)) return (*view.store)->stored_92[axis(5211)];
    if (number == 5220) return state.system;
    if (is_in(number, 5221, 180)) {
        const int system = (number - 5221) / 20;
        const int item = (number - 5221) % 20;
        const WorkOffset& offset = (*view.store)->work_offsets[static_cast<std::size_t>(system)];
        if (item < 9) return offset.origin[static_cast<std::size_t>(item)];
        if (item == 9) return offset.rotation;
    }
    if (number == 5400) return state.tool;
    if (is_in(number, 5401, 9)) return state.tool_offset[axis(5401)] * state.unit_mm();
    if (number == 5410) return 2.0 * state.cutter_radius * state.unit_mm();
    if (strict_) return std::nullopt;

    if (is_in(number, 5001, 9)) return state.position[axis(5001)];
    if (is_in(number, 5041, 9)) return state.position[axis(5041)];
    if (is_in(number, 5021, 9)) {
        const std::size_t a = axis(5021);
        return state.position[a] + state.offset_92[a] + state.work_offset[a] + state.tool_offset[a];
    }
    switch (number) {
        case 4001: return std::max(tenths_of(state.motion), 0) / 10.0;
        case 4003: return state.incremental ? 91.0 : 90.0;
        case 4006: return state.inches ? 20.0 : 21.0;
        case 4009:
        case 4109: return state.feed;
        case 4014: return 53.0 + state.system;
        case 4119: return state.spindle_rpm;
        case 4120: return state.tool;
        default: return std::nullopt;
    }
}

std::optional<double> Parameters::numbered(double number) const {
    const int n = to_index(number, strict_);
    if (n < 0 || (n == 0 && strict_)) return std::nullopt;
    if (n == 0) return empty();
    if (n <= static_cast<int>(kLocals)) return locals_[static_cast<std::size_t>(n)];
    if (n >= 4001) {
        if (const std::optional<double> shown = of_machine(n)) return shown;
    }
    const auto i = static_cast<std::size_t>(n);
    return i < numbers_.size() ? numbers_[i] : empty();
}

bool Parameters::is_read_only(double number) {
    const int n = to_index(number, false);
    return n == 0 || is_in(n, 5420, 9) || is_in(n, 5400, 14);
}

bool Parameters::set_numbered(double number, double value) {
    const int n = to_index(number, strict_);
    if (n < 1 || is_read_only(number)) return false;
    const auto i = static_cast<std::size_t>(n);
    if (i <= kLocals) {
        locals_[i] = value;
        return true;
    }
    if (i >= numbers_.size()) numbers_.resize(i + 100, empty());
    numbers_[i] = value;
    return true;
}

namespace {

/// #<_x> and its kin. Names that only LinuxCNC's configuration knows ("_ini[…]", "_hal[…]") are not
/// here: nobody can know their values from the program.
std::optional<double> predefined(std::string_view name, const MachineView& view) {
    const MachineState& s = *view.state;
    constexpr std::string_view kNames = "xyzabcuvw";
    const auto axis_of = [&](char c) { return kNames.find(c); };
    if (name.size() == 2 && name[0] == '_' && axis_of(name[1]) != std::string_view::npos) {
        return s.position[axis_of(name[1])];
    }
    if (name.size() == 6 && name.starts_with("_abs_") &&
        axis_of(name[5]) != std::string_view::npos) {
        const std::size_t a = axis_of(name[5]);
        if (s.rotation == 0.0 || a > kY) {
            return s.position[a] + s.offset_92[a] + s.work_offset[a] + s.tool_offset[a];
        }
        return std::nullopt;  // rotated: computed by the machine
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
    return found->value;
}

}  // namespace

std::optional<double> Parameters::named(std::string_view name) const {
    const bool global = name.starts_with('_');
    const auto& names = global ? global_names_ : local_names_;
    if (const auto found = names.find(name); found != names.end()) return found->second;
    if (global) return predefined(name, view);
    return std::nullopt;
}

bool Parameters::set_named(std::string_view name, double value) {
    const bool global = name.starts_with('_');
    if (strict_ && global && name != "_value" && predefined(name, view)) return false;
    auto& names = global ? global_names_ : local_names_;
    if (const auto found = names.find(name); found != names.end()) {
        found->second = value;
        return true;
    }
    if (names.size() >= kMaxNames) return false;
    names.emplace(name, value);
    return true;
}

Parameters::Locals Parameters::take_locals(std::size_t count) {
    Locals saved;
    saved.names.swap(local_names_);
    saved.numbers = locals_;
    std::fill_n(locals_.begin() + 1, count, empty());
    return saved;
}

void Parameters::restore_locals(Locals locals, std::size_t count) {
    local_names_ = std::move(locals.names);
    std::copy_n(locals.numbers.begin() + 1, count, locals_.begin() + 1);
}

}  // namespace ncsim::gcode
