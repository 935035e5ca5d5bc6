// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/tool.h"

#include "ncsim/toolpath/angles.h"

#include <algorithm>

namespace ncsim::toolpath {

namespace {

Tool of_one_piece(ToolKind kind, std::vector<ProfilePoint> profile) {
    Tool tool;
    tool.kind = kind;
    tool.pieces.push_back({std::move(profile), true});
    return tool;
}

Tool cylinder(ToolKind kind, double diameter, double corner_radius, double length) {
    const double r = diameter / 2;
    const double fillet = std::min(corner_radius, r);
    return of_one_piece(kind, {{r, 0, fillet}, {r, std::max(length, fillet), 0}});
}

// A point or a flat, a cone, and a cylinder where the length leaves room for it.
Tool cone(ToolKind kind, double diameter, double tip_diameter, double included_angle,
          double length) {
    const double r = diameter / 2;
    const double tip = std::min(tip_diameter / 2, r);
    const double half_angle = std::clamp(included_angle, 1.0, 179.0) / 2;
    const double rise = (r - tip) / tangent(half_angle);
    std::vector<ProfilePoint> profile{{tip, 0, 0}};
    if (rise > 0) profile.push_back({r, rise, 0});
    if (length > rise) profile.push_back({r, length, 0});
    return of_one_piece(kind, std::move(profile));
}

}  // namespace

std::string_view name_of(ToolKind kind) {
    switch (kind) {
        case ToolKind::FlatEndMill: return "flat end mill";
        case ToolKind::BallEndMill: return "ball end mill";
        case ToolKind::BullNoseEndMill: return "bull nose end mill";
        case ToolKind::FaceMill: return "face mill";
        case ToolKind::VCutter: return "v-cutter";
        case ToolKind::Drill: return "drill";
        case ToolKind::TaperedEndMill: return "tapered end mill";
        case ToolKind::Other: break;
    }
    return "form tool";
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
    // The corner that the cone would make with the floor without its rounding: the arc keeps its
    // radius and its centre, (tip radius - fillet, fillet).
    const double corner = tip_diameter / 2 - fillet + fillet * (1 - a.sin) / a.cos;
    const double height = std::max(length, fillet);
    return of_one_piece(ToolKind::TaperedEndMill,
                        {{corner, 0, fillet}, {corner + height * a.sin / a.cos, height, 0}});
}

void add_holder_segment(Tool& tool, double lower_diameter, double upper_diameter, double height) {
    const double base = height_of(tool);
    tool.pieces.push_back(
        {{{lower_diameter / 2, base, 0}, {upper_diameter / 2, base + height, 0}}, false});
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
