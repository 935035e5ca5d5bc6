// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions of cycles, calls, patterns of places.
// Source: HEIDENHAIN TNC 640, User's Manual for Cycle Programming, 892903.
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
    const bool at_places = scan.take_word("PAT");
    const bool has_place = !at_places && scan.take_word("POS");
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
    const bool done = at_places ? call_at_places(is_rapid || !words.feed, block.whole())
                                : call_cycle(block.whole());
    surface_shift_ = 0.0;
    if (!done) return false;
    // The feed of the block acts up to the position.
    if ((has_place || at_places) && words.feed) {
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

}  // namespace ncsim::gcode::klartext
