// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact round tool: a convex solid of revolution about z with the tip at the origin (frame T, mm),
// and the distance of a point from the surface.
#pragma once

#include "nightly/vec.h"

#include <vector>

namespace ncsim::nightly {

/// Point of the half-plane of the profile: distance from the axis, and height.
struct Meridian {
    double r = 0.0, h = 0.0;
};

class RoundTool {
public:
    /// Returns a flat, face or slot mill (with or without corner radius), bull-nose mill, or
    /// ball-nose mill (corner radius = diameter / 2).
    static RoundTool end_mill(double diameter, double corner_radius, double length);
    /// Returns a cone with an included angle (degrees) at the tip, then a cylinder: V-cutters and
    /// drills.
    static RoundTool cone(double diameter, double tip_diameter, double included_angle,
                          double length);
    /// Returns a cone that opens by `taper` degrees per side from a flat or rounded tip.
    static RoundTool tapered(double tip_diameter, double corner_radius, double taper,
                             double length);
    /// Returns a tool that narrows upwards by `taper` degrees per side.
    static RoundTool dovetail(double diameter, double taper, double length);
    /// Returns a whole ball.
    static RoundTool lollipop(double diameter);

    /// Returns the distance from the surface, negative inside. The function is convex with slopes
    /// of at most 1.
    double signed_distance(const Vec& p_T) const;

    double radius() const { return radius_; }  ///< The largest.
    double height() const { return height_; }
    /// Returns half of the sharpest interior angle of the solid, at an edge or at the tip, rad.
    double sharpest_half_angle() const;
    /// True if the tool has a ball or a rounded corner.
    bool is_rounded() const { return !arcs_.empty(); }
    bool is_whole_ball() const { return is_rounded() && top_.r == 0.0; }
    /// True if the tool is a cylinder.
    bool is_upright() const { return bottom_.r == radius_ && top_.r == radius_; }
    /// Returns a point of the surface; `along` and `around` are in [0, 1).
    Vec surface_point(double along, double around) const;

private:
    struct Line {
        Meridian from, to;
    };
    struct Arc {
        Meridian centre, from, to;  // counter-clockwise, at most a right angle
        double radius = 0.0;
    };
    void close(const std::vector<Meridian>& corners);

    Meridian bottom_;          // outer end of the flat at the bottom
    std::vector<Arc> arcs_;    // arcs after the bottom: none, one, or two that form a half circle
    std::vector<Line> sides_;  // sides after the arcs, upwards
    Meridian top_;             // outer end of the flat at the top
    double radius_ = 0.0, height_ = 0.0;
};

}  // namespace ncsim::nightly
