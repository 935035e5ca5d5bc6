// SPDX-License-Identifier: GPL-3.0-or-later
//
// G2, G3, CIP, CT: arcs by centre, radius, opening angle, three points and tangent; TURN=; polar
// coordinates.
// Source: SINUMERIK 840D sl, Programming Manual Fundamentals, "Circular interpolation", 06/2019.
#include "ncsim/base/angles.h"

#include "sinumerik/sinumerik_control.h"
#include "text/message.h"

#include <array>
#include <cmath>

namespace ncsim::gcode::sinumerik {

/// Returns the centre of the arc along `axis`; nullopt without a word.
std::optional<double> Control::centre_of(const Words& words, std::size_t axis) const {
    const auto& word = words.centre[axis];
    if (!word) return std::nullopt;
    // I, J and K count from the start of the arc, whatever the mode is.
    return word->way == Way::Absolute ? word->value : at_[axis] + word->value;
}

bool Control::arc(const Words& words, const Command& command_of_block, const Axes& end,
                  AxisMask mask, SourceSpan span) {
    const PlaneAxes axes = axes_of(plane_);
    Command command = command_of_block;
    if (const std::optional<language::Corner> corner = corner_of(words)) put(command, *corner);
    if (motion_ == kCt) return tangential(command, end, mask, span);
    ProgramArc arc;
    arc.end = end;
    if (motion_ == kCip) return arc_by_points(words, command, arc, mask, span);
    const std::string_view name = motion_ == 2 ? "G2" : "G3";
    arc.turns = motion_ == 2 ? -1 : 1;
    if (words.turns) {
        const double turns = std::floor(*words.turns);
        if (turns != *words.turns) log_.add(Message::TurnFraction, words.corner_span);
        if (!(turns >= 0.0 && turns <= 999.0))
            return fail(Message::BlockNeeds, words.corner_span, {"TURN", "a number from 0 to 999"});
        arc.turns *= 1 + static_cast<int>(turns);
    }
    const bool has_end = (mask & (1U << axes.first | 1U << axes.second)) != 0;
    if (words.radius) return make_arc(arc, mask, *words.radius, command);
    if (words.opening) return arc_by_opening(words, command, arc, mask, has_end, span);
    const bool by_pole = words.polar_angle || words.polar_radius;
    const std::optional<double> first = centre_of(words, axes.first);
    const std::optional<double> second = centre_of(words, axes.second);
    if (!first && !second && !by_pole)
        return fail(Message::BlockNeeds, span, {name, "a centre (I, J, K), CR or AR"});
    arc.centre_1 = first.value_or(by_pole ? pole_[0] : at_[axes.first]);
    arc.centre_2 = second.value_or(by_pole ? pole_[1] : at_[axes.second]);
    return make_arc(arc, mask, std::nullopt, command);
}

/// AR: with the end, or with the centre.
bool Control::arc_by_opening(const Words& words, const Command& command, ProgramArc arc,
                             AxisMask mask, bool has_end, SourceSpan span) {
    const PlaneAxes axes = axes_of(plane_);
    const double opening = *words.opening;
    if (!(opening > 0.0 && opening < 360.0))
        return fail(Message::BlockNeeds, words.corner_span, {"AR", "an angle between 0 and 360"});
    const double x = at_[axes.first];
    const double y = at_[axes.second];
    if (has_end) {
        const double chord = hypotenuse(arc.end[axes.first] - x, arc.end[axes.second] - y);
        const double radius = chord / 2.0 / sin_cos(opening / 2.0).sin;
        return make_arc(arc, mask, opening > 180.0 ? -radius : radius, command);
    }
    const std::optional<double> first = centre_of(words, axes.first);
    const std::optional<double> second = centre_of(words, axes.second);
    if (!first && !second)
        return fail(Message::BlockNeeds, span, {"AR", "an end or a centre (I, J, K)"});
    arc.centre_1 = first.value_or(x);
    arc.centre_2 = second.value_or(y);
    double dx = x - arc.centre_1;
    double dy = y - arc.centre_2;
    rotate(dx, dy, arc.turns > 0 ? opening : -opening);
    arc.end[axes.first] = arc.centre_1 + dx;
    arc.end[axes.second] = arc.centre_2 + dy;
    return make_arc(arc, mask, std::nullopt, command);
}

/// CIP: the arc through the point I1, J1, K1.
bool Control::arc_by_points(const Words& words, const Command& command, ProgramArc arc,
                            AxisMask mask, SourceSpan span) {
    const PlaneAxes axes = axes_of(plane_);
    Axes via = at_;
    for (std::size_t i = 0; i < 3; ++i) {
        if (words.via[i])
            via[i] =
                is_increment(*words.via[i]) ? at_[i] + words.via[i]->value : words.via[i]->value;
    }
    const bool has_point = words.via[axes.first] || words.via[axes.second];
    if (!has_point) return fail(Message::BlockNeeds, span, {"CIP", "a point (I1=, J1=, K1=)"});
    if (via[axes.third] != at_[axes.third] || arc.end[axes.third] != at_[axes.third])
        return fail(Message::NotRead, span, {"CIP outside the plane"});
    // Centre of the circle through the start (the origin), `via` and the end.
    const double ax = via[axes.first] - at_[axes.first];
    const double ay = via[axes.second] - at_[axes.second];
    const double bx = arc.end[axes.first] - at_[axes.first];
    const double by = arc.end[axes.second] - at_[axes.second];
    const double area = 2.0 * (ax * by - ay * bx);
    if (!(std::abs(area) > 1e-9 * (ax * ax + ay * ay + bx * bx + by * by)))
        return fail(Message::BlockNeeds, span, {"CIP", "three points that are not on a line"});
    const double a = ax * ax + ay * ay;
    const double b = bx * bx + by * by;
    arc.centre_1 = at_[axes.first] + (by * a - ay * b) / area;
    arc.centre_2 = at_[axes.second] + (ax * b - bx * a) / area;
    arc.turns = area > 0.0 ? 1 : -1;
    return make_arc(arc, mask, std::nullopt, command);
}

/// CT: continues the last element tangentially.
bool Control::tangential(const Command& command, const Axes& end, AxisMask mask, SourceSpan span) {
    ProgramArc arc;
    switch (tangent_ ? tangent_arc(end, arc) : Tangent::None) {
        case Tangent::None:
            return fail(Message::BlockNeeds, span, {"CT", "a move in the plane before"});
        case Tangent::Arc: return make_arc(arc, mask, std::nullopt, command);
        case Tangent::Line: break;
    }
    Command straight = command;
    put(straight, Code::G1);
    for (std::size_t i = 0; i < end.size(); ++i) {
        if ((mask >> i & 1U) != 0) put(straight, kAxisNames[i], end[i]);
    }
    straight.axis_words = true;
    if (!run(straight)) return false;
    arrive(end);
    return true;
}

// --- Polar coordinates ---

/// G110, G111, G112: pole from the last position, the zero, the last pole.
bool Control::set_pole(int code, const Words& words, SourceSpan span) {
    const PlaneAxes axes = axes_of(plane_);
    const std::array<std::size_t, 2> index{axes.first, axes.second};
    const Vec2 from = code == 110   ? Vec2{at_[axes.first], at_[axes.second]}
                      : code == 112 ? pole_
                                    : Vec2{};
    for (std::size_t i = 0; i < 2; ++i)
        pole_[i] = from[i];
    if (words.polar_radius || words.polar_angle) {
        if (!words.polar_radius || !words.polar_angle)
            return fail(Message::BlockNeeds, span, {"the pole", "AP and RP"});
        const SinCos direction = sin_cos(words.polar_angle->value);
        pole_[0] += *words.polar_radius * direction.cos;
        pole_[1] += *words.polar_radius * direction.sin;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        if (words.axis[index[i]]) pole_[i] = from[i] + words.axis[index[i]]->value;
    }
    polar_angle_.reset();
    polar_radius_.reset();
    return true;
}

/// Computes the end of AP and RP about the pole.
bool Control::polar_end(const Words& words, Axes& end, AxisMask& mask, SourceSpan span) {
    if (!words.polar_angle && !words.polar_radius) return true;
    const PlaneAxes axes = axes_of(plane_);
    if (words.axis[axes.first] || words.axis[axes.second])
        return fail(Message::NotRead, span, {"AP or RP with an axis of the plane"});
    const double x = at_[axes.first] - pole_[0];
    const double y = at_[axes.second] - pole_[1];
    double radius = polar_radius_.value_or(hypotenuse(x, y));
    double angle = polar_angle_.value_or(angle_of(x, y));
    if (words.polar_radius) radius = *words.polar_radius;
    if (words.polar_angle) {
        const bool adds = is_increment(*words.polar_angle);
        angle = adds ? angle + words.polar_angle->value : words.polar_angle->value;
    }
    const SinCos direction = sin_cos(angle);
    end[axes.first] = pole_[0] + radius * direction.cos;
    end[axes.second] = pole_[1] + radius * direction.sin;
    mask |= 1U << axes.first | 1U << axes.second;
    polar_radius_ = radius;
    polar_angle_ = angle;
    return true;
}

}  // namespace ncsim::gcode::sinumerik
