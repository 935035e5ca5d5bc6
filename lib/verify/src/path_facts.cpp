// SPDX-License-Identifier: GPL-3.0-or-later
//
// Derives facts about paths from the program.
#include "path_facts.h"

#include "ncsim/toolpath/extent.h"
#include "ncsim/toolpath/kinematics.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/trace.h"

#include "rule_table.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace ncsim::verify {

using gcode::MoveKind;

namespace {

// Returns the smaller radius (mm) of an arc, which may be a spiral.
double smallest_radius(const gcode::Arc& specified) {
    const gcode::Arc arc = gcode::in_own_frame(specified);
    const auto radius = [&arc](const gcode::Position& p) {
        double first = p.x.mm(), second = p.y.mm();
        switch (arc.plane) {
            case gcode::Plane::XY: break;
            case gcode::Plane::ZX: first = p.z.mm(), second = p.x.mm(); break;
            case gcode::Plane::YZ: first = p.y.mm(), second = p.z.mm(); break;
            case gcode::Plane::UV: first = p.u.mm(), second = p.v.mm(); break;
            case gcode::Plane::WU: first = p.w.mm(), second = p.u.mm(); break;
            case gcode::Plane::VW: first = p.v.mm(), second = p.w.mm(); break;
        }
        first -= arc.centre_1.mm();
        second -= arc.centre_2.mm();
        return std::sqrt(first * first + second * second);
    };
    return std::min(radius(arc.from), radius(arc.to));
}

// True if positions of the machine's X, Y and Z differ from the programmed positions: under tip
// control, or if an axis U, V or W moves the tool along itself.
bool hides_axes(const toolpath::Poses& poses, const gcode::Position& from,
                const gcode::Position& to) {
    if (poses.has_tip_control()) return true;
    if (!poses.chain() || !poses.chain()->has_second_axes()) return false;
    const auto is_away = [](const gcode::Position& p) {
        return p.u != gcode::Length() || p.v != gcode::Length() || p.w != gcode::Length();
    };
    return is_away(from) || is_away(to);
}

}  // namespace

PathFacts::PathFacts(const Setup& setup, const Box& stock) : setup_(setup) {
    if (!stock.is_empty()) highest_ = stock.max.z;
    for (const Fixture& fixture : setup_.machine.fixtures)
        highest_ = std::max(highest_, fixture.place().max.z);
}

void PathFacts::set_frame(const gcode::ProgramFrame& frame) {
    const double unit = frame.inches ? 25.4 : 1.0;
    tool_offset_ = {unit * frame.tool_offset[gcode::kX], unit * frame.tool_offset[gcode::kY],
                    unit * frame.tool_offset[gcode::kZ]};
    frame_ = frame;
}

void PathFacts::take(Move& move, const gcode::Position& from, const gcode::Position& to,
                     FindingLog& log) {
    const gcode::Motion& motion = *move.motion;
    const toolpath::Poses poses(setup_.kinematics.get(), motion);
    measure(move, poses, from, to);
    move.is_tilted_tip = hides_axes(poses, from, to) && is_turned(motion);
    move.previous_path_box = way_;
    if (!move.is_tilted_tip) way_.add(move.path);
    move.way = way_;
    place_in_machine(move, log);
    move.passes_above = passes_above(motion, from, to);
    enter_tool_length(move, poses.place(from).z, poses.place(to).z);
    note_nose_position(move, from, to);
}

void PathFacts::note_nose_position(Move& move, const gcode::Position& from,
                                   const gcode::Position& to) {
    const gcode::Motion& motion = *move.motion;
    move.starts_at_nose = at_nose_;
    // A machine position of Z may equal the programmed height of the tip.
    const bool is_upright = from.x == to.x && from.y == to.y;
    if (from.z != to.z || !motion.known_start.z || (motion.machine_coordinates && is_upright)) {
        at_nose_ = motion.machine_coordinates;
    }
    move.ends_at_nose = at_nose_;
}

void PathFacts::measure(Move& move, const toolpath::Poses& poses, const gcode::Position& from,
                        const gcode::Position& to) const {
    const gcode::Motion& motion = *move.motion;
    Box& path = move.path;
    const bool turns = from.a != to.a || from.b != to.b || from.c != to.c;
    const bool is_shifted = poses.shift(from) != Vec3{} || poses.shift(to) != Vec3{};
    if (std::holds_alternative<gcode::Linear>(motion.action) && !(turns && is_shifted)) {
        const Vec3 a = poses.place(from);
        const Vec3 b = poses.place(to);
        move.length_mm = norm(b - a);
        move.enters = move.leaves = normalized(b - a);
    } else {
        toolpath::SamplingOptions coarse;
        coarse.chord_tolerance_mm = 0.01;
        const toolpath::Samples samples =
            toolpath::sample(motion, {}, coarse, {}, setup_.kinematics.get());
        for (std::size_t i = 1; i < samples.poses.size(); ++i) {
            const Vec3 chord = samples.poses[i].translation - samples.poses[i - 1].translation;
            move.length_mm += norm(chord);
            move.leaves = normalized(chord);
            if (i == 1) move.enters = move.leaves;
        }
        if (const auto* arc = std::get_if<gcode::Arc>(&motion.action)) {
            move.radius_mm = smallest_radius(*arc);
        }
    }
    path = toolpath::extent_of_path(motion, poses);
    if (!toolpath::has_known_start(motion)) {
        move.length_mm = 0.0;
        path = {};
        path.add(poses.place(to));
    }
}

// Computes the positions of the axes if the position of the work zero is specified.
void PathFacts::place_in_machine(Move& move, FindingLog& log) const {
    const gcode::Motion& motion = *move.motion;
    const auto is_specified = [](const auto& travel) { return travel.has_value(); };
    const bool has_joints = setup_.kinematics && setup_.axes_guess.empty() &&
                            setup_.machine.work_zero && toolpath::has_known_start(motion) &&
                            (!setup_.kinematics->chain.has_head() || motion.length.mm() > 0.0);
    if (move.is_tilted_tip && has_joints) {
        const Vec3 shift = *setup_.machine.work_zero + tool_offset_;
        const Box joints = toolpath::extent_of_joints(motion, *setup_.kinematics);
        if (!joints.is_empty()) move.machine_path = Box{joints.min + shift, joints.max + shift};
    } else if (move.is_tilted_tip && std::ranges::any_of(setup_.machine.travel, is_specified)) {
        log.doubt("setting-not-used",
                  "travels: where the axes go under tip control is not compared with them",
                  {motion.file, motion.span});
    } else if (setup_.machine.work_zero && toolpath::has_known_end(motion)) {
        const Vec3 shift = *setup_.machine.work_zero + tool_offset_;
        move.machine_path = Box{move.path.min + shift, move.path.max + shift};
    }
}

void PathFacts::enter_tool_length(Move& move, double from_mm, double to_mm) const {
    const gcode::Motion& motion = *move.motion;
    move.length_register = frame_.length_register;
    move.length_specified = frame_.length_specified;
    move.length_offset = tool_offset_.z;
    move.tool_length = frame_.tool_length;
    // Some posts position at a high feed, above all bodies.
    const bool positions =
        motion.kind == MoveKind::Rapid || (motion.kind == MoveKind::Feed && move.passes_above);
    move.needs_length =
        !motion.machine_coordinates && (!positions || (motion.known_start.z && to_mm < from_mm) ||
                                        (!motion.known_start.z && motion.known_end.z));
}

// True if the motion meets no body, whatever its unknown start and the position of home.
// Convention: the reference point is above all bodies on the table, as on every mill.
bool PathFacts::passes_above(const gcode::Motion& motion, const gcode::Position& from,
                             const gcode::Position& to) const {
    if (is_turned(motion)) return false;
    const Vec3 a = toolpath::linear_axes(from);
    const Vec3 b = toolpath::linear_axes(to);
    const auto& start = motion.known_start;
    const auto& end = motion.known_end;
    if (a == b && start == end && !motion.start_assumed) return true;  // no motion
    constexpr double kRounding = 1e-6;                                 // mm
    const bool to_home = motion.machine_coordinates && end.z && b.z >= setup_.home_z - kRounding;
    const bool only_z = a.x == b.x && a.y == b.y && start.x == end.x && start.y == end.y;
    if (to_home && only_z) return true;
    // "G0 Z15" first: the tool comes down from above, or moves straight up from a free position.
    const bool is_first_lift = motion.kind == MoveKind::Rapid && only_z && !start.z && end.z &&
                               b.z > highest_ && !motion.offset_unknown &&
                               !motion.machine_coordinates && !motion.start_assumed;
    if (is_first_lift) return true;
    const bool certain = !motion.start_assumed && !motion.offset_unknown &&
                         (!motion.machine_coordinates || setup_.home_assumption.empty());
    return start.z && end.z && std::min(a.z, b.z) > highest_ && (certain || to_home);
}

ToolLength PathFacts::tool_length(const gcode::Motion& motion) const {
    const bool is_active = frame_.length_register != gcode::kNoLength;
    const bool is_specified = is_active && frame_.length_specified;
    ToolLength length;
    length.nose_known = is_active ? is_specified : setup_.uses_length_offsets;
    length.gauge_mm = frame_.tool_length;
    if (!length.gauge_mm && is_specified) length.gauge_mm = motion.length.mm();
    return length;
}

}  // namespace ncsim::verify
