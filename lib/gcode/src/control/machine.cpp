// SPDX-License-Identifier: GPL-3.0-or-later
//
// Order of execution, and modes.
#include "control/machine.h"

#include "ncsim/base/angles.h"
#include "ncsim/gcode/print.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ncsim::gcode {
namespace {

Axes to_axes(const Position& p) {
    return {p.x.mm(),      p.y.mm(), p.z.mm(), p.a.degrees(), p.b.degrees(),
            p.c.degrees(), p.u.mm(), p.v.mm(), p.w.mm()};
}

}  // namespace

Machine::Machine(const InterpreterOptions& options, const Rules& rules, ArcCentres& centres,
                 DiagnosticLog& log, Path& path, Parameters& parameters)
    : options_(options),
      rules_(rules),
      centres_(centres),
      log_(log),
      path_(path),
      parameters_(parameters),
      compensation_(control_.compensation, path, log) {
    Store& store = control_.store.change();
    store.tools = options.tools;
    for (std::size_t i = 0; i < store.work_offsets.size(); ++i) {
        store.work_offsets[i].origin = to_axes(options.work_offsets[i]);
        const bool known = options.work_offsets_specified[i];
        store.work_offsets[i].frame.fill(known ? 0 : static_cast<int>(i) + 1);
    }
    for (const auto& [number, origin] : options.extended_offsets)
        store.extended[number].origin = to_axes(origin);
    for (std::size_t i = 0; i < store.homes.size(); ++i)
        store.homes[i] = to_axes(options.homes[i]);
    for (const auto& [number, radius] : options.compensation) {
        if (ToolTableEntry* entry = register_of(number))
            entry->diameter = Length::from_mm(2.0 * radius.mm());
        unread_registers_.insert(number);
    }
    state_.inches = options.default_units == DefaultUnits::Inches;
    state_.retract_to_r = options.starts_with_g99.value_or(rules.is_linuxcnc());
    state_.chosen = state_.coordinates = options.tip_control.at_start;
    compensation_.set_linuxcnc(rules.is_linuxcnc());
    use_system({});  // G54, with the axes at home.
    parameters_.view.state = &state_;
    parameters_.view.store = &control_.store;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!options.start[i]) continue;
        state_.position[i] = options.start[i]->mm() / state_.unit_mm();
        mark_known(i);
    }
    state_.is_at_start = !options.start_is_of_machine;
}

/// Marks the position of `axis` as known in the active system.
void Machine::mark_known(std::size_t axis) {
    state_.place_frame[axis] = state_.frame[axis];
    state_.known[axis] = true;
}

void Machine::report_to(Interpretation& result) const {
    result.uses_length_offsets = uses_length_offsets_;
    result.requested_tip_positions = requested_tip_positions_;
    result.setting_askew = setting_askew_;
    result.unread_registers = unread_registers_;
    result.distance_guess = distance_guess();
    result.units_stated = state_.units_stated;
    result.uses_inches = state_.first_length_seen ? state_.first_length_in_inches : state_.inches;
}

/// Returns the first move before G90 and G91 if neither the control nor the values determine the
/// mode.
std::optional<ProgramPlace> Machine::distance_guess() const {
    const bool starts_absolute = rules_.is_linuxcnc() || rules_.dialect == Dialect::Grbl ||
                                 rules_.dialect == Dialect::Haas ||
                                 rules_.dialect == Dialect::Heidenhain ||
                                 rules_.dialect == Dialect::Sinumerik;
    if (starts_absolute || distance_.is_certain || distance_.are_places()) return std::nullopt;
    return distance_.first;
}

void Machine::set_origin(SourceSpan span, std::uint32_t file) {
    span_ = span;
    file_ = file;
    path_.set_origin(span, file);
}

/// Makes a move of the programmed path, with or without cutter compensation.
bool Machine::feed_straight(const Axes& end, MoveKind kind, AxisMask mask) {
    if (outline_) {
        outline_->is_foreign |= kind != MoveKind::Feed;
        return record_outline_move(end, nullptr);
    }
    if (compensation_.is_entering() && rules_.is_linuxcnc()) {
        const PlaneAxes axes = axes_of(state_.plane);
        if (end[axes.first] == state_.position[axes.first] &&
            end[axes.second] == state_.position[axes.second])
            return fail(Message::CompensationEntry, span_);
    }
    state_.just_left_compensation = false;
    if (compensation_.is_on())
        return compensation_.linear_move(state_, end, kind, mask, span_, file_);
    path_.linear_move(state_, with_cancelled_offset(end, mask), kind, mask);
    return true;
}

/// Returns `end` plus the offset that remains after G40: the first move in the plane after G40 ends
/// at the programmed point along both axes of the plane.
Axes Machine::with_cancelled_offset(const Axes& end, AxisMask mask) {
    const PlaneAxes axes = axes_of(state_.plane);
    const auto moves = [mask](std::size_t axis) { return (mask >> axis & 1U) != 0; };
    if (!moves(axes.first) && !moves(axes.second)) return end;
    Axes target = end;
    for (const std::size_t axis : {axes.first, axes.second}) {
        if (!moves(axis) || state_.incremental) target[axis] += state_.uncancelled[axis];
    }
    state_.uncancelled = {};
    return target;
}

bool Machine::execute(const Command& command) {
    if (control_.corner && !continues_from_corner(command)) settle_corner();
    flush_held(command);
    const ControlState before = control_;
    const std::uint64_t motions = path_.count();
    curve_fails_ = false;
    if (act(command)) return true;
    if (outline_) outline_->is_foreign = true;
    if (path_.count() == motions) restore(before);  // Motions that were made cannot be undone.
    if (curve_fails_) control_.curve = {};
    return false;
}

/// Restores the control to `before`.
/// Requires: the path has made no motion since `before`.
void Machine::restore(const ControlState& before) {
    for (std::size_t i = 0; i < 3; ++i) {
        const double shift = before.machine.frame_shift[i] - state_.frame_shift[i];
        if (shift != 0.0) path_.shift_unspecified(i, shift);
    }
    control_ = before;
}

/// True if the words of `command` that select a plane, a system or a length change none of the
/// three. Cutter compensation continues across such words.
bool Machine::keeps_frame(const Command& command) const {
    const Code system = command.group(Group::WorkOffset);
    const bool by_number = system == Code::G54_1 || system == Code::G154 ||
                           (command.has('P') && !has_other_use(command, 'P'));
    if (system != Code::None && (by_number || system_of(system) != state_.system)) return false;
    if (const std::optional<Plane> plane = plane_of(command); plane && *plane != state_.plane)
        return false;
    switch (command.group(Group::ToolLength)) {
        case Code::None: return true;
        case Code::G49:
            return state_.length_register == kNoLength && state_.frames.tool_offset == Axes{};
        case Code::G43: return is_length_active(command);
        default: return false;
    }
}

/// True if G43 of `command` selects the active length with the same value.
bool Machine::is_length_active(const Command& command) const {
    const int h = length_number(command);
    if (state_.length_register != h || state_.tip_by_length) return false;
    Axes offset{};
    const auto entry = std::ranges::find(control_.store->tools, h, &ToolTableEntry::number);
    for (std::size_t i = 0; entry != control_.store->tools.end() && i < 3; ++i)
        offset[i] = entry->offset[i].mm() / state_.unit_mm();
    return offset == state_.frames.tool_offset;
}

std::optional<Plane> Machine::plane_of(const Command& command) {
    switch (command.group(Group::Plane)) {
        case Code::G17: return Plane::XY;
        case Code::G18: return Plane::ZX;
        case Code::G19: return Plane::YZ;
        case Code::G17_1: return Plane::UV;
        case Code::G18_1: return Plane::WU;
        case Code::G19_1: return Plane::VW;
        default: return std::nullopt;
    }
}

/// Makes a move held back by cutter compensation before a command that interrupts compensation.
void Machine::flush_held(const Command& command) {
    if (!compensation_.is_on()) return;
    const Code one_shot = command.group(Group::OneShot);
    const int stop = command.group(MGroup::Stop);
    const bool changes_nothing = one_shot == Code::None || one_shot == Code::G4 ||
                                 (one_shot == Code::G10 && !sets_active_data(command));
    if (!changes_nothing || !keeps_frame(command) ||
        command.group(Group::TiltedPlane) != Code::None ||
        command.group(Group::PolarInterpolation) != Code::None ||
        command.group(Group::Orient) != Code::None ||
        command.group(Group::DynamicOffset) != Code::None ||
        command.group(MGroup::ToolChange) != kNone || command.group(MGroup::Kinematics) != kNone ||
        stop == 2 || stop == 30) {
        compensation_.flush(state_);
        path_.set_origin(span_, file_);
    } else if (command.group(Group::CutterSide) == Code::G40) {
        compensation_.finish_held();
        path_.set_origin(span_, file_);
    }
}

bool Machine::act(const Command& command) {
    if (const Code code = command.group(Group::Unsupported); code != Code::None) {
        stopped_ = true;
        const bool of_tip = code == Code::G43_4 || code == Code::G43_5 || code == Code::G234;
        if (of_tip) {
            return fail(options_.joints ? Message::TipFrameMissing : Message::RotaryUnspecified,
                        command.span, {name_of(code)});
        }
        const bool lathe = code >= Code::G70 && code < Code::G73;
        return fail(lathe ? Message::LatheCycle : Message::TiltedPlane, command.span,
                    {name_of(code)});
    }
    if (const Code code = command.group(Group::NotSimulated); code != Code::None)
        return fail(Message::NotSimulated, span_of_g(command, code), {name_of(code)});
    if (!check(command) || !check_plane(command) || !check_dynamic_offset(command)) return false;
    if (command.corner != 0 && !ends_in_corner(command)) {
        return fail(Message::CornerWord, command.corner_span, {corner_name(command.corner)});
    }
    if (command.has_angle && !ends_in_corner(command))
        return fail(Message::CornerWord, command.angle_span, {",A"});
    // On most controls G20 F10 is 10 inches per minute; RS274/NGC reads F before G20.
    const Code units = command.group(Group::Units);
    const auto switch_units = [&] {
        if (units != Code::None) set_units(units == Code::G20 || units == Code::G70);
    };
    if (!rules_.is_linuxcnc()) switch_units();
    if (!set_feed(command)) return false;
    set_speeds_and_tools(command);
    if (needs_kinematics(command)) {
        stopped_ = true;
        return fail(Message::KinematicsUnspecified, command.span,
                    {std::string("M").append(std::to_string(state_.kinematics))});
    }
    if (command.group(Group::OneShot) == Code::G4 && !dwell(command)) return false;
    if (const std::optional<Plane> plane = plane_of(command)) state_.plane = *plane;
    if (rules_.is_linuxcnc()) switch_units();
    // G41 in the block of G150 applies to the pocket only.
    const bool for_pocket = command.group(Group::Pocket) == Code::G150;
    if ((!for_pocket && !set_cutter_side(command)) || !set_tool_length(command) ||
        !set_work_offset(command)) {
        return false;
    }
    set_modes(command);
    if (!set_programmed(command) || !set_plane(command) || !apply_dynamic_offset(command) ||
        !polar_interpolation(command) || !cylinder(command) || !orient(command) ||
        !check_tip_control(command) || !one_shot(command)) {
        return false;
    }
    if (!move(command, command.group(Group::Motion))) return false;
    if (command.group(MGroup::Stop) != kNone) stop(command);
    return true;
}

// --- Faults ---

SourceSpan Machine::span_of(const Command& command, char letter) const {
    const Word* word = find_word(*command.block, letter);
    return word ? word->span : command.span;
}

SourceSpan Machine::span_of_g(const Command& command, Code code) const {
    for (const Word& word : command.block->words) {
        if (word.letter == 'G' && word.literal &&
            std::lround(word.number * 10) == tenths_of(code)) {
            return word.span;
        }
    }
    return command.span;
}

bool Machine::fail(const MessageText& message, SourceSpan span,
                   std::initializer_list<std::string_view> arguments) {
    log_.add(Severity::Error, message, span, arguments);
    return false;
}

void Machine::warn(const MessageText& message, SourceSpan span,
                   std::initializer_list<std::string_view> arguments) {
    log_.add(message, span, arguments);
}

bool Machine::tolerate(const MessageText& message, SourceSpan span,
                       std::initializer_list<std::string_view> arguments) {
    if (rules_.strict) return fail(message, span, arguments);
    log_.add(Severity::Warning, message, span, arguments);
    return true;
}

/// Checks that RS274/NGC makes before executing the block.
bool Machine::check(const Command& command) {
    const Code motion = command.group(Group::Motion);
    const Code one_shot = command.group(Group::OneShot);
    const bool takes_axes = one_shot != Code::None && entry_of(one_shot).takes_axes;
    if (takes_axes && motion != Code::None && motion != Code::G80 && rules_.strict) {
        return fail(Message::TwoCodesUseAxes, span_of_g(command, one_shot), {name_of(one_shot)});
    }
    if (rules_.strict) {
        const std::string_view forbidden = forbidden_with_compensation(command);
        if (!forbidden.empty())
            return fail(Message::ForbiddenWithCompensation, command.span, {forbidden});
        if (!check_strict(command)) return false;
    } else if (!check_compensation(command)) {
        return false;
    }
    return check_corner_words(command) && check_unused_words(command);
}

/// Reports "G1 X50. R2." and "X50. C4.": corners in the form of lathe controls; mill controls of
/// the same makers require a comma.
bool Machine::check_corner_words(const Command& command) {
    if (!rules_.corner_words || !is_line(command) || state_.polar_interpolation) return true;
    if (command.has('R') && command['R'] != 0.0)
        return fail(Message::CornerWithoutComma, span_of(command, 'R'), {"R", "R", ""});
    if (!command.has('C') || !rules_.c_may_be_corner) return true;
    return fail(Message::CornerWithoutComma, span_of(command, 'C'),
                {"C", "C", ", or begin with C0. if it is an axis"});
}

/// Reports words that no code of the block uses. RS274/NGC refuses such words. Other controls
/// ignore the words, which may then hide a missing code.
bool Machine::check_unused_words(const Command& command) {
    constexpr std::string_view kParameters = "DEHIJKLPQR";
    if (!command.has_any(letters('D', 'E', 'H', 'I', 'J', 'K', 'L', 'P', 'Q', 'R'))) return true;
    Code motion = command.group(Group::Motion);
    if (motion == Code::None && (command.axis_words || is_modal_arc(command)))
        motion = state_.motion;
    // On other controls, register words are allowed anywhere, ignored codes may have words, and
    // cycles have further words.
    const bool lax = !rules_.strict;
    const bool user_m = command.has_m;  // M66 P, M61 Q, M68 E, and M codes of the user.
    std::uint32_t used = !user_m ? 0U
                         : lax   ? letters('E', 'L', 'P', 'Q', 'R')
                                 : letters_of_m(command);
    bool others = user_m || command.has_others || control_.curve.by_knots ||
                  command.group(MGroup::ToolChange) != kNone ||
                  command.group(Group::HolePattern) != Code::None;
    const auto use = [&](Code code) {
        if (code == Code::None) return;
        used |= entry_of(code).letters;
        others |= entry_of(code).has_other_letters;
    };
    use(motion);
    std::ranges::for_each(command.g, use);
    if (state_.by_vector) used |= letters('I', 'J', 'K');
    if (lax) used |= letters('D', 'E', 'H');
    if (lax && others) return true;
    for (const char& letter : kParameters) {
        if (!command.has(letter) || (used >> letter_index(letter) & 1U) != 0) continue;
        if (!tolerate(Message::WordUnused, span_of(command, letter), {{&letter, 1}})) return false;
    }
    return true;
}

// --- Modes ---

bool Machine::set_feed(const Command& command) {
    const Code mode = command.group(Group::Feed);
    if (mode != Code::None) {
        const FeedMode before = state_.feed_mode;
        state_.feed_mode = mode == Code::G93   ? FeedMode::InverseTime
                           : mode == Code::G94 ? FeedMode::PerMinute
                                               : FeedMode::PerRevolution;
        // A feed in the unit of a different mode is not a valid feed.
        if (before != state_.feed_mode || rules_.strict) {
            state_.feed = 0.0;
            // G93 of LinuxCNC keeps the number of the last F.
            if (mode != Code::G93) control_.feed_word = 0.0;
        }
    }
    if (command.has('F') && letter_of_dwell(command) != 'F') {
        if (command['F'] < 0.0) return fail(Message::NegativeValue, span_of(command, 'F'), {"F"});
        state_.feed = command['F'];
        control_.feed_word = state_.feed;
    }
    return true;
}

void Machine::set_speeds_and_tools(const Command& command) {
    if (const Code mode = command.group(Group::SpindleSpeed); mode != Code::None) {
        state_.constant_surface_speed = mode == Code::G96;
    }
    if (command.has('S') && letter_of_dwell(command) != 'S')
        state_.spindle_rpm = std::abs(command['S']);
    if (command.has('T')) {
        state_.selected_tool = static_cast<int>(std::clamp(command['T'], -1.0, 1e9));
    }
    const int change = command.group(MGroup::ToolChange);
    if (change == 6 && state_.selected_tool >= 0) {
        state_.tool = state_.selected_tool;
        if (command.next_tool >= 0.0) {
            state_.selected_tool = static_cast<int>(std::min(command.next_tool, 1e9));
        }
        state_.spindle = SpindleTurning::Stopped;
        state_.tool_length = gauge_length();
        path_.tool_change(state_);
    } else if (change == 61 && command.has('Q')) {
        state_.tool = static_cast<int>(std::clamp(command['Q'], 0.0, 1e9));
        state_.tool_length = gauge_length();
        path_.tool_change(state_);
    }
    if (const int spindle = command.group(MGroup::Spindle); spindle != kNone) {
        state_.spindle_in_doubt = false;
        state_.spindle_oriented = spindle == 19;
    }
    switch (command.group(MGroup::Spindle)) {
        case 3:
        case 13: state_.spindle = SpindleTurning::Clockwise; break;
        case 4:
        case 14: state_.spindle = SpindleTurning::Counterclockwise; break;
        case 5:
        // M19 holds the spindle in a direction.
        case 19: state_.spindle = SpindleTurning::Stopped; break;
        default: break;
    }
    set_coolant(command);
    for (const int code : command.clamps) {
        for (const RotaryClamp& clamp : options_.clamps) {
            const auto axis = static_cast<std::size_t>(clamp.letter - 'A');
            if (clamp.clamp == code) state_.clamped[axis] = true;
            if (clamp.release == code) state_.clamped[axis] = false;
        }
    }
    if (const int code = command.group(MGroup::Kinematics); code != kNone) {
        const auto specified = options_.tip_control.m_codes.find(code);
        const bool is_specified = specified != options_.tip_control.m_codes.end();
        state_.kinematics = is_specified ? 0 : code;
        state_.tip_by_length = false;
        if (is_specified) choose(specified->second);
    }
}

void Machine::set_coolant(const Command& command) {
    const int spindle = command.group(MGroup::Spindle);
    if (spindle == 13 || spindle == 14) state_.coolant.flood = true;
    switch (command.group(MGroup::Coolant)) {
        case 7: state_.coolant.mist = true; break;
        case 8: state_.coolant.flood = true; break;
        case 9: state_.coolant = {}; break;
        default: break;
    }
    if (command.mist_and_flood) state_.coolant = {.mist = true, .flood = true};
}

/// True if a rotary axis is not at 0.
bool Machine::is_turned() const {
    const Axes at = machine_position();
    return at[kA] != 0.0 || at[kB] != 0.0 || at[kC] != 0.0;
}

/// Reports codes that would move incorrectly under tip control with the tool tilted.
bool Machine::check_tip_control(const Command& command) {
    if (state_.coordinates != Coordinates::Tip || !command.axis_words || command.axes_are_taken())
        return true;
    if (const Code motion = command.group(Group::Motion);
        state_.by_vector && (motion == Code::None ? state_.motion : motion) > Code::G1) {
        return fail(Message::TipControlForbids, command.span,
                    {name_of(motion == Code::None ? state_.motion : motion)});
    }
    // In a tilted plane, cycles, arcs and compensation use X, Y and Z of the plane.
    if (state_.frames.tilt) return true;
    bool turns = is_turned();
    for (const char letter : {'A', 'B', 'C'})
        turns |= command.has(letter) && command[letter] != 0.0;
    if (!turns) return true;
    const Code motion = command.group(Group::Motion);
    const Code now = motion == Code::None ? state_.motion : motion;
    std::string_view what;
    if (is_cycle(now)) {
        what = name_of(now);
    } else if (command.group(Group::Pocket) != Code::None) {
        what = name_of(command.group(Group::Pocket));
    } else if (command.group(Group::HolePattern) != Code::None) {
        what = name_of(command.group(Group::HolePattern));
    } else if (state_.cutter_side != CutterSide::Off) {
        what = state_.cutter_side == CutterSide::Left ? "G41" : "G42";
    } else if (state_.frames.programmed.changes_places()) {
        what = state_.frames.programmed.rotated ? "G68" : "G51";
    } else if (state_.frames.programmed.polar) {
        what = "G16";
    }
    return what.empty() || fail(Message::TipControlForbids, command.span, {what});
}

/// True if the position of the tip depends on an M428 or similar code whose kinematics are
/// unspecified. If no rotary axis has turned, the kinematics do not matter.
bool Machine::needs_kinematics(const Command& command) {
    if (state_.kinematics == 0) return false;
    return command.has_any(letters('A', 'B', 'C')) || is_turned();
}

namespace {

/// Converts all lengths of `state`; `factor` = new value / old value.
void convert_units(MachineState& state, double factor) {
    scale_lengths(state.position, factor);
    scale_lengths(state.uncancelled, factor);
    state.frames.scale_lengths(factor);
    state.cutter_radius *= factor;
    if (state.feed_mode != FeedMode::InverseTime) state.feed *= factor;
    if (state.cylinder) state.cylinder->radius *= factor;
    state.inches = !state.inches;
}

}  // namespace

void Machine::set_units(bool inches) {
    if (!state_.first_length_seen) state_.units_stated = true;
    if (inches == state_.inches) return;
    const double factor = inches ? 1.0 / 25.4 : 25.4;
    convert_units(state_, factor);
    compensation_.convert_units(factor,
                                [factor](MachineState& s) { gcode::convert_units(s, factor); });
    Store& store = control_.store.change();
    scale_lengths(store.probed, factor);
    scale_lengths(store.via, factor);
    for (std::size_t i = 0; store.specified_plane && i < 3; ++i)
        store.specified_plane->origin[i] *= factor;
}

void Machine::set_modes(const Command& command) {
    if (const Code g = command.group(Group::Distance); g != Code::None) {
        state_.incremental = g == Code::G91;
        if (!distance_is_stated_ && g == Code::G91) distance_.is_certain = true;
        distance_is_stated_ = true;
    }
    if (const Code g = command.group(Group::Centre); g != Code::None) {
        state_.absolute_centres = g == Code::G90_1;
        centres_.is_settled = true;
    }
    if (const Code g = command.group(Group::Retract); g != Code::None)
        state_.retract_to_r = g == Code::G99;
    if (const Code g = command.group(Group::Diameter); g != Code::None)
        state_.lathe_diameter = g == Code::G7;
}

/// Returns seconds. On Fanuc and similar controls P without a decimal point is in milliseconds.
double Machine::seconds_of(const Command& command, char letter) const {
    const double value = command[letter];
    if (!rules_.dwell_milliseconds || letter != 'P') return value;
    const Word* word = find_word(*command.block, letter);
    const bool has_point =
        word && command.block->text.substr(word->span.column - 1, word->span.length).find('.') !=
                    std::string_view::npos;
    return has_point ? value : value / 1000.0;
}

/// Returns the letter of the dwell time of G4; ' ': none. A word has a single meaning in a block,
/// so the word sets neither feed nor spindle speed.
char Machine::letter_of_dwell(const Command& command) const {
    if (command.group(Group::OneShot) != Code::G4) return ' ';
    for (const char letter : {'P', 'X', 'U', 'F', 'S'}) {
        if (command.has(letter) && (letter == 'P' || !rules_.strict)) return letter;
    }
    return ' ';
}

bool Machine::dwell(const Command& command) {
    const char letter = letter_of_dwell(command);
    if (letter == ' ') return tolerate(Message::DwellWithoutTime, span_of_g(command, Code::G4));
    const double seconds = seconds_of(command, letter);
    if (seconds < 0.0)
        return fail(Message::NegativeValue, span_of(command, letter), {{&letter, 1}});
    compensation_.dwell(state_, seconds, span_, file_);
    return true;
}

bool Machine::one_shot(const Command& command) {
    const Code code = command.group(Group::OneShot);
    switch (code) {
        case Code::None:
        case Code::G4:
        case Code::G53: return true;
        case Code::G10: return set_data(command);
        case Code::G28: return home(command, false);
        case Code::G29: return return_from_home(command);
        case Code::G30: return home(command, true);
        case Code::G28_1: return store_home(false), true;
        case Code::G28_2: return seek_home(command);
        case Code::G30_1: return store_home(true), true;
        default: return offset_92(command, code);
    }
}

void Machine::stop(const Command& command) {
    const int code = command.group(MGroup::Stop);
    if (code == 2 || code == 30) return finish();
    if (rules_.is_linuxcnc()) compensation_.finish_held();
    stop_at(code);
}

void Machine::stop_at(int code) {
    // M0, M1, M60. LinuxCNC and grbl keep the spindle on; other controls stop the spindle,
    // including Haas and most Fanuc machines.
    if (rules_.strict || rules_.dialect == Dialect::Grbl) return;
    const bool stops_it = rules_.dialect == Dialect::Fanuc || rules_.dialect == Dialect::Haas;
    if (stops_it && code != 1) {
        state_.spindle = SpindleTurning::Stopped;
    } else {
        // M1 stops only if the operator enabled M1.
        state_.spindle_in_doubt = state_.spindle != SpindleTurning::Stopped;
    }
}

void Machine::finish() {
    ended_ = true;
    compensation_.end(state_);
    end_polar_interpolation();
    end_plane();
    set_dynamic_offset(std::nullopt);
    state_.frames.dynamic_offset_home = {};
    state_.table_offset = 0;
    state_.cylinder.reset();
    select_system(1);
    state_.plane = Plane::XY;
    state_.incremental = false;
    state_.feed_mode = FeedMode::PerMinute;
    state_.feed = control_.feed_word = 0.0;
    state_.cutter_side = CutterSide::Off;
    state_.uncancelled = {};
    state_.spindle = SpindleTurning::Stopped;
    state_.coolant = {};
    state_.spindle_in_doubt = false;
    state_.spindle_oriented = false;
    state_.motion = Code::G1;
    state_.frames.programmed = {};
}

}  // namespace ncsim::gcode
