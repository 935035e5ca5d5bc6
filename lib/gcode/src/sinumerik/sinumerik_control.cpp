// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modes, tools, offsets, straight moves.
// Source: SINUMERIK 840D sl, Programming Manual Fundamentals, 06/2019.
#include "sinumerik/sinumerik_control.h"

#include "ncsim/base/angles.h"

#include "text/message.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ncsim::gcode::sinumerik {
namespace {

/// M codes that move no axis: gears, clamps, doors, chips.
bool moves_nothing(int m) {
    return (m >= 40 && m <= 45) || m == 70 || m == 17;
}

/// Reports words of arcs that a block of the motion mode `motion` in `plane` does not use.
void note_unused_words(const Words& words, int motion, Plane plane, SourceSpan span,
                       DiagnosticLog& log) {
    const auto note = [&](SourceSpan place, std::string_view name) {
        log.add(Severity::Warning, Message::WordUnused, place, {name});
    };
    const auto note_points = [&](const auto& points, std::string_view names) {
        for (const auto& point : points) {
            if (point) return note(point->span, names);
        }
    };
    const bool is_arc = motion == 2 || motion == 3;
    if (words.radius && !is_arc) note(span, "CR");
    if (words.opening && (!is_arc || words.radius)) note(span, "AR");
    if (words.turns && !is_arc) note(span, "TURN");
    if (motion != kCip) note_points(words.via, "I1, J1, K1");
    const PlaneAxes axes = axes_of(plane);
    const bool has_end = words.axis[axes.first] || words.axis[axes.second];
    if (!is_arc || words.radius || (words.opening && has_end))
        return note_points(words.centre, "I, J, K");
    if (const auto& centre = words.centre[axes.third]; centre && centre->value != 0.0) {
        const char letter = static_cast<char>('I' + static_cast<int>(axes.third));
        note(centre->span, {&letter, 1});
    }
}

}  // namespace

Control::Control(const InterpreterOptions& options, const std::array<RotaryWay, 3>& ways,
                 Controller& machine, DiagnosticLog& log, bool tool_word_changes)
    : BlockControl(options, machine, log), ways_(ways), tool_word_changes_(tool_word_changes) {
    is_feed_in_inches_ = options.default_units == DefaultUnits::Inches;
}

// --- Modes ---

std::vector<language::BlockControl::ActiveMode> Control::modes_left_on() const {
    std::vector<ActiveMode> modes;
    if (machine_.state().coordinates == Coordinates::Tip) modes.push_back({"TRAORI", "TRAFOOF"});
    if (!(swivel_ == Frame{})) modes.push_back({"CYCLE800", "CYCLE800()"});
    if (!(chain_ == Frame{})) modes.push_back({"a programmable frame", "TRANS"});
    if (side_ != CutterSide::Off) modes.push_back({"cutter compensation", "G40"});
    return modes;
}

std::vector<language::BlockControl::ActiveMode> Control::modes_at_change() const {
    std::vector<ActiveMode> modes;
    if (machine_.state().coordinates == Coordinates::Tip) modes.push_back({"TRAORI", "TRAFOOF"});
    if (side_ != CutterSide::Off) modes.push_back({"cutter compensation", "G40"});
    return modes;
}

bool Control::block(const Words& words, SourceSpan span) {
    if (!set_modes(words, span)) return false;
    if (words.of(CodeGroup::OneShot)) {
        if (!one_shot(words, span)) return false;
        return act_at_end(words, span);
    }
    Command command = make(span);
    if (!put_speeds(words, command, span) || !set_side(words, command, span)) return false;
    const auto is_set = [](const auto& word) { return word.has_value(); };
    const bool is_arc = motion_ == 2 || motion_ == 3;
    const bool moves = words.has_axes() ||
                       (is_arc && (words.opening || std::ranges::any_of(words.centre, is_set)));
    note_unused_words(words, motion_, plane_, span, log_);
    if (moves ? !move(words, command, span) : !run(command)) return false;
    return act_at_end(words, span);
}

/// Executes what acts before the move: units, plane, tools, systems, tip control.
bool Control::set_modes(const Words& words, SourceSpan span) {
    if (const auto code = words.of(CodeGroup::Units)) set_units(*code, span);
    if (const auto code = words.of(CodeGroup::Distance)) {
        is_incremental_ = *code == 91;
        Command command = make(span);
        // Increments are computed here; the machine gets positions.
        put(command, Code::G90);
        if (!run(command)) return false;
    }
    if (const auto code = words.of(CodeGroup::Corner)) goes_around_corners_ = *code == 450;
    if (const auto code = words.of(CodeGroup::Motion)) motion_ = *code;
    if (words.turns_by_vector) turns_by_vector_ = *words.turns_by_vector;
    if (words.modal_rounding) modal_rounding_ = *words.modal_rounding;
    if (words.modal_corner_feed) modal_corner_feed_ = *words.modal_corner_feed;
    if (const auto code = words.of(CodeGroup::Plane)) {
        const Plane plane = *code == 17 ? Plane::XY : *code == 18 ? Plane::ZX : Plane::YZ;
        if (plane != plane_) {
            plane_ = plane;
            tangent_.reset();
            if (chain_.turn != Frame::Turn{} && !apply_frame("a rotation", span)) return false;
        }
        Command command = make(span);
        put(command, *code == 17 ? Code::G17 : *code == 18 ? Code::G18 : Code::G19);
        if (!run(command)) return false;
    }
    if (words.tool || words.tool_name || words.edge || words.has_m(6)) {
        Command command = make(span);
        if (!set_tool(words, command, span)) return false;
        if (command.present != 0 || command.group(Group::ToolLength) != Code::None) {
            if (!run(command)) return false;
            refresh();
        }
    }
    if (const auto code = words.of(CodeGroup::System)) {
        if (!set_system(*code, span)) return false;
    }
    if (const auto code = words.of(CodeGroup::Transform)) {
        if (side_ != CutterSide::Off)
            return fail(Message::NotRead, span, {"TRAORI or TRAFOOF under G41 or G42"});
        Command command = make(span);
        put(command, MGroup::Kinematics, *code == kTraori ? 128 : 129);
        if (!run(command)) return false;
        refresh();
    }
    return true;
}

void Control::set_units(int code, SourceSpan span) {
    const bool inches = code == 70 || code == 700;
    is_feed_in_inches_ = code >= 700 ? inches : options_.default_units == DefaultUnits::Inches;
    if (is_feed_in_inches_ != inches && !is_feed_reported_) {
        is_feed_reported_ = true;
        log_.add(
            Message::FeedUnit, span,
            {inches ? "G70" : "G71", is_feed_in_inches_ ? "inch" : "mm", inches ? "G700" : "G710"});
    }
    Command command = make(span);
    put(command, inches ? Code::G20 : Code::G21);
    (void)run(command);
    refresh();
}

double Control::feed_of(double value) const {
    const bool inches = machine_.state().inches;
    if (inches == is_feed_in_inches_) return value;
    return inches ? value / 25.4 : value * 25.4;
}

bool Control::set_tool(const Words& words, Command& command, SourceSpan span) {
    std::optional<int> number;
    if (words.tool_name) {
        number = number_of(*words.tool_name);
        log_.add(Message::NamedTool, span,
                 {"\"" + *words.tool_name + "\"", std::to_string(*number)});
    } else if (words.tool) {
        const double whole = std::round(*words.tool);
        if (whole != *words.tool || !(whole >= 0.0 && whole < 1e8))
            return fail(Message::NotWhole, span, {"T"});
        number = static_cast<int>(whole);
    }
    if (number) put(command, 'T', *number);
    const bool by_word = number && tool_word_changes_;
    if (by_word && !is_tool_change_reported_) {
        is_tool_change_reported_ = true;
        log_.add(Message::ToolWordChanges, span);
    }
    if (words.has_m(6) || by_word) {
        const int selected = number.value_or(machine_.state().selected_tool);
        if (selected != machine_.state().tool) check_tool_change(span);
        put(command, MGroup::ToolChange, 6);
        if (command.present == 0 && selected >= 0) put(command, 'T', selected);
        if (selected >= 0) {
            tool_ = selected;
            // The first edge acts after the change of the tool.
            if (!words.edge && !set_edge(selected == 0 ? 0.0 : 1.0, command, span)) return false;
        }
    }
    return !words.edge || set_edge(*words.edge, command, span);
}

bool Control::set_edge(double edge, Command& command, SourceSpan span) {
    const double whole = std::round(edge);
    if (whole != edge || !(whole >= 0.0 && whole < 1e6))
        return fail(Message::NotWhole, span, {"D"});
    edge_ = static_cast<int>(whole);
    if (edge_ == 0 || tool_ == 0) {
        put(command, Code::G49);
        return true;
    }
    if (edge_ > 1 && edge_ != tool_)
        log_.add(Message::ToolEdge, span, {std::to_string(edge_), std::to_string(tool_)});
    put(command, Code::G43);
    put(command, 'H', tool_);
    return true;
}

/// G54 … G57, G505 … G599, G500. G505 is the system 5 of G54.1; G500 is a system without offset.
bool Control::set_system(int code, SourceSpan span) {
    constexpr double kWithoutOffset = 300.0;  // Number of the system that stands for G500.
    constexpr std::array kNamed{Code::G54, Code::G55, Code::G56, Code::G57};
    system_ = code;
    const bool is_tilted = machine_.state().frames.tilt.has_value();
    if (is_tilted) machine_.end_tilt();
    Command command = make(span);
    if (code < 500) {
        put(command, kNamed[static_cast<std::size_t>(code - 54)]);
    } else {
        put(command, Code::G54_1);
        put(command, 'P', code == 500 ? kWithoutOffset : code - 500.0);
    }
    if (!run(command)) return false;
    refresh();
    return !is_tilted || apply_frame("a frame", span);
}

void Control::begin_contour(const Control& caller) {
    records_contour_ = true;
    motion_ = caller.motion_;
    is_incremental_ = caller.is_incremental_;
    is_feed_in_inches_ = caller.is_feed_in_inches_;
    is_feed_reported_ = is_tool_change_reported_ = true;
    plane_ = caller.plane_;
    Command command = make({});
    put(command, caller.machine_.state().inches ? Code::G20 : Code::G21);
    put(command, code_of(plane_));
    (void)machine_.execute(command);
    // The feed of the cycle counts.
    machine_.state().feed = 1.0;
    refresh();
}

bool Control::set_side(const Words& words, Command& command, SourceSpan span) {
    const auto code = words.of(CodeGroup::Side);
    if (!code || records_contour_) return true;
    const CutterSide side = *code == 40   ? CutterSide::Off
                            : *code == 41 ? CutterSide::Left
                                          : CutterSide::Right;
    side_ = side;
    if (side == CutterSide::Off) {
        put(command, Code::G40);
        return true;
    }
    if (!goes_around_corners_) return fail(Message::NotRead, span, {"G41 or G42 with G451"});
    const PlaneAxes axes = axes_of(plane_);
    const bool is_mirrored = (chain_.scale[axes.first] < 0.0) != (chain_.scale[axes.second] < 0.0);
    const bool is_left = (side == CutterSide::Left) != is_mirrored;
    const bool has_radius = edge_ != 0 && tool_ != 0;
    if (has_radius && !diameter_of(tool_)) {
        put(command, is_left ? Code::G41 : Code::G42);  // Reports the unknown radius.
        put(command, 'D', tool_);
        return true;
    }
    put(command, is_left ? Code::G41_1 : Code::G42_1);
    put(command, 'D', has_radius ? *diameter_of(tool_) : 0.0);
    return true;
}

/// Puts feed, speed, spindle and coolant into `command`.
bool Control::put_speeds(const Words& words, Command& command, SourceSpan span) {
    if (const auto code = words.of(CodeGroup::Feed)) {
        switch (*code) {
            case 93: put(command, Code::G93); break;
            case 94:
            case 97: put(command, *code == 94 ? Code::G94 : Code::G97); break;
            case 95: put(command, Code::G95); break;
            case 971: put(command, Code::G94); break;
            default: return fail(Message::NotRead, span, {"constant cutting speed (G96)"});
        }
    }
    if (words.feed && !words.of(CodeGroup::OneShot)) {
        if (*words.feed < 0.0) return fail(Message::NegativeValue, span, {"F"});
        const FeedMode mode = machine_.state().feed_mode;
        const Code named = command.group(Group::Feed);
        const bool by_time =
            named == Code::G93 || (named == Code::None && mode == FeedMode::InverseTime);
        put(command, 'F', by_time ? *words.feed : feed_of(*words.feed));
    }
    if (words.speed && !words.of(CodeGroup::OneShot)) {
        if (*words.speed < 0.0) return fail(Message::NegativeValue, span, {"S"});
        put(command, 'S', *words.speed);
    }
    for (const int m : words.m) {
        std::string name = "M";
        name += std::to_string(m);
        switch (m) {
            case 3:
            case 4:
            case 5:
            case 19: put(command, MGroup::Spindle, m); break;
            case 7:
            case 8:
            case 9: put(command, MGroup::Coolant, m); break;
            case 0:
            case 1:
            case 2:
            case 6:
            case 30: break;
            default: {
                for (const RotaryClamp& clamp : options_.clamps) {
                    if (clamp.clamp == m || clamp.release == m) command.clamps.push_back(m);
                }
                const bool is_allowed =
                    std::ranges::find(options_.allow, name) != options_.allow.end();
                if (!moves_nothing(m) && !is_allowed && command.clamps.empty())
                    log_.add(Message::UnknownM, span, {name});
            }
        }
    }
    return true;
}

/// M0, M1: stops behind the move.
bool Control::act_at_end(const Words& words, SourceSpan span) {
    if (!words.has_m(0) && !words.has_m(1)) return true;
    Command command = make(span);
    put(command, MGroup::Stop, words.has_m(0) ? 0 : 1);
    return run(command);
}

bool Control::restore(const SavedModes& saved, SourceSpan span) {
    motion_ = saved.motion;
    is_incremental_ = saved.is_incremental;
    if (saved.plane != plane_) {
        Words words;
        const int code = saved.plane == Plane::XY ? 17 : saved.plane == Plane::ZX ? 18 : 19;
        words.code[static_cast<std::size_t>(CodeGroup::Plane)] = code;
        if (!block(words, span)) return false;
    }
    if (saved.frame == chain_) return true;
    chain_ = saved.frame;
    return apply_frame("the frame of a subprogram with SAVE", span);
}

// --- Codes for one block ---

bool Control::one_shot(const Words& words, SourceSpan span) {
    const int code = *words.of(CodeGroup::OneShot);
    Command command = make(span);
    if (!put_speeds(words, command, span) || !set_side(words, command, span) || !run(command))
        return false;
    switch (code) {
        case 4: return dwell_block(words, span);
        case 25:
        case 26: return true;  // Limits of the working area and of the spindle.
        case 58:
        case 59: return offset_part(code, words, span);
        case 74:
        case 75: return seek_home(words, span);
        default: return set_pole(code, words, span);
    }
}

bool Control::dwell_block(const Words& words, SourceSpan span) {
    if (words.has_axes()) return fail(Message::NotRead, span, {"G4 with axes"});
    double seconds = words.feed.value_or(0.0);
    if (words.speed) {
        const double rpm = machine_.state().spindle_rpm;
        if (!(rpm > 0.0)) return fail(Message::BlockNeeds, span, {"G4 S", "a spindle speed"});
        seconds = *words.speed * 60.0 / rpm;
    }
    if (seconds < 0.0) return fail(Message::NegativeValue, span, {"the dwell"});
    cycle_span_ = span;
    return dwell(seconds);
}

/// G74, G75: the named axes go to a point of the machine builder.
bool Control::seek_home(const Words& words, SourceSpan span) {
    if (side_ != CutterSide::Off)
        return fail(Message::NotRead, span, {"G74 or G75 under G41 or G42"});
    Command command = make(span);
    put(command, Code::G28);
    for (std::size_t i = 0; i < words.axis.size(); ++i) {
        if (words.axis[i]) put(command, kAxisNames[i], 0.0);
    }
    if (command.present == 0) return fail(Message::BlockNeeds, span, {"G74 or G75", "axes"});
    command.axis_words = true;
    machine_.state().incremental = true;
    const bool done = run(command);
    machine_.state().incremental = false;
    refresh();
    return done;
}

// --- Ends ---

bool Control::is_increment(const Coordinate& word) const {
    return word.way == Way::Increment || (word.way == Way::Modal && is_incremental_);
}

/// Returns the end of `axis`. Rotary axes: by the shortest way, or in one direction.
double Control::end_of(const Coordinate& word, std::size_t axis) const {
    constexpr double kTurn = 360.0;
    const double at = at_[axis];
    if (is_increment(word)) return at + word.value;
    Way way = word.way;
    if (way == Way::Modal && is_rotary(axis)) {
        const RotaryWay machine_way = ways_[axis - kA];
        if (machine_way == RotaryWay::Shortest) way = Way::Shortest;
        if (machine_way == RotaryWay::Positive) way = Way::Positive;
    }
    if (way == Way::Modal || way == Way::Absolute) return word.value;
    double turn = std::fmod(word.value - at, kTurn);
    switch (way) {
        case Way::Shortest:
            if (turn > kTurn / 2) turn -= kTurn;
            if (turn <= -kTurn / 2) turn += kTurn;
            break;
        case Way::Positive:
            if (turn < 0.0) turn += kTurn;
            break;
        case Way::Negative:
            if (turn > 0.0) turn -= kTurn;
            break;
        default: return word.value;
    }
    // The end is the value plus whole turns, exactly.
    return word.value + kTurn * std::round((at + turn - word.value) / kTurn);
}

Axes Control::ends(const Words& words, AxisMask& mask) const {
    Axes end = at_;
    for (std::size_t i = 0; i < words.axis.size(); ++i) {
        if (!words.axis[i]) continue;
        mask |= 1U << i;
        end[i] = end_of(*words.axis[i], i);
    }
    return end;
}

// --- Moves ---

/// Returns the corner at the end of the block: RND, CHR or CHF, otherwise RNDM.
std::optional<language::Corner> Control::corner_of(const Words& words) const {
    language::Corner corner;
    corner.span = words.corner_span;
    const double feed = words.corner_feed.value_or(modal_corner_feed_);
    if (feed > 0.0) corner.feed = feed_of(feed);
    if (words.rounding) {
        corner.size = *words.rounding;
    } else if (words.chamfer) {
        corner.letter = 'C';
        corner.size = *words.chamfer;
    } else if (words.chamfer_length) {
        corner.letter = 'L';
        corner.size = *words.chamfer_length;
    } else {
        if (modal_rounding_ == 0.0 || motion_ == 0) return std::nullopt;
        if (words.of(CodeGroup::Suppress) || machine_.state().feed_mode == FeedMode::InverseTime)
            return std::nullopt;
        corner.size = modal_rounding_;
        corner.is_modal = true;
    }
    return corner;
}

bool Control::move(const Words& words, Command& command, SourceSpan span) {
    const bool is_of_machine = words.of(CodeGroup::Suppress).has_value();
    AxisMask mask = 0;
    Axes end = ends(words, mask);
    const std::optional<double> radius = polar_radius_;
    const std::optional<double> angle = polar_angle_;
    polar_radius_.reset();
    polar_angle_.reset();
    if (words.polar_angle || words.polar_radius) polar_radius_ = radius, polar_angle_ = angle;
    if (!polar_end(words, end, mask, span)) return false;
    if (motion_ <= 1) return line(words, command, end, mask, span);
    if (is_of_machine) return fail(Message::NotRead, span, {"an arc with SUPA, G53 or G153"});
    if (words.chamfer || words.chamfer_length || words.line_angle)
        return fail(Message::NotRead, words.corner_span, {"a chamfer at an arc (CHR, CHF, ANG)"});
    return arc(words, command, end, mask, span);
}

/// Reports the first large turn under ORIWKS or ORIVECT: the control turns the tool along a great
/// circle, ncsim turns the axes linearly. Both ends are the same.
void Control::check_turn(const Axes& end, SourceSpan span) {
    constexpr double kLarge = 1.0;  // Degrees; CAM systems divide larger turns.
    if (is_turn_reported_ || machine_.state().coordinates != Coordinates::Tip) return;
    int turning = 0;
    bool is_large = false;
    for (std::size_t i = kA; i <= kC; ++i) {
        const double way = std::abs(end[i] - at_[i]);
        if (way > 0.0) ++turning;
        is_large = is_large || way > kLarge;
    }
    if (turning < 2 || !is_large) return;
    is_turn_reported_ = true;
    log_.add(Message::TurnByVector, span);
}

bool Control::line(const Words& words, Command& command, const Axes& end, AxisMask mask,
                   SourceSpan span) {
    MachineState& state = machine_.state();
    const bool suppresses = words.of(CodeGroup::Suppress).has_value();
    put(command, motion_ == 0 ? Code::G0 : Code::G1);
    bool all_incremental = !words.polar_angle && !words.polar_radius;
    const auto next_axis = [](AxisMask axes) {
        return static_cast<std::size_t>(std::countr_zero(axes));
    };
    for (AxisMask rest = mask; rest != 0; rest &= rest - 1) {
        const auto& word = words.axis[next_axis(rest)];
        all_incremental = all_incremental && (!word || is_increment(*word));
    }
    const bool is_of_machine = suppresses && !(all_incremental && mask != 0);
    if (is_of_machine) put(command, Code::G53);
    const std::optional<language::Corner> corner = corner_of(words);
    const bool has_corner = corner || words.line_angle;
    // Increments are known even if the position before the move is unknown.
    const bool by_increments = is_unknown(mask) && all_incremental && !is_of_machine &&
                               !has_corner && side_ == CutterSide::Off;
    for (AxisMask rest = mask; rest != 0; rest &= rest - 1) {
        const std::size_t i = next_axis(rest);
        double value = by_increments && words.axis[i] ? words.axis[i]->value : end[i];
        // The length of the tool acts under SUPA, too.
        if (is_of_machine && i < 3) value += state.frames.tool_offset[i];
        put(command, kAxisNames[i], value);
    }
    command.axis_words = mask != 0;
    bool by_vector = false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!words.direction[i]) continue;
        by_vector = true;
        put(command, "IJK"[i], *words.direction[i]);
    }
    if (by_vector && state.coordinates != Coordinates::Tip)
        return fail(Message::BlockNeeds, span, {"A3, B3, C3", "TRAORI before"});
    if (has_corner && motion_ != 1)
        return fail(Message::NotRead, words.corner_span,
                    {"a corner at a rapid move (RND, CHR, CHF, ANG)"});
    if (corner) put(command, *corner);
    if (words.line_angle) {
        command.has_angle = true;
        command.angle = *words.line_angle;
        command.angle_span = words.corner_span;
    }
    if (turns_by_vector_ && motion_ == 1) check_turn(end, span);
    state.incremental = by_increments;
    state.by_vector = by_vector;
    const bool done = run(command);
    machine_.state().incremental = false;
    machine_.state().by_vector = false;
    if (!done) return false;
    if (is_of_machine || by_vector || words.line_angle) {
        refresh();
        tangent_.reset();
    } else {
        arrive(end);
    }
    return true;
}

std::optional<double> Control::system_value(std::string_view name, std::string_view axis) const {
    const MachineState& state = machine_.state();
    if (name == "$P_TOOLR") {
        if (edge_ == 0 || tool_ == 0) return 0.0;
        const std::optional<double> diameter = diameter_of(tool_);
        return diameter ? std::optional(*diameter / 2.0) : std::nullopt;
    }
    if (name == "$P_TOOLNO") return tool_;
    if (name == "$P_TOOL") return edge_;
    if (name == "$P_F") return state.feed;
    if (name == "$P_S") return state.spindle_rpm;
    // The program runs on the machine, not in a test or a search.
    if (name == "$P_SIM" || name == "$P_SEARCH" || name == "$P_ISTEST") return 0.0;
    if ((name == "$P_EP" || name == "$AA_IW") && axis.size() == 1) {
        const std::size_t i = kAxisNames.find(axis[0]);
        if (i == std::string_view::npos || is_unknown(static_cast<AxisMask>(1U << i)))
            return std::nullopt;
        return at_[i];
    }
    return std::nullopt;
}

}  // namespace ncsim::gcode::sinumerik
