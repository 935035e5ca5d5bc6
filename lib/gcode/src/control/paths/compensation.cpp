// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offset paths of cutter radius compensation.
#include "control/paths/compensation.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ncsim::gcode {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Corners flatter than this angle (degrees) need no connection; the offset paths meet.
constexpr double kFlat = 1e-5 * kDegrees;

/// A corner closer to a reversal than this angle (degrees) counts as an outside corner (value of
/// LinuxCNC).
constexpr double kReversal = 0.05 * kDegrees;

}  // namespace

void Compensation::begin(CutterSide side, double radius, CompensationStart start) {
    s_.start = start;
    s_.held_enters = false;
    s_.side = side == CutterSide::Left ? 1.0 : -1.0;
    s_.radius = radius;
    s_.entering = true;
    s_.held.reset();
    s_.made.reset();
    s_.programmed.reset();
    s_.followers = {};
}

void Compensation::begin_at_offset(CutterSide side, double radius, const Axes& at) {
    begin(side, radius, CompensationStart::SquareToItself);
    s_.entering = false;
    s_.at = at;
}

double Compensation::radius_of(const Element& e) const {
    return hypotenuse(e.to.x - e.centre.x, e.to.y - e.centre.y);
}

/// Returns the radius of the offset arc. The centre of a counter-clockwise arc is on the left.
double Compensation::offset_radius(const Element& e) const {
    return radius_of(e) - s_.side * (e.turns > 0 ? s_.radius : -s_.radius);
}

Compensation::Vec Compensation::start_tangent(const Element& e) const {
    if (!e.is_arc) {
        const double length = hypotenuse(e.to.x - e.from.x, e.to.y - e.from.y);
        return {(e.to.x - e.from.x) / length, (e.to.y - e.from.y) / length};
    }
    const double r = hypotenuse(e.from.x - e.centre.x, e.from.y - e.centre.y);
    const double turn = e.turns > 0 ? 1.0 : -1.0;
    return {-turn * (e.from.y - e.centre.y) / r, turn * (e.from.x - e.centre.x) / r};
}

Compensation::Vec Compensation::end_tangent(const Element& e) const {
    if (!e.is_arc) return start_tangent(e);
    const double r = radius_of(e);
    const double turn = e.turns > 0 ? 1.0 : -1.0;
    return {-turn * (e.to.y - e.centre.y) / r, turn * (e.to.x - e.centre.x) / r};
}

Compensation::Vec Compensation::offset_point(Vec point, Vec tangent) const {
    return {point.x - s_.side * s_.radius * tangent.y, point.y + s_.side * s_.radius * tangent.x};
}

bool Compensation::linear_move(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask,
                               SourceSpan span, std::uint32_t file) {
    const PlaneAxes axes = axes_of(state.plane);
    const Vec from{state.position[axes.first], state.position[axes.second]};
    const Vec to{end[axes.first], end[axes.second]};
    if (from.x == to.x && from.y == to.y) {
        if (!s_.held) {
            // On the offset path, if the previous move was made already.
            Axes beside_end = end;
            if (s_.made) {
                state.position = s_.at;
                beside_end[axes.first] = s_.at[axes.first];
                beside_end[axes.second] = s_.at[axes.second];
            }
            path_.linear_move(state, beside_end, kind, mask);
            if (s_.made) {
                s_.at = state.position;
                state.position = end;
                s_.programmed = end;
            }
            return true;
        }
        s_.followers.push_back({state, end, kind, mask, span, file, false, 0.0});
        state.position = end;
        s_.programmed = end;
        record_move(state, mask, false);
        return true;
    }
    Element element;
    element.state = state;
    element.end = end;
    element.kind = kind;
    element.mask = mask;
    element.span = span;
    element.file = file;
    element.from = from;
    element.to = to;
    return take(state, element);
}

bool Compensation::arc(MachineState& state, const ProgramArc& arc, AxisMask mask, SourceSpan span,
                       std::uint32_t file) {
    const PlaneAxes axes = axes_of(state.plane);
    Element element;
    element.state = state;
    element.end = arc.end;
    element.mask = mask;
    element.span = span;
    element.file = file;
    element.is_arc = true;
    element.from = {state.position[axes.first], state.position[axes.second]};
    element.to = {arc.end[axes.first], arc.end[axes.second]};
    element.centre = {arc.centre_1, arc.centre_2};
    element.turns = arc.turns;
    element.is_open = arc.is_open;
    if (offset_radius(element) <= 0.0) {
        log_.add(Message::CompensationArc, span);
        return false;
    }
    return take(state, element);
}

void Compensation::dwell(const MachineState& state, double seconds, SourceSpan span,
                         std::uint32_t file) {
    if (!s_.held) return path_.dwell(state, seconds);
    s_.followers.push_back({state, {}, MoveKind::Feed, 0, span, file, true, seconds});
}

bool Compensation::take(MachineState& state, Element element) {
    const bool enters = s_.entering;
    const bool is_done = enters ? enter(state, element) : !(s_.held || s_.made) || join(element);
    if (!is_done) return false;
    s_.held_enters = enters;
    s_.made.reset();
    const Axes end = element.end;
    s_.programmed = end;
    state.position = end;
    record_move(state, element.mask, false);
    s_.held = element;
    return true;
}

/// Starts compensation with `element`, if the control allows this.
bool Compensation::enter(MachineState& state, Element& element) {
    const double length = hypotenuse(element.to.x - element.from.x, element.to.y - element.from.y);
    if (s_.start == CompensationStart::SquareToNext) {
        bool turns = false;
        for (std::size_t axis = 0; axis < element.end.size(); ++axis)
            turns |= is_rotary(axis) && element.end[axis] != state.position[axis];
        if (element.is_arc || turns) {
            log_.add(Message::CompensationEntryArc, element.span);
            return false;
        }
    } else if (length <= s_.radius && (is_linuxcnc_ || element.is_arc)) {
        log_.add(Message::CompensationEntry, element.span);
        return false;
    } else if (length <= s_.radius) {
        log_.add(Message::CompensationEntryShort, element.span);
        s_.start = CompensationStart::SquareToNext;
    } else if (element.is_arc && !place_centre(element, state.position)) {
        log_.add(Message::CompensationArc, element.span);
        return false;
    } else if (element.is_arc && !is_linuxcnc_) {
        log_.add(Message::CompensationEntryByArc, element.span);
    }
    s_.at = state.position;
    s_.entering = false;
    return true;
}

/// Moves the centre of the first arc so that the compensated arc leads from `at` to the offset
/// point E of the end, with the programmed end tangent: centre = E + s n with unit normal n and
/// |centre - at| = s, so s = |at - E|² / (2 (at - E)·n).
/// Returns: false if there is no such arc.
bool Compensation::place_centre(Element& element, const Axes& at) const {
    constexpr double kSquare = 1e-4;
    const PlaneAxes axes = axes_of(element.state.plane);
    const Vec end = offset_point(element.to, end_tangent(element));
    const double chord_x = at[axes.first] - end.x;
    const double chord_y = at[axes.second] - end.y;
    const double radius = radius_of(element);
    const Vec inwards{(element.centre.x - element.to.x) / radius,
                      (element.centre.y - element.to.y) / radius};
    const double chord = hypotenuse(chord_x, chord_y);
    const double along = chord_x * inwards.x + chord_y * inwards.y;
    if (std::abs(along) < kSquare * chord) return false;
    const double distance = chord * chord / (2.0 * along);
    element.centre = {end.x + distance * inwards.x, end.y + distance * inwards.y};
    return true;
}

/// Ends the held element at the start of `next`.
bool Compensation::join(const Element& next) {
    const bool is_made = !s_.held;
    const Element held = is_made ? *s_.made : *s_.held;
    const Vec corner = held.to;
    const Vec in = end_tangent(held);
    const Vec out = start_tangent(next);
    const double turn = angle_of(dot(in, out), cross(in, out));
    const bool is_flat = std::abs(turn) < kFlat;
    if (is_flat || (s_.held_enters && s_.start == CompensationStart::SquareToNext)) {
        if (!is_made) emit(held, offset_point(corner, out));
        return true;
    }
    const bool outside = turn * s_.side < 0.0 || std::abs(turn) > 180.0 - kReversal;
    if (!outside) {
        if (is_made) return true;
        Vec point;
        if (!meeting_point(held, next, point)) {
            log_.add(Message::CompensationGouge, next.span);
            return false;
        }
        emit(held, point);
        return true;
    }
    if (!is_made) emit(held, offset_point(corner, in));
    // The arc around the corner belongs to the next move.
    MachineState state = next.state;
    state.position = s_.at;
    const PlaneAxes axes = axes_of(state.plane);
    const Vec to = offset_point(corner, out);
    ProgramArc arc;
    arc.end = s_.at;
    arc.end[axes.first] = to.x;
    arc.end[axes.second] = to.y;
    arc.centre_1 = corner.x;
    arc.centre_2 = corner.y;
    arc.turns = s_.side > 0.0 ? -1 : 1;
    path_.set_origin(next.span, next.file);
    if (is_linuxcnc_ && next.kind == MoveKind::Rapid) {
        path_.linear_move(state, arc.end, MoveKind::Rapid, 0);
    } else {
        path_.arc(state, arc, 0);
    }
    s_.at = state.position;
    return true;
}

/// Computes the intersection of the two offset elements that is nearest to the corner.
bool Compensation::meeting_point(const Element& a, const Element& b, Vec& point) const {
    const Vec corner = a.to;
    std::vector<Vec> candidates;
    const auto line_circle = [&](const Element& line, const Circle& circle) {
        const Vec d = start_tangent(line);
        const Vec p = offset_point(line.from, d);
        const double along = (circle.centre.x - p.x) * d.x + (circle.centre.y - p.y) * d.y;
        const double distance = cross(d, circle.centre - p);
        const double square = circle.radius * circle.radius - distance * distance;
        if (square < 0.0) return;
        for (const double step : {along - std::sqrt(square), along + std::sqrt(square)}) {
            candidates.push_back({p.x + step * d.x, p.y + step * d.y});
        }
    };
    // In rounded programs the radius of an arc differs between start and end; the radius at the
    // corner counts.
    const auto circle_of = [&](const Element& e) {
        const double at_start = hypotenuse(e.from.x - e.centre.x, e.from.y - e.centre.y);
        const double programmed = &e == &a ? radius_of(e) : at_start;
        return Circle{e.centre, offset_radius(e) - radius_of(e) + programmed};
    };
    if (!a.is_arc && !b.is_arc) {
        const Vec d = start_tangent(a);
        const Vec e = start_tangent(b);
        const Vec p = offset_point(corner, d);
        const Vec q = offset_point(corner, e);
        const double denominator = cross(d, e);
        const double step = cross(q - p, e) / denominator;
        candidates.push_back({p.x + step * d.x, p.y + step * d.y});
    } else if (!a.is_arc || !b.is_arc) {
        line_circle(a.is_arc ? b : a, circle_of(a.is_arc ? a : b));
    } else {
        const Circle c = circle_of(a);
        const Circle k = circle_of(b);
        const double dx = k.centre.x - c.centre.x;
        const double dy = k.centre.y - c.centre.y;
        const double distance = hypotenuse(dx, dy);
        if (distance == 0.0) return false;
        const double along =
            (distance * distance + c.radius * c.radius - k.radius * k.radius) / (2.0 * distance);
        const double square = c.radius * c.radius - along * along;
        if (square < 0.0) return false;
        for (const double height : {std::sqrt(square), -std::sqrt(square)}) {
            candidates.push_back({c.centre.x + (along * dx - height * dy) / distance,
                                  c.centre.y + (along * dy + height * dx) / distance});
        }
    }
    if (candidates.empty()) return false;
    point = *std::ranges::min_element(
        candidates, {}, [&](Vec v) { return hypotenuse(v.x - corner.x, v.y - corner.y); });
    // A negative remaining length means that the cutter does not fit.
    const PlaneAxes axes = axes_of(a.state.plane);
    const Vec start{s_.at[axes.first], s_.at[axes.second]};
    const auto backwards = [&](const Element& e, Vec from, Vec to) {
        const Vec d = start_tangent(e);
        return (to.x - from.x) * d.x + (to.y - from.y) * d.y < -1e-9;
    };
    if (!a.is_arc && backwards(a, start, point)) return false;
    return b.is_arc || !backwards(b, point, offset_point(b.to, end_tangent(b)));
}

void Compensation::emit(Element element, Vec end) {
    MachineState& state = element.state;
    state.position = s_.at;
    const PlaneAxes axes = axes_of(state.plane);
    Axes target = element.end;
    target[axes.first] = end.x;
    target[axes.second] = end.y;
    path_.set_origin(element.span, element.file);
    if (element.is_arc) {
        ProgramArc arc;
        arc.end = target;
        arc.centre_1 = element.centre.x;
        arc.centre_2 = element.centre.y;
        arc.turns = element.turns;
        arc.is_open = element.is_open;
        path_.arc(state, arc, element.mask);
    } else {
        path_.linear_move(state, target, element.kind, element.mask);
    }
    s_.at = state.position;
    for (Follower follower : s_.followers) {
        path_.set_origin(follower.span, follower.file);
        follower.state.position = s_.at;
        if (follower.is_dwell) {
            path_.dwell(follower.state, follower.seconds);
            continue;
        }
        Axes to = follower.end;
        to[axes.first] = end.x;
        to[axes.second] = end.y;
        path_.linear_move(follower.state, to, follower.kind, follower.mask);
        s_.at = follower.state.position;
    }
    s_.followers = {};
    s_.held.reset();
}

void Compensation::finish_held() {
    if (!s_.held) return;
    const Element held = *s_.held;
    emit(held, offset_point(held.to, end_tangent(held)));
    s_.made = held;
}

void Compensation::flush(MachineState& state) {
    if (!s_.held && !s_.made) return;
    finish_held();
    s_.made.reset();
    s_.programmed.reset();
    state.position = s_.at;
    s_.entering = true;
}

void Compensation::end(MachineState& state) {
    flush(state);
    s_.radius = 0.0;
}

void CompensationState::convert_units(double factor,
                                      const std::function<void(MachineState&)>& convert) {
    const auto scale_element = [&](Rare<Element>& element) {
        if (!element) return;
        convert(element->state);
        scale_lengths(element->end, factor);
        for (Vec* v : {&element->from, &element->to, &element->centre}) {
            v->x *= factor;
            v->y *= factor;
        }
    };
    radius *= factor;
    scale_lengths(at, factor);
    if (programmed) scale_lengths(*programmed, factor);
    scale_element(held);
    scale_element(made);
    const GrowingList<Follower> before = followers;
    followers = {};
    for (Follower follower : before) {
        convert(follower.state);
        scale_lengths(follower.end, factor);
        followers.push_back(follower);
    }
}

}  // namespace ncsim::gcode
