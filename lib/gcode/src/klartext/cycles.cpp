// SPDX-License-Identifier: GPL-3.0-or-later
//
// CYCL DEF and the hole cycles: drilling, reaming, boring, tapping, bore milling, centring;
// patterns of holes. Source: HEIDENHAIN TNC 640, User's Manual for Cycle Programming, 892903.
#include "ncsim/base/angles.h"

#include "klartext/control.h"
#include "klartext/cycle_parameters.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::klartext {
namespace {

bool is_hole_cycle(int number) {
    switch (number) {
        case 1:
        case 2:
        case 17:
        case 200:
        case 201:
        case 202:
        case 203:
        case 204:
        case 205:
        case 206:
        case 207:
        case 208:
        case 209:
        case 240:
        case 241: return true;
        default: return false;
    }
}

/// Cycles without effect on the path: tolerance, orientation of the spindle.
bool has_no_path(int number) {
    return number == 13 || number == 32 || number == 239 || number == 332 || number == 392;
}

std::string name_of_cycle(int number) {
    std::string name = "CYCL DEF ";
    return name += std::to_string(number);
}

/// Skips the name of a value, a word in the language of the control: "V.ZEIT", "DEPTH".
void skip_name(Scanner& scan) {
    while (!scan.is_at_end()) {
        const char c = upper(scan.peek());
        const bool is_value = is_digit(c) || c == '+' || c == '-' ||
                              ((c == '.' || c == 'Q') && is_digit(scan.peek(1)));
        if (is_value) return;
        scan.move_to(scan.at() + 1);
    }
}

}  // namespace

// --- Definitions ---

bool Control::cycle_def(const Block& block) {
    Scanner scan(block.code, block.rest);
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    const std::optional<std::uint32_t> number = scan.whole();
    if (!number || *number > 9999) {
        return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                    {block.code.substr(begin)});
    }
    cycle_span_ = block.whole();
    const int cycle = static_cast<int>(*number);
    if (scan.peek() == '.') {
        scan.move_to(scan.at() + 1);
        const int part = static_cast<int>(scan.whole().value_or(0));
        return old_cycle(block, scan, cycle, part);
    }
    return numbered_cycle(block, scan, cycle);
}

/// Reads "Q200=2 Q201=-15 …" behind the name of the cycle.
bool Control::read_cycle_values(const Block& block, Scanner& scan, Cycle& cycle) {
    // The name is any text before the first "Qn =".
    const auto find_next = [&]() -> bool {
        for (std::size_t at = scan.at(); at < block.code.size(); ++at) {
            if (upper(block.code[at]) != 'Q') continue;
            if (at > 0 && is_letter(block.code[at - 1])) continue;
            Scanner probe(block.code, at);
            const auto parameter = probe.parameter();
            if (!parameter || parameter->set != 'Q' || !probe.take('=')) continue;
            scan.move_to(at);
            return true;
        }
        return false;
    };
    if (!find_next()) return true;
    while (!scan.is_at_end()) {
        const std::size_t begin = scan.at();
        const auto parameter = scan.parameter();
        if (!parameter || !scan.take('=')) {
            return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                        {block.code.substr(begin)});
        }
        CycleValue value;
        if (scan.take_word("MAX") || scan.take_word("FMAX")) {
            value.kind = Value::Rapid;
        } else if (scan.take_word("AUTO") || scan.take_word("FAUTO")) {
            value.kind = Value::Automatic;
            value.number = tool_feed_;
        } else if (scan.take_word("PREDEF")) {
            return fail(Message::KlartextVerb, block.span(begin, scan.at() - begin),
                        {"a global value (PREDEF)"});
        } else if (scan.take_word("FU") || scan.take_word("FZ")) {
            return fail(Message::KlartextVerb, block.span(begin, scan.at() - begin),
                        {"a feed per revolution or tooth in a cycle"});
        } else if (const auto text = scan.quoted()) {
            continue;
        } else if (upper(scan.peek()) == 'Q' && upper(scan.peek(1)) == 'S') {
            scan.move_to(scan.at() + 2);
            (void)scan.whole();
            continue;
        } else {
            const std::optional<double> number = parameters_.read_value(scan, block);
            if (!number) return false;
            value.number = *number;
            (void)parameters_.set(*parameter, *number);
        }
        cycle.values[parameter->index] = value;
    }
    return true;
}

/// Reports the first parameter of `cycle` that acts on the control and not here.
void Control::report_left_out(const Cycle& cycle, SourceSpan span) {
    for (const auto& [q, value] : cycle.values) {
        if (!leaves_out(cycle.number, q, value.number)) continue;
        log_.add(Message::KlartextParameterLeftOut, span,
                 {"Q" + std::to_string(q), std::to_string(cycle.number)});
        return;
    }
}

bool Control::numbered_cycle(const Block& block, Scanner& scan, int number) {
    if (has_no_path(number)) return true;
    const bool is_pattern = number == 220 || number == 221;
    const bool mills_contours = number >= 22 && number <= 25;
    const bool is_known = (is_hole_cycle(number) && number >= 200) || is_area_cycle(number) ||
                          is_thread_cycle(number) || number == 247 || is_pattern || number == 20 ||
                          mills_contours;
    if (!is_known) return fail(Message::KlartextVerb, block.whole(), {name_of_cycle(number)});
    Cycle cycle;
    cycle.number = number;
    if (!read_cycle_values(block, scan, cycle)) return false;
    report_left_out(cycle, block.whole());
    if (number == 247) {
        const auto found = cycle.values.find(339);
        if (found == cycle.values.end())
            return fail(Message::KlartextCycleParameter, block.whole(), {"247", "Q339"});
        return preset(block, found->second.number);
    }
    if (is_pattern) return pattern(cycle, block.whole());
    if (number == 20) {
        contour_data_ = std::move(cycle);
        return true;
    }
    cycle_ = std::move(cycle);
    show_defined_cycle(number, block.whole());
    return true;
}

/// CYCL DEF 7.1 X+10: cycles of several blocks with a number after the point.
bool Control::old_cycle(const Block& block, Scanner& scan, int number, int part) {
    const bool is_head = part == 0;
    switch (number) {
        case 7: return is_head || datum_shift(block, scan);
        case 8: return is_head || mirror(block, scan);
        case 9: {
            if (is_head) return true;
            skip_name(scan);
            const std::optional<double> seconds = parameters_.read_value(scan, block);
            if (!seconds) return false;
            if (*seconds < 0.0) return fail(Message::NegativeValue, block.whole(), {"the dwell"});
            return dwell(*seconds);
        }
        case 10: return is_head || rotation(block, scan);
        case 11: return is_head || scaling(block, scan, false);
        case 14: return is_head || contour_labels(block, scan);
        case 20:
        case 22:
        case 23:
        case 24:
        case 25:
            if (is_head) return numbered_cycle(block, scan, number);
            return fail(Message::KlartextVerb, block.whole(), {name_of_cycle(number)});
        case 19: return is_head || working_plane(block, scan);
        case 26: return is_head || scaling(block, scan, true);
        case 13:
        case 32: return true;
        case 1:
        case 2:
        case 17: break;
        default: return fail(Message::KlartextVerb, block.whole(), {name_of_cycle(number)});
    }
    if (is_head) {
        old_ = {};
        old_.number = number;
        show_defined_cycle(number, block.whole());
        return true;
    }
    // Pecking, tapping: SETUP, DEPTH, PECKG, DWELL, F or PITCH, in the order of the parts.
    if (old_.number != number)
        return fail(Message::KlartextVerb, block.whole(), {name_of_cycle(number)});
    const bool is_feed_part = number == 1 ? part == 5 : number == 2 ? part == 4 : false;
    const std::uint32_t parameter = part == 1      ? 200
                                    : part == 2    ? 201
                                    : is_feed_part ? 206
                                    : number == 1  ? (part == 3 ? 202 : 211)
                                    : number == 2  ? 211
                                                   : 239;
    skip_name(scan);
    // "CYCL DEF 1.4 DWELL": a value that was left empty.
    const std::optional<double> value =
        scan.is_at_end() ? std::optional(0.0) : parameters_.read_value(scan, block);
    if (!value) return false;
    old_.values[parameter] = {Value::Number, *value};
    cycle_ = old_;
    return true;
}

void Control::cycle_end(const Block& block) {
    log_.add(Message::KlartextCyclEnd, block.whole());
    calls_at_each_ = false;
}

// --- Calls ---

bool Control::cycle_call(const Block& block) {
    Scanner scan(block.code, block.rest);
    if (scan.take_word("PAT")) return fail(Message::KlartextVerb, block.whole(), {"CYCL CALL PAT"});
    const bool has_place = scan.take_word("POS");
    std::array<std::optional<double>, 3> place;
    std::array<bool, 3> is_incremental{};
    bool is_rapid = false;
    Words words;
    while (!scan.is_at_end()) {
        const std::size_t begin = scan.at();
        std::string name = upper_of(scan.letters());
        if (name == "FMAX" || (name == "F" && scan.take_word("MAX"))) {
            is_rapid = true;
            continue;
        }
        const bool increment = name.size() == 2 && name[0] == 'I';
        if (increment) name.erase(0, 1);
        const klartext::Value value = scan.value();
        const SourceSpan span = block.span(begin, scan.at() - begin);
        if (value.kind == klartext::Value::Kind::None || name.size() != 1)
            return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                        {block.code.substr(begin)});
        if (name == "M") {
            if (!take_m(block, {Address::M, false, value, span}, words)) return false;
            continue;
        }
        const std::optional<double> number = parameters_.value_of(value, span);
        if (!number) return false;
        if (name == "F") {
            words.feed = *number;
        } else if (has_place && name >= "X" && name <= "Z") {
            const auto axis = static_cast<std::size_t>(name[0] - 'X');
            place[axis] = *number;
            is_incremental[axis] = increment;
        } else {
            return fail(Message::KlartextWord, span, {name});
        }
    }
    Command command = make(block.whole());
    const double feed_before = feed_;
    if (!act_before(block, words, command)) return false;
    if (has_place) {
        const std::size_t tool_axis = axes_of(plane_).third;
        // The coordinate of the tool axis shifts the surface of the cycle.
        if (is_incremental[tool_axis])
            return fail(Message::KlartextVerb, block.whole(),
                        {"CYCL CALL POS with an increment of the tool axis"});
        surface_shift_ = place[tool_axis].value_or(0.0);
        const double surface = value(203, 0.0) + surface_shift_;
        cycle_span_ = block.whole();
        if (cycle_.number >= 200 && at_[tool_axis] < surface &&
            !is_unknown(static_cast<AxisMask>(1U << tool_axis)) &&
            !move_to(surface + value(200, 0.0), std::nullopt))
            return false;
        Axes end = at_;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!place[i] || i == tool_axis) continue;
            end[i] = is_incremental[i] ? at_[i] + *place[i] : *place[i];
            put(command, kAxisNames[i], end[i]);
            command.axis_words = true;
        }
        put(command, is_rapid || !words.feed ? Code::G0 : Code::G1);
        if (!run(command)) return false;
        arrive(end);
    } else if (!run(command)) {
        return false;
    }
    const bool done = call_cycle(block.whole());
    surface_shift_ = 0.0;
    if (!done) return false;
    // The feed of the block acts up to the position.
    if (has_place && words.feed) {
        feed_ = feed_before;
        machine_.state().feed = feed_of(feed_before);
    }
    // A call by M99 or M89 in the same block is the same call.
    std::erase(words.m, 99);
    std::erase(words.m, 89);
    return act_after(block, words);
}

// --- Patterns ---

/// Returns the places of cycle 220 (on a circle) or 221 (on lines).
std::vector<Control::Point> Control::places_of(const Cycle& pattern) const {
    const auto q = [&](std::uint32_t index) {
        const auto found = pattern.values.find(index);
        return found == pattern.values.end() ? 0.0 : found->second.number;
    };
    const auto whole = [](double number) {
        constexpr double kMost = 10'000.0;
        return static_cast<int>(std::clamp(std::round(number), 0.0, kMost));
    };
    std::vector<Point> places;
    if (pattern.number == 220) {
        const int count = whole(q(241));
        // Without a step the angle between start and end is divided; a full circle has one place
        // less than divisions.
        const double range = q(246) - q(245);
        const bool is_full = std::abs(range) == 360.0;
        const double divisions = is_full ? count : std::max(1, count - 1);
        const double step = q(247) != 0.0 ? q(247) : range / divisions;
        for (int i = 0; i < count; ++i) {
            const SinCos direction = sin_cos(q(245) + i * step);
            const double radius = q(244) / 2.0;
            places.push_back({q(216) + radius * direction.cos, q(217) + radius * direction.sin});
        }
        return places;
    }
    const int columns = whole(q(242));
    const int rows = whole(q(243));
    const SinCos direction = sin_cos(q(224));
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < columns; ++i) {
            // Every second line runs back.
            const int column = row % 2 == 0 ? i : columns - 1 - i;
            const double x = column * q(237);
            const double y = row * q(238);
            places.push_back({q(225) + x * direction.cos - y * direction.sin,
                              q(226) + x * direction.sin + y * direction.cos});
        }
    }
    return places;
}

/// 220, 221: runs the defined cycle at the places of a pattern. Q200, Q203 and Q204 of the pattern
/// replace those of the cycle.
bool Control::pattern(const Cycle& pattern, SourceSpan span) {
    constexpr double kMostPlaces = 10'000.0;
    const std::string name = std::to_string(pattern.number);
    const auto required = pattern.number == 220 ? std::array{216U, 217U, 244U, 241U}
                                                : std::array{225U, 226U, 242U, 243U};
    for (const std::uint32_t q : required) {
        if (!pattern.values.contains(q))
            return fail(Message::KlartextCycleParameter, span, {name, "Q" + std::to_string(q)});
    }
    const auto q = [&](std::uint32_t index, double otherwise) {
        const auto found = pattern.values.find(index);
        return found == pattern.values.end() ? otherwise : found->second.number;
    };
    const double columns = std::round(q(pattern.number == 220 ? 241 : 242, 0.0));
    const double rows = pattern.number == 220 ? 1.0 : std::round(q(243, 0.0));
    if (!(columns >= 1.0 && rows >= 1.0 && columns * rows <= kMostPlaces))
        return fail(Message::BlockNeeds, span,
                    {"cycle " + name, "a number of places from 1 to 10000"});
    if (q(365, 0.0) != 0.0)
        return fail(Message::KlartextVerb, span, {"cycle 220 with arcs between (Q365=1)"});
    if (cycle_.number < 200) {
        log_.add(Message::KlartextCycleUndefined, span);
        return true;
    }
    for (const std::uint32_t index : {200U, 203U, 204U}) {
        const auto found = pattern.values.find(index);
        if (found != pattern.values.end()) cycle_.values[index] = found->second;
    }
    const double second = value(204, 0.0);
    const bool stays_low = q(301, 1.0) == 0.0;
    const std::vector<Point> places = places_of(pattern);
    cycle_span_ = span;
    const double safe = value(203, 0.0) + std::max(second, value(200, 0.0));
    const std::size_t axis = axes_of(plane_).third;
    const bool is_lower = at_[axis] < safe || is_unknown(static_cast<AxisMask>(1U << axis));
    if (is_lower && !move_to(safe, std::nullopt)) return false;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!go_to(places[i], true, span)) return false;
        const bool is_last = i + 1 == places.size();
        cycle_.values[204].number = stays_low && !is_last ? 0.0 : second;
        if (!call_cycle(span)) return false;
    }
    return true;
}

std::optional<double> Control::value(std::uint32_t q) const {
    const auto found = cycle_.values.find(q);
    if (found == cycle_.values.end()) return std::nullopt;
    return found->second.number;
}

/// Returns the feed `q` of the cycle; nullopt for a rapid (MAX).
std::optional<double> Control::feed_value(std::uint32_t q) const {
    const auto found = cycle_.values.find(q);
    if (found == cycle_.values.end() || found->second.kind == Value::Rapid) return std::nullopt;
    return found->second.number;
}

/// Returns the feed out of a hole (Q208): the feed `down` for 0 and without Q208; nullopt for FMAX.
std::optional<double> Control::feed_out(double down) const {
    if (!cycle_.values.contains(208)) return down;
    const std::optional<double> up = feed_value(208);
    if (!up) return std::nullopt;
    return *up > 0.0 ? feed_of(*up) : down;
}

bool Control::needs(std::initializer_list<std::uint32_t> parameters, SourceSpan span) {
    for (const std::uint32_t q : parameters) {
        if (cycle_.values.contains(q)) continue;
        return fail(Message::KlartextCycleParameter, span,
                    {std::to_string(cycle_.number), "Q" + std::to_string(q)});
    }
    return true;
}

/// Executes the defined cycle at the position of the tool.
bool Control::call_cycle(SourceSpan span) {
    if (cycle_.number < 0) {
        log_.add(Message::KlartextCycleUndefined, span);
        return true;
    }
    if (side_ != CutterSide::Off)
        return fail(Message::KlartextVerb, span, {"a cycle under RL or RR"});
    if (records_contour_) return fail(Message::KlartextVerb, span, {"a cycle in a contour"});
    const SourceSpan definition = cycle_span_;
    cycle_span_ = span;
    MachineState& state = machine_.state();
    const double feed = state.feed;
    const FeedMode mode = state.feed_mode;
    state.feed_mode = FeedMode::PerMinute;
    const bool done = drill(span);
    machine_.state().feed = feed;
    machine_.state().feed_mode = mode;
    cycle_span_ = definition;
    return done;
}

bool Control::drill(SourceSpan span) {
    const int number = cycle_.number;
    if (number == 204) return back_bore(span);
    if (number >= 22 && number <= 24) return mill_contours(span);
    if (number == 25) return mill_contour_train(span);
    if (is_thread_cycle(number)) return thread_cycle(span);
    if (!needs({200, 201}, span)) return false;
    const std::string name = std::to_string(number);
    const double depth = value(201, 0.0);
    const bool by_diameter = number == 240 && value(343, 0.0) == 1.0;
    if (by_diameter)
        return fail(Message::KlartextVerb, span, {"cycle 240 by the diameter (Q343=1)"});
    if (depth > 0.0) {
        log_.add(Message::KlartextDepthPositive, span, {name});
        return true;
    }
    if (depth == 0.0) {
        log_.add(Message::KlartextDepthZero, span, {name});
        return true;
    }
    const bool needs_radius = number == 208 || is_area_cycle(number);
    if (needs_radius && !(radius_of_tool().value_or(0.0) > 0.0)) {
        report_unknown_radius("cycle " + name);
        return true;
    }
    const std::size_t axis = axes_of(plane_).third;
    // The old cycles begin at the clearance above the surface.
    const bool is_old = number < 100;
    const double clearance = value(200, 0.0);
    const double surface = is_old ? at_[axis] - clearance : value(203, 0.0) + surface_shift_;
    const double clear = surface + clearance;
    const double bottom = surface + depth;
    if (!move_to(clear, std::nullopt)) return false;
    const double down = feed_of(feed_value(206).value_or(0.0));
    bool done = true;
    switch (number) {
        case 240:
            done = needs({206}, span) && move_to(bottom, down) && dwell(value(211, 0.0)) &&
                   move_to(clear, std::nullopt);
            break;
        case 201:
            done = needs({206}, span) && move_to(bottom, down) && dwell(value(211, 0.0)) &&
                   move_to(clear, feed_out(down));
            break;
        case 202: done = needs({206}, span) && bore(bottom, clear); break;
        case 2:
        case 17:
        case 206:
        case 207:
        case 209: done = tap(span, surface, bottom, clear); break;
        case 208: done = bore_mill(span, bottom, clear); break;
        case 251:
        case 252:
        case 253:
        case 254:
        case 256:
        case 257:
        case 258: done = mill_area(span, bottom, clear); break;
        case 241: done = single_lip_drill(span, surface, bottom, clear); break;
        default: done = peck(span, surface, bottom, clear); break;
    }
    if (!done) return false;
    // The second clearance is a height above the surface; never down.
    const double second = surface + value(204, 0.0);
    return second <= clear || move_to(second, std::nullopt);
}

/// 1, 200, 203 and 205: infeeds with retraction or chip breaking.
bool Control::peck(SourceSpan span, double surface, double bottom, double clear) {
    if (!needs({206, 202}, span)) return false;
    const int number = cycle_.number;
    const double down = feed_of(feed_value(206).value_or(0.0));
    const double infeed = std::abs(value(202, 0.0));
    const double decrement = number == 200 || number == 1 ? 0.0 : std::abs(value(212, 0.0));
    const double least = std::min(infeed, std::abs(value(205, 0.0)));
    std::optional<double> up;  // Retract feed; empty: rapid.
    if (number == 203 || number == 205) {
        if (const std::optional<double> feed = feed_value(208))
            up = feed_of(*feed > 0.0 ? *feed : feed_value(206).value_or(0.0));
    }
    const double breaking = number == 203 || number == 205 ? std::abs(value(256, 0.0)) : 0.0;
    const double breaks = number == 203 ? value(213, 0.0) : 0.0;
    const double broken_depth = number == 205 ? std::abs(value(257, 0.0)) : 0.0;
    const double ahead = number == 205 && value(258)
                             ? std::abs(*value(258))
                             : options_.peck_clearance.value_or(0.2 / machine_.state().unit_mm());
    double from = surface;
    if (number == 205 && value(379, 0.0) != 0.0) {
        // Deepened start: the tool goes there with the feed of pre-positioning.
        from = surface - std::abs(value(379, 0.0));
        if (from <= bottom) from = surface;
        const std::optional<double> feed = feed_value(253);
        if (from < surface && !move_to(from, feed ? std::optional(feed_of(*feed)) : std::nullopt))
            return false;
    }
    language::Pecks pecks;
    pecks.surface = surface;
    pecks.bottom = bottom;
    pecks.clear = clear;
    pecks.from = from;
    pecks.infeed = infeed;
    pecks.decrement = decrement;
    pecks.least = least;
    pecks.ahead = ahead;
    if (number == 205 && value(259)) pecks.last_ahead = std::abs(*value(259));
    pecks.breaking = breaking;
    pecks.breaks = breaks;
    pecks.break_depth = broken_depth;
    pecks.feed = down;
    pecks.up = up;
    pecks.dwell_above = value(210, 0.0);
    pecks.dwell_below = value(211, 0.0);
    return peck(pecks, Message::CycleRepeats);
}

/// 241: drills with a single-lip drill. The tool goes to a deepened start (Q379) and out of the
/// hole with the speed Q427, and drills with the speed Q428.
bool Control::single_lip_drill(SourceSpan span, double surface, double bottom, double clear) {
    if (!needs({206}, span)) return false;
    const double deepened = surface - std::abs(value(379, 0.0));
    const double from = deepened < surface && deepened > bottom ? deepened : surface;
    MachineState& state = machine_.state();
    const double speed = state.spindle_rpm;
    const SpindleTurning turning = state.spindle;
    const auto turn = [&](bool drills) {
        using enum SpindleTurning;
        const double direction = drills ? 3.0 : value(426, 3.0);
        state.spindle = direction == 5.0   ? Stopped
                        : direction == 4.0 ? Counterclockwise
                                           : Clockwise;
        state.spindle_rpm = value(drills ? 428 : 427, speed);
    };
    language::Pecks pecks;
    pecks.surface = surface;
    pecks.from = from;
    pecks.bottom = bottom;
    // Between infeeds the tool stays in its guiding hole.
    pecks.clear = from < surface ? from : clear;
    pecks.infeed = std::abs(value(202, 0.0));
    pecks.decrement = std::abs(value(212, 0.0));
    pecks.least = std::min(pecks.infeed, std::abs(value(205, 0.0)));
    pecks.ahead = options_.peck_clearance.value_or(0.2 / state.unit_mm());
    pecks.feed = feed_of(feed_value(206).value_or(0.0));
    pecks.up = feed_out(pecks.feed);
    pecks.dwell_below = value(211, 0.0);
    turn(false);
    bool done = from == surface || move_to(from, feed_or_rapid(253));
    turn(true);
    done = done && peck(pecks, Message::CycleRepeats);
    turn(false);
    done = done && move_to(clear, pecks.up);
    state.spindle = turning;
    state.spindle_rpm = speed;
    return done;
}

/// 202: the spindle is oriented at the bottom, and the tool steps away from the wall (Q214).
bool Control::bore(double bottom, double clear) {
    const double down = feed_of(feed_value(206).value_or(0.0));
    if (!move_to(bottom, down) || !dwell(value(211, 0.0))) return false;
    return bore_out(clear, feed_out(down), value(214, 0.0) != 0.0);
}

/// 204: bores upwards from below the part. The tool goes through the hole with the spindle
/// oriented, aside by Q251.
bool Control::back_bore(SourceSpan span) {
    if (!needs({200, 249, 250, 252, 253, 254, 203}, span)) return false;
    const double surface = value(203, 0.0) + surface_shift_;
    const double clear = surface + value(200, 0.0);
    const double lower_edge = surface - std::abs(value(250, 0.0));
    const double edge = std::abs(value(252, 0.0));  // Height of the cutting edge above the tip.
    const double below = lower_edge - value(200, 0.0) - edge;
    const double bottom = lower_edge + std::abs(value(249, 0.0)) - edge;
    const SpindleTurning turning = machine_.state().spindle;
    const auto orient = [&](bool on) {
        MachineState& state = machine_.state();
        state.spindle = on ? SpindleTurning::Stopped : turning;
        state.spindle_oriented = on;
        if (on) state.steps_aside = value(251, 0.0) != 0.0;
        if (!on) state.steps_aside.reset();
    };
    bool done = move_to(clear, std::nullopt);
    orient(true);
    done = done && move_to(below, feed_or_rapid(253));
    orient(false);
    done = done && move_to(bottom, feed_or_rapid(254)) && dwell(value(255, 0.0)) &&
           move_to(below, feed_or_rapid(253));
    orient(true);
    done = done && move_to(clear, feed_or_rapid(253));
    orient(false);
    const double second = surface + value(204, 0.0);
    return done && (second <= clear || move_to(second, std::nullopt));
}

/// 2, 17, 206, 207, 209: taps; the spindle turns back at the bottom.
bool Control::tap(SourceSpan span, double surface, double bottom, double clear) {
    MachineState& state = machine_.state();
    const int number = cycle_.number;
    const bool is_rigid = number == 17 || number == 207 || number == 209;
    if (!(is_rigid ? needs({239}, span) : needs({206}, span))) return false;
    language::Tapping tapping;
    tapping.surface = surface;
    tapping.bottom = bottom;
    tapping.clear = clear;
    tapping.feed = feed_of(feed_value(206).value_or(0.0));
    tapping.in = tapping.after = state.spindle;
    if (is_rigid) {
        tapping.feed = std::abs(value(239, 0.0)) * state.spindle_rpm;
        tapping.in =
            value(239, 0.0) < 0.0 ? SpindleTurning::Counterclockwise : SpindleTurning::Clockwise;
    }
    tapping.feed_out = tapping.feed;
    if (number == 209) {
        tapping.step = std::abs(value(257, 0.0));
        tapping.breaking = std::abs(value(256, 0.0));
    }
    tapping.dwell = value(211, 0.0);
    return tap(tapping, Message::CycleRepeats);
}

/// 208: mills a bore along a helix.
/// Requires: the radius of the tool is known.
bool Control::bore_mill(SourceSpan span, double bottom, double clear) {
    if (!needs({206, 334, 335}, span)) return false;
    const double radius = value(335, 0.0) / 2.0 - *radius_of_tool();
    const double infeed = std::abs(value(334, 0.0));
    if (!(radius > 0.0))
        return fail(Message::BlockNeeds, span, {"cycle 208", "a diameter larger than the tool"});
    const double feed = feed_of(feed_value(206).value_or(0.0));
    const bool is_climb = value(351, 1.0) >= 0.0;
    const bool is_clockwise = machine_.state().spindle == SpindleTurning::Counterclockwise;
    const bool is_left = is_climb != is_clockwise;  // Climb milling in a bore: counter-clockwise.
    const Vec2 centre = point_in_plane();
    const Vec2 edge{centre.x + radius, centre.y};
    const Vec2 between{centre.x + radius / 2.0, centre.y};
    const int turn = is_left ? 1 : -1;
    // The helix begins at the clearance; each turn goes down by the infeed.
    return cut({centre, edge, between, turn}, clear, feed) &&
           wind(centre, bottom, infeed, !is_left, feed) &&
           wind(centre, bottom, 0.0, !is_left, feed) &&
           cut({edge, centre, between, turn}, bottom, feed) && move_to(clear, std::nullopt);
}

}  // namespace ncsim::gcode::klartext
