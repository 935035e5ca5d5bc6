// SPDX-License-Identifier: GPL-3.0-or-later
//
// TOOL CALL and TOOL DEF.
#include "klartext/control.h"
#include "klartext/reader.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::klartext {

std::vector<std::string> tool_names(const SourceFile& program) {
    constexpr std::size_t kMostNames = 1000;
    std::vector<std::string> names;
    if (program.text.find('"') == std::string::npos) return names;
    Reader reader(program);
    Block block;
    while (names.size() < kMostNames && reader.next_verb(block)) {
        if (block.verb != Verb::ToolCall) continue;
        Scanner scan(block.code, block.rest);
        const std::optional<std::string_view> name = scan.quoted();
        if (name && std::ranges::find(names, *name) == names.end()) names.emplace_back(*name);
    }
    return names;
}

/// Reads the tool of TOOL CALL. `has_tool`: false if the block has no tool.
/// Returns: nullopt after reporting an error.
std::optional<int> Control::tool_number(Scanner& scan, const Block& block, bool& has_tool) {
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    std::optional<std::string> name;
    if (const auto quoted = scan.quoted()) {
        name = std::string(*quoted);
    } else if (upper_of(block.code.substr(begin, 2)) == "QS" && is_digit(scan.peek(2))) {
        scan.move_to(begin + 2);
        const std::uint32_t index = scan.whole().value_or(0);
        name = parameters_.text(index);
        if (!name) {
            log_.add(Message::BlockNeeds, block.span(begin, scan.at() - begin),
                     {"TOOL CALL", "the name of a tool"});
            return std::nullopt;
        }
    }
    if (name) {
        has_tool = true;
        const int number = number_of(*name);
        log_.add(Message::NamedTool, block.span(begin, scan.at() - begin),
                 {"\"" + *name + "\"", std::to_string(number)});
        return number;
    }
    const klartext::Value value = scan.value();
    if (value.kind == klartext::Value::Kind::None) {
        has_tool = false;
        return tool_;
    }
    has_tool = true;
    const SourceSpan span = block.span(begin, scan.at() - begin);
    const std::optional<double> number = parameters_.value_of(value, span);
    if (!number) return std::nullopt;
    // "5.1" is the tool 5 with its offsets of step 1.
    if (!(*number >= 0.0 && *number < 1e8)) {
        log_.add(Message::KlartextWord, span, {"a tool number out of range"});
        return std::nullopt;
    }
    if (*number != std::floor(*number)) {
        log_.add(Message::KlartextVerb, span, {"a step of a tool (T.1)"});
        return std::nullopt;
    }
    return static_cast<int>(*number);
}

/// Returns the radius of the tool with the oversize of TOOL CALL, in active units.
std::optional<double> Control::radius_of_tool() const {
    const std::optional<double> diameter = diameter_of(tool_);
    if (!diameter) return std::nullopt;
    return *diameter / 2.0 + radius_oversize_;
}

bool Control::tool_call(const Block& block) {
    Scanner scan(block.code, block.rest);
    bool has_tool = false;
    const std::optional<int> number = tool_number(scan, block, has_tool);
    if (!number) return false;
    std::optional<double> speed;
    std::optional<double> feed;
    double oversize = 0.0;
    std::optional<Plane> plane;
    while (!scan.is_at_end()) {
        const std::size_t begin = scan.at();
        const std::string name = upper_of(scan.letters());
        const auto refuse = [&] {
            std::size_t end = begin;
            while (end < block.code.size() && !is_blank(block.code[end]))
                ++end;
            return fail(Message::KlartextWord, block.span(begin, end - begin),
                        {block.code.substr(begin, end - begin)});
        };
        if (name == "X" || name == "Y" || name == "Z") {
            plane = name == "X" ? Plane::YZ : name == "Y" ? Plane::ZX : Plane::XY;
            continue;
        }
        // "SQ5", "FQ5"
        if ((name == "SQ" || name == "FQ") && is_digit(scan.peek())) scan.move_to(begin + 1);
        const bool is_corner = name == "DR" && scan.peek() == '2' &&
                               (scan.peek(1) == '+' || scan.peek(1) == '-' || scan.peek(1) == ':' ||
                                is_blank(scan.peek(1)));
        if (is_corner) scan.move_to(scan.at() + 1);
        if (name != "S" && name != "SQ" && name != "F" && name != "FQ" && name != "DL" &&
            name != "DR")
            return refuse();
        if (scan.peek() == ':') scan.move_to(scan.at() + 1);
        const std::size_t value_at = scan.at();
        const std::optional<double> value = parameters_.read_value(scan, block);
        if (!value) return false;
        const SourceSpan span = block.span(begin, scan.at() - begin);
        (void)value_at;
        if (name[0] == 'S') speed = *value;
        if (name[0] == 'F') feed = *value;
        if (name == "DL" && *value != 0.0)
            return fail(Message::KlartextVerb, span, {"an oversize of the length (DL)"});
        if (name == "DR" && !is_corner) oversize = *value;
    }
    if (speed && *speed < 0.0) return fail(Message::NegativeValue, block.whole(), {"S"});
    if (feed) {
        if (*feed < 0.0) return fail(Message::NegativeValue, block.whole(), {"F"});
        tool_feed_ = *feed;
        feed_ = *feed;
    }
    Command command = make(block.whole());
    if (speed) put(command, 'S', *speed);
    if (feed) put(command, 'F', feed_of(*feed));
    const bool changes_plane = plane && *plane != plane_;
    if (plane) {
        plane_ = *plane;
        put(command, code_of(plane_));
    }
    if (has_tool) {
        radius_oversize_ = oversize;
        if (*number != tool_ || machine_.state().tool != *number) {
            check_tool_change(block.whole());
            put(command, 'T', *number);
            command.m[static_cast<std::size_t>(MGroup::ToolChange)] = 6;
            tool_ = *number;
        }
        if (*number == 0) {
            put(command, Code::G49);
        } else {
            put(command, Code::G43);
            put(command, 'H', *number);
        }
        parameters_.set_system(109, plane_ == Plane::XY ? 2.0 : plane_ == Plane::ZX ? 1.0 : 0.0);
    }
    if (!run(command)) return false;
    if (has_tool) {
        if (const std::optional<double> radius = radius_of_tool())
            parameters_.set_system(108, *radius);
    }
    refresh();
    if (changes_plane) centre_.reset(), tangent_.reset();
    return true;
}

bool Control::tool_def(const Block& block) {
    Scanner scan(block.code, block.rest);
    if (scan.quoted() || scan.is_at_end()) return true;  // Only prepares the tool.
    if (upper_of(scan.remaining()).starts_with("QS")) return true;
    const std::optional<double> number = parameters_.read_value(scan, block);
    if (!number) return false;
    std::optional<double> length;
    std::optional<double> radius;
    while (!scan.is_at_end()) {
        const std::size_t begin = scan.at();
        const std::string name = upper_of(scan.letters());
        const std::optional<double> value = name == "L" || name == "R" || name == "F"
                                                ? parameters_.read_value(scan, block)
                                                : std::nullopt;
        if (!value) {
            return fail(Message::KlartextWord, block.span(begin, block.code.size() - begin),
                        {block.code.substr(begin)});
        }
        if (name == "L") length = *value;
        if (name == "R") radius = *value;
    }
    const bool has_values = length.value_or(0.0) != 0.0 || radius.value_or(0.0) != 0.0;
    if (!has_values || !(*number >= 1.0 && *number < 1e6)) return true;
    const auto& tools = machine_.control().store->tools;
    const auto entry = std::ranges::find(tools, static_cast<int>(*number), &ToolTableEntry::number);
    const bool is_known = entry != tools.end() && entry->diameter;
    Command command = make(block.whole());
    put(command, Code::G10);
    put(command, 'L', 1.0);
    put(command, 'P', std::floor(*number));
    if (length.value_or(0.0) != 0.0) put(command, 'Z', *length);
    if (radius.value_or(0.0) != 0.0 && !is_known) put(command, 'R', *radius);
    command.axis_words = command.has('Z');
    return run(command);
}

}  // namespace ncsim::gcode::klartext
