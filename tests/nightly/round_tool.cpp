// SPDX-License-Identifier: GPL-3.0-or-later
//
// Profiles of round tools, and distances from the profiles.
#include "nightly/round_tool.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace ncsim::nightly {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Meridian operator-(Meridian a, Meridian b) {
    return {a.r - b.r, a.h - b.h};
}
double dot(Meridian a, Meridian b) {
    return a.r * b.r + a.h * b.h;
}
double cross(Meridian a, Meridian b) {
    return a.r * b.h - a.h * b.r;
}
double norm(Meridian a) {
    return std::sqrt(dot(a, a));
}

double distance_to_segment(Meridian p, Meridian a, Meridian b) {
    const Meridian d = b - a;
    const double squared = dot(d, d);
    const double t = squared > 0.0 ? std::clamp(dot(p - a, d) / squared, 0.0, 1.0) : 0.0;
    return norm(p - Meridian{a.r + t * d.r, a.h + t * d.h});
}

bool is_left(Meridian p, Meridian a, Meridian b) {
    return cross(b - a, p - a) >= 0.0;
}

}  // namespace

RoundTool RoundTool::end_mill(double diameter, double corner_radius, double length) {
    RoundTool tool;
    const double r = diameter / 2;
    const double corner = std::min(corner_radius, r);
    tool.bottom_ = {r - corner, 0.0};
    if (corner > 0.0)
        tool.arcs_.push_back({{r - corner, corner}, tool.bottom_, {r, corner}, corner});
    tool.close({{r, corner}, {r, std::max(length, corner)}});
    return tool;
}

RoundTool RoundTool::cone(double diameter, double tip_diameter, double included_angle,
                          double length) {
    RoundTool tool;
    const double r = diameter / 2;
    const double tip = std::min(tip_diameter / 2, r);
    const double rise = (r - tip) / std::tan(included_angle / 2 * kDegree);
    tool.bottom_ = {tip, 0.0};
    tool.close({tool.bottom_, {r, rise}, {r, std::max(length, rise)}});
    return tool;
}

RoundTool RoundTool::tapered(double tip_diameter, double corner_radius, double taper,
                             double length) {
    RoundTool tool;
    const double angle = taper * kDegree;
    const double r = tip_diameter / 2;
    const double corner = std::min(corner_radius, r);
    const double height = std::max(length, corner);
    tool.bottom_ = {r - corner, 0.0};
    // The arc ends where the cone is tangent to the arc.
    const Meridian touch{r - corner + corner * std::cos(angle), corner - corner * std::sin(angle)};
    if (corner > 0.0) tool.arcs_.push_back({{r - corner, corner}, tool.bottom_, touch, corner});
    tool.close({touch, {touch.r + (height - touch.h) * std::tan(angle), height}});
    return tool;
}

RoundTool RoundTool::dovetail(double diameter, double taper, double length) {
    RoundTool tool;
    const double r = diameter / 2;
    const double slope = std::tan(taper * kDegree);
    // The top keeps at least a twentieth of the width.
    const double height = std::min(length, 0.95 * r / slope);
    tool.bottom_ = {r, 0.0};
    tool.close({tool.bottom_, {r - height * slope, height}});
    return tool;
}

RoundTool RoundTool::lollipop(double diameter) {
    RoundTool tool;
    const double r = diameter / 2;
    const Meridian equator{r, r};
    tool.arcs_.push_back({{0.0, r}, tool.bottom_, equator, r});
    tool.arcs_.push_back({{0.0, r}, equator, {0.0, diameter}, r});
    tool.close({equator});
    tool.top_ = tool.arcs_.back().to;
    tool.height_ = diameter;
    return tool;
}

// Adds the sides between `corners`, from the lowest upwards, except sides of length zero.
void RoundTool::close(const std::vector<Meridian>& corners) {
    for (std::size_t i = 1; i < corners.size(); ++i) {
        if (norm(corners[i] - corners[i - 1]) > 0.0) sides_.push_back({corners[i - 1], corners[i]});
    }
    top_ = corners.back();
    radius_ = std::max(corners.front().r, top_.r);
    height_ = top_.h;
}

// The nearest point of the surface is in the half-plane of the axis and the point. In the
// half-plane the profile with its mirror image is convex: a point is inside if the point is left of
// all lines and, in front of an arc, within the radius.
double RoundTool::signed_distance(const Vec& p_T) const {
    const Meridian p{std::sqrt(p_T[0] * p_T[0] + p_T[1] * p_T[1]), p_T[2]};
    bool inside = p.h >= 0.0 && p.h <= height_;
    double distance = std::min(distance_to_segment(p, {0.0, 0.0}, bottom_),
                               distance_to_segment(p, top_, {0.0, height_}));
    for (const Line& side : sides_) {
        inside = inside && is_left(p, side.from, side.to);
        distance = std::min(distance, distance_to_segment(p, side.from, side.to));
    }
    for (const Arc& arc : arcs_) {
        const Meridian q = p - arc.centre;
        const bool in_front =
            cross(arc.from - arc.centre, q) >= 0.0 && cross(q, arc.to - arc.centre) >= 0.0;
        const double beyond = norm(q) - arc.radius;
        if (in_front) {
            inside = inside && beyond <= 0.0;
            distance = std::min(distance, std::abs(beyond));
        }
        distance = std::min({distance, norm(p - arc.from), norm(p - arc.to)});
    }
    return inside ? -distance : distance;
}

double RoundTool::sharpest_half_angle() const {
    double sharpest = std::numbers::pi / 4;   // of a disc and a cylinder
    const auto lean = [](const Line& side) {  // angle to the axis
        return std::atan2(side.to.r - side.from.r, side.to.h - side.from.h);
    };
    if (!sides_.empty()) {
        // The upper rim, between the last side and the top disc; and the pointed tip, or the lower
        // rim of a dovetail.
        sharpest = std::min(sharpest, (std::numbers::pi / 2 - lean(sides_.back())) / 2);
        if (arcs_.empty() && bottom_.r == 0.0) {
            sharpest = std::min(sharpest, lean(sides_.front()));
        } else if (arcs_.empty()) {
            sharpest = std::min(sharpest, (std::numbers::pi / 2 + lean(sides_.front())) / 2);
        }
    }
    return sharpest;
}

Vec RoundTool::surface_point(double along, double around) const {
    // Chooses a piece of the profile by length. An arc counts as its chord, which only selects an
    // angle.
    std::vector<Line> pieces{{{0.0, 0.0}, bottom_}};
    for (const Arc& arc : arcs_)
        pieces.push_back({arc.from, arc.to});
    pieces.insert(pieces.end(), sides_.begin(), sides_.end());
    pieces.push_back({top_, {0.0, height_}});
    double rest = 0.0;
    for (const Line& piece : pieces)
        rest += norm(piece.to - piece.from);
    rest *= along;
    std::size_t i = 0;
    while (i + 1 < pieces.size() && rest > norm(pieces[i].to - pieces[i].from)) {
        rest -= norm(pieces[i].to - pieces[i].from);
        ++i;
    }
    const Line& piece = pieces[i];
    const double length = norm(piece.to - piece.from);
    const double t = length > 0.0 ? rest / length : 0.0;
    Meridian p{piece.from.r + t * (piece.to.r - piece.from.r),
               piece.from.h + t * (piece.to.h - piece.from.h)};
    if (1 <= i && i <= arcs_.size()) {
        const Arc& arc = arcs_[i - 1];
        const Meridian q = p - arc.centre;
        const double stretch = arc.radius / norm(q);
        p = {arc.centre.r + stretch * q.r, arc.centre.h + stretch * q.h};
    }
    const double azimuth = 2 * std::numbers::pi * around;
    return {p.r * std::cos(azimuth), p.r * std::sin(azimuth), p.h};
}

}  // namespace ncsim::nightly
