// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths: L, LP, C, CP, CR, CT, CTP, CC, M codes, feeds, cutter compensation.
// Source: HEIDENHAIN TNC 640, User's Manual for Klartext Programming, 34059x.
#include "klartext/control.h"

#include "ncsim/base/angles.h"
#include "ncsim/gcode/print.h"

#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::klartext {
namespace {

constexpr int kMaxArcTurns = 100'000;

/// M codes that move no axis and do not change the meaning of other words: programming aids, feed
/// rules, look-ahead, clamps of rotary axes and displays.
bool moves_nothing(int m) {
    constexpr std::array kCodes{6,   90,  94,  101, 102, 103, 105, 106, 107, 108, 109, 110, 111,
                                112, 114, 116, 117, 120, 124, 134, 135, 138, 141, 142, 143, 144,
                                145, 148, 149, 197, 200, 201, 202, 203, 204, 125, 104};
    return std::ranges::find(kCodes, m) != kCodes.end();
}

std::string_view verb_of(const Block& block) {
    return block.name.empty() ? std::string_view("L") : block.name;
}

}  // namespace

Control::Control(const InterpreterOptions& options, Controller& machine, Parameters& parameters,
                 DiagnosticLog& log)
    : BlockControl(options, machine, log), parameters_(parameters) {}

bool Control::Words::has(int code) const {
    return std::ranges::find(m, code) != m.end();
}

bool Control::Words::has_axes() const {
    return std::ranges::any_of(axis, [](const auto& value) { return value.has_value(); });
}

// --- Commands ---

void Control::refresh() {
    BlockControl::refresh();
    pr_.reset();
    pa_.reset();
}

void Control::arrive(const Axes& end) {
    const PlaneAxes axes = axes_of(plane_);
    if (end[axes.first] != at_[axes.first] || end[axes.second] != at_[axes.second]) {
        pr_.reset();
        pa_.reset();
    }
    BlockControl::arrive(end);
}

std::vector<language::BlockControl::ActiveMode> Control::modes_left_on() const {
    const MachineState& state = machine_.state();
    std::vector<ActiveMode> modes;
    const Transformation& t = transformation_;
    const bool is_mirrored = std::ranges::find(t.is_mirrored, true) != t.is_mirrored.end();
    if (state.frames.tilt) modes.push_back({"a tilted plane", "PLANE RESET"});
    if (state.coordinates == Coordinates::Tip) modes.push_back({"tip control", "M129"});
    if (state.frames.offset_92 != Axes{}) modes.push_back({"a datum shift", "CYCL DEF 7.1 X+0"});
    if (is_mirrored) modes.push_back({"a mirror image", "CYCL DEF 8.1"});
    if (t.angle != 0.0) modes.push_back({"a rotation", "CYCL DEF 10.1 ROT+0"});
    if (side_ != CutterSide::Off) modes.push_back({"cutter compensation", "R0"});
    if (calls_at_each_) modes.push_back({"M89", "M99"});
    return modes;
}

std::vector<language::BlockControl::ActiveMode> Control::modes_at_change() const {
    std::vector<ActiveMode> modes;
    if (machine_.state().coordinates == Coordinates::Tip) modes.push_back({"tip control", "M129"});
    if (side_ != CutterSide::Off) modes.push_back({"cutter compensation", "R0"});
    if (calls_at_each_) modes.push_back({"M89", "M99"});
    return modes;
}

void Control::set_units(bool inches) {
    inches_ = inches;
    Command command = make({});
    put(command, inches ? Code::G20 : Code::G21);
    (void)machine_.execute(command);
    refresh();
}

// --- Words ---

/// Reads the words of `block`. `is_ahead`: of a block that is not executed yet.
bool Control::gather(const Block& block, Words& words, bool is_ahead) {
    for (const Word& word : block.words) {
        double value = 0.0;
        if (word.value.kind != klartext::Value::Kind::None) {
            const std::optional<double> read = parameters_.value_of(word.value, word.span);
            if (!read) return false;
            value = *read;
        }
        switch (word.address) {
            case Address::PR:
                words.pr = value, words.is_pr_incremental = word.is_incremental;
                break;
            case Address::PA:
                words.pa = value, words.is_pa_incremental = word.is_incremental;
                break;
            case Address::Radius:
                words.radius = value;
                words.is_radius_signed = std::signbit(value);
                break;
            case Address::R0: words.side = CutterSide::Off; break;
            case Address::RL: words.side = CutterSide::Left; break;
            case Address::RR: words.side = CutterSide::Right; break;
            case Address::F: words.feed = value; break;
            case Address::FMax: words.is_rapid = true; break;
            case Address::FAuto: words.feed = tool_feed_; break;
            case Address::FU: {
                // Feed per revolution, as a feed per minute.
                const double rpm = machine_.state().spindle_rpm;
                words.feed = value * rpm * (inches_ ? 10.0 : 1.0);
                break;
            }
            case Address::FZ:
                return fail(Message::KlartextVerb, word.span, {"a feed per tooth (FZ)"});
            case Address::S: words.speed = value; break;
            case Address::M:
                if (!is_ahead && !take_m(block, word, words)) return false;
                break;
            case Address::DrPlus: words.direction = 1; break;
            case Address::DrMinus: words.direction = -1; break;
            case Address::MB: words.mb = value; break;
            case Address::MBMax: words.is_retracted_fully = true; break;
            case Address::LA: break;
            case Address::Len: words.length = value; break;
            case Address::Cca: words.opening = value; break;
            default: {
                const auto axis = static_cast<std::size_t>(word.address);
                words.axis[axis] = value;
                words.is_incremental[axis] = word.is_incremental;
                words.span[axis] = word.span;
                break;
            }
        }
    }
    if (words.feed && *words.feed < 0.0) return fail(Message::NegativeValue, block.whole(), {"F"});
    return true;
}

bool Control::take_m(const Block& block, const Word& word, Words& words) {
    const std::optional<double> number = parameters_.value_of(word.value, word.span);
    if (!number) return false;
    const double whole = std::round(*number);
    if (whole != *number || whole < 0.0 || whole > 9999.0)
        return fail(Message::KlartextWord, word.span, {"M"});
    const int m = static_cast<int>(whole);
    const bool is_compensated =
        side_ != CutterSide::Off || words.side.value_or(CutterSide::Off) != CutterSide::Off;
    std::string name = "M";
    name += std::to_string(m);
    switch (m) {
        case 97:
        case 98:
            if (is_compensated) return fail(Message::KlartextVerb, word.span, {name});
            return true;
        case 118:
        case 130:
        case 140: {
            if (m == 130 && !machine_.state().frames.tilt) return true;
            if (m != 140) return fail(Message::KlartextVerb, word.span, {name});
            break;
        }
        case 0:
        case 1:
        case 2:
        case 3:
        case 4:
        case 5:
        case 7:
        case 8:
        case 9:
        case 13:
        case 14:
        case 19:
        case 30:
        case 89:
        case 91:
        case 92:
        case 99:
        case 126:
        case 127:
        case 128:
        case 129:
        case 136:
        case 137: break;
        default:
            if (!moves_nothing(m)) log_.add(Message::UnknownM, word.span, {name});
            break;
    }
    (void)block;
    words.m.push_back(m);
    return true;
}

/// Puts spindle, coolant, feed and cutter side into `command`: what acts at the start of the block.
bool Control::act_before(const Block& block, Words& words, Command& command) {
    for (const int m : words.m) {
        switch (m) {
            case 3:
            case 4:
            case 13:
            case 14:
            case 19:
                command.m[static_cast<std::size_t>(MGroup::Spindle)] = static_cast<std::int16_t>(m);
                break;
            case 7:
            case 8:
                command.m[static_cast<std::size_t>(MGroup::Coolant)] = static_cast<std::int16_t>(m);
                break;
            case 126: shortest_way_ = true; break;
            case 127: shortest_way_ = false; break;
            case 128:
            case 129:
                if (m == 128 && (side_ != CutterSide::Off))
                    return fail(Message::KlartextVerb, block.whole(),
                                {"M128 under cutter compensation"});
                command.m[static_cast<std::size_t>(MGroup::Kinematics)] =
                    static_cast<std::int16_t>(m);
                break;
            case 136:
            case 137:
                per_revolution_ = m == 136;
                put(command, per_revolution_ ? Code::G95 : Code::G94);
                feed_ = 0.0;
                break;
            case 92: log_.add(Message::MachinePoint, block.whole(), {"M92"}); break;
            default: break;
        }
    }
    if (words.speed) put(command, 'S', *words.speed);
    // The F of these codes is no feed of the path.
    const bool is_other_feed = words.has(128) || words.has(103) || words.has(140);
    if (words.feed && !is_other_feed) {
        feed_ = *words.feed;
        put(command, 'F', feed_of(feed_));
    }
    return set_side(command, words, block.whole());
}

void Control::begin_contour(const Control& caller) {
    records_contour_ = true;
    set_units(caller.inches_);
    plane_ = caller.plane_;
    Command command = make({});
    put(command, code_of(plane_));
    (void)machine_.execute(command);
    // The feed of the cycle counts.
    machine_.state().feed = 1.0;
    refresh();
}

bool Control::set_side(Command& command, const Words& words, SourceSpan span) {
    if (records_contour_) {
        if (words.side && *words.side != CutterSide::Off) contour_side_ = *words.side;
        return true;
    }
    if (!words.side || *words.side == side_) return true;
    if (*words.side != CutterSide::Off && side_ != CutterSide::Off)
        return fail(Message::KlartextSideChange, span);
    side_ = *words.side;
    if (side_ == CutterSide::Off) {
        put(command, Code::G40);
        return true;
    }
    const Transformation& t = transformation_;
    const PlaneAxes axes = axes_of(plane_);
    const bool is_mirrored = t.is_mirrored[axes.first] != t.is_mirrored[axes.second];
    const bool is_left = (side_ == CutterSide::Left) != is_mirrored;
    if (const std::optional<double> radius = radius_of_tool()) {
        put(command, is_left ? Code::G41_1 : Code::G42_1);
        put(command, 'D', 2.0 * *radius);
    } else {
        put(command, is_left ? Code::G41 : Code::G42);
        put(command, 'D', tool_);
    }
    return true;
}

bool Control::end_compensation(SourceSpan span) {
    if (side_ == CutterSide::Off) return true;
    side_ = CutterSide::Off;
    Command command = make(span);
    put(command, Code::G40);
    return run(command);
}

/// Executes what acts at the end of the block: M5, M9, stops, M99, M89.
bool Control::act_after(const Block& block, const Words& words) {
    if (words.m.empty() && !calls_at_each_) return true;
    const SourceSpan span = block.whole();
    Command command = make(span);
    bool has_effect = false;
    for (const int m : words.m) {
        const MGroup group = m == 5 ? MGroup::Spindle : m == 9 ? MGroup::Coolant : MGroup::Stop;
        if (m != 5 && m != 9 && m != 0 && m != 1) continue;
        command.m[static_cast<std::size_t>(group)] = static_cast<std::int16_t>(m);
        has_effect = true;
    }
    if (has_effect && !run(command)) return false;
    if (words.has(89)) calls_at_each_ = true;
    const bool moves_in_plane = words.axis[axes_of(plane_).first] ||
                                words.axis[axes_of(plane_).second] || words.pa || words.pr;
    if (words.has(99)) {
        if (!call_cycle(span)) return false;
        if (!words.has(89)) calls_at_each_ = false;
    } else if (calls_at_each_ && moves_in_plane) {
        if (!call_cycle(span)) return false;
    }
    if (words.has(2) || words.has(30)) end_program(span);
    return true;
}

// --- Ends ---

/// Returns the end of a rotary axis at `at`: `value`, or by the shortest way (M126).
double Control::rotary_end(double value, double at) const {
    if (!shortest_way_) return value;
    constexpr double kTurn = 360.0;
    double way = std::fmod(value - at, kTurn);
    if (way > kTurn / 2) way -= kTurn;
    if (way <= -kTurn / 2) way += kTurn;
    return at + way;
}

/// Returns the end of the axis words, and the named axes.
Axes Control::ends(const Words& words, AxisMask& mask) const {
    Axes end = at_;
    for (std::size_t i = 0; i < words.axis.size(); ++i) {
        if (!words.axis[i]) continue;
        mask |= 1U << i;
        end[i] = words.is_incremental[i] ? at_[i] + *words.axis[i] : *words.axis[i];
        if (is_rotary(i) && !words.is_incremental[i]) end[i] = rotary_end(*words.axis[i], at_[i]);
    }
    return end;
}

/// Computes the end of polar coordinates about the centre.
bool Control::polar_end(const Block& block, const Words& words, Axes& end) {
    if (!centre_)
        return fail(Message::KlartextCentreMissing, block.whole(), {verb_of(block)}), false;
    const PlaneAxes axes = axes_of(plane_);
    const double x = at_[axes.first] - (*centre_)[0];
    const double y = at_[axes.second] - (*centre_)[1];
    double radius = pr_ ? *pr_ : hypotenuse(x, y);
    double angle = pa_ ? *pa_ : angle_of(x, y);
    if (words.pr) radius = words.is_pr_incremental ? radius + *words.pr : *words.pr;
    if (words.pa) angle = words.is_pa_incremental ? angle + *words.pa : *words.pa;
    const SinCos direction = sin_cos(angle);
    end[axes.first] = (*centre_)[0] + radius * direction.cos;
    end[axes.second] = (*centre_)[1] + radius * direction.sin;
    pr_ = radius;
    pa_ = angle;
    return true;
}

// --- Blocks ---

bool Control::path(const Block& block, const Corner* corner) {
    Words words;
    if (!gather(block, words)) return false;
    const bool is_polar = block.verb == Verb::StraightPolar || block.verb == Verb::ArcPolar ||
                          block.verb == Verb::ArcTangentPolar;
    for (const std::size_t axis : {axes_of(plane_).first, axes_of(plane_).second}) {
        if (is_polar && words.axis[axis])
            return fail(Message::KlartextWord, words.span[axis], {{&kAxisNames[axis], 1}});
    }
    if (block.verb == Verb::Straight || block.verb == Verb::StraightPolar) {
        if (!linear_move(block, words, corner)) return false;
    } else if (!arc(block, words, corner)) {
        return false;
    }
    return act_after(block, words);
}

bool Control::centre(const Block& block) {
    Words words;
    if (!gather(block, words)) return false;
    const PlaneAxes axes = axes_of(plane_);
    Vec2 centre = centre_.value_or(Vec2{at_[axes.first], at_[axes.second]});
    if (!words.axis[axes.first] && !words.axis[axes.second])
        centre = {at_[axes.first], at_[axes.second]};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t axis = i == 0 ? axes.first : axes.second;
        if (!words.axis[axis]) continue;
        centre[i] = words.is_incremental[axis] ? at_[axis] + *words.axis[axis] : *words.axis[axis];
    }
    centre_ = centre;
    pr_.reset();
    pa_.reset();
    return true;
}

bool Control::linear_move(const Block& block, Words& words, const Corner* corner) {
    const SourceSpan span = block.whole();
    Command command = make(span);
    if (!act_before(block, words, command)) return false;
    if (words.has(140)) return retract(block, words, command);
    AxisMask mask = 0;
    Axes end = ends(words, mask);
    std::optional<double> pr;
    std::optional<double> pa;
    if (block.verb == Verb::StraightPolar) {
        if (!polar_end(block, words, end)) return true;
        pr = pr_, pa = pa_;
        const PlaneAxes axes = axes_of(plane_);
        mask |= 1U << axes.first | 1U << axes.second;
    }
    const bool is_of_machine = words.has(91) || words.has(92);
    if (mask != 0) {
        put(command, words.is_rapid ? Code::G0 : Code::G1);
        was_rapid_ = words.is_rapid;
        if (is_of_machine) put(command, Code::G53);
        // Increments are known even if the position before the move is unknown.
        MachineState& state = machine_.state();
        bool all_incremental = !is_of_machine;
        for (std::size_t i = 0; i < end.size(); ++i) {
            if ((mask >> i & 1U) != 0) all_incremental &= words.is_incremental[i];
        }
        const bool by_increments = is_unknown(mask) && all_incremental && !corner &&
                                   block.verb == Verb::Straight && side_ == CutterSide::Off;
        for (std::size_t i = 0; i < end.size(); ++i) {
            if ((mask >> i & 1U) == 0) continue;
            const double value =
                is_of_machine || by_increments ? words.axis[i].value_or(0.0) : end[i];
            put(command, kAxisNames[i], value);
        }
        command.axis_words = true;
        if (corner) put(command, with_feed(*corner));
        state.incremental = by_increments;
        const bool done = run(command);
        machine_.state().incremental = false;
        if (!done) return false;
        if (command.group(MGroup::Kinematics) != kNone) {
            refresh();
        } else if (is_of_machine) {
            refresh();
            tangent_.reset();
        } else {
            arrive(end);
            if (pr) pr_ = pr, pa_ = pa;
        }
        return true;
    }
    const bool had_kinematics = command.group(MGroup::Kinematics) != kNone;
    if (!run(command)) return false;
    if (had_kinematics) refresh();
    return true;
}

/// M140 MB: retracts along the tool axis.
bool Control::retract(const Block& block, const Words& words, Command command) {
    const SourceSpan span = block.whole();
    if (side_ != CutterSide::Off && command.group(Group::CutterSide) == Code::None)
        return fail(Message::KlartextVerb, span, {"M140 under cutter compensation"});
    if (words.has_axes()) return fail(Message::KlartextVerb, span, {"M140 with axes"});
    if (!words.mb && !words.is_retracted_fully)
        return fail(Message::BlockNeeds, span, {"M140", "MB"});
    const std::size_t axis = axes_of(plane_).third;
    const bool feeds = words.feed && !words.is_rapid;
    const double before = machine_.state().feed;
    if (feeds) put(command, 'F', feed_of(*words.feed));
    put(command, feeds ? Code::G1 : Code::G0);
    command.axis_words = true;
    if (words.is_retracted_fully) {
        // The limit of travel is taken as the zero of the machine, as for G28.
        put(command, Code::G53);
        put(command, kAxisNames[axis], 0.0);
    } else {
        put(command, kAxisNames[axis], *words.mb);
        machine_.state().incremental = true;
    }
    const bool done = run(command);
    machine_.state().incremental = false;
    machine_.state().feed = before;
    refresh();
    return done;
}

bool Control::arc(const Block& block, const Words& words_of_block, const Corner* corner) {
    Words words = words_of_block;
    const SourceSpan span = block.whole();
    Command command = make(span);
    if (words.has(91) || words.has(92))
        return fail(Message::KlartextVerb, span, {"an arc with M91"});
    if (words.has(140)) return fail(Message::KlartextVerb, span, {"an arc with M140"});
    if (!act_before(block, words, command)) return false;
    if (words.is_rapid) log_.add(Message::KlartextArcRapid, span);
    if (corner) put(command, with_feed(*corner));
    AxisMask mask = 0;
    ProgramArc arc;
    arc.end = ends(words, mask);
    if ((mask & kRotaryAxes) != 0)
        return fail(Message::KlartextVerb, span, {"an arc with a rotary axis"});
    const PlaneAxes axes = axes_of(plane_);
    int direction = words.direction;
    const auto skip = [&](const MessageText& message) {
        log_.add(message, span, {verb_of(block)});
        return true;
    };
    if (block.verb == Verb::ArcTangent || block.verb == Verb::ArcTangentPolar) {
        if (block.verb == Verb::ArcTangentPolar && !polar_end(block, words, arc.end)) return true;
        if (!tangent_) return skip(Message::KlartextTangentMissing);
        return continue_tangentially(block, words, arc.end, command);
    }
    if (direction == 0 && block.verb == Verb::ArcPolar && words.pa && words.is_pa_incremental)
        direction = *words.pa < 0.0 ? -1 : 1;
    if (direction == 0) direction = last_direction_;
    if (direction == 0) return skip(Message::KlartextDirectionMissing);
    last_direction_ = direction;
    arc.turns = direction;
    if (block.verb == Verb::ArcByRadius) {
        if (!words.radius) return fail(Message::BlockNeeds, span, {"CR", "a radius (R)"});
        return make_arc(words, arc, *words.radius, command);
    }
    if (!centre_) return skip(Message::KlartextCentreMissing);
    arc.centre_1 = (*centre_)[0];
    arc.centre_2 = (*centre_)[1];
    if (block.verb == Verb::ArcPolar) {
        const double x = at_[axes.first] - arc.centre_1;
        const double y = at_[axes.second] - arc.centre_2;
        const double start = pa_ ? *pa_ : angle_of(x, y);
        double sweep = 360.0;  // CP DR+ alone: a full circle.
        double angle = start;
        if (words.pa && words.is_pa_incremental) {
            sweep = std::abs(*words.pa);
            if (*words.pa != 0.0 && (*words.pa > 0.0) != (direction > 0)) {
                // The end of whole turns does not depend on the sign.
                const bool is_whole = std::fmod(sweep, 360.0) == 0.0;
                if (!is_whole) return skip(Message::KlartextDirection);
                log_.add(Message::KlartextDirectionOfTurns, span);
            }
            if (!(sweep <= 360.0 * kMaxArcTurns)) return fail(Message::ArcTurns, span);
            angle = start + direction * sweep;
        } else if (words.pa) {
            sweep = 0.0;
            angle = *words.pa;
        }
        const double pr = pr_.value_or(hypotenuse(x, y));
        const double whole = std::round(sweep / 360.0);
        if (sweep > 0.0 && sweep == 360.0 * whole) {
            // Full circles end exactly at the start.
            arc.turns = direction * static_cast<int>(whole);
        } else {
            const double turned = angle - start;
            double ex = x;
            double ey = y;
            rotate(ex, ey, turned);
            arc.end[axes.first] = arc.centre_1 + ex;
            arc.end[axes.second] = arc.centre_2 + ey;
            if (sweep > 360.0) arc.turns = direction * static_cast<int>(std::ceil(sweep / 360.0));
        }
        if (!make_arc(words, arc, std::nullopt, command)) return false;
        pr_ = pr;
        pa_ = angle;
        return true;
    }
    return make_arc(words, arc, std::nullopt, command);
}

/// Makes the element that continues the last element tangentially to `end`.
/// Returns: false if the program stops.
bool Control::continue_tangentially(const Block& block, const Words& words, const Axes& end,
                                    const Command& command) {
    ProgramArc arc;
    switch (tangent_arc(end, arc)) {
        case Tangent::None:
            log_.add(Message::KlartextTangentMissing, block.whole(), {verb_of(block)});
            return true;
        case Tangent::Arc:
            last_direction_ = arc.turns;
            return make_arc(words, arc, std::nullopt, command);
        case Tangent::Line: break;
    }
    Command line = command;
    put(line, Code::G1);
    const PlaneAxes axes = axes_of(plane_);
    for (std::size_t i = 0; i < 3; ++i) {
        if (i == axes.first || i == axes.second || words.axis[i]) put(line, kAxisNames[i], end[i]);
    }
    line.axis_words = true;
    if (run(line)) arrive(end);
    return true;
}

/// Makes the arc with the modes in `command`.
bool Control::make_arc(const Words& words, const ProgramArc& arc, std::optional<double> radius,
                       const Command& command) {
    AxisMask named = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (words.axis[i]) named |= 1U << i;
    }
    return BlockControl::make_arc(arc, named, radius, command);
}

bool Control::stop_block(const Block& block) {
    Scanner scan(block.code, block.rest);
    Words words;
    while (scan.take('M')) {
        const std::size_t begin = scan.at();
        const klartext::Value number = scan.value();
        if (number.kind == klartext::Value::Kind::None) break;
        const Word word{Address::M, false, number, block.span(begin - 1, scan.at() - begin + 1)};
        if (!take_m(block, word, words)) return false;
    }
    if (!scan.is_at_end())
        return fail(Message::KlartextWord, block.span(scan.at(), scan.remaining().size()),
                    {scan.remaining()});
    Command command = make(block.whole());
    if (!act_before(block, words, command)) return false;
    command.m[static_cast<std::size_t>(MGroup::Stop)] = 0;
    return run(command) && act_after(block, words);
}

}  // namespace ncsim::gcode::klartext
