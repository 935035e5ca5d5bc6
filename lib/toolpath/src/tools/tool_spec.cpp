// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools from specifications with assumed values, and the option --tool.
#include "ncsim/toolpath/tool_spec.h"

#include "tools/comment_text.h"

#include <algorithm>
#include <cmath>

namespace ncsim::toolpath {

namespace {

// Returns the kind if specified, otherwise the most probable kind for the numbers.
ToolKind kind_of(const ToolSpec& spec) {
    if (spec.kind) return *spec.kind;
    if (spec.taper && *spec.taper > 0) return ToolKind::TaperedEndMill;
    if (spec.angle) return ToolKind::VCutter;
    const double radius = spec.corner_radius.value_or(0.0);
    if (radius <= 0.0 || !spec.diameter) return ToolKind::FlatEndMill;
    // CAM systems print radii rounded to a few digits.
    return radius >= 0.49 * *spec.diameter ? ToolKind::BallEndMill : ToolKind::BullNoseEndMill;
}

// Default taper of a dovetail mill: 60 degrees between floor and flank.
constexpr double kDovetailTaper = 30.0;
// Default neck diameter of an undercutting mill, as a share of the mill's diameter.
constexpr double kNeck = 0.6;

// Engraving cones are sold by angle and tip, on a shank of an eighth of an inch.
constexpr double kEngraverShank = 3.175;

double diameter_of(const ToolSpec& spec) {
    if (spec.diameter) return *spec.diameter;
    if (spec.kind == ToolKind::CornerRoundingMill && spec.corner_radius)
        return spec.tip_diameter.value_or(0.0) + 2 * *spec.corner_radius;
    return spec.tip_diameter ? std::max(kEngraverShank, 2 * *spec.tip_diameter) : 0.0;
}

// Returns the tip diameter of a corner rounding mill. Without a specified tip the quarter circle
// ends at the diameter.
double round_tip_of(const ToolSpec& spec) {
    if (spec.tip_diameter) return *spec.tip_diameter;
    return std::max(0.0, diameter_of(spec) - 2 * spec.corner_radius.value_or(0.0));
}

double arc_height_of(const ToolSpec& spec) {
    return height_of(corner_rounding_mill(diameter_of(spec), round_tip_of(spec),
                                          spec.corner_radius.value_or(0.0), 0.0));
}

// True if the diameter is larger than that of the quarter circle.
bool has_shoulder(const ToolSpec& spec) {
    constexpr double kRounding = 1e-9;
    return diameter_of(spec) >
           round_tip_of(spec) + 2 * spec.corner_radius.value_or(0.0) + kRounding;
}

// Returns the length of the cutting part, or a default.
double length_of(const ToolSpec& spec, ToolKind kind, double assumed) {
    if (spec.length) return *spec.length;
    const double d = diameter_of(spec);
    if (kind == ToolKind::LollipopMill) return d;
    if (kind == ToolKind::CornerRoundingMill) {
        const double shoulder = has_shoulder(spec) ? 0.1 * d : 0.0;
        return arc_height_of(spec) + shoulder;
    }
    // The wider a disc, the more it would remove.
    if (kind == ToolKind::SlotMill) return std::max(0.25 * d, spec.corner_radius.value_or(0.0));
    if (kind == ToolKind::DovetailMill) return 0.5 * d;
    if (!spec.stick_out) return assumed;
    const double above = spec.neck_length.value_or(0.0) + spec.shank_length.value_or(0.0);
    const double room = *spec.stick_out - above;
    return std::min(assumed, room > 0.0 ? room : *spec.stick_out);
}

std::optional<double> neck_of(const ToolSpec& spec, ToolKind kind) {
    if (spec.neck_diameter) return spec.neck_diameter;
    const double d = diameter_of(spec);
    if (!is_undercutting(kind) || !spec.shaft.empty()) return std::nullopt;
    // The shank is the neck.
    if (spec.shank_diameter && *spec.shank_diameter < d) return std::nullopt;
    return kNeck * d;
}

void add_assembly(Tool& tool, const ToolSpec& spec) {
    const double flutes = height_of(tool);
    const auto add = [&tool](const ToolSegment& s) {
        if (s.height > 0) add_holder_segment(tool, s.lower_diameter, s.upper_diameter, s.height);
    };
    for (const ToolSegment& segment : spec.shaft)
        add(segment);
    const double reach = spec.stick_out.value_or(0.0);
    if (spec.shaft.empty()) {
        if (const auto neck = neck_of(spec, tool.kind)) {
            const double room = std::max(0.0, reach - flutes);
            double length = spec.shank_diameter ? *neck : 3 * *neck;
            if (spec.stick_out && !spec.shank_diameter) length = room;
            if (spec.stick_out && spec.shank_diameter)
                length = std::min(length, std::max(0.0, room - spec.shank_length.value_or(0.0)));
            length = spec.neck_length.value_or(length);
            add({*neck, *neck, length});
            tool.pieces.back().assumed = !spec.neck_diameter;
        }
        if (spec.shank_diameter) {
            constexpr double kShown = 3.0;  // diameters, if the length is unspecified
            const bool ends = spec.stick_out || !spec.holder.empty();
            const double rest = ends ? reach - height_of(tool) : kShown * *spec.shank_diameter;
            add({*spec.shank_diameter, *spec.shank_diameter, spec.shank_length.value_or(rest)});
        }
    }
    if (spec.holder.empty()) return;
    // The gap between the last segment and the holder has an unknown thickness; it is assumed to be
    // as thick as the segment below.
    if (const double gap = reach - height_of(tool); gap > 0) {
        const double d = 2 * tool.pieces.back().profile.back().radius;
        add({d, d, gap});
        tool.pieces.back().assumed = true;
    }
    for (const ToolSegment& segment : spec.holder) {
        add(segment);
        // Without a stick-out, the holder begins as low as possible.
        tool.pieces.back().assumed = !spec.stick_out && spec.shaft.empty() && !spec.shank_length;
    }
}

double tip_angle_of(const ToolSpec& spec, ToolKind kind) {
    return spec.angle.value_or(kind == ToolKind::Drill ? 118.0 : 90.0);
}

Tool shape_tool(const ToolSpec& spec, double length) {
    const double d = diameter_of(spec);
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
        case ToolKind::ChamferMill:
        case ToolKind::Countersink: {
            Tool tool =
                v_cutter(d, spec.tip_diameter.value_or(0.0), tip_angle_of(spec, kind), length);
            tool.kind = kind;
            return tool;
        }
        case ToolKind::Drill: return drill(d, tip_angle_of(spec, kind), length);
        case ToolKind::TaperedEndMill:
            return tapered_end_mill(d, corner, spec.taper.value_or(0.0), length);
        case ToolKind::SlotMill: return slot_mill(d, corner, length);
        case ToolKind::DovetailMill:
            return dovetail_mill(d, spec.taper.value_or(kDovetailTaper), length);
        case ToolKind::LollipopMill: return lollipop_mill(d);
        case ToolKind::CornerRoundingMill:
            return corner_rounding_mill(d, round_tip_of(spec), corner, length);
        case ToolKind::FlatEndMill:
        case ToolKind::Tap:
        case ToolKind::Reamer:
        case ToolKind::BoringBar:
        case ToolKind::ThreadMill:
        case ToolKind::Other: break;
    }
    Tool plain = corner > 0 ? bull_nose_end_mill(d, corner, length) : flat_end_mill(d, length);
    if (kind != ToolKind::Other)
        plain.kind = corner > 0 && kind == ToolKind::FlatEndMill ? plain.kind : kind;
    return plain;
}

}  // namespace

bool is_complete(const ToolSpec& spec) {
    if (!spec.pieces.empty()) return true;
    const ToolKind kind = kind_of(spec);
    if (kind == ToolKind::CornerRoundingMill) {
        const double tip = round_tip_of(spec);
        return spec.corner_radius && text::is_sane_length(*spec.corner_radius) &&
               text::is_sane_length(diameter_of(spec)) && tip < diameter_of(spec) &&
               (spec.diameter || spec.tip_diameter);
    }
    if (!spec.diameter && !is_conical(kind)) return false;
    return text::is_sane_length(diameter_of(spec));
}

Tool make_tool(const ToolSpec& spec, double assumed_length) {
    Tool tool;
    if (spec.pieces.empty()) {
        tool = shape_tool(spec, length_of(spec, kind_of(spec), assumed_length));
        // Flutes within the holder do not cut.
        const double reach = spec.stick_out.value_or(height_of(tool));
        if (reach < height_of(tool)) {
            for (ToolPiece& piece : tool.pieces)
                piece = slice(piece, 0.0, reach);
            std::erase_if(tool.pieces, [](const ToolPiece& p) { return p.profile.empty(); });
        }
        add_assembly(tool, spec);
    } else {
        tool.kind = spec.kind.value_or(ToolKind::Other);
        tool.pieces = spec.pieces;
    }
    tool.number = spec.number;
    tool.description = spec.description;
    return tool;
}

namespace {

using Words = std::vector<std::string>;

std::string with_article(ToolKind kind) {
    const std::string name(name_of(kind));
    return (name.find_first_of("aeiou") == 0 ? "an " : "a ") + name;
}

std::string value_of(const char* letter, double value) {
    return letter + text::number(value);
}

// Adds a sentence for each value that tools of this kind do not have.
void add_missing_values(const ToolSpec& spec, ToolKind kind, Words& all) {
    const auto add = [&](const char* what) {
        all.push_back(with_article(kind) + " has no " + what);
    };
    const bool per_side = kind == ToolKind::TaperedEndMill || kind == ToolKind::DovetailMill;
    const bool has_angle = is_conical(kind) || kind == ToolKind::Drill;
    const bool has_tip = is_conical(kind) || kind == ToolKind::CornerRoundingMill;
    const bool has_radius = !has_angle && kind != ToolKind::DovetailMill;
    if (spec.corner_radius.value_or(0.0) > 0.0 && !has_radius) add("corner radius (R)");
    if ((spec.angle && !has_angle) || (spec.taper.value_or(0.0) > 0.0 && !per_side))
        add("angle (A)");
    if (spec.tip_diameter && !has_tip) add("tip diameter (P)");
    if (spec.pitch && kind != ToolKind::Tap && kind != ToolKind::ThreadMill) add("pitch (K)");
    if (spec.pitch && *spec.pitch <= 0.0) all.emplace_back("a pitch (K) is more than 0");
}

// Adds a sentence for each radius, tip or length that contradicts another value.
void add_contradicting_shape(const ToolSpec& spec, ToolKind kind, Words& all) {
    const double d = diameter_of(spec);
    const double slack = 0.01 * d;
    const double radius = spec.corner_radius.value_or(0.0);
    const bool is_ball = kind == ToolKind::BallEndMill || kind == ToolKind::LollipopMill;
    if (is_ball && spec.corner_radius && std::abs(radius - d / 2) > slack)
        all.push_back(value_of("R", radius) + " of " + with_article(kind) + " is not half of " +
                      value_of("D", d));
    if (!is_ball && kind != ToolKind::CornerRoundingMill && radius > d / 2 + slack)
        all.push_back(value_of("R", radius) + " is more than half of " + value_of("D", d));
    const double tip = spec.tip_diameter.value_or(0.0);
    if (tip > d) all.push_back(value_of("P", tip) + " is more than " + value_of("D", d));
    if (!spec.length) return;
    const double length = *spec.length;
    const double made = cutting_height_of(shape_tool(spec, length));
    const bool has_cone = is_conical(kind) || kind == ToolKind::Drill;
    if (std::abs(made - length) > slack) {
        all.push_back(value_of("L", length) +
                      (made < length ? " is more than " : " is less than ") + "the height of " +
                      (has_cone ? "the cone" : "the shape") + ", " + text::number(made) + " mm");
    } else if (kind == ToolKind::CornerRoundingMill && has_shoulder(spec) &&
               length <= arc_height_of(spec)) {
        all.push_back(value_of("D", d) + " is more than P + 2 R, and " + value_of("L", length) +
                      " leaves no shoulder");
    } else if (kind == ToolKind::SlotMill && radius > length + slack) {
        all.push_back(value_of("R", radius) + " is more than " + value_of("L", length));
    }
}

}  // namespace

std::vector<std::string> unsupported_values(const ToolSpec& specified) {
    const ToolSpec spec = specified_part(specified);
    Words all;
    if (!spec.pieces.empty() || !is_complete(spec)) return all;
    const ToolKind kind = kind_of(spec);
    add_missing_values(spec, kind, all);
    add_contradicting_shape(spec, kind, all);
    const bool has_steps = spec.neck_length || spec.shank_length || !spec.shaft.empty();
    if (spec.stick_out && has_steps) {
        ToolSpec bare = spec;
        bare.holder.clear();
        const double top = height_of(make_tool(bare, spec.length.value_or(0.0)));
        if (top > *spec.stick_out + 0.01 * diameter_of(spec))
            all.push_back(value_of("E", *spec.stick_out) +
                          " is less than flutes, neck and shank together, " + text::number(top) +
                          " mm");
    }
    return all;
}

ToolSpec specified_part(const ToolSpec& spec) {
    ToolSpec part = spec;
    part.assumed.clear();
    for (const std::string& name : spec.assumed) {
        if (name == "shape") {
            part = {};
            part.number = spec.number;
        }
        if (name == "kind") part.kind.reset();
        if (name == "diameter") part.diameter.reset();
        if (name == "angle") part.angle.reset();
        if (name == "taper") part.taper.reset();
        if (name == "length") part.length.reset();
    }
    return part;
}

ToolSpec filled(const ToolSpec& spec, double assumed_length) {
    ToolSpec result = spec;
    if (!spec.pieces.empty()) return result;
    const auto assume = [&result](const char* name) {
        if (std::ranges::find(result.assumed, name) == result.assumed.end())
            result.assumed.emplace_back(name);
    };
    result.kind = kind_of(spec);
    // A corner radius or an angle determines the kind.
    if (!spec.kind && *result.kind == ToolKind::FlatEndMill) assume("kind");
    if (!spec.diameter) {
        result.diameter = diameter_of(spec);
        if (*result.kind != ToolKind::CornerRoundingMill) assume("diameter");
    }
    if (*result.kind == ToolKind::Drill || is_conical(result.kind)) {
        result.angle = tip_angle_of(spec, *result.kind);
        if (!spec.angle) assume("angle");
    }
    if (*result.kind == ToolKind::DovetailMill && !spec.taper) {
        result.taper = kDovetailTaper;
        assume("taper");
    }
    if (!spec.length) {
        result.length = length_of(spec, *result.kind, assumed_length);
        if (*result.kind != ToolKind::LollipopMill && *result.kind != ToolKind::CornerRoundingMill)
            assume("length");
    }
    return result;
}

bool guesses_shape(const ToolSpec& spec) {
    if (!spec.assumed.empty()) {
        const ToolSpec part = specified_part(spec);
        return !is_complete(part) || guesses_shape(part);
    }
    if (!spec.pieces.empty()) return false;
    const ToolKind kind = kind_of(spec);
    switch (kind) {
        case ToolKind::VCutter:
        case ToolKind::ChamferMill:
        case ToolKind::Countersink: return !spec.angle || !spec.diameter;
        case ToolKind::TaperedEndMill: return !spec.taper;
        case ToolKind::CornerRoundingMill: return !spec.corner_radius;
        case ToolKind::SlotMill: return !spec.length;
        case ToolKind::DovetailMill: return !spec.length || !spec.taper;
        case ToolKind::Other: return true;
        default: break;
    }
    // A radius determines a kind, too.
    return !spec.kind && spec.corner_radius.value_or(0.0) <= 0.0;
}

namespace {

// True if the pieces include a part that does not cut; then the pieces describe the whole tool.
bool has_body(const std::vector<ToolPiece>& pieces) {
    return std::ranges::any_of(pieces, [](const ToolPiece& p) { return !p.cutting; });
}

}  // namespace

bool specifies_holder(const ToolSpec& spec) {
    return !spec.holder.empty() || has_body(spec.pieces);
}

double least_flute_length(const Tool& tool) {
    const double d = cutting_diameter_of(tool);
    double cone = 0.0;  // height of the shaped end
    for (const ToolPiece& piece : tool.pieces) {
        const auto widest = std::ranges::find_if(
            piece.profile, [&](const ProfilePoint& p) { return 2 * p.radius >= d; });
        if (piece.cutting && widest != piece.profile.end())
            cone = std::max(cone, widest->height + widest->fillet);
    }
    switch (tool.kind) {
        case ToolKind::FaceMill: return std::max(cone, 0.1 * d);
        case ToolKind::Drill: return cone + 3 * d;
        case ToolKind::VCutter:
        case ToolKind::ChamferMill:
        case ToolKind::Countersink:
        case ToolKind::TaperedEndMill: return cone;
        case ToolKind::SlotMill:
        case ToolKind::DovetailMill:
        case ToolKind::LollipopMill:
        case ToolKind::CornerRoundingMill: return cutting_height_of(tool);
        case ToolKind::FlatEndMill:
        case ToolKind::BallEndMill:
        case ToolKind::BullNoseEndMill:
        case ToolKind::Tap:
        case ToolKind::Reamer:
        case ToolKind::BoringBar:
        case ToolKind::ThreadMill:
        case ToolKind::Other: break;
    }
    return std::max(cone, 1.25 * d);
}

std::string assumed_values_text(const ToolSpec& spec, double assumed_length) {
    const ToolSpec part = specified_part(spec);
    if (!part.pieces.empty()) return {};
    std::string result;
    const auto add = [&result](const std::string& what) {
        result += (result.empty() ? "" : ", ") + what;
    };
    const ToolKind kind = kind_of(spec);
    if (!part.kind) add("kind " + std::string(name_of(kind)));
    if (!part.diameter && kind != ToolKind::CornerRoundingMill)
        add("diameter " + text::number(diameter_of(spec)) + " mm");
    if (kind == ToolKind::Other) add("the shape of a flat end mill");
    if ((kind == ToolKind::Drill || is_conical(kind)) && !part.angle) {
        add("angle " + text::number(tip_angle_of(spec, kind)) + " deg");
    }
    if (kind == ToolKind::DovetailMill && !part.taper)
        add("taper " + text::number(spec.taper.value_or(kDovetailTaper)) + " deg");
    if (!part.length && kind != ToolKind::LollipopMill && kind != ToolKind::CornerRoundingMill)
        add("length " + text::number(length_of(spec, kind, assumed_length)) + " mm");
    if (const auto neck = neck_of(spec, kind); neck && !part.neck_diameter)
        add("neck " + text::number(*neck) + " mm");
    return result;
}

std::string describe(const Tool& tool) {
    std::string line(name_of(tool.kind));
    line += " D" + text::number(cutting_diameter_of(tool));
    const ToolPiece* tip = tool.pieces.empty() ? nullptr : &tool.pieces.front();
    if (tip && tool.kind != ToolKind::BallEndMill && tool.kind != ToolKind::LollipopMill &&
        tip->profile.front().fillet > 0) {
        line += " R" + text::number(tip->profile.front().fillet);
    }
    if (tip && tool.kind == ToolKind::CornerRoundingMill) {
        // The first chord begins where the arc is upright.
        const double out = tip->profile.back().radius - tip->profile.front().radius;
        const double up = tip->profile.back().height;
        line += " P" + text::number(2 * tip->profile.front().radius);
        line += " R" + text::number((up * up + out * out) / (2 * out));
    }
    line += " L" + text::number(cutting_height_of(tool));
    double height = cutting_height_of(tool);
    for (const ToolPiece& piece : tool.pieces) {
        if (piece.cutting || piece.profile.back().height <= height) continue;
        const double lower = 2 * piece.profile.front().radius;
        const double upper = 2 * piece.profile.back().radius;
        height = piece.profile.back().height;
        line.append(", D").append(text::number(lower));
        if (upper != lower) line.append("-").append(text::number(upper));
        line.append(" to ").append(text::number(height));
    }
    return line;
}

namespace {

// Reader of the parts of --tool after the tool number.
class OptionReader {
public:
    explicit OptionReader(ToolSpec& spec) : spec_(spec) {}

    // Reads a part. Returns the reason why the part is invalid; empty if it was read.
    std::string read(std::string_view part) {
        static constexpr std::pair<std::string_view, ToolKind> kKinds[] = {
            {"FLAT", ToolKind::FlatEndMill},
            {"BALL", ToolKind::BallEndMill},
            {"BULL", ToolKind::BullNoseEndMill},
            {"FACE", ToolKind::FaceMill},
            {"V", ToolKind::VCutter},
            {"SPOT", ToolKind::VCutter},
            {"ENGRAVER", ToolKind::VCutter},
            {"CHAMFER", ToolKind::ChamferMill},
            {"COUNTERSINK", ToolKind::Countersink},
            {"DRILL", ToolKind::Drill},
            {"TAPER", ToolKind::TaperedEndMill},
            {"SLOT", ToolKind::SlotMill},
            {"DOVETAIL", ToolKind::DovetailMill},
            {"LOLLIPOP", ToolKind::LollipopMill},
            {"CORNER", ToolKind::CornerRoundingMill},
            {"TAP", ToolKind::Tap},
            {"REAMER", ToolKind::Reamer},
            {"BORING-BAR", ToolKind::BoringBar},
            {"THREAD", ToolKind::ThreadMill}};
        const auto* kind = std::find_if(std::begin(kKinds), std::end(kKinds),
                                        [part](const auto& k) { return k.first == part; });
        if (kind != std::end(kKinds)) {
            if (spec_.kind) return "a tool has one kind";
            spec_.kind = kind->second;
            return {};
        }
        if (!part.empty() && part.front() == 'H') return read_holder(part);
        std::size_t at = 1;
        const auto value = part.empty() ? std::nullopt : number_at(part, at);
        if (!value || (at != part.size() && part.front() != 'S' && part.front() != 'N')) {
            return std::string(part).append(
                " is neither a kind of tool (flat, ball, bull, face, v, spot, engraver, chamfer, "
                "countersink, drill, taper, slot, dovetail, lollipop, corner, tap, reamer, "
                "boring-bar, thread) nor a value (D, K, R, "
                "L, A, P, N, S, E, H)");
        }
        if (part.find_first_of("DKRLPESNA") == 0) {
            if (seen_.find(part.front()) != std::string::npos)
                return std::string(1, part.front()) + " is specified twice";
            seen_ += part.front();
        }
        switch (part.front()) {
            case 'D': spec_.diameter = value; break;
            case 'K': spec_.pitch = value; break;
            case 'R': spec_.corner_radius = value; break;
            case 'L': spec_.length = value; break;
            case 'P': spec_.tip_diameter = value; break;
            case 'E': spec_.stick_out = value; break;
            case 'S': return read_step(part, at, *value, spec_.shank_diameter, spec_.shank_length);
            case 'N': return read_step(part, at, *value, spec_.neck_diameter, spec_.neck_length);
            case 'A': angle_ = value; break;
            default:
                return std::string(part).append(
                    " starts with none of D, K, R, L, A, P, N, S, E, H");
        }
        return {};
    }

    // Takes the angle, whose meaning depends on the kind. Returns why not; empty: taken.
    std::string finish() { return angle_ ? read_angle(*angle_) : std::string(); }

private:
    // Reads a number in mm; `at` moves to the end of the number and its unit.
    static std::optional<double> number_at(std::string_view part, std::size_t& at) {
        const auto q = text::quantity_at(part, at);
        if (!q || q->begin != at || q->value < 0) return std::nullopt;
        at = q->end;
        const bool is_inch =
            q->unit == text::Unit::Inch || (q->is_fraction && q->unit == text::Unit::None);
        return is_inch ? 25.4 * q->value : q->value;
    }

    std::string read_angle(double degrees) {
        const bool per_side =
            spec_.kind == ToolKind::TaperedEndMill || spec_.kind == ToolKind::DovetailMill;
        if (per_side && degrees > 80) return "a flank opens by 80 degrees per side at most";
        if (!per_side && (degrees < 1 || degrees > 179))
            return "an angle is between 1 and 179 degrees";
        if (spec_.kind == ToolKind::DovetailMill) degrees = dovetail_taper(degrees);
        (per_side ? spec_.taper : spec_.angle) = degrees;
        return {};
    }

    // Reads S12 or S12x30.
    static std::string read_step(std::string_view part, std::size_t at, double diameter,
                                 std::optional<double>& into, std::optional<double>& length) {
        into = diameter;
        if (at == part.size()) return {};
        if (part[at++] == 'X') length = number_at(part, at);
        if (length && at == part.size()) return {};
        return std::string(part).append(
            ": expected a diameter, or diameter x length, as in S12x30");
    }

    // Reads H28x15,40x25 or H20-32x10.
    std::string read_holder(std::string_view part) {
        for (std::string_view step : text::split(part.substr(1), ',')) {
            step = trimmed(step);
            std::size_t at = 0;
            ToolSegment segment;
            const auto lower = number_at(step, at);
            auto upper = lower;
            if (lower && at < step.size() && step[at] == '-') upper = number_at(step, ++at);
            std::optional<double> height;
            if (upper && at < step.size() && step[at] == 'X') height = number_at(step, ++at);
            if (!height || at != step.size() || *height <= 0) {
                return std::string(part).append(
                    ": expected diameter x height, or lower-upper x height, from below upwards, as "
                    "in H28x15,28-40x25");
            }
            segment = {*lower, *upper, *height};
            spec_.holder.push_back(segment);
        }
        return {};
    }

    ToolSpec& spec_;
    std::optional<double> angle_;
    std::string seen_;
};

}  // namespace

double dovetail_taper(double degrees) {
    constexpr double kLeastOfMetal = 40.0;
    return degrees < kLeastOfMetal ? degrees : 90.0 - degrees;
}

std::optional<ToolSpec> parse_tool_option(std::string_view option, std::string& message) {
    const std::string upper = uppercase(option);
    const std::string_view s = upper;
    const auto refuse = [&](std::string_view why) {
        message = text::quoted(option) + ": ";
        message += why;
        return std::nullopt;
    };
    const std::size_t equals = s.find('=');
    std::string_view number = trimmed(s.substr(0, equals));
    if (!number.empty() && number.front() == 'T') number.remove_prefix(1);
    const auto tool = text::quantity_at(number, 0);
    if (equals == std::string_view::npos || !tool || tool->end != number.size() ||
        tool->value < 1 || tool->value > 99999999 || tool->value != std::floor(tool->value)) {
        return refuse("expected a tool number first, as in T1=flat:D10:L40");
    }
    ToolSpec spec;
    spec.number = static_cast<int>(tool->value);
    spec.description = std::string(trimmed(option.substr(equals + 1)));
    OptionReader reader(spec);
    for (const std::string_view part : text::split(s.substr(equals + 1), ':')) {
        const std::string why = reader.read(trimmed(part));
        if (!why.empty()) return refuse(why);
    }
    if (const std::string why = reader.finish(); !why.empty()) return refuse(why);
    if (!is_complete(spec) && spec.kind == ToolKind::CornerRoundingMill)
        return refuse(
            "a corner rounding mill needs R, its concave radius, and a diameter: D, or P of the "
            "tip, smaller than D");
    if (!is_complete(spec))
        return refuse("a tool needs a diameter, as in D10, between 1 nm and 1 km");
    for (const auto& length : {spec.length, spec.shank_diameter, spec.shank_length,
                               spec.neck_diameter, spec.neck_length, spec.stick_out, spec.pitch}) {
        if (length && !text::is_sane_length(*length))
            return refuse("a length of that size is no tool's");
    }
    for (const ToolSegment& segment : spec.holder) {
        if (!text::is_sane_length(std::max(segment.lower_diameter, segment.upper_diameter)) ||
            !text::is_sane_length(segment.height)) {
            return refuse("a length of that size is no holder's");
        }
    }
    if (const Words unkept = unsupported_values(spec); !unkept.empty())
        return refuse(unkept.front());
    return spec;
}

}  // namespace ncsim::toolpath
