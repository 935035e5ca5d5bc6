// SPDX-License-Identifier: GPL-3.0-or-later
//
// Commands, positions, arcs and tools.
#include "language/block_control.h"

#include "ncsim/base/angles.h"

#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ncsim::gcode::language {
namespace {

const gcode::Block kNoWords;

}  // namespace

BlockControl::BlockControl(const InterpreterOptions& options, Controller& machine,
                           DiagnosticLog& log)
    : options_(options), machine_(machine), log_(log) {
    machine_.state().absolute_centres = true;
    at_ = machine_.state().programmed_position();
}

bool BlockControl::fail(const MessageText& message, SourceSpan span,
                        std::initializer_list<std::string_view> arguments) {
    log_.add(message, span, arguments);
    return false;
}

Command BlockControl::make(SourceSpan span) {
    return empty_command(kNoWords, span);
}

void put(Command& command, const Corner& corner) {
    command.corner = corner.letter;
    command.corner_size = corner.size;
    command.corner_is_modal = corner.is_modal;
    command.corner_feed = corner.feed;
    command.corner_span = corner.span;
}

bool BlockControl::run(const Command& command) {
    machine_.set_origin(command.span, file_);
    const bool done = machine_.execute(command);
    const Code motion = command.group(Group::Motion);
    if (command.axis_words) {
        const double height = machine_.state().position[axes_of(plane_).third];
        highest_ = std::max(highest_.value_or(height), height);
        if (motion >= Code::G1 && motion <= Code::G3)
            lowest_feed_ = std::min(lowest_feed_.value_or(height), height);
    }
    if (machine_.stopped()) return false;
    if (!done) refresh();
    return true;
}

bool BlockControl::is_unknown(AxisMask mask) const {
    const MachineState& state = machine_.state();
    for (std::size_t i = kX; i <= kZ; ++i) {
        if ((mask >> i & 1U) != 0 && (!state.known[i] || state.relative[i])) return true;
    }
    return false;
}

void BlockControl::show_defined_cycle(int number, SourceSpan span) {
    machine_.state().defined_cycle = {number, number != 0 ? span.line : 0};
}

void BlockControl::end_program(SourceSpan span) {
    show_defined_cycle(0, span);
    for (const ActiveMode& mode : modes_left_on())
        log_.add(Message::LeftOnAtEnd, span, {mode.name, mode.end});
    machine_.flush();
    machine_.finish();
    has_ended_ = true;
}

void BlockControl::check_tool_change(SourceSpan span) {
    for (const ActiveMode& mode : modes_at_change())
        log_.add(Message::LeftOnAtChange, span, {mode.name, mode.end});
    constexpr double kAbove = 1e-6;
    const double height = machine_.state().position[axes_of(plane_).third];
    const bool has_cut = lowest_feed_ && *lowest_feed_ < *highest_ - kAbove;
    if (has_cut && height <= *lowest_feed_ + kAbove) log_.add(Message::ChangeWithoutRetract, span);
    lowest_feed_.reset();
    highest_.reset();
}

void BlockControl::refresh() {
    lowest_feed_.reset();
    highest_.reset();
    at_ = machine_.state().programmed_position();
}

void BlockControl::arrive(const Axes& end) {
    const PlaneAxes axes = axes_of(plane_);
    const double dx = end[axes.first] - at_[axes.first];
    const double dy = end[axes.second] - at_[axes.second];
    if (dx != 0.0 || dy != 0.0) tangent_ = {{dx, dy}};
    at_ = end;
}

// --- Arcs ---

/// Computes the element that continues the last element tangentially to `end`. An end on the
/// tangent gives a line.
/// Requires: `tangent_` is set.
BlockControl::Tangent BlockControl::tangent_arc(const Axes& end, ProgramArc& arc) const {
    constexpr double kFlat = 1e-9;
    const PlaneAxes axes = axes_of(plane_);
    const double length = hypotenuse((*tangent_)[0], (*tangent_)[1]);
    const double dx = (*tangent_)[0] / length;
    const double dy = (*tangent_)[1] / length;
    const double cx = end[axes.first] - at_[axes.first];
    const double cy = end[axes.second] - at_[axes.second];
    const double across = dx * cy - dy * cx;  // Positive: the end is on the left.
    const double chord = hypotenuse(cx, cy);
    if (std::abs(across) <= kFlat * chord)
        return chord == 0.0 || dx * cx + dy * cy < 0.0 ? Tangent::None : Tangent::Line;
    const double radius = chord * chord / (2.0 * across);  // Signed: positive to the left.
    arc.end = end;
    arc.centre_1 = at_[axes.first] - radius * dy;
    arc.centre_2 = at_[axes.second] + radius * dx;
    arc.turns = radius > 0.0 ? 1 : -1;
    return Tangent::Arc;
}

bool BlockControl::make_arc(const ProgramArc& arc, AxisMask named, std::optional<double> radius,
                            Command command) {
    const PlaneAxes axes = axes_of(plane_);
    put(command, arc.turns > 0 ? Code::G3 : Code::G2);
    const Axes start = at_;
    double c1 = arc.centre_1;
    double c2 = arc.centre_2;
    for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
        if (i == axes.first || i == axes.second || (named >> i & 1U) != 0)
            put(command, kAxisNames[i], arc.end[i]);
    }
    command.axis_words = true;
    if (radius) {
        put(command, 'R', *radius);
        // Centre, for the tangent at the end.
        const double dx = arc.end[axes.first] - start[axes.first];
        const double dy = arc.end[axes.second] - start[axes.second];
        const double half = hypotenuse(dx, dy) / 2.0;
        const double height = std::sqrt(std::max(0.0, *radius * *radius - half * half));
        const bool is_left = (arc.turns > 0) == (*radius >= 0.0);
        const double side = half == 0.0 ? 0.0 : (is_left ? height : -height) / (2.0 * half);
        c1 = start[axes.first] + dx / 2.0 - dy * side;
        c2 = start[axes.second] + dy / 2.0 + dx * side;
    } else {
        put(command, kCentres[axes.first], arc.centre_1);
        put(command, kCentres[axes.second], arc.centre_2);
    }
    if (std::abs(arc.turns) > 1) put(command, 'P', std::abs(arc.turns));
    if (!run(command)) return false;
    arrive(arc.end);
    const double turn = arc.turns > 0 ? 1.0 : -1.0;
    const double rx = arc.end[axes.first] - c1;
    const double ry = arc.end[axes.second] - c2;
    if (rx != 0.0 || ry != 0.0) tangent_ = {{-turn * ry, turn * rx}};
    return true;
}

// --- Tools ---

void BlockControl::add_tool_names(const std::vector<std::string>& names) {
    for (const std::string& name : names)
        named_tools_.try_emplace(name, kFirstNamedTool + static_cast<int>(named_tools_.size()));
}

/// Returns the number that stands for the tool `tool_name`.
int BlockControl::number_of(const std::string& tool_name) {
    if (const int number = number_in_name(tool_name); number > 0) return number;
    add_tool_names({tool_name});
    return named_tools_.at(tool_name);
}

/// Returns the diameter of `tool` in active units; nullopt if unspecified.
std::optional<double> BlockControl::diameter_of(int tool) const {
    const auto& tools = machine_.control().store->tools;
    const auto entry = std::ranges::find(tools, tool, &ToolTableEntry::number);
    if (entry == tools.end() || !entry->diameter) return std::nullopt;
    return entry->diameter->mm() / machine_.state().unit_mm();
}

void BlockControl::report_unknown_radius(std::string_view name) {
    const std::string tool = std::to_string(tool_);
    log_.add(Message::CycleRadiusUnknown, cycle_span_, {name, tool, tool});
}

}  // namespace ncsim::gcode::language
