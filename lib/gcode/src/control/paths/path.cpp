// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions in machine coordinates and in W, and the choice of W.
#include "control/paths/path.h"

#include "ncsim/base/angles.h"

#include "control/store.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {
namespace {

/// An arc whose ends subtend a smaller angle (radians) at the centre is a full circle; rounding of
/// offsets and units must not turn a full circle into no motion.
/// Source: grbl.
constexpr double kFullCircle = 5e-7;
constexpr double kFullCircleStrict = 1e-12;

constexpr std::array kCoordinates{&Position::x, &Position::y, &Position::z};

Length& coordinate(Position& position, std::size_t axis) {
    return position.*kCoordinates[axis];
}

/// True for an increment parallel to a machine axis from a known position.
bool keeps_frame(const MachineState& state, std::size_t axis, bool to_machine) {
    return state.incremental && !to_machine && state.known[axis] && state.frames.rotation == 0.0 &&
           !state.frames.tilt && !state.frames.programmed.changes_places();
}

/// Largest number of held motions; after this number W is the system of the last motion.
constexpr std::size_t kMostHeld = 10'000;

ProgramFrame frame_of(const MachineState& state) {
    ProgramFrame frame;
    frame.inches = state.inches;
    frame.system = state.system;
    frame.work_offset = state.frames.work_offset;
    frame.offset_92 = state.frames.offset_92;
    frame.tool_offset = state.frames.tool_offset;
    frame.rotation = state.frames.rotation;
    frame.plane = state.plane;
    frame.length_register = state.length_register;
    frame.length_specified = state.length_specified;
    frame.tool_length = state.tool_length;
    return frame;
}

/// Returns the origin of a system with `zero_92`, the zero that G92 set, in mm and degrees.
WorkOffset zero_of(const Axes& work_offset, const Axes& zero_92, double rotation, double unit) {
    WorkOffset zero;
    zero.rotation = rotation;
    double x = zero_92[kX];
    double y = zero_92[kY];
    rotate(x, y, rotation);
    for (std::size_t i = 0; i < zero.origin.size(); ++i) {
        const double shift = i == kX ? x : i == kY ? y : zero_92[i];
        zero.origin[i] = (work_offset[i] + shift) * (is_rotary(i) ? 1.0 : unit);
    }
    return zero;
}

std::string name_of_system(int system) {
    std::string name = system > kExtended ? "G54.1 P" : system > 6 ? "G59." : "G";
    const int number = system > kExtended ? system - kExtended
                       : system > 6       ? system - 6
                                          : 53 + system;
    return name.append(std::to_string(number));
}

}  // namespace

Path::Place Path::place(const MachineState& state, const Axes& at_plane) {
    const Axes p = state.frames.to_system(at_plane);
    const double mm = state.unit_mm();
    const auto& g5x = state.frames.work_offset;
    Place out;
    Position& at = out.machine;
    at.x = Length::from_mm(mm * (p[kX] + g5x[kX]));
    at.y = Length::from_mm(mm * (p[kY] + g5x[kY]));
    at.z = Length::from_mm(mm * (p[kZ] + g5x[kZ]));
    at.a = Angle::from_degrees(p[kA] + g5x[kA]);
    at.b = Angle::from_degrees(p[kB] + g5x[kB]);
    at.c = Angle::from_degrees(p[kC] + g5x[kC]);
    at.u = Length::from_mm(mm * (p[kU] + g5x[kU]));
    at.v = Length::from_mm(mm * (p[kV] + g5x[kV]));
    at.w = Length::from_mm(mm * (p[kW] + g5x[kW]));
    if (state.frames.dynamic_offset) {
        at.x += Length::from_mm(mm * (*state.frames.dynamic_offset)[kX]);
        at.y += Length::from_mm(mm * (*state.frames.dynamic_offset)[kY]);
        at.z += Length::from_mm(mm * (*state.frames.dynamic_offset)[kZ]);
    }
    out.frame = state.frame;
    return out;
}

Path::Place Path::target(const MachineState& state, const Place& from, const Axes& end,
                         AxisMask mask) const {
    constexpr double kRounding = 1e-6;  // mm
    Place to = place(state, end);
    for (std::size_t i = 0; i < 3; ++i) {
        const bool is_named = (mask & 1U << i) != 0;
        if (is_named && machine_coordinates_) {
            to.frame[i] = kMachinePlace;
            continue;
        }
        if (!state.known[i] || from.frame[i] == to.frame[i]) continue;
        Length& there = coordinate(to.machine, i);
        const Length here = from.machine.*kCoordinates[i];
        const bool rests = !is_named && std::abs((there - here).mm()) < kRounding;
        if (rests) there = here;
        if (rests || (is_named && keeps_frame(state, i, machine_coordinates_)))
            to.frame[i] = from.frame[i];
    }
    return to;
}

bool Path::is_related(const Place& place, std::size_t axis) const {
    return place.frame[axis] == frame_W_[axis] || place.frame[axis] == kMachinePlace;
}

Position Path::in_workpiece(const Place& place) const {
    const WorkOffset& w = result_.workpiece;
    Position at = place.machine;
    double x = at.x.mm() - w.origin[kX];
    double y = at.y.mm() - w.origin[kY];
    rotate(x, y, -w.rotation);
    at.x = Length::from_mm(x);
    at.y = Length::from_mm(y);
    at.z = Length::from_mm(at.z.mm() - w.origin[kZ]);
    at.a = Angle::from_degrees(at.a.degrees() - w.origin[kA]);
    at.b = Angle::from_degrees(at.b.degrees() - w.origin[kB]);
    at.c = Angle::from_degrees(at.c.degrees() - w.origin[kC]);
    at.u = Length::from_mm(at.u.mm() - w.origin[kU]);
    at.v = Length::from_mm(at.v.mm() - w.origin[kV]);
    at.w = Length::from_mm(at.w.mm() - w.origin[kW]);
    return at;
}

Knowledge after_move(const MachineState& state, AxisMask mask, bool to_machine) {
    Knowledge knows{state.known, state.relative, state.of_machine};
    for (std::size_t i = kX; i <= kZ; ++i) {
        if ((mask & 1U << i) == 0) continue;
        knows.relative[i] = state.incremental && !to_machine &&
                            (knows.relative[i] || knows.of_machine[i] || !knows.known[i]);
        knows.of_machine[i] = to_machine && state.frame[i] != 0;
        knows.known[i] = true;
    }
    return knows;
}

void set_knowledge(MachineState& state, const Knowledge& knows) {
    state.known = knows.known;
    state.relative = knows.relative;
    state.of_machine = knows.of_machine;
}

void record_move(MachineState& state, AxisMask mask, bool to_machine) {
    for (std::size_t i = 0; i < 3; ++i) {
        if ((mask & 1U << i) != 0 && !keeps_frame(state, i, to_machine))
            state.place_frame[i] = to_machine ? kMachinePlace : state.frame[i];
    }
    state.is_at_start = false;
    set_knowledge(state, after_move(state, mask, to_machine));
}

const Path::Place& Path::start(const MachineState& state) {
    if (!at_ || state.length_changes != length_changes_) {
        at_ = place(state, state.position);
        length_changes_ = state.length_changes;
    }
    at_->frame = state.place_frame;
    return *at_;
}

void Path::fill(const MachineState& state, MoveKind kind, AxisMask mask) {
    motion_.span = span_;
    motion_.file = file_;
    motion_.kind = kind;
    motion_.feed_mode = state.feed_mode;
    motion_.feed = state.feed;
    motion_.spindle = state.spindle;
    motion_.spindle_rpm = state.spindle_rpm;
    motion_.coolant = state.coolant;
    motion_.tool = state.tool;
    motion_.coordinates = state.coordinates;
    motion_.length = Length::from_mm(state.frames.tool_offset[kZ] * state.unit_mm());
    motion_.known_start = state.known;
    const Knowledge end = after_move(state, mask, machine_coordinates_);
    motion_.known_end = end.known;
    motion_.start_assumed = state.relative.any() || end.relative.any();
    motion_.machine_coordinates = machine_coordinates_;
    motion_.turns_clamped = false;
    motion_.spindle_in_doubt = state.spindle_in_doubt;
    motion_.spindle_oriented = state.spindle_oriented;
    motion_.steps_aside = state.steps_aside;
}

// --- Choice of W ---

void Path::shift_unspecified(std::size_t axis, double distance_mm) {
    const Length distance = Length::from_mm(distance_mm);
    const auto shift = [&](Place& place) {
        if (place.frame[axis] > 0) coordinate(place.machine, axis) += distance;
    };
    for (HeldMotion& held : held_) {
        shift(held.from);
        shift(held.to);
        if (held.origin_frame[axis] > 0)
            held.frame.work_offset[axis] += distance_mm / (held.frame.inches ? 25.4 : 1.0);
    }
    if (bound_ && frame_W_[axis] > 0) result_.workpiece.origin[axis] += distance_mm;
    if (!at_) return;
    const bool goes_on =
        last_end_machine_ && *last_end_machine_ == at_->machine && at_->frame[axis] > 0;
    shift(*at_);
    // A machine position has a different position in W after the shift.
    if (goes_on) last_end_machine_ = at_->machine;
    if (!goes_on) last_end_workpiece_.reset();
}

/// Compares the origin at the first cut in the system of `frame` with the origin that the options
/// specify.
void Path::compare_offset(const ProgramFrame& frame, const OriginFrame& origin_frame,
                          const std::array<bool, 3>& is_zero_by_hand) {
    constexpr double kSame = 1e-3;  // mm
    const int system = frame.system;
    const double unit = frame.inches ? 25.4 : 1.0;
    if (!compared_.insert(system).second) return;
    const auto written_at = offset_places_.find(system);
    if (written_at == offset_places_.end()) return;
    const Position* specified = nullptr;
    if (system <= kExtended) {
        const auto index = static_cast<std::size_t>(system - 1);
        if (options_.work_offsets_specified[index]) specified = &options_.work_offsets[index];
    } else if (const auto found = options_.extended_offsets.find(system - kExtended);
               found != options_.extended_offsets.end()) {
        specified = &found->second;
    }
    if (!specified) return;
    OffsetConflict conflict{.system = system, .place = written_at->second};
    bool differs = false;
    for (std::size_t i = 0; i < 3; ++i) {
        conflict.specified[i] = (specified->*kCoordinates[i]).mm();
        if (origin_frame[i] == 0 && !is_zero_by_hand[i])
            conflict.written[i] = frame.work_offset[i] * unit;
        differs |=
            !conflict.written[i] || std::abs(*conflict.written[i] - conflict.specified[i]) > kSame;
    }
    if (differs) result_.offset_conflicts.push_back(conflict);
}

void Path::bind(int system, const WorkOffset& workpiece,
                const std::array<bool, 3>& is_zero_by_hand) {
    bound_ = true;
    result_.workpiece_system = system;
    result_.workpiece = workpiece;
    frame_W_ = workpiece.frame;
    // A zero that G92 set at an unknown position is unknown in machine coordinates.
    for (std::size_t i = 0; i < 3; ++i) {
        if (is_zero_by_hand[i]) result_.workpiece.frame[i] = system;
    }
    for (HeldMotion& held : held_)
        emit_motion(held.motion, held.frame, held.from, held.to, held.centre, held.plane_origin);
    held_ = {};
}

void Path::bind(const HeldMotion& held) {
    const double unit = held.frame.inches ? 25.4 : 1.0;
    WorkOffset workpiece = zero_of(held.frame.work_offset, held.zero_92, held.frame.rotation, unit);
    for (std::size_t i = 0; i < 3; ++i)
        workpiece.origin[i] += unit * held.dynamic_offset_home[i];
    workpiece.frame = held.origin_frame;
    compare_offset(held.frame, held.origin_frame, held.is_zero_by_hand);
    bind(held.frame.system, workpiece, held.is_zero_by_hand);
}

void Path::finish() {
    if (bound_ || held_.empty()) return;
    // Without a cut, the last system of the program counts, as at the first motion in the system.
    const auto has_known_state = [](const HeldMotion& h) {
        return !h.motion.machine_coordinates && start_of(h.motion);
    };
    const auto last = std::find_if(held_.rbegin(), held_.rend(), has_known_state);
    const HeldMotion& chosen = last == held_.rend() ? held_.back() : *last;
    bind(HeldMotion(*std::ranges::find_if(held_, [&](const HeldMotion& h) {
        return &h == &chosen || (has_known_state(h) && h.origin_frame == chosen.origin_frame);
    })));
}

void Path::emit(const MachineState& state, const Place& from, const Place& to,
                const Position& centre, const std::optional<Place>& plane_origin) {
    ++result_.motions;
    const bool cuts = motion_.kind != MoveKind::Rapid && start_of(motion_);
    if (bound_) {
        if (cuts && !compared_.contains(state.system))
            compare_offset(frame_of(state), state.frame, state.frames.is_zero_by_hand);
        emit_motion(motion_, frame_of(state), from, to, centre, plane_origin);
        return;
    }
    held_.push_back({motion_, frame_of(state), from, to, centre, plane_origin, state.frames.zero_92,
                     state.frames.is_zero_by_hand, state.frames.dynamic_offset_home, state.frame});
    if (cuts || held_.size() >= kMostHeld) bind(HeldMotion(held_.back()));
}

void Path::emit_motion(Motion& motion, const ProgramFrame& frame, const Place& from,
                       const Place& to, const Position& centre,
                       const std::optional<Place>& plane_origin) {
    // A motion begins at the end of the motion before, in whatever coordinates the end was given.
    const bool goes_on = last_end_workpiece_ && *last_end_machine_ == from.machine;
    const Position from_W = goes_on ? *last_end_workpiece_ : in_workpiece(from);
    const Position to_W = in_workpiece(to);
    // At a machine height (G28, G53) the move to the height is checked; the origin of X and Y does
    // not matter.
    const bool is_at_height = from.frame[kZ] == kMachinePlace && to.frame[kZ] == kMachinePlace;
    bool ends_elsewhere = false;
    bool starts_elsewhere = false;
    for (std::size_t i = 0; i < 3; ++i) {
        ends_elsewhere |= motion.known_end[i] && !is_related(to, i);
        starts_elsewhere |= motion.known_start[i] && !is_related(from, i) && !is_at_height;
    }
    motion.offset_unknown = ends_elsewhere || starts_elsewhere;
    if (auto* line = std::get_if<Linear>(&motion.action)) {
        *line = {from_W, to_W};
    } else if (auto* tilted = std::get_if<Arc>(&motion.action); tilted && plane_origin) {
        // The centre is in plane coordinates already; the directions are in machine coordinates.
        tilted->from = from_W;
        tilted->to = to_W;
        const Position origin_W = in_workpiece(*plane_origin);
        tilted->tilted = turn_about(2, -result_.workpiece.rotation) * *tilted->tilted;
        tilted->tilted->origin = {origin_W.x.mm(), origin_W.y.mm(), origin_W.z.mm()};
    } else if (auto* arc = std::get_if<Arc>(&motion.action)) {
        Place at = to;
        at.machine = centre;
        const Position centre_W = in_workpiece(at);
        const Length lengths[] = {centre_W.x, centre_W.y, centre_W.z, Length(),  Length(),
                                  Length(),   centre_W.u, centre_W.v, centre_W.w};
        const PlaneAxes axes = axes_of(arc->plane);
        arc->from = from_W;
        arc->to = to_W;
        arc->centre_1 = lengths[axes.first];
        arc->centre_2 = lengths[axes.second];
        // Axes that are at rest in the machine are at rest in W, whatever the system of the words.
        if (to.machine.x == from.machine.x && to.machine.y == from.machine.y) {
            arc->to.x = from_W.x;
            arc->to.y = from_W.y;
        }
        if (to.machine.z == from.machine.z) arc->to.z = from_W.z;
    } else if (auto* spline = std::get_if<Spline>(&motion.action)) {
        spline->from = from_W;
        spline->to = to_W;
        for (Spline::ControlPoint& point : spline->control_points) {
            Place at = to;
            at.machine.x = point.x;
            at.machine.y = point.y;
            const Position point_W = in_workpiece(at);
            point.x = point_W.x;
            point.y = point_W.y;
        }
    } else if (auto* change = std::get_if<ToolChange>(&motion.action)) {
        change->at = to_W;
    }
    last_end_machine_ = to.machine;
    last_end_workpiece_ = to_W;
    if (ends_elsewhere && start_of(motion)) warn_of_frame(motion, to, frame.system);
    if (!sink_) return;
    if (!last_frame_ || !(*last_frame_ == frame))
        last_frame_ = std::make_shared<const ProgramFrame>(frame);
    motion.frame = last_frame_;
    sink_(motion);
}

/// `system`: the active system.
void Path::warn_of_frame(const Motion& motion, const Place& to, int system) {
    std::size_t axis = 0;
    while (axis < 2 && (!motion.known_end[axis] || is_related(to, axis)))
        ++axis;
    const bool is_specified = to.frame[axis] == 0;
    if (!is_specified) system = to.frame[axis];
    std::string name = name_of_system(system);
    std::string other = name_of_system(result_.workpiece_system);
    if (name == other && is_specified) name = "the machine";
    if (name == other) other += " at the first cut";
    log_.add(Message::OffsetUnknown, motion.span, {name, other});
}

void Path::set_end(MachineState& state, const Axes& end, const Place& target, AxisMask mask) {
    at_ = target;
    state.position = end;
    record_move(state, mask, machine_coordinates_);
    state.place_frame = target.frame;
}

// --- Motions ---

void Path::linear_move(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask) {
    const Place from = start(state);
    const Place to = target(state, from, end, mask);
    const Position& a = from.machine;
    const Position& b = to.machine;
    fill(state, kind, mask);
    const bool lengths =
        a.x != b.x || a.y != b.y || a.z != b.z || a.u != b.u || a.v != b.v || a.w != b.w;
    const bool turns = a.a != b.a || a.b != b.b || a.c != b.c;
    motion_.turns_clamped = (state.clamped[0] && a.a != b.a) || (state.clamped[1] && a.b != b.b) ||
                            (state.clamped[2] && a.c != b.c);
    // The feed of a purely rotary move is in degrees, independent of inches.
    if (state.feed_mode != FeedMode::InverseTime && (lengths || !turns)) {
        motion_.feed *= state.unit_mm();
    }
    if (!std::holds_alternative<Linear>(motion_.action)) motion_.action = Linear{};
    // A target in machine coordinates under tip control: with turned rotary axes the position of
    // the tip depends on the kinematics, so the position is unknown.
    const auto is_turned = [](const Position& p) {
        return p.a != Angle() || p.b != Angle() || p.c != Angle();
    };
    const bool is_lost = machine_coordinates_ && state.coordinates == Coordinates::Tip &&
                         (mask & (1U << kX | 1U << kY | 1U << kZ)) != 0 &&
                         (is_turned(a) || is_turned(b));
    constexpr KnownAxes kNothing{false, false, false};
    if (is_lost) motion_.known_start = motion_.known_end = kNothing;
    emit(state, from, to);
    set_end(state, end, to, mask);
    if (is_lost) set_knowledge(state, Knowledge{kNothing, kNothing, kNothing});
}

void Path::arc(MachineState& state, const ProgramArc& arc, AxisMask mask) {
    const PlaneAxes axes = axes_of(state.plane);
    const Axes& end = arc.end;
    const double x0 = state.position[axes.first] - arc.centre_1;
    const double y0 = state.position[axes.second] - arc.centre_2;
    const double x1 = end[axes.first] - arc.centre_1;
    const double y1 = end[axes.second] - arc.centre_2;
    const double limit = options_.strict ? kFullCircleStrict : kFullCircle;
    const bool full = !arc.is_open && std::abs(x0 * y1 - y0 * x1) <= limit * (x0 * x0 + y0 * y0) &&
                      x0 * x1 + y0 * y1 > 0.0 &&
                      hypotenuse(x1 - x0, y1 - y0) <= limit * hypotenuse(x0, y0) * 4;
    const Place from = start(state);
    Axes centre = state.position;
    centre[axes.first] = arc.centre_1;
    centre[axes.second] = arc.centre_2;
    const Place arc_centre = place(state, centre);
    Axes whole = end;
    if (full && state.frames.tilt) {
        whole[axes.first] = state.position[axes.first];
        whole[axes.second] = state.position[axes.second];
    }
    Place to = target(state, from, whole, mask);
    if (full && !state.frames.tilt) {  // The two ends are exactly equal, whatever the rounding.
        for (const std::size_t axis : {axes.first, axes.second}) {
            if (axis == kX) to.machine.x = from.machine.x;
            if (axis == kY) to.machine.y = from.machine.y;
            if (axis == kZ) to.machine.z = from.machine.z;
            if (axis == kU) to.machine.u = from.machine.u;
            if (axis == kV) to.machine.v = from.machine.v;
            if (axis == kW) to.machine.w = from.machine.w;
        }
    }
    fill(state, MoveKind::Feed, mask);
    if (state.feed_mode != FeedMode::InverseTime) motion_.feed *= state.unit_mm();
    Arc out{{}, {}, state.plane, {}, {}, arc.turns, {}};
    std::optional<Place> plane_origin;
    if (state.frames.tilt) {
        out.centre_1 = Length::from_mm(arc.centre_1 * state.unit_mm());
        out.centre_2 = Length::from_mm(arc.centre_2 * state.unit_mm());
        out.tilted = turn_about(2, state.frames.rotation) * *state.frames.tilt;
        plane_origin = place(state, {});
    }
    motion_.action = out;
    emit(state, from, to, arc_centre.machine, plane_origin);
    set_end(state, end, to, mask);
}

void Path::spline(MachineState& state, const Spline& spline, const Axes& end, AxisMask mask) {
    Spline out = spline;
    const Place from = start(state);
    const Place to = target(state, from, end, mask);
    for (Spline::ControlPoint& point : out.control_points) {
        Axes p = state.position;
        p[kX] = point.x.mm();
        p[kY] = point.y.mm();
        const Place at = place(state, p);
        point.x = at.machine.x;
        point.y = at.machine.y;
    }
    fill(state, MoveKind::Feed, mask);
    if (state.feed_mode != FeedMode::InverseTime) motion_.feed *= state.unit_mm();
    motion_.action = std::move(out);
    emit(state, from, to);
    set_end(state, end, to, mask);
}

void Path::dwell(const MachineState& state, double seconds) {
    const Place at = start(state);
    fill(state, MoveKind::Feed);
    motion_.feed *= state.unit_mm();
    motion_.action = Dwell{seconds};
    emit(state, at, at);
}

void Path::tool_change(const MachineState& state) {
    const Place at = start(state);
    fill(state, MoveKind::Rapid);
    motion_.feed *= state.unit_mm();
    motion_.action = ToolChange{state.tool, {}};
    emit(state, at, at);
}

}  // namespace ncsim::gcode
