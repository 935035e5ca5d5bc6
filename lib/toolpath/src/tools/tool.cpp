// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes of tools as profiles, and slices and dimensions of tools.
#include "ncsim/toolpath/tool.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>

namespace ncsim::toolpath {

namespace {

Tool make_one_piece_tool(ToolKind kind, std::vector<ProfilePoint> profile) {
    Tool tool;
    tool.kind = kind;
    tool.pieces.push_back({std::move(profile), true});
    return tool;
}

Tool cylinder(ToolKind kind, double diameter, double corner_radius, double length) {
    const double r = diameter / 2;
    const double fillet = std::min(corner_radius, r);
    return make_one_piece_tool(kind, {{r, 0, fillet}, {r, std::max(length, fillet), 0}});
}

// Makes a tip or a flat, a cone, and a cylinder if the length leaves room.
Tool cone(ToolKind kind, double diameter, double tip_diameter, double included_angle,
          double length) {
    const double r = diameter / 2;
    const double tip = std::min(tip_diameter / 2, r);
    const double half_angle = std::clamp(included_angle, 1.0, 179.0) / 2;
    const double rise = (r - tip) / tangent(half_angle);
    std::vector<ProfilePoint> profile{{tip, 0, 0}};
    if (rise > 0) profile.push_back({r, rise, 0});
    if (length > rise) profile.push_back({r, length, 0});
    return make_one_piece_tool(kind, std::move(profile));
}

}  // namespace

bool is_conical(std::optional<ToolKind> kind) {
    return kind == ToolKind::VCutter || kind == ToolKind::ChamferMill ||
           kind == ToolKind::Countersink;
}

bool is_axial(ToolKind kind) {
    return kind == ToolKind::Drill || kind == ToolKind::Tap || kind == ToolKind::Reamer ||
           kind == ToolKind::BoringBar;
}

std::string_view name_of(ToolKind kind) {
    switch (kind) {
        case ToolKind::FlatEndMill: return "flat end mill";
        case ToolKind::BallEndMill: return "ball end mill";
        case ToolKind::BullNoseEndMill: return "bull nose end mill";
        case ToolKind::FaceMill: return "face mill";
        case ToolKind::VCutter: return "v-cutter";
        case ToolKind::ChamferMill: return "chamfer mill";
        case ToolKind::Countersink: return "countersink";
        case ToolKind::Drill: return "drill";
        case ToolKind::Tap: return "tap";
        case ToolKind::Reamer: return "reamer";
        case ToolKind::BoringBar: return "boring bar";
        case ToolKind::ThreadMill: return "thread mill";
        case ToolKind::TaperedEndMill: return "tapered end mill";
        case ToolKind::SlotMill: return "slot mill";
        case ToolKind::DovetailMill: return "dovetail mill";
        case ToolKind::LollipopMill: return "lollipop mill";
        case ToolKind::CornerRoundingMill: return "corner rounding mill";
        case ToolKind::Other: break;
    }
    return "form tool";
}

bool is_undercutting(ToolKind kind) {
    return kind == ToolKind::SlotMill || kind == ToolKind::DovetailMill ||
           kind == ToolKind::LollipopMill;
}

Tool flat_end_mill(double diameter, double length) {
    return cylinder(ToolKind::FlatEndMill, diameter, 0, length);
}

Tool face_mill(double diameter, double length) {
    return cylinder(ToolKind::FaceMill, diameter, 0, length);
}

Tool ball_end_mill(double diameter, double length) {
    return cylinder(ToolKind::BallEndMill, diameter, diameter / 2, length);
}

Tool bull_nose_end_mill(double diameter, double corner_radius, double length) {
    return cylinder(ToolKind::BullNoseEndMill, diameter, corner_radius, length);
}

Tool v_cutter(double diameter, double tip_diameter, double included_angle, double length) {
    return cone(ToolKind::VCutter, diameter, tip_diameter, included_angle, length);
}

Tool drill(double diameter, double point_angle, double length) {
    return cone(ToolKind::Drill, diameter, 0, point_angle, length);
}

Tool tapered_end_mill(double tip_diameter, double corner_radius, double taper, double length) {
    const double angle = std::clamp(taper, 0.0, 89.0);
    const SinCos a = sin_cos(angle);
    const double fillet = std::min(corner_radius, tip_diameter / 2);
    // Corner between cone and floor without rounding. The arc has the radius `fillet` and the
    // centre
    // (tip radius - fillet, fillet).
    const double corner = tip_diameter / 2 - fillet + fillet * (1 - a.sin) / a.cos;
    const double height = std::max(length, fillet);
    return make_one_piece_tool(ToolKind::TaperedEndMill,
                               {{corner, 0, fillet}, {corner + height * a.sin / a.cos, height, 0}});
}

Tool slot_mill(double diameter, double corner_radius, double length) {
    return cylinder(ToolKind::SlotMill, diameter, std::min(corner_radius, length), length);
}

Tool dovetail_mill(double diameter, double taper, double length) {
    const double r = diameter / 2;
    const double slope = tangent(std::clamp(taper, 0.0, 80.0));
    // The upper end keeps a positive radius.
    const double height = slope > 0 ? std::min(length, 0.95 * r / slope) : length;
    return make_one_piece_tool(ToolKind::DovetailMill,
                               {{r, 0, 0}, {r - slope * height, height, 0}});
}

Tool lollipop_mill(double diameter) {
    const double r = diameter / 2;
    return make_one_piece_tool(ToolKind::LollipopMill, {{r, 0, r}, {r, diameter, r}});
}

Tool corner_rounding_mill(double diameter, double tip_diameter, double radius, double length) {
    const double r = diameter / 2;
    const double tip = std::min(tip_diameter / 2, r);
    // The arc turns from upright at the tip to level, or ends at the diameter.
    const double reach = std::min(radius, r - tip);
    const double end =
        reach < radius ? angle_of(radius - reach, std::sqrt(reach * (2 * radius - reach))) : 90.0;
    // A chord over the angle 2x is rho (1 - cos x) off the arc, about rho x²/2.
    const double step = 2 * std::sqrt(2 * kConcaveChord / radius) * 57.29;  // degrees
    const int steps = std::clamp(static_cast<int>(std::ceil(end / step)), 1, 90);
    const auto point_at = [&](int k) -> ProfilePoint {
        if (k == 0) return {tip, 0.0, 0.0};
        const SinCos a = sin_cos(end * k / steps);
        const double out = k == steps ? reach : radius * (1 - a.cos);
        return {tip + out, k == steps && end == 90.0 ? radius : radius * a.sin, 0.0};
    };
    Tool tool;
    tool.kind = ToolKind::CornerRoundingMill;
    for (int k = 0; k < steps; ++k)
        tool.pieces.push_back({{point_at(k), point_at(k + 1)}, true});
    const double top = point_at(steps).height;
    if (length > top) tool.pieces.push_back({{{r, top, 0.0}, {r, length, 0.0}}, true});
    return tool;
}

void add_holder_segment(Tool& tool, double lower_diameter, double upper_diameter, double height) {
    const double base = height_of(tool);
    tool.pieces.push_back(
        {{{lower_diameter / 2, base, 0}, {upper_diameter / 2, base + height, 0}}, false});
}

namespace {

struct Corner {
    double radius, height;
};

Corner operator+(Corner a, Corner b) {
    return {a.radius + b.radius, a.height + b.height};
}
Corner operator-(Corner a, Corner b) {
    return {a.radius - b.radius, a.height - b.height};
}
Corner operator*(double s, Corner a) {
    return {s * a.radius, s * a.height};
}
Corner unit(Corner a) {
    const double length = std::sqrt(a.radius * a.radius + a.height * a.height);
    return length > 0 ? (1 / length) * a : a;
}

// Returns the profile with chords instead of arcs.
std::vector<Corner> polyline_of(const ToolPiece& piece) {
    constexpr double kChord = 1e-3;  // mm
    std::vector<Corner> line;
    const auto& profile = piece.profile;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Corner at{profile[i].radius, profile[i].height};
        const double rho = profile[i].fillet;
        if (rho <= 0) {
            line.push_back(at);
            continue;
        }
        const Corner before =
            i > 0 ? Corner{profile[i - 1].radius, profile[i - 1].height} : Corner{0, at.height};
        const Corner after = i + 1 < profile.size()
                                 ? Corner{profile[i + 1].radius, profile[i + 1].height}
                                 : Corner{0, at.height};
        const Corner d1 = unit(at - before);
        const Corner d2 = unit(after - at);
        const double cosine = d1.radius * d2.radius + d1.height * d2.height;
        const double sine = d1.radius * d2.height - d1.height * d2.radius;
        const double turn = angle_of(cosine, sine);
        const Corner start = at - (rho * sine / (1 + cosine)) * d1;
        const Corner out{d1.height, -d1.radius};  // from the centre to the start
        const Corner centre = start - rho * out;
        // A chord over the angle 2x is rho (1 - cos x) away from the arc, about rho x²/2.
        const double step = 2 * std::sqrt(2 * kChord / rho) * 57.29;  // degrees
        const int steps = std::clamp(static_cast<int>(std::ceil(turn / step)), 2, 1000);
        for (int k = 0; k <= steps; ++k) {
            const SinCos a = sin_cos(turn * k / steps);
            const Corner away = a.cos * out + a.sin * d1;
            line.push_back(centre + rho * away);
        }
    }
    return line;
}

}  // namespace

ToolPiece slice(const ToolPiece& piece, double low, double high) {
    ToolPiece part;
    part.cutting = piece.cutting;
    part.assumed = piece.assumed;
    const std::vector<Corner> line = polyline_of(piece);
    const auto add = [&part](Corner c) {
        if (!part.profile.empty() && part.profile.back() == ProfilePoint{c.radius, c.height, 0.0})
            return;
        part.profile.push_back({std::max(0.0, c.radius), c.height, 0.0});
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (i > 0 && line[i - 1].height < line[i].height) {
            const Corner a = line[i - 1];
            const Corner way = line[i] - a;
            for (const double cut : {low, high}) {
                if (a.height < cut && cut < line[i].height)
                    add({a.radius + (cut - a.height) / way.height * way.radius, cut});
            }
        }
        if (line[i].height >= low && line[i].height <= high) add(line[i]);
    }
    const bool is_body =
        !part.profile.empty() && part.profile.front().height < part.profile.back().height;
    if (!is_body) part.profile.clear();
    return part;
}

double height_of(const Tool& tool) {
    double height = 0;
    for (const ToolPiece& piece : tool.pieces) {
        for (const ProfilePoint& p : piece.profile)
            height = std::max(height, p.height);
    }
    return height;
}

double cutting_height_of(const Tool& tool) {
    double height = 0;
    for (const ToolPiece& piece : tool.pieces) {
        for (const ProfilePoint& p : piece.profile) {
            if (piece.cutting) height = std::max(height, p.height);
        }
    }
    return height;
}

double cutting_diameter_of(const Tool& tool) {
    double radius = 0;
    for (const ToolPiece& piece : tool.pieces) {
        for (const ProfilePoint& p : piece.profile) {
            if (piece.cutting) radius = std::max(radius, p.radius);
        }
    }
    return 2 * radius;
}

}  // namespace ncsim::toolpath
