// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text of blocks and motions.
#include "ncsim/gcode/print.h"

#include <array>
#include <charconv>
#include <cmath>

namespace ncsim::gcode {
namespace {

void print_word(std::string& out, std::string_view letter, double value) {
    out.append(1, ' ').append(letter);
    print_number(out, value);
}

std::string_view name_of(ControlWord word) {
    switch (word) {
        case ControlWord::None: return "";
        case ControlWord::ProgramNumber: return "program";
        case ControlWord::Sub: return "sub";
        case ControlWord::EndSub: return "endsub";
        case ControlWord::Call: return "call";
        case ControlWord::Return: return "return";
        case ControlWord::OIf:
        case ControlWord::If: return "if";
        case ControlWord::OElseIf: return "elseif";
        case ControlWord::OElse: return "else";
        case ControlWord::OEndIf: return "endif";
        case ControlWord::OWhile:
        case ControlWord::While: return "while";
        case ControlWord::OEndWhile: return "endwhile";
        case ControlWord::ODo: return "do";
        case ControlWord::ORepeat: return "repeat";
        case ControlWord::OEndRepeat: return "endrepeat";
        case ControlWord::OBreak: return "break";
        case ControlWord::OContinue: return "continue";
        case ControlWord::Goto: return "goto";
        case ControlWord::End: return "end";
    }
    return "";
}

void print_control(std::string& out, const Control& control) {
    const bool is_macro = control.word >= ControlWord::If;
    out += is_macro ? " " : " O";
    if (!is_macro) out.append(control.label).append(1, ' ');
    out.append(name_of(control.word));
    if (!control.expression.empty()) out.append(1, ' ').append(control.expression);
    if (is_macro && !control.label.empty()) out.append(" -> ").append(control.label);
}

// Rounds to a picometre, finer than the resolution of any control, to hide rounding errors of
// offsets and inches.
double picometres(double mm) {
    constexpr double kPerMm = 1e9;
    return std::abs(mm) < 1e6 ? std::round(mm * kPerMm) / kPerMm : mm;
}

void print_position(std::string& out, const Position& at) {
    print_word(out, "X", picometres(at.x.mm()));
    print_word(out, "Y", picometres(at.y.mm()));
    print_word(out, "Z", picometres(at.z.mm()));
    if (at.a != Angle()) print_word(out, "A", at.a.degrees());
    if (at.b != Angle()) print_word(out, "B", at.b.degrees());
    if (at.c != Angle()) print_word(out, "C", at.c.degrees());
    if (at.u != Length()) print_word(out, "U", picometres(at.u.mm()));
    if (at.v != Length()) print_word(out, "V", picometres(at.v.mm()));
    if (at.w != Length()) print_word(out, "W", picometres(at.w.mm()));
}

void print_manner(std::string& out, const Motion& motion) {
    if (motion.kind != MoveKind::Rapid) {
        print_word(out, "F", motion.feed);
        if (motion.feed_mode == FeedMode::InverseTime) out += "/inverse-time";
        if (motion.feed_mode == FeedMode::PerRevolution) out += "/rev";
    }
    if (motion.spindle != SpindleTurning::Stopped) {
        print_word(out, motion.spindle == SpindleTurning::Clockwise ? "S" : "S-",
                   motion.spindle_rpm);
    }
    if (motion.tool != 0) print_word(out, "T", motion.tool);
    if (motion.machine_coordinates) out += " machine";
    const KnownAxes& known = motion.known_start;
    if (!known.all()) {
        out += " from-unknown-";
        if (!known.x) out += 'x';
        if (!known.y) out += 'y';
        if (!known.z) out += 'z';
    } else if (motion.start_assumed) {
        out += " start-assumed";
    }
}

std::string_view name_of(Plane plane) {
    constexpr std::array<std::string_view, 6> kNames = {"XY", "ZX", "YZ", "UV", "WU", "VW"};
    return kNames[static_cast<std::size_t>(plane)];
}

}  // namespace

void print_number(std::string& out, double value) {
    if (value == 0.0) value = 0.0;  // -0 is printed as 0.
    std::array<char, 40> text{};
    const bool ordinary = std::abs(value) < 1e15 && (value == 0.0 || std::abs(value) > 1e-9);
    const auto format = ordinary ? std::chars_format::fixed : std::chars_format::scientific;
    const auto* const end =
        std::to_chars(text.data(), text.data() + text.size(), value, format).ptr;
    const char* first = text.data();
    if (value == 0.0 && *first == '-') ++first;
    out.append(first, end);
}

void print(std::string& out, const Block& block) {
    const std::size_t start = out.size();
    // A slash within the block is printed before the first part that it deletes.
    bool has_slash = block.block_delete || block.deletable.length == 0;
    const auto slash_before = [&](SourceSpan span) {
        if (!has_slash && span.column > block.deletable.column) {
            out += " /";
            has_slash = true;
        }
    };
    if (block.block_delete) out += " /";
    if (block.has_number) print_word(out, "N", block.number);
    if (block.kind == BlockKind::Percent) out += " %";
    if (block.kind == BlockKind::Command) out.append(" command");
    if (block.kind == BlockKind::Unreadable) out.append(" unreadable");
    if (block.control.word != ControlWord::None) print_control(out, block.control);
    for (const Assignment& assignment : block.assignments) {
        slash_before(assignment.span);
        out.append(" #").append(assignment.target).append(1, '=').append(assignment.value);
    }
    for (const Word& word : block.words) {
        slash_before(word.span);
        out += word.comma ? " ," : " ";
        out += word.letter;
        if (word.literal) {
            print_number(out, word.number);
        } else {
            out += word.text;
        }
    }
    if (!block.program_name.empty()) out.append(" <").append(block.program_name).append(1, '>');
    for (const Comment& comment : block.comments) {
        out.append(comment.semicolon ? " ;" : " (").append(comment.text);
        if (!comment.semicolon) out += ')';
    }
    if (out.size() > start) out.erase(start, 1);
}

void print(std::string& out, const Motion& motion) {
    out += 'L';
    out += std::to_string(motion.span.line);
    if (motion.file != 0) out.append("@").append(std::to_string(motion.file));
    out += ' ';
    if (const auto* line = std::get_if<Linear>(&motion.action)) {
        out += name_of(motion.kind);
        print_position(out, line->to);
        print_manner(out, motion);
    } else if (const auto* arc = std::get_if<Arc>(&motion.action)) {
        out.append("arc ").append(name_of(arc->plane));
        print_position(out, arc->to);
        print_word(out, "centre ", picometres(arc->centre_1.mm()));
        print_word(out, "", picometres(arc->centre_2.mm()));
        print_word(out, "turns ", arc->turns);
        if (arc->tilted) {
            out += " tilted";
            for (const double v : arc->tilted->origin)
                print_word(out, "", picometres(v));
            for (const Triple& row : arc->tilted->rows) {
                for (const double v : row)
                    print_word(out, "", picometres(v));
            }
        }
        print_manner(out, motion);
    } else if (const auto* spline = std::get_if<Spline>(&motion.action)) {
        out += "spline";
        print_position(out, spline->to);
        print_word(out, "order ", spline->order);
        for (const Spline::ControlPoint& point : spline->control_points) {
            out += " [";
            print_number(out, picometres(point.x.mm()));
            print_word(out, "", picometres(point.y.mm()));
            print_word(out, "*", point.weight);
            out += ']';
        }
        print_manner(out, motion);
    } else if (const auto* dwell = std::get_if<Dwell>(&motion.action)) {
        out += "dwell ";
        print_number(out, dwell->seconds);
    } else if (const auto* change = std::get_if<ToolChange>(&motion.action)) {
        out += "tool ";
        print_number(out, change->tool);
        out += " at";
        print_position(out, change->at);
    }
}

}  // namespace ncsim::gcode
