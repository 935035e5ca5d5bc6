// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/tool_spec.h"

#include "text.h"

#include <algorithm>
#include <cmath>

namespace ncsim::toolpath {

namespace {

// What the tool most probably is: what is said first, else what follows from its numbers.
ToolKind kind_of(const ToolSpec& spec) {
    if (spec.kind) return *spec.kind;
    if (spec.taper && *spec.taper > 0) return ToolKind::TaperedEndMill;
    if (spec.angle) return ToolKind::VCutter;
    const double radius = spec.corner_radius.value_or(0.0);
    if (radius <= 0.0 || !spec.diameter) return ToolKind::FlatEndMill;
    // CAM systems print radii rounded to a few digits.
    return radius >= 0.49 * *spec.diameter ? ToolKind::BallEndMill : ToolKind::BullNoseEndMill;
}

double angle_of(const ToolSpec& spec, ToolKind kind) {
    return spec.angle.value_or(kind == ToolKind::Drill ? 118.0 : 90.0);
}

Tool shaped(const ToolSpec& spec, double length) {
    const double d = spec.diameter.value_or(0.0);
    const double corner = spec.corner_radius.value_or(0.0);
    const ToolKind kind = kind_of(spec);
    switch (kind) {
        case ToolKind::FaceMill:
            if (corner > 0) {
                Tool tool = bull_nose_end_mill(d, corner, length);
                tool.kind = ToolKind::FaceMill;
                return tool;
            }
            return face_mill(d, length);
        case ToolKind::BallEndMill: return ball_end_mill(d, length);
        case ToolKind::BullNoseEndMill: return bull_nose_end_mill(d, corner, length);
        case ToolKind::VCutter:
            return v_cutter(d, spec.tip_diameter.value_or(0.0), angle_of(spec, kind), length);
        case ToolKind::Drill: return drill(d, angle_of(spec, kind), length);
        case ToolKind::TaperedEndMill:
            return tapered_end_mill(d, corner, spec.taper.value_or(0.0), length);
        case ToolKind::FlatEndMill:
        case ToolKind::Other: break;
    }
    return corner > 0 ? bull_nose_end_mill(d, corner, length) : flat_end_mill(d, length);
}

}  // namespace

bool is_complete(const ToolSpec& spec) {
    return !spec.pieces.empty() || (spec.diameter && text::is_sane_length(*spec.diameter));
}

Tool make_tool(const ToolSpec& spec, double assumed_length) {
    Tool tool;
    if (spec.pieces.empty()) {
        tool = shaped(spec, spec.length.value_or(assumed_length));
    } else {
        tool.kind = spec.kind.value_or(ToolKind::Other);
        tool.pieces = spec.pieces;
    }
    tool.number = spec.number;
    tool.description = spec.description;
    return tool;
}

ToolSpec filled(const ToolSpec& spec, double assumed_length) {
    ToolSpec result = spec;
    if (!spec.pieces.empty()) return result;
    result.kind = kind_of(spec);
    if (*result.kind == ToolKind::Drill || *result.kind == ToolKind::VCutter) {
        result.angle = angle_of(spec, *result.kind);
    }
    if (!spec.length) result.length = assumed_length;
    return result;
}

std::string filled_in(const ToolSpec& spec, double assumed_length) {
    if (!spec.pieces.empty()) return {};
    std::string result;
    const auto add = [&result](const std::string& what) {
        result += (result.empty() ? "" : ", ") + what;
    };
    const ToolKind kind = kind_of(spec);
    if (!spec.kind) add("kind " + std::string(name_of(kind)));
    if ((kind == ToolKind::Drill || kind == ToolKind::VCutter) && !spec.angle) {
        add("angle " + text::number(angle_of(spec, kind)) + " deg");
    }
    if (!spec.length) add("length " + text::number(assumed_length) + " mm");
    return result;
}

std::string describe(const Tool& tool) {
    std::string line(name_of(tool.kind));
    line += " D" + text::number(cutting_diameter_of(tool));
    const ToolPiece* tip = tool.pieces.empty() ? nullptr : &tool.pieces.front();
    if (tip && tool.kind != ToolKind::BallEndMill && tip->profile.front().fillet > 0) {
        line += " R" + text::number(tip->profile.front().fillet);
    }
    line += " L" + text::number(cutting_height_of(tool));
    return line;
}

std::optional<ToolSpec> parse_tool_option(std::string_view option, std::string& message) {
    const std::string upper = text::upper(option);
    const std::string_view s = upper;
    const auto refuse = [&](std::string_view why) {
        message = text::quoted(option) + ": ";
        message += why;
        return std::nullopt;
    };
    const std::size_t equals = s.find('=');
    std::string_view number = text::trimmed(s.substr(0, equals));
    if (!number.empty() && number.front() == 'T') number.remove_prefix(1);
    const auto tool = text::quantity_at(number, 0);
    if (equals == std::string_view::npos || !tool || tool->end != number.size() ||
        tool->value < 1 || tool->value > 99999999 || tool->value != std::floor(tool->value)) {
        return refuse("expected a tool number first, as in T1=flat:D10:L40");
    }
    ToolSpec spec;
    spec.number = static_cast<int>(tool->value);
    spec.description = std::string(text::trimmed(option.substr(equals + 1)));
    for (std::string_view part : text::split(s.substr(equals + 1), ':')) {
        part = text::trimmed(part);
        static constexpr std::pair<std::string_view, ToolKind> kKinds[] = {
            {"FLAT", ToolKind::FlatEndMill},
            {"BALL", ToolKind::BallEndMill},
            {"BULL", ToolKind::BullNoseEndMill},
            {"FACE", ToolKind::FaceMill},
            {"V", ToolKind::VCutter},
            {"CHAMFER", ToolKind::VCutter},
            {"DRILL", ToolKind::Drill},
            {"TAPER", ToolKind::TaperedEndMill}};
        const auto* kind = std::find_if(std::begin(kKinds), std::end(kKinds),
                                        [part](const auto& k) { return k.first == part; });
        if (kind != std::end(kKinds)) {
            spec.kind = kind->second;
            continue;
        }
        const auto value = part.empty() ? std::nullopt : text::quantity_at(part, 1);
        if (!value || value->end != part.size() || value->value < 0) {
            return refuse(
                std::string(part).append(" is neither a kind of tool (flat, ball, bull, face, v, "
                                         "chamfer, drill, taper) nor a "
                                         "value (D, R, L, A, P, S)"));
        }
        const bool inches = value->unit == text::Unit::Inch || value->is_fraction;
        const double mm = inches ? 25.4 * value->value : value->value;
        switch (part.front()) {
            case 'D': spec.diameter = mm; break;
            case 'R': spec.corner_radius = mm; break;
            case 'L': spec.length = mm; break;
            case 'P': spec.tip_diameter = mm; break;
            case 'S': spec.shank_diameter = mm; break;
            case 'A':
                if (spec.kind == ToolKind::TaperedEndMill) {
                    spec.taper = value->value;
                } else {
                    spec.angle = value->value;
                }
                break;
            default:
                return refuse(std::string(part).append(" starts with none of D, R, L, A, P, S"));
        }
    }
    if (!is_complete(spec))
        return refuse("a tool needs a diameter, as in D10, between 1 nm and 1 km");
    for (const auto& length : {spec.length, spec.shank_diameter}) {
        if (length && !text::is_sane_length(*length))
            return refuse("a length of that size is no tool's");
    }
    return spec;
}

}  // namespace ncsim::toolpath
