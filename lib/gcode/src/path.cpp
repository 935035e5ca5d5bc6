// SPDX-License-Identifier: GPL-3.0-or-later
#include "path.h"

#include "trig.h"

#include <cmath>

namespace ncsim::gcode {
namespace {

/// An arc whose ends are closer than this, seen from the centre, is a full circle: rounding of
/// offsets and units must not turn one into nothing. In radians, as grbl has it.
constexpr double kFullCircle = 5e-7;
constexpr double kFullCircleStrict = 1e-12;

}  // namespace

Position Path::in_workpiece(const MachineState& state, const Axes& p) const {
    const double mm = state.unit_mm();
    double x = p[kX] + state.offset_92[kX];
    double y = p[kY] + state.offset_92[kY];
    if (state.rotation != 0.0) {
        const SinCos r = sin_cos_degrees(state.rotation);
        const double turned = x * r.cos - y * r.sin;
        y = x * r.sin + y * r.cos;
        x = turned;
    }
    const auto& g5x = state.work_offset;
    const auto& g92 = state.offset_92;
    const Position& origin = options_.work_offsets[0];
    Position at;
    at.x = Length::from_mm(mm * (x + g5x[kX])) - origin.x;
    at.y = Length::from_mm(mm * (y + g5x[kY])) - origin.y;
    at.z = Length::from_mm(mm * (p[kZ] + g92[kZ] + g5x[kZ])) - origin.z;
    at.a = Angle::from_degrees(p[kA] + g92[kA] + g5x[kA]) - origin.a;
    at.b = Angle::from_degrees(p[kB] + g92[kB] + g5x[kB]) - origin.b;
    at.c = Angle::from_degrees(p[kC] + g92[kC] + g5x[kC]) - origin.c;
    at.u = Length::from_mm(mm * (p[kU] + g92[kU] + g5x[kU])) - origin.u;
    at.v = Length::from_mm(mm * (p[kV] + g92[kV] + g5x[kV])) - origin.v;
    at.w = Length::from_mm(mm * (p[kW] + g92[kW] + g5x[kW])) - origin.w;
    return at;
}

Position Path::start(const MachineState& state) {
    if (stale_) {
        at_ = in_workpiece(state, state.position);
        stale_ = false;
    }
    return at_;
}

void Path::fill(const MachineState& state, MoveKind kind) {
    motion_.span = span_;
    motion_.file = file_;
    motion_.kind = kind;
    motion_.feed_mode = state.feed_mode;
    motion_.feed = state.feed;
    motion_.spindle = state.spindle;
    motion_.spindle_rpm = state.spindle_rpm;
    motion_.tool = state.tool;
    motion_.known_start = state.known;
    motion_.machine_coordinates = machine_coordinates_;
}

void Path::emit(const MachineState& state) {
    ++result_.motions;
    if (options_.observe_frame) {
        options_.observe_frame(motion_,
                               {state.inches, state.system, state.work_offset, state.offset_92,
                                state.tool_offset, state.rotation, state.plane});
    }
    if (sink_) sink_(motion_);
}

void Path::arrive(MachineState& state, const Axes& end, const Position& target, AxisMask mask) {
    at_ = target;
    state.position = end;
    state.known.x = state.known.x || (mask & 1U << kX) != 0;
    state.known.y = state.known.y || (mask & 1U << kY) != 0;
    state.known.z = state.known.z || (mask & 1U << kZ) != 0;
}

void Path::straight(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask) {
    const Position from = start(state);
    const Position to = in_workpiece(state, end);
    fill(state, kind);
    const bool lengths = from.x != to.x || from.y != to.y || from.z != to.z || from.u != to.u ||
                         from.v != to.v || from.w != to.w;
    const bool turns = from.a != to.a || from.b != to.b || from.c != to.c;
    // A purely rotary move is fed in degrees, which have no inches.
    if (state.feed_mode != FeedMode::InverseTime && (lengths || !turns)) {
        motion_.feed *= state.unit_mm();
    }
    if (auto* line = std::get_if<Linear>(&motion_.what)) {
        *line = {from, to};
    } else {
        motion_.what = Linear{from, to};
    }
    emit(state);
    arrive(state, end, to, mask);
}

void Path::arc(MachineState& state, const ProgramArc& arc, AxisMask mask) {
    const PlaneAxes axes = axes_of(state.plane);
    Axes end = arc.end;
    const double x0 = state.position[axes.first] - arc.centre_1;
    const double y0 = state.position[axes.second] - arc.centre_2;
    const double x1 = end[axes.first] - arc.centre_1;
    const double y1 = end[axes.second] - arc.centre_2;
    const double limit = options_.strict ? kFullCircleStrict : kFullCircle;
    const bool full = std::abs(x0 * y1 - y0 * x1) <= limit * (x0 * x0 + y0 * y0) &&
                      x0 * x1 + y0 * y1 > 0.0 &&
                      std::hypot(x1 - x0, y1 - y0) <= limit * std::hypot(x0, y0) * 4;
    const Position from = start(state);
    Axes centre = state.position;
    centre[axes.first] = arc.centre_1;
    centre[axes.second] = arc.centre_2;
    const Position arc_centre = in_workpiece(state, centre);
    Position to = in_workpiece(state, end);
    const auto pick = [](const Position& p, std::size_t axis) {
        const Length lengths[] = {p.x, p.y, p.z, Length(), Length(), Length(), p.u, p.v, p.w};
        return lengths[axis];
    };
    if (full) {  // Exactly: the ends are one point, whatever rounding says.
        const auto copy = [&](std::size_t axis) {
            if (axis == kX) to.x = from.x;
            if (axis == kY) to.y = from.y;
            if (axis == kZ) to.z = from.z;
            if (axis == kU) to.u = from.u;
            if (axis == kV) to.v = from.v;
            if (axis == kW) to.w = from.w;
        };
        copy(axes.first);
        copy(axes.second);
    }
    fill(state, MoveKind::Feed);
    if (state.feed_mode != FeedMode::InverseTime) motion_.feed *= state.unit_mm();
    motion_.what =
        Arc{from,     to, state.plane, pick(arc_centre, axes.first), pick(arc_centre, axes.second),
            arc.turns};
    emit(state);
    arrive(state, end, to, mask);
}

void Path::spline(MachineState& state, const Spline& spline, const Axes& end, AxisMask mask) {
    Spline out = spline;
    out.from = start(state);
    out.to = in_workpiece(state, end);
    for (Spline::ControlPoint& point : out.control_points) {
        Axes p = state.position;
        p[kX] = point.x.mm();
        p[kY] = point.y.mm();
        const Position at = in_workpiece(state, p);
        point.x = at.x;
        point.y = at.y;
    }
    fill(state, MoveKind::Feed);
    if (state.feed_mode != FeedMode::InverseTime) motion_.feed *= state.unit_mm();
    const Position to = out.to;
    motion_.what = std::move(out);
    emit(state);
    arrive(state, end, to, mask);
}

void Path::dwell(const MachineState& state, double seconds) {
    fill(state, MoveKind::Feed);
    motion_.feed *= state.unit_mm();
    motion_.what = Dwell{seconds};
    emit(state);
}

void Path::tool_change(const MachineState& state) {
    const Position at = start(state);
    fill(state, MoveKind::Rapid);
    motion_.feed *= state.unit_mm();
    motion_.what = ToolChange{state.tool, at};
    emit(state);
}

}  // namespace ncsim::gcode
