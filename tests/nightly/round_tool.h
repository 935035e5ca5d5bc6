// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tool as it is meant: round. A convex solid of revolution about z, tip at the origin (frame T,
// mm), and how far a point is from its surface.
#pragma once

#include "nightly/vec.h"

#include <vector>

namespace ncsim::nightly {

/// A point of the half-plane in which the profile is drawn: distance from the axis, and height.
struct Meridian {
    double r = 0.0, h = 0.0;
};

class RoundTool {
public:
    /// Flat, face and slot mills (with or without a corner radius), bull noses, and ball noses
    /// (half the diameter).
    static RoundTool end_mill(double diameter, double corner_radius, double length);
    /// A cone of an included angle (degrees) from a tip, then a cylinder: V-cutters and drills.
    static RoundTool cone(double diameter, double tip_diameter, double included_angle,
                          double length);
    /// A cone that opens by `taper` degrees a side from a flat or rounded tip.
    static RoundTool tapered(double tip_diameter, double corner_radius, double taper,
                             double length);
    /// Narrower upwards, by `taper` degrees a side.
    static RoundTool dovetail(double diameter, double taper, double length);
    /// A whole ball.
    static RoundTool lollipop(double diameter);

    /// Distance from the surface, negative inside. As a function of the point convex, and its
    /// slope is at most 1.
    double signed_distance(const Vec& p_T) const;

    double radius() const { return radius_; }  ///< The largest.
    double height() const { return height_; }
    /// Half of the sharpest interior angle of the solid, at an edge or at its tip, radians.
    double sharpest_half_angle() const;
    /// Has it a ball or a rounded corner?
    bool is_rounded() const { return !arcs_.empty(); }
    bool is_whole_ball() const { return is_rounded() && top_.r == 0.0; }
    /// Is it a cylinder?
    bool is_upright() const { return bottom_.r == radius_ && top_.r == radius_; }
    /// Of the surface; `along` and `around` in [0, 1).
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

    Meridian bottom_;          // where the flat under the tool ends
    std::vector<Arc> arcs_;    // behind it: none, one, or two that are a half circle
    std::vector<Line> sides_;  // from there up
    Meridian top_;             // where the flat on top of the tool begins
    double radius_ = 0.0, height_ = 0.0;
};

}  // namespace ncsim::nightly
