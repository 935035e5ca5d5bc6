// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collects the tools of a file, and takes the kind of a tool from its remark.
#include "tools/tool_collector.h"

#include "tools/comment_text.h"
#include "tools/tool_comment.h"
#include "tools/tool_messages.h"

#include <cmath>
#include <optional>
#include <utility>

namespace ncsim::toolpath {

void Collector::add_remark(const gcode::MessageText& message, gcode::SourceSpan span,
                           std::initializer_list<std::string_view> arguments) {
    gcode::Diagnostic d = gcode::diagnostic_of(message, span, arguments);
    d.file = file_;
    diagnostics_.push_back(std::move(d));
}

void Collector::keep(ToolSpec spec, Vec3 offset, gcode::SourceSpan span, std::string text) {
    const std::string number = std::to_string(spec.number);
    if (find_tool(tools_, spec.number)) return add_remark(Message::ToolTwice, span, {number});
    if (!is_complete(spec)) return add_remark(Message::NoDiameter, span, {number});
    ToolEntry entry;
    entry.spec = std::move(spec);
    entry.specified_by = ValueSource::Table;
    entry.span = span;
    entry.text = std::move(text);
    entry.file = file_;
    entry.offset = offset;
    tools_.push_back(std::move(entry));
}

void take_kind(std::string_view remark, ToolSpec& spec) {
    auto said = read_tool_remark(remark);
    if (!said && spec.diameter) {
        const std::string size = text::number(*spec.diameter);
        said = read_tool_remark("T1 D" + size + "MM " + std::string(remark));
    }
    if (!said) return;
    const double factor = said->unit == text::Unit::Inch ? 25.4 : 1.0;
    const auto in_mm = [factor](std::optional<double> length) {
        if (length) *length *= factor;
        return length;
    };
    spec.kind = said->spec.kind;
    spec.angle = said->spec.angle;
    spec.taper = said->spec.taper;
    spec.pitch = said->spec.pitch;
    spec.left_hand = said->spec.left_hand;
    const auto corner = in_mm(said->spec.corner_radius);
    if (corner && spec.diameter && *corner <= 0.505 * *spec.diameter) spec.corner_radius = corner;
    const auto tip = in_mm(said->spec.tip_diameter);
    if (!tip || !spec.diameter) return;
    spec.tip_diameter = tip;
    constexpr double kSame = 1e-6;  // mm; both numbers are typed by hand, perhaps in two units
    if (std::abs(*tip - *spec.diameter) < kSame) spec.diameter.reset();
}

}  // namespace ncsim::toolpath
