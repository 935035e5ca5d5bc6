// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides the motions of a program into operations.
#include "operation_course.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <variant>

namespace ncsim::simulation {

// Notes the last name between the line before and that of `motion`. A loop reads names again.
void OperationCourse::read_names(const gcode::Motion& motion) {
    // Subprograms are part of the operation that calls them.
    if (motion.file != 0 || motion.span.line == line_) return;
    const std::uint32_t from = motion.span.line > line_ ? line_ : 0;
    const auto after =
        std::ranges::upper_bound(names_, motion.span.line, {}, &toolpath::OperationName::line);
    if (after != names_.begin() && std::prev(after)->line > from) waiting_ = &*std::prev(after);
    line_ = motion.span.line;
}

void OperationCourse::begin(const toolpath::OperationName* name) {
    ++count_;
    set_name(name);
    has_cut_ = false;
    highest_mm_ = -std::numeric_limits<double>::infinity();
    lowest_mm_ = -highest_mm_;
}

void OperationCourse::set_name(const toolpath::OperationName* name) {
    name_ = name;
    if (name) has_begun_[static_cast<std::size_t>(name - names_.data())] = true;
}

bool OperationCourse::take(const gcode::Motion& motion) {
    const std::size_t before = count_;
    read_names(motion);
    const gcode::Position* from = start_of(motion);
    const gcode::Position* to = end_of(motion);
    const auto* change = std::get_if<gcode::ToolChange>(&motion.action);
    const int tool = change ? change->tool : motion.tool;
    if (has_cut_ && (count_ == 0 || change || (from && tool != tool_)))
        begin(std::exchange(waiting_, nullptr));
    if (change || from) tool_ = tool;
    if (!from || !to) return count_ != before;
    if (const auto* const next = std::exchange(waiting_, nullptr)) {
        constexpr double kLevel = 1e-6, kLift = 0.1;
        const bool is_known = (name_ && name_->name == next->name) ||
                              has_begun_[static_cast<std::size_t>(next - names_.data())];
        const double z = from->z.mm();
        if (has_cut_ && !is_known && z >= highest_mm_ - kLevel && z > lowest_mm_ + kLift)
            begin(next);
        else if (!has_cut_)
            set_name(next);
    }
    has_cut_ |= motion.kind == gcode::MoveKind::Feed;
    if (has_cut_) {
        highest_mm_ = std::max(highest_mm_, to->z.mm());
        lowest_mm_ = std::min(lowest_mm_, to->z.mm());
    }
    return count_ != before;
}

}  // namespace ncsim::simulation
