// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds on the hulls of a rotating tool, as derived in the header, and division of tools into
// slabs.
#include "ncsim/toolpath/rotation_bounds.h"

#include <algorithm>
#include <cmath>

namespace ncsim::toolpath {

namespace {

constexpr double kMargin = 1.0;   // mm
constexpr double kOverlap = 0.1;  // mm, by which slabs overlap their neighbours

// Avoids std::hypot, because the last bit of its result depends on the library.
double length_of(double a, double b) {
    return std::sqrt(a * a + b * b);
}

// A body of revolution between two heights with a largest radius; or the cylinder of these
// dimensions.
struct Body {
    double low_mm, high_mm, radius_mm;
    bool is_cylinder;
};

// Returns the gain of a cylinder whose axis rotates from one direction to another at the distance s
// <= 1 and bends by `bend` on the way. See "Cylinders" in the header.
double gained_by_cylinder(double s, double bend, double height, double across) {
    const double turned = 0.051 * s + bend / 32;  // t (1-t) times the angle between axis and m
    const double leans = 0.53 * s + bend / 8;     // largest angle between axis and m
    const double beyond_side = s * (height / 4 + turned * across);
    // Largest |z1 - z2| if the point is beyond an end.
    const double apart = s * (across + leans * height);
    const double beyond_end = s * (across / 4 + turned * std::min(height, apart));
    const double aside = 0.149 * s * apart + s * turned * across;
    return std::max(beyond_side, length_of(beyond_end, aside));
}

// Returns the gain of the hull for a straight motion. The gain is of first order in the angle.
double first_order_gain(const Pose& X_WA, const Pose& X_WB, double bend, const Body& body) {
    const auto axis_of = [](const Pose& pose) {
        return Vec3{pose.rows[0].z, pose.rows[1].z, pose.rows[2].z};
    };
    const Vec3 tilt = axis_of(X_WB) - axis_of(X_WA);
    const double s = norm(tilt);
    if (s == 0.0) return 0.0;
    const double across = 2 * body.radius_mm;
    const double height = body.high_mm - body.low_mm;
    double at_once = s * length_of(height, across) / 4;
    if (body.is_cylinder && s <= 1.0) {
        at_once = std::min(at_once, gained_by_cylinder(s, bend, height, across));
    }
    const Vec3 moved = X_WB.translation - X_WA.translation;
    const double along = dot(moved, tilt) / s;
    const double v1 = along + s * body.low_mm;
    const double v2 = along + s * body.high_mm;
    if (!(v1 > 0.0 && v2 > 0.0) && !(v1 < 0.0 && v2 < 0.0)) return at_once;
    const double r1 = std::sqrt(std::abs(v1));
    const double r2 = std::sqrt(std::abs(v2));
    const double later = std::abs(r2 - r1) / (r2 + r1);
    const double aside = norm(moved - (along / s) * tilt) + s * body.radius_mm;
    return std::min(at_once, later * aside + s * across / 4);
}

double reach_of(const PieceExtent& piece) {
    return length_of(piece.radius_mm, std::max(std::abs(piece.low_mm), std::abs(piece.high_mm)));
}

// Returns the radius of the ball that rolls around the core.
double ball_of(const PieceExtent& piece) {
    return std::max(piece.core_low_mm - piece.low_mm, piece.radius_mm - piece.core_radius_mm);
}

// Returns a bound on the acceleration of a point of the body's axis. In the frame that rotates by Ω
// the point moves only with the tip. So the acceleration is at most Ω² times the distance from the
// rotary axis, plus 2 Ω times the speed in that frame. `place_mm` is a further bound on that
// distance.
double bend_of_axis(const RotationBounds& t, const Body& body, double place_mm) {
    const double from_tip = std::max(std::abs(body.low_mm), std::abs(body.high_mm));
    const double distance = std::min(t.tip_mm + t.lean * from_tip, place_mm);
    return t.turn_rad * t.turn_rad * distance + 2 * t.turn_rad * t.moved_mm;
}

double missed_mm(const RotationBounds& t, const PieceExtent& piece) {
    // A point of the tool that reaches a place that matters is at most the length of its path away
    // from that place.
    const double place = t.place_mm + t.moved_mm;
    const double distance = std::min(t.tip_mm + reach_of(piece), place);
    const double as_it_turns = t.turn_rad * t.turn_rad * distance + 2 * t.turn_rad * t.moved_mm;
    // Alternatively, without rotation about the tool's own axis: a point of the axis, and a disc
    // across the axis that leans with the axis.
    const double r = piece.radius_mm;
    const double as_it_leans = bend_of_axis(t, {piece.low_mm, piece.high_mm, r, false}, place + r) +
                               r * (t.tilt_bend_rad + t.tilt_rad * t.tilt_rad);
    return std::min(as_it_turns, as_it_leans) / 8;
}

// Returns the gain of the hull of a body, and of the hull of the body with a ball of radius
// `ball_mm` rolled around.
double gained_mm(const Pose& X_WA, const Pose& X_WB, const RotationBounds& t, const Body& body,
                 double ball_mm) {
    const double first = first_order_gain(X_WA, X_WB, t.tilt_bend_rad, body);
    const double leans = body.radius_mm * t.tilt_bend_rad;
    const double anywhere = first + (bend_of_axis(t, body, RotationBounds::kInf) + leans) / 8;
    // The tool's point nearest to a place that matters is at most the gain g farther away than that
    // place. So g ≤ first + (b + Ω² g)/8.
    const double share = t.turn_rad * t.turn_rad / 8;
    if (share >= 0.5 || t.place_mm == RotationBounds::kInf) return anywhere;
    const double place = t.place_mm + body.radius_mm + ball_mm + t.moved_mm + t.chord_mm;
    const double here = (first + (bend_of_axis(t, body, place) + leans) / 8) / (1 - share);
    return std::min(anywhere, here);
}

double gained_mm(const Pose& X_WA, const Pose& X_WB, const RotationBounds& t,
                 const PieceExtent& piece) {
    const double ball = ball_of(piece);
    const Body core{piece.core_low_mm, piece.core_high_mm, piece.core_radius_mm,
                    piece.is_core_cylinder};
    const double rolled = gained_mm(X_WA, X_WB, t, core, ball);
    // A piece that is above all places that matter by more than its gain has no gain there, because
    // a gained place is at most the gain away from the tool.
    const auto highest = [&](double gained) {
        const double gain = gained + t.chord_mm;
        return gain <= RotationBounds::kSideMargin ? t.top_mm + gain : RotationBounds::kInf;
    };
    if (piece.core_low_mm - ball > highest(rolled)) return 0.0;
    if (!piece.open_above || highest(rolled) <= piece.high_mm) return rolled;
    const Body whole{piece.low_mm, piece.high_mm, piece.radius_mm, false};
    const double flat = gained_mm(X_WA, X_WB, t, whole, 0.0);
    return piece.low_mm > highest(flat) ? 0.0 : flat;
}

}  // namespace

PieceExtent extent_of(const ToolPiece& piece) {
    PieceExtent e;
    const auto& profile = piece.profile;
    if (profile.empty()) return e;
    e.low_mm = profile.front().height;
    e.high_mm = profile.back().height;
    for (const ProfilePoint& p : profile)
        e.radius_mm = std::max(e.radius_mm, p.radius);
    e.core_low_mm = e.low_mm;
    e.core_high_mm = e.high_mm;
    e.core_radius_mm = e.radius_mm;
    e.straight_mm = e.high_mm;
    if (profile.size() < 2) return e;
    const ProfilePoint& last = profile.back();
    const ProfilePoint& before = profile[profile.size() - 2];
    // The arc of a corner reaches at most its radius up, because heights do not decrease.
    if (before.radius == last.radius && last.fillet == 0.0)
        e.straight_mm = std::min(e.high_mm, before.height + before.fillet);
    if (profile.size() != 2) return e;
    const ProfilePoint& below = profile.front();
    const ProfilePoint& above = profile.back();
    const double rise = above.height - below.height;
    const double opening = above.radius - below.radius;
    if (opening < 0.0 || rise <= 0.0) return e;
    e.is_core_cylinder = opening == 0.0 && below.fillet == 0.0 && above.fillet == 0.0;
    // The ball touches the wall at right angles. On a cone the contact is above the ball's centre,
    // so some of the centres lie above the upper end.
    const double f = below.fillet;
    if (f <= 0.0 || (above.fillet != 0.0 && (above.fillet != f || opening != 0.0))) return e;
    const double slant = length_of(rise, opening);
    e.open_above = above.fillet == 0.0;
    e.core_low_mm = e.low_mm + f;
    e.core_high_mm = e.open_above ? e.high_mm + f * opening / slant : e.high_mm - f;
    e.core_high_mm = std::max(e.core_high_mm, e.core_low_mm);
    e.core_radius_mm = std::max(0.0, e.radius_mm - f * rise / slant);
    e.is_core_cylinder = opening == 0.0;
    return e;
}

ToolExtent extent_of(const Tool& tool) {
    ToolExtent extent;
    for (const ToolPiece& piece : tool.pieces) {
        if (piece.cutting) extent.pieces.push_back(extent_of(piece));
    }
    return extent;
}

double cut_off(const PieceExtent& piece, double top_mm) {
    return std::min(piece.high_mm, std::max(piece.straight_mm, top_mm + kMargin));
}

bool is_above(const PieceExtent& piece, double top_mm) {
    return piece.low_mm > top_mm + kMargin;
}

ToolExtent below(ToolExtent tool, double top_mm) {
    for (PieceExtent& piece : tool.pieces) {
        const double high = cut_off(piece, top_mm);
        if (high == piece.high_mm) continue;
        piece.high_mm = piece.core_high_mm = high;
    }
    return tool;
}

std::vector<Slab> slabs_of(const PieceExtent& piece, double slab_mm) {
    const double length = piece.high_mm - piece.straight_mm;
    if (!(slab_mm < length)) return {{piece.low_mm, piece.high_mm}};
    const auto count = static_cast<std::size_t>(std::ceil(length / slab_mm));
    const double height = length / static_cast<double>(count);
    std::vector<Slab> slabs;
    for (std::size_t i = 0; i < count; ++i) {
        const double low = piece.straight_mm + static_cast<double>(i) * height;
        const double high = i + 1 < count ? low + height : piece.high_mm;
        slabs.push_back({i > 0 ? low - std::min(kOverlap, height) : piece.low_mm, high});
    }
    return slabs;
}

ToolExtent split_into_slabs(const ToolExtent& tool, double slab_mm) {
    ToolExtent result;
    for (const PieceExtent& piece : tool.pieces) {
        const std::vector<Slab> slabs = slabs_of(piece, slab_mm);
        if (slabs.size() == 1) {
            result.pieces.push_back(piece);
            continue;
        }
        for (std::size_t i = 0; i < slabs.size(); ++i) {
            PieceExtent e = piece;
            e.low_mm = e.core_low_mm = slabs[i].low_mm;
            e.high_mm = e.core_high_mm = e.straight_mm = slabs[i].high_mm;
            const bool is_last = i + 1 == slabs.size();
            const double above = is_last ? RotationBounds::kInf : piece.high_mm - e.high_mm;
            if (i > 0) {
                // Largest ball that fits above and below. At the upper end of the tool the ball is
                // cut off.
                const double ball =
                    std::min({piece.radius_mm, e.low_mm - piece.straight_mm, above});
                e.core_radius_mm = piece.radius_mm - ball;
                e.is_core_cylinder = true;
                e.open_above = is_last;
            } else {
                // Rounded like the whole piece, if that fits.
                const double ball = piece.radius_mm - piece.core_radius_mm;
                e.open_above = false;
                if (piece.open_above && ball <= above && piece.core_low_mm <= e.high_mm) {
                    e.core_low_mm = piece.core_low_mm;
                } else {
                    e.is_core_cylinder &= ball == 0.0;
                    e.core_radius_mm = piece.radius_mm;
                }
            }
            result.pieces.push_back(e);
        }
    }
    return result;
}

RotationBounds RotationBounds::raise_tool(double distance_mm) const {
    RotationBounds t = *this;
    t.tip_mm += std::abs(distance_mm);
    t.top_mm -= distance_mm;
    return t;
}

double missed_mm(const RotationBounds& turning, const ToolExtent& tool) {
    if (tool.pieces.empty()) return missed_mm(turning, PieceExtent{});
    double worst = 0.0;
    for (const PieceExtent& piece : tool.pieces) {
        if (piece.low_mm <= turning.top_mm) worst = std::max(worst, missed_mm(turning, piece));
    }
    return worst;
}

double gained_mm(const Pose& X_WA, const Pose& X_WB, const RotationBounds& turning,
                 const ToolExtent& tool) {
    double worst = 0.0;
    for (const PieceExtent& piece : tool.pieces)
        worst = std::max(worst, gained_mm(X_WA, X_WB, turning, piece));
    return worst;
}

}  // namespace ncsim::toolpath
